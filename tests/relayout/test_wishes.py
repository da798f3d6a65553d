"""Soft constraints are kept where they can be, the weightier ones first; a note says which are not."""

from __future__ import annotations

from typing import Any

import pytest

from layoutkit.constraints import Constraint, Frequency, Sequence, Size
from layoutkit.constraints.checking import checked
from layoutkit.hooks import Outcome
from layoutkit.model import Facade, Layout, Measure, Region, RegionSet, Word
from layoutkit_relayout.stage import Relayout, RelayoutOptions

FREE = [Sequence(within=("R",), word=Word.parse(word)) for word in ("⊢ {a b}", "{a b} {a b}", "{a b} ⊣")]
FIXED = Size(of=RegionSet.parse("R/a | R/b"), min=Measure(1.0), max=Measure(1.0))


def at_least(symbol: str, number: float, weight: float | None) -> Constraint:
    return Frequency(of=RegionSet.parse(symbol), within="R", min=Measure(number), weight=weight)


def made(*constraints: Constraint, **options: Any) -> tuple[list[Outcome], Facade]:
    """Vary a row of four places, each for an a or a b."""
    root = Region("R", 4.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in "abab"))
    facade = Facade("row", "m", root, constraints=(*FREE, FIXED, *constraints))
    return list(Relayout().run(facade, RelayoutOptions(count=3, **options))), facade


def words(outcomes: list[Outcome]) -> list[str]:
    found = [outcome.document for outcome in outcomes]
    assert all(isinstance(layout, Layout) for layout in found)
    return ["".join(layout.root.word) for layout in found if isinstance(layout, Layout)]


def test_what_can_be_kept_together_is() -> None:
    outcomes, _ = made(at_least("a", 2, 1.0), at_least("b", 2, 5.0))
    assert all(word.count("a") == 2 for word in words(outcomes))
    assert [d.code for o in outcomes for d in o.diagnostics] == []


@pytest.mark.parametrize(("heavy", "light"), ["ab", "ba"])
def test_the_weightier_one_is_kept(heavy: str, light: str) -> None:
    outcomes, facade = made(at_least(light, 3, 1.0), at_least(heavy, 3, 2.0))
    assert all(word.count(heavy) >= 3 for word in words(outcomes))
    notes = [d for outcome in outcomes for d in outcome.diagnostics]
    assert [(d.code, f'of="{light}"' in d.message) for d in notes] == [("LK603", True)], "it is said once"
    assert isinstance(outcomes[0].document, Layout)
    assert {str(v.constraint) for v in checked(outcomes[0].document, facade).unkept} == {
        str(at_least(light, 3, 1.0))
    }


def test_of_equal_ones_the_earlier_one_is_kept_and_later_ones_that_fit_with_it() -> None:
    outcomes, _ = made(at_least("a", 3, 1.0), at_least("b", 3, 1.0), at_least("b", 1, 1.0))
    assert all((word.count("a"), word.count("b")) == (3, 1) for word in words(outcomes))


def test_a_hard_one_is_never_given_up() -> None:
    outcomes, _ = made(at_least("a", 4, None), at_least("b", 1, 9.0))
    assert words(outcomes) == ["aaaa"] * 3
    outcomes, _ = made(at_least("a", 4, None), at_least("b", 1, None), at_least("b", 2, 1.0))
    assert [outcome.status for outcome in outcomes] == ["infeasible"] * 3
