"""The built-in constraint kinds use the interface that plugins use, and nothing more.

Each is taken out, and put back by a package from outside: once as the class that it is, once as a copy of its
source under a namespace of its own. Nothing shows of it: layouts are the same to the byte, and so are counts
and explanations, but for the prefix.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import layoutkit.constraints
from layoutkit.constraints import BUILT_IN, Constraint

FACADE = """<facade xmlns="urn:layoutkit:1" xmlns:their="urn:their:1" name="house" units="m">
  <region symbol="H" width="11" height="7.6" split="rows">
    <region symbol="Top" height="0.6" labels="Cornice"/>
    <region symbol="F" height="3" split="columns">
      <region symbol="P" width="1" labels="Pier"/>
      <region symbol="W" width="2" labels="Bay" split="rows">
        <region symbol="Over" height="0.8"/>
        <region symbol="Pane" height="1.6" labels="Window"/>
        <region symbol="Under" height="0.6"/>
      </region>
      <again symbol="P"/>
      <region symbol="X" width="3" labels="Bay"/>
      <again symbol="P"/>
      <again symbol="W"/>
      <again symbol="P"/>
    </region>
    <region symbol="G" height="3" split="columns">
      <region symbol="P" width="1" labels="Pier"/>
      <region symbol="W" width="2" labels="Bay"/>
      <again symbol="P"/>
      <region symbol="X" width="3" labels="Bay Door"/>
      <again symbol="P"/>
      <again symbol="W"/>
      <again symbol="P"/>
    </region>
    <region symbol="Plinth" height="1" split="columns">
      <region symbol="L" width="5.5"/>
      <region symbol="R" width="5.5"/>
    </region>
  </region>
  <constraints>
    <sequence within="H" word="|- Top F"/>
    <sequence within="H" word="F G Plinth -|"/>
    <sequence within="H" word="F F"/>
    <repetition within="H/F" pattern="(P W|P X)+ P"/>
    <replication within="H/G"/>
    <reuse within="H/G" like="H/F"/>
    <reversal within="H/G"/>
    <replication within="H/Plinth"/>
    <two-shuffle within="H/Plinth" of="L R"/>
    <frequency of="@Door" within="H" min="1" max="2"/>
    <frequency of="X" within="H/F" max="2" weight="2"/>
    <same-arrangement of="H/F H/G"/>
    <alignment first="H/F/W" second="H/G/W" lines="left right"/>
    <same-size first="H/F/X" second="H/G/X" dimension="width"/>
    <symmetry of="H/F"/>
    <instances of="H/F/P" max="2"/>
    <lock of="H/G/X" keep="size"/>
    <size of="@Pier" min="70%" max="140%" weight="3"/>
    <size of="@Bay" min="80%" max="130%"/>
    <size of="H/F | H/G" min="85%" max="120%"/>
  </constraints>
</facade>
"""
NARROW = '<size of="H/Top" max="0.5"/>\n    <size of="H/Top" min="0.7"/>'
FUTURE = "from __future__ import annotations\n"
THEIRS = """
from layoutkit.hooks import hookimpl

@hookimpl
def layoutkit_constraints():
    return [{kinds}]
"""


@pytest.fixture
def ended(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Leave no copy of a module behind."""
    yield
    for name in [name for name in sys.modules if name.startswith("their_")]:
        del sys.modules[name]


def alike(kind: type[Constraint]) -> list[type[Constraint]]:
    """Return the kinds that one file declares."""
    return [other for other in BUILT_IN if other.__module__ == kind.__module__]


def copied(kind: type[Constraint]) -> str:
    """Return the source of a kind's file, its kinds under another namespace."""
    source = inspect.getsource(sys.modules[kind.__module__])
    named = r'(    kind: ClassVar\[str\] = "[^"]*"\n)'
    source, times = re.subn(named, r'\1    namespace = Namespace("their", "urn:their:1")' + "\n", source)
    own = alike(kind)
    assert times == len(own)
    source = source.replace(FUTURE, f"{FUTURE}from layoutkit.constraints.namespace import Namespace\n", 1)
    return source + THEIRS.format(kinds=", ".join(other.__name__ for other in own))


