"""Formats, solvers, stages and packages that fail, or clash: each is named, and nothing else is lost."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
from odd_kind import FACADE, KIND

from layoutkit.model import Facade, Region


@pytest.fixture
def facade(tmp_path: Path) -> Path:
    (tmp_path / "facade.xml").write_text(FACADE.replace("<odd:rule/>", ""))
    return tmp_path / "facade.xml"


FORMAT = """
from layoutkit.hooks import Format, hookimpl

class Odd(Format):
    name = "odd"
    summary = "Fails."
    def recognises(self, path, head): {recognises}
    def read(self, path, picture): {read}

@hookimpl
def layoutkit_formats():
    return [Odd()]
"""
CMP = """<object>
<points><x>0.1</x><x>0.9</x><y>0.1</y><y>0.9</y></points>
<label>2</label>
<labelname>facade</labelname>
</object>
"""


def test_a_format_that_fails_to_recognise_a_file_leaves_it_to_the_others(
    install: Any, layoutkit: Any, tmp_path: Path
) -> None:
    install("odd_format", FORMAT.format(recognises="raise OSError('torn')", read="return 3"))
    (tmp_path / "b.xml").write_text(CMP)
    run = layoutkit("convert", tmp_path / "b.xml", "-o", tmp_path / "f.xml")
    assert "error LK407 plugin: the format 'odd' of the plugin 'odd_format' of acme-plugin 1.2" in run.err
    assert "OSError: torn" in run.err
    assert "LK302" in run.err, "the format cmp has looked at it, and misses the picture"
    assert run.code == 5


def test_a_format_that_reads_no_facade_is_named(install: Any, layoutkit: Any, tmp_path: Path) -> None:
    install("odd_format", FORMAT.format(recognises="return True", read="return 3"))
    (tmp_path / "b.odd").write_text("odd")
    run = layoutkit("convert", tmp_path / "b.odd", "-o", tmp_path / "f.xml")
    assert run.code == 5
    assert "the plugin 'odd_format' of acme-plugin 1.2 failed: Odd reads 3, and no facade" in run.err
    assert not (tmp_path / "f.xml").exists()


BACKEND = """
import numpy as np
from layoutkit.hooks import hookimpl
from layoutkit.sizing.backends import Daqp
from layoutkit.sizing.qp import Backend, Solution

class Odd(Backend):
    name = "odd"
    summary = "A solver of someone's own."
    most_variables = 1000
    asked = 0
    def solve(self, problem):
        Odd.asked += 1
        {solve}

@hookimpl
def layoutkit_qp_backends():
    return [Odd()]
"""


@pytest.mark.parametrize(
    ("solve", "told"),
    [
        ("raise ArithmeticError('overflow')", "ArithmeticError: overflow"),
        ("return 3", "returns 3, and no Solution"),
        ("return Solution('solved', np.zeros(99))", "returns x of the shape (99,)"),
    ],
)
def test_a_backend_that_fails_is_named(
    solve: str, told: str, install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install("odd_solver", BACKEND.format(solve=solve))
    run = layoutkit("--backend", "odd", "vary", facade, "-n", "1", "--width", "110%", "-o", tmp_path / "out")
    assert run.code == 5
    assert "the plugin 'odd_solver' of acme-plugin 1.2 failed" in run.err
    assert told in run.err
    without = layoutkit("--without", "odd_solver", "vary", facade, "-n", "1", "-o", tmp_path / "out")
    assert without.code == 0


def test_a_backend_is_asked_first_where_it_is_named(
    install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install("odd_solver", BACKEND.format(solve="return Daqp().solve(problem)"))
    arguments = ("vary", facade, "-n", "2", "--width", "110%", "-o", tmp_path / "out")
    assert layoutkit(*arguments).code == 0
    assert sys.modules["odd_solver"].Odd.asked == 0, "the built-in ones have solved all"
    assert layoutkit("--backend", "odd", *arguments).code == 0
    assert sys.modules["odd_solver"].Odd.asked > 0
    unknown = layoutkit("--backend", "od", *arguments)
    assert unknown.code == 2
    assert "did you mean 'odd'?" in unknown.err


def test_a_backend_that_answers_wrongly_is_checked_and_the_next_one_asked(
    install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install("odd_solver", BACKEND.format(solve="return Solution('solved', np.ones(problem.rows.shape[1]))"))
    run = layoutkit("--backend", "odd", "vary", facade, "-n", "2", "--width", "110%", "-o", tmp_path / "out")
    assert run.code == 0
    assert layoutkit("validate", *sorted((tmp_path / "out").glob("variation-*.xml"))).code == 0


def test_a_stage_that_yields_something_else_is_named(install: Any, layoutkit: Any, tmp_path: Path) -> None:
    install(
        "odd_stage",
        """
        from dataclasses import dataclass
        from layoutkit.hooks import Stage, hookimpl
        @dataclass(frozen=True)
        class Options:
            effort: int = 3
        class Audit(Stage):
            name = "odd"
            summary = "Yields nonsense."
            options = Options
            def run(self, facade, options):
                yield 5
        @hookimpl
        def layoutkit_stages():
            return [Audit()]
        """,
    )
    from layoutkit.cli.session import Session
    from layoutkit.diagnostics.blame import Misbehaviour, diagnosed

    session = Session()
    facade = Facade("plain", "m", Region("Plain", 1.0, 1.0))
    with pytest.raises(Misbehaviour, match="yields 5, and no Outcome") as raised:
        next(session.run("odd", facade))
    assert diagnosed(raised.value).message.startswith("the plugin 'odd_stage' of acme-plugin 1.2 failed")


@pytest.mark.parametrize(("version", "hint"), [(0, "upgrade acme-plugin"), (2, "upgrade layoutkit")])
def test_a_plugin_for_another_version_of_the_interface_is_told_apart(
    version: int, hint: str, install: Any, layoutkit: Any
) -> None:
    install("other", f"LAYOUTKIT_API = {version}\n" + FORMAT.format(recognises="return False", read="return"))
    run = layoutkit("plugins", "--json")
    assert run.code == 5
    (told,) = run.data["diagnostics"]
    assert told["code"] == "LK409"
    assert f"is for version {version} of the plugin interface; this layoutkit has 1" in told["message"]
    assert hint in told["hint"]
    assert "other" not in [plugin["name"] for plugin in run.data["plugins"]]


def test_one_prefix_cannot_stand_for_two_namespaces(install: Any, layoutkit: Any) -> None:
    install("alpha", KIND.replace("{method}", ""), package="alpha", version="1")
    other = KIND.replace("{method}", "").replace("urn:odd:1", "urn:odd:2").replace('"rule"', '"law"')
    install("beta", other, package="beta", version="2")
    run = layoutkit("plugins", "--json")
    assert run.code == 5
    (told,) = run.data["diagnostics"]
    assert told["code"] == "LK405"
    assert "plugin 'beta' of beta 2 has a namespace of the prefix 'odd'" in told["message"]
    assert "plugin 'alpha' of alpha 1" in told["message"]
