"""A plugin's constraint that fails, or answers nonsense: it is named, and nothing else is lost."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import pytest
from odd_kind import FACADE, KIND

#: With a constraint that names what is not there.
MORE = FACADE.replace("<odd:rule/>", '<odd:rule/>\n    <frequency of="C" within="R" max="2"/>')

SIZE = "def size_rules(self, arrangement):\n    "
WORD = "@classmethod\ndef word_rules(cls, constraints, facade):\n    "
CONVEX = (
    "from layoutkit.sizing.rules import Convex\n    yield Convex((arrangement.size('R/A', 0),), {}, self)"
)
#: What the kind does, and what is said of it by `vary`.
IN_THE_SEARCH = {
    "rules that raise": (SIZE + "yield 1 / 0", "ZeroDivisionError: division by zero"),
    "a row without numbers": (
        SIZE + "yield Range(0, {1: nan}, 0.0, 1.0, self)",
        "gives a row of what is no number",
    ),
    "an end without a number": (
        SIZE + "yield Range(0, {1: 1.0}, nan, 1.0, self)",
        "gives a row of what is no number",
    ),
    "an axis that is none": (SIZE + "yield Range(3, {1: 1.0}, 0.0, 1.0, self)", "names the axis 3"),
    "a variable that is none": (
        SIZE + "yield Range(0, {99: 1.0}, 0.0, 1.0, self)",
        "names variables that axis 0 has not",
    ),
    "no rule at all": (SIZE + "yield 'wide'", "gives 'wide' for a rule on sizes"),
    "rows of the wrong shape": (
        SIZE + "yield Rows((arrangement.size('R/A', 0),), np.ones((1, 2)), np.zeros(1), np.ones(1), self)",
        "whose matrix and ends are of shapes (1, 2), (1,), (1,)",
    ),
    "rows without numbers": (
        SIZE
        + "yield Rows((arrangement.size('R/A', 0),), np.full((1, 1), nan), np.zeros(1), np.ones(1), self)",
        "gives rows of what is no number",
    ),
    "quantities that are none": (
        SIZE + "yield Rows((3,), np.ones((1, 1)), np.zeros(1), np.ones(1), self)",
        "relates quantities that are none",
    ),
    "a target without a number": (
        SIZE + "yield Target(0, {1: 1.0}, inf, 1.0, 0.0, 1.0)",
        "gives a target of what is no number",
    ),
    "a concave excess": (
        SIZE + CONVEX.format("lambda x: __import__('cvxpy').sqrt(x)"),
        "gives an excess that is not convex by cvxpy's rules",
    ),
    "an excess that is no expression": (
        SIZE + CONVEX.format("lambda x: 3.0"),
        "gives 3.0 for an excess, and no cvxpy expression",
    ),
    "an excess that raises": (SIZE + CONVEX.format("lambda x: 1 / 0"), "ZeroDivisionError"),
    "word rules that raise": (WORD + "raise KeyError('lost')", "KeyError: 'lost'"),
    "no rule on words": (WORD + "return [4]", "gives a rule on words that is none: 4"),
    "no automaton": (WORD + "yield Admits('R', 5, constraints)", "has no automaton: 5 has no start()"),
    "a region that is none": (
        WORD + "yield Admits('Q', Automaton(), constraints)",
        "speaks of 'Q', which is no divided region",
    ),
    "counts of what is not there": (
        WORD + "yield Counts('R', frozenset({'R/Q'}), Bound(0, False), Bound(1, False), constraints)",
        "counts 'R/Q', which the facade has not",
    ),
    "counts without a number": (
        WORD + "yield Counts('R', frozenset({'R/A'}), Bound(nan, False), Bound(1, False), constraints)",
        "for a bound",
    ),
    "an automaton that raises": (
        WORD + "Automaton.step = lambda self, state, symbol: [][0]\n    "
        "yield Admits('R', Automaton(), constraints)",
        "IndexError: list index out of range",
    ),
    "states that cannot be kept": (
        WORD + "Automaton.step = lambda self, state, symbol: []\n    "
        "yield Admits('R', Automaton(), constraints)",
        "gives a state that is not hashable",
    ),
    "claims that raise": ("def claims(self, facade):\n    return 1 / 0", "ZeroDivisionError"),
    "a claim that is none": ("def claims(self, facade):\n    yield 'wide'", "is no claim: 'wide'"),
    "a claim about nothing": (
        "def claims(self, facade):\n    yield Sized('R/Q', 0.0, 1.0, 1.0, 1.0)",
        "is not there: 'R/Q'",
    ),
    "a claim without a number": (
        "def claims(self, facade):\n    yield Sized('R/A', nan, 1.0, 1.0, 1.0)",
        "is no number",
    ),
    "ties that raise": ("def ties(self, facade):\n    raise OSError('cut')", "OSError: cut"),
    "ties of nothing": ("def ties(self, facade):\n    yield 5, ('R/Q',)", "ties"),
    "a check that raises": ("def violations(self, view):\n    yield 1 / 0", "ZeroDivisionError"),
    "a check without a number": (
        "def violations(self, view):\n    yield Violation(self, 'R', 'is off', nan)",
        "whose amount is no number",
    ),
    "a program that is ended": (SIZE + "raise SystemExit(0)", "SystemExit: 0"),
    "an error that is no Exception": (
        "def violations(self, view):\n    class Panic(BaseException): pass\n    raise Panic('at once')",
        "Panic: at once",
    ),
    "a line that is along no axis": (
        "def claims(self, facade):\n    yield InLine(7, ('R/A',), ('R/B',), (0.0,))",
        "is along no axis: 7",
    ),
    "a line of what is not there": (
        "def claims(self, facade):\n    yield InLine(0, ('R/X',), ('R/B',), (0.0,))",
        "is not there: 'R/X'",
    ),
    "equal sizes of what are no extents": (
        "def claims(self, facade):\n    yield EquallyLarge(0, ('R/A', 'R/B'))",
        "is no extent: 'R/A'",
    ),
    "a check that answers something else": (
        "def violations(self, view):\n    yield 'R'",
        "gives 'R' for a violation",
    ),
}


def install_rule(install: Any, method: str) -> None:
    body = KIND.replace("{method}", textwrap.indent(method, "    "))
    install("odd_rules", body, package="odd-rules", version="2.5")


@pytest.fixture
def facade(tmp_path: Path) -> Path:
    (tmp_path / "facade.xml").write_text(FACADE)
    return tmp_path / "facade.xml"


@pytest.mark.parametrize("name", IN_THE_SEARCH)
def test_a_constraint_that_fails_in_the_search_is_named(
    name: str, install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    method, told = IN_THE_SEARCH[name]
    install_rule(install, method)
    run = layoutkit("vary", facade, "-n", "1", "--width", "110%", "-o", tmp_path / "out")
    assert run.code == 5, run.err
    assert "plugin 'odd_rules' of odd-rules 2.5 failed" in run.err
    assert told in run.err, run.err
    assert "error LK407" in run.err


def test_a_check_that_fails_hides_no_other_fault(
    install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install_rule(install, "")
    assert layoutkit("vary", facade, "-n", "1", "-o", tmp_path / "out").code == 0
    layout = tmp_path / "out" / "variation-01.xml"
    other = tmp_path / "out" / "facade.xml"
    other.write_text(other.read_text().replace("<odd:rule", '<size of="R/B" max="1"/><odd:rule'))
    assert layoutkit("validate", layout).code == 1
    for name in [name for name in sys.modules if name == "odd_rules"]:
        del sys.modules[name]
    install_rule(install, IN_THE_SEARCH["a check that raises"][0])
    run = layoutkit("validate", layout)
    assert run.code == 5
    assert "LK502" in run.err, "the size is broken all the same"
    assert re.search(
        r"facade\.xml:\d+:\d+: error LK407 plugin: the constraint kind 'odd:rule' of the plugin", run.err
    )


@pytest.mark.parametrize(
    ("method", "told"),
    [
        ("def faults(self, facade):\n    raise LookupError('gone')", "LookupError: gone"),
        ("def faults(self, facade):\n    yield 'bad'", "gives 'bad' for a fault"),
        ("def __post_init__(self):\n    raise RuntimeError('not today')", "RuntimeError: not today"),
    ],
)
def test_a_constraint_that_fails_when_it_is_read_is_named_at_its_place(
    method: str, told: str, install: Any, layoutkit: Any, tmp_path: Path
) -> None:
    (tmp_path / "facade.xml").write_text(MORE)
    install_rule(install, method)
    run = layoutkit("validate", tmp_path / "facade.xml")
    assert run.code == 5
    assert (
        "facade.xml:9:5: error LK407 plugin: the constraint kind 'odd:rule' of the plugin 'odd_rules'"
        in run.err
    )
    assert told in run.err, run.err
    assert "facade.xml:10:5: error LK201" in run.err, "other faults are told as well"


def test_what_was_made_before_a_failure_is_kept(
    install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install_rule(
        install,
        """