def results(layoutkit: Any, folder: Path, text: str) -> dict[str, Any]:
    """Return what the commands make of a facade."""
    folder.mkdir()
    document = folder / "facade.xml"
    document.write_text(text)
    small = ("--scale", "0.05", "-o")
    varied = layoutkit("vary", document, "-n", 2, "--width", "115%", "--seed", 3, *small, folder / "out")
    narrow = folder / "narrow.xml"
    narrow.write_text(text.replace("</constraints>", f"  {NARROW}\n  </constraints>"))
    refused = layoutkit("vary", narrow, "-n", "1", "-o", folder / "none")
    told = refused.err.replace("their:", "").replace(str(folder), "")
    return {
        "valid": layoutkit("validate", document).code,
        "vary": (varied.code, varied.err),
        "layouts": [file.read_bytes() for file in sorted((folder / "out").glob("variation-*.xml"))],
        "count": layoutkit("count", document, "--width", "115%").out,
        "refused": (refused.code, re.sub(" +", " ", told)),
    }


@pytest.fixture(scope="module")
def built_in(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return {"folder": tmp_path_factory.mktemp("built-in")}


@pytest.fixture
def expected(built_in: dict[str, Any], layoutkit: Any) -> dict[str, Any]:
    """Return what the built-in kinds make of it; worked out once."""
    if "results" not in built_in:
        found = results(layoutkit, built_in["folder"] / "work", FACADE)
        assert (found["valid"], found["vary"], found["refused"][0]) == (0, (0, ""), 3)
        assert len(found["layouts"]) == 2
        built_in["results"] = found
    return built_in["results"]


@pytest.fixture(params=BUILT_IN, ids=lambda kind: kind.kind)
def taken_out(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> type[Constraint]:
    """Return a built-in kind that layoutkit does without."""
    kind: type[Constraint] = request.param
    monkeypatch.setattr(layoutkit_constraints(), "BUILT_IN", tuple(k for k in BUILT_IN if k is not kind))
    return kind


def test_a_kind_taken_out_is_unknown(taken_out: type[Constraint], layoutkit: Any, tmp_path: Path) -> None:
    document = tmp_path / "facade.xml"
    document.write_text(FACADE)
    without = layoutkit("validate", document)
    assert without.code == 1
    assert f"there is no constraint kind {taken_out.kind!r}" in without.err


@pytest.mark.nightly  # the other way, below, asks for more
def test_a_kind_put_back_from_outside_does_all_it_did(
    taken_out: type[Constraint], install: Any, layoutkit: Any, expected: dict[str, Any], tmp_path: Path
) -> None:
    kind = taken_out
    install(
        "their_registration",
        f"""
        from {kind.__module__} import {kind.__name__}
        from layoutkit.hooks import hookimpl

        @hookimpl
        def layoutkit_constraints():
            return [{kind.__name__}]
        """,
    )
    assert results(layoutkit, tmp_path / "work", FACADE) == expected


@pytest.mark.parametrize("kind", BUILT_IN, ids=lambda kind: kind.kind)
def test_a_kind_written_outside_does_all_that_the_built_in_one_does(
    kind: type[Constraint],
    install: Any,
    layoutkit: Any,
    expected: dict[str, Any],
    tmp_path: Path,
    ended: None,
) -> None:
    install("their_kinds", copied(kind), package="their-kinds", version="1")
    text = re.sub(rf"<({kind.kind}) ", r"<their:\1 ", FACADE)
    assert text != FACADE
    assert results(layoutkit, tmp_path / "work", text) == expected


def layoutkit_constraints() -> Any:
    return layoutkit.constraints
