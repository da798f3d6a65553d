"""Constraints of plugins while a facade is edited: asked of sizes, checked, carried over, and blamed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from layoutkit.constraints import Constraint
from layoutkit.diagnostics.blame import Misbehaviour, diagnosed
from layoutkit.documents import read
from layoutkit.hooks.host import Host
from layoutkit.model import Facade
from layoutkit_editing.constraints.checks import broken
from layoutkit_editing.constraints.rules import asked
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State, Targets
from tests.editing.constraints.house import Outcome, edited, outcome, read_back, refusal, spans_of, wide
from tests.editing.drawn import state_of

EXAMPLES = Path(__file__).parents[3] / "plugins" / "examples"

FACADE = """<facade xmlns="urn:layoutkit:1" {namespace} name="house" units="m">
  <region symbol="H" width="10" height="4" split="rows">
    <region symbol="C" height="1"/>
    <region symbol="F" height="3" split="columns">
      <region symbol="P" width="1"/>
      <region symbol="W" width="2" labels="Window"/>
      <again symbol="P"/>
      <again symbol="W"/>
      <again symbol="P"/>
      <again symbol="W"/>
      <again symbol="P"/>
    </region>
  </region>
  <constraints>
    {constraint}
  </constraints>
</facade>
"""
ODD = """
    from dataclasses import dataclass
    from layoutkit.constraints import Constraint
    from layoutkit.constraints.namespace import Namespace
    from layoutkit.hooks import hookimpl
    from layoutkit.sizing.rules import Range

    @dataclass(frozen=True, kw_only=True)
    class Rule(Constraint):
        kind = "rule"
        namespace = Namespace("odd", "urn:odd:1")
        summary = "Fails in one way or another."
        def violations(self, view):
            return iter(())
        {method}

    @hookimpl
    def layoutkit_constraints():
        return [Rule]
"""

Opened = Callable[[str, str], State]


@pytest.fixture
def kinds() -> Callable[[], Mapping[str, type[Constraint]]]:
    return lambda: Host.load().constraints


@pytest.fixture
def example(install: Callable[..., Path], monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str], None]]:
    """Install an example plugin for one test."""
    before = set(sys.modules)

    def _install(name: str) -> None:
        monkeypatch.syspath_prepend(str(EXAMPLES / name / "src"))
        source = f"from {name} import layoutkit_constraints"
        install(f"their_{name}", source, package=name.replace("_", "-"), version="1.0")

    yield _install
    for name in set(sys.modules) - before:
        if name.partition(".")[0] in ("even_spacings", "golden_windows"):
            del sys.modules[name]


@pytest.fixture
def opened(tmp_path: Path, kinds: Callable[[], Mapping[str, type[Constraint]]]) -> Opened:
    """Return a function that reads the house with one constraint."""

    def _opened(namespace: str, constraint: str) -> State:
        path = tmp_path / "house.xml"
        path.write_text(FACADE.format(namespace=namespace, constraint=constraint))
        facade = read(path, kinds()).model
        assert isinstance(facade, Facade)
        return state_of(facade, windows=("H/F/W", "H/F/W.2", "H/F/W.3"))

    return _opened


EVEN = 'xmlns:spacing="urn:example:even-spacings:1"'
GOLDEN = 'xmlns:golden="urn:example:golden-windows:1"'


def uneven(state: State) -> State:
    """Return the state with one pier wider than the others, if nobody objects."""
    own = state.original.by_path["H/F/P.2"]
    return replace(state, lattices=(), targets=Targets((12.0, None), {(own, 0): 1.8}))


def test_rows_of_one_axis_are_asked_of_sizes(example: Callable[[str], None], opened: Opened) -> None:
    example("even_spacings")
    state = uneven(edited(opened(EVEN, '<spacing:even of="@Window" deviation="0"/>')))
    free = sized(state)
    assert isinstance(free, Sized)
    assert "vary by" in broken(state, free.span)
    found = outcome(state)
    assert found.broken == ""
    children = state.tree.nodes[state.original.by_path["H/F"]].children
    between = [found.sized.span(own, 0) for own in children[2:-2:2]]
    assert [end - start for start, end in between] == pytest.approx([1.8] * 3, abs=1e-6)


def test_convex_rules_are_checked_afterwards(example: Callable[[str], None], opened: Opened) -> None:
    example("even_spacings")
    state = edited(opened(EVEN, '<spacing:even of="@Window" deviation="5%"/>'))
    assert not asked(state).rules
    assert refusal(state) == ""
    told = (
        'it would break spacing:even of="@Window" deviation="5%" (line 15): H/F its spacings of @Window vary'
    )
    assert refusal(uneven(state)).startswith(told)


def test_rules_across_both_axes_are_checked_afterwards(
    example: Callable[[str], None], opened: Opened
) -> None:
    example("golden_windows")
    state = edited(opened(GOLDEN, '<golden:ratio of="H/F/W" ratio="1.5"/>'))
    assert not asked(state).rules
    assert refusal(state) == ""
    assert "golden:ratio" in refusal(wide(state, 12.0))


def test_kinds_of_plugins_are_carried_over(
    example: Callable[[str], None],
    opened: Opened,
    kinds: Callable[[], Mapping[str, type[Constraint]]],
    tmp_path: Path,
) -> None:
    example("golden_windows")
    state = edited(opened(GOLDEN, '<golden:ratio of="H/F/W" tolerance="50%"/>'))
    third = state.tree.nodes[state.original.by_path["H/F"]].children[5]
    state = replace(state, lattices=(), targets=Targets((None, None), {(third, 0): 2.2}))
    found = Outcome(state, outcome(state).sized)
    assert "W_2" in found.word["F"]
    (ratio,) = found.carried.constraints
    assert str(ratio) == 'golden:ratio of="H/F/W | H/F/W_2" tolerance="50%"'
    assert read_back(found.facade, tmp_path, kinds()).constraints == (ratio,)


@pytest.mark.parametrize(
    "method",
    [
        "def violations(self, view):\n            return [view.nothing]",
        "def violations(self, view):\n            yield 3",
    ],
)
def test_a_plugin_that_fails_to_check_is_blamed(
    method: str, install: Callable[..., Path], opened: Opened
) -> None:
    install("odd", ODD.format(method=method), package="odd-rules")
    state = opened('xmlns:odd="urn:odd:1"', "<odd:rule/>")
    with pytest.raises((Misbehaviour, AttributeError)) as failed:
        broken(state, spans_of(state))
    told = diagnosed(failed.value)
    assert told.code == "LK407"
    assert "odd-rules" in told.message


def test_a_plugin_that_asks_sizes_what_makes_no_sense_is_blamed(
    install: Callable[..., Path], opened: Opened
) -> None:
    method = "def size_rules(self, arrangement):\n            yield Range(0, {99: 1.0}, 0.0, 1.0, self)"
    install("odd", ODD.format(method=method), package="odd-rules")
    state = opened('xmlns:odd="urn:odd:1"', "<odd:rule/>")
    with pytest.raises(Misbehaviour) as failed:
        refusal(state)
    assert "odd-rules" in diagnosed(failed.value).message