times = []
def violations(self, view):
    type(self).times.append(1)
    if len(self.times) > 2:
        raise RuntimeError("tired")
    return iter(())
""".replace("times = []", "from typing import ClassVar\ntimes: ClassVar = []"),
    )
    run = layoutkit("vary", facade, "-n", "6", "--json", "-o", tmp_path / "out")
    assert run.code == 5
    made = [file.name for file in sorted((tmp_path / "out").glob("variation-*.xml"))]
    assert made
    assert [Path(v["layout"]).name for v in run.data["variations"]] == made
    assert (tmp_path / "out" / "sheet.png").exists()
    assert "facade.xml:9:5: error LK407 plugin: the constraint kind 'odd:rule' of the plugin" in run.err
    assert "RuntimeError: tired\n  in violations(), " in run.err
    assert "RuntimeError: tired" in run.data["diagnostics"][-1]["message"]


@pytest.mark.parametrize(
    ("relation", "told"),
    [
        ("3", "says that it relates 3, which is no Relates"),
        ("Relates(frozenset({('R/Q', 0)}))", "says that it relates 'R/Q', which is not there"),
        ("Relates(words=('R/Q',))", "says that it relates 'R/Q', which is not there"),
        ("Relates(words=('R/A',))", "says that it hangs on words of R/A, which has none"),
    ],
)
def test_relations_are_looked_over(
    relation: str, told: str, install: Any, layoutkit: Any, facade: Path
) -> None:
    install_rule(install, f"def relations(self, facade):\n    return [{relation}]")
    run = layoutkit("count", facade, "--width", "110%")
    assert run.code == 5
    assert told in run.err


def test_words_that_mirror_need_not_be_of_equal_sizes(install: Any, layoutkit: Any, tmp_path: Path) -> None:
    method = """
@classmethod
def word_rules(cls, constraints, facade):
    from layoutkit.constraints.word_rules import Mirrored
    yield Mirrored("R", {"A": ("B",), "B": ("A",), "C": ("C",)}, tuple(constraints))
"""
    document = FACADE.replace('<again symbol="A"/>', '<region symbol="C" width="1"/>')
    document = document.replace('pattern="(A|B)+"', 'pattern="A B C"').replace("A B C", "A C+ B")
    document = document.replace(
        "</constraints>", '<size of="R/A" max="2"/><size of="R/B" min="3" max="5"/></constraints>'
    )
    (tmp_path / "facade.xml").write_text(document)
    install_rule(install, method)
    for command in ("vary", "explain"):
        run = layoutkit(command, tmp_path / "facade.xml", "-o", tmp_path / command)
        assert run.code == 0, run.err


STUCK = {
    "at import": ("", "import time\nwhile True: time.sleep(1)\n"),
    "in a hook": ("", "@hookimpl\ndef layoutkit_formats():\n    while True: pass\n"),
    "in the search": (WORD + "while True: pass", ""),
    "in a check": ("def violations(self, view):\n    import time\n    time.sleep(1e6)", ""),
}


@pytest.mark.parametrize("name", STUCK)
def test_a_plugin_that_does_not_come_to_an_end_is_stopped(
    name: str, install: Any, facade: Path, tmp_path: Path
) -> None:
    method, more = STUCK[name]
    body = KIND.replace("{method}", textwrap.indent(method, "    ")) + more
    folder = install("odd_rules", body, package="odd-rules", version="2.5")
    command = ["vary", str(facade), "-n", "1", "-o", str(tmp_path / "out")]
    if name == "in a hook":
        command = ["plugins"]
    path = os.pathsep.join([str(folder), os.environ.get("PYTHONPATH", "")])
    run = subprocess.run(
        [sys.executable, "-m", "layoutkit", *command],
        env={**os.environ, "PYTHONPATH": path, "LAYOUTKIT_PLUGIN_PATIENCE": "1.5"},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert run.returncode == 5, run.stderr
    assert "plugin 'odd_rules' of odd-rules 2.5" in run.stderr
    assert "did not come to an end" in run.stderr
    assert "Traceback" not in run.stderr


def test_a_constraint_that_ends_the_program_hides_no_other_document(
    install: Any, layoutkit: Any, facade: Path, tmp_path: Path
) -> None:
    install_rule(install, SIZE + "raise SystemExit(0)")
    facade.write_text(FACADE.replace('width="6"', 'width="7"').replace('width="4"', 'width="5"'))
    sizes = '<size of="R/A" min="2"/>'
    facade.write_text(facade.read_text().replace("<odd:rule/>", f"<odd:rule/>{sizes}"))
    broken = tmp_path / "broken.xml"
    broken.write_text("<facade")
    run = layoutkit("validate", facade, broken)
    assert run.code == 5
    assert "SystemExit: 0" in run.err
    assert "LK002" in run.err, "the next document is checked all the same"
