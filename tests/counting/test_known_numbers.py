"""Numbers of arrangements that are known by formulas, however large."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import comb, inf
from typing import ClassVar

import pytest
from countable import anything, row, search, sequences, sized, stack
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
)
from layoutkit.model import Count, Extent, Facade, Measure, Region, RegionSet
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Range, SizeRule
from layoutkit_relayout.counting.census import Census
from layoutkit_relayout.counting.counted import counted

EFFORT = 20_000
ONE = {"a": (1.0, 1.0), "b": (1.0, 1.0)}
ONE_OR_TWO = {"a": (1.0, 1.0), "b": (2.0, 2.0)}
LOOSE = {"a": (1.0, 2.0)}


def fibonacci(number: int) -> int:
    one, other = 0, 1
    for _ in range(number):
        one, other = other, one + other
    return one


def number(facade: Facade, width: float, height: float = 0.0) -> int:
    found = counted(search(facade, width, height), EFFORT)
    assert found.kind == "exact", found
    assert found.size == (width, height or facade.root.height)
    return found.least


@pytest.mark.parametrize("bays", [1, 2, 10, 64, 200])
def test_bays_of_two_kinds(bays: int) -> None:
    assert number(row(ONE), bays) == 2**bays


@pytest.mark.parametrize("length", [1, 2, 3, 30, 100])
def test_bays_of_one_and_two_metres(length: int) -> None:
    assert number(row(ONE_OR_TWO), length) == fibonacci(length + 1)


@pytest.mark.parametrize("chosen", [0, 1, 7, 20, 40])
def test_a_frequency_chooses(chosen: int) -> None:
    exactly = Measure(float(chosen))
    facade = row(ONE, Frequency(of=RegionSet("a"), within="R", min=exactly, max=exactly))
    assert number(facade, 40) == comb(40, chosen)


@pytest.mark.parametrize("bays", [4, 5, 60, 61])
def test_words_that_mirror_themselves(bays: int) -> None:
    assert number(row(ONE, Symmetry(of=("R",))), bays) == 2 ** (bays - bays // 2)


def test_floors_have_nothing_to_do_with_each_other() -> None:
    assert number(stack({"F": ONE, "G": ONE_OR_TWO, "H": ONE}), 30) == 2**60 * fibonacci(31)


def test_floors_that_agree() -> None:
    agree = SameArrangement(of=("R/F", "R/H"))
    assert number(stack({"F": ONE, "G": ONE_OR_TWO, "H": ONE}, agree), 30) == 2**30 * fibonacci(31)


@pytest.mark.parametrize("storeys", [1, 2, 3, 12])
def test_only_floors_that_stand_there_count(storeys: int) -> None:
    facade = stack(
        {"F": ONE, "G": ONE_OR_TWO}, *anything("R", "FG"), *sized("R", dict.fromkeys("FG", (3, 3)))
    )
    one, other = 2**20, fibonacci(21)
    both = (2**storeys - 2) * one * other
    assert number(facade, 20, 3 * storeys) == one + other + both


def test_a_loose_bay_fits_in_several_numbers() -> None:
    # From 6 to 12 bays of 1 to 2 m fill 12 m.
    assert number(row(LOOSE), 12) == 7


def test_equal_sizes_tie_floors_together() -> None:
    tied = SameSize(first=Extent(RegionSet("R/F/a")), second=Extent(RegionSet("R/G/a")), dimension="width")
    assert number(stack({"F": LOOSE, "G": LOOSE}), 12) == 49
    assert number(stack({"F": LOOSE, "G": LOOSE}, tied), 12) == 7


def test_lines_tie_floors_together() -> None:
    lines = Alignment(first=RegionSet("R/F/a"), second=RegionSet("R/G/a"), lines=("left", "right"))
    assert number(stack({"F": LOOSE, "G": LOOSE}, lines), 12) == 7


def test_words_alone_do_not_suffice() -> None:
    # F has bays of 1 m and 2 m, G bays of 1 m: where all bays must be in line, F has none of 2 m.
    lines = Alignment(
        first=RegionSet.union(["R/F/a", "R/F/b"]), second=RegionSet("R/G/a"), lines=("left", "right")
    )
    assert number(stack({"F": ONE_OR_TWO, "G": {"a": (1.0, 1.0)}}, lines), 6) == 1


def test_instances_of_a_region_are_no_other_arrangements() -> None:
    assert number(row(LOOSE, Instances(of=RegionSet("R/a"))), 6) == 4


def test_instances_may_have_arrangements_of_their_own() -> None:
    bay = Region("B", 2.0, 3.0, "columns", (Region("x", 1.0, 3.0), Region("y", 1.0, 3.0)))
    root = Region("R", 6.0, 3.0, "columns", (bay, bay, bay))
    inside = [*sized("R/B", {"x": (1, 1), "y": (1, 1)}), *anything("R/B", "xy")]
    replicas = Facade("bays", "m", root, constraints=tuple(inside))
    assert number(replicas, 6) == 4
    own: list[Constraint] = [*inside, Size(of=RegionSet("R/B"), min=Measure(2.0), max=Measure(2.0))]
    varied = Facade("bays", "m", root, constraints=(*own, Instances(of=RegionSet("R/B"))))
    assert number(varied, 6) == 4**3
    two = Facade("bays", "m", root, constraints=(*own, Instances(of=RegionSet("R/B"), max=Measure(2.0))))
    assert number(two, 6) == 4 + 3 * 4 * 3


@dataclass(frozen=True, kw_only=True)
class Broad(Constraint):
    """A kind that a plugin might add: all regions of a path are so broad at least."""

    kind: ClassVar[str] = "broad"
    summary: ClassVar[str] = "So broad at least."
    of: str = ""
    least: float = 0.0

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        if self.of in arrangement.frames:
            yield Range(0, arrangement.extent(self.of, 0), self.least, inf, self)


def test_kinds_that_plugins_add_count() -> None:
    """Nothing is known of them, so that whole layouts are tried."""
    # From 6 to 8 bays of 1.5 to 2 m fill 12 m; on either floor by itself.
    broad = Broad(of="R/F/a", least=1.5)
    assert number(stack({"F": LOOSE, "G": LOOSE}, broad), 12) == 3 * 7
    assert number(row(LOOSE, Broad(of="R/a", least=1.5)), 12) == 3


def test_nothing_fits() -> None:
    found = counted(search(row(ONE), 10.5), EFFORT)
    assert (found.kind, found.least, found.most) == ("exact", 0, 0)


def test_a_region_that_no_word_leads_to_does_not_count() -> None:
    floors = stack({"F": ONE, "G": ONE}, *sequences("R", "⊢ F ⊣"))
    assert number(floors, 10, 3) == 2**10


SIZES = st.tuples(st.integers(1, 4), st.integers(0, 3)).map(lambda pair: (pair[0], sum(pair)))


@settings(max_examples=60)
@given(st.lists(SIZES, min_size=1, max_size=3), st.integers(1, 9))
def test_rows_of_any_bays(sizes: Sequence[tuple[int, int]], length: int) -> None:
    """Every word is tried: whole numbers, so that nothing is rounded."""
    widths = dict(zip("abc", sizes, strict=False))
    words = [word for n in range(1, length + 1) for word in product(widths, repeat=n)]
    fitting = {
        word for word in words if sum(widths[s][0] for s in word) <= length <= sum(widths[s][1] for s in word)
    }
    facade = row({name: (float(low), float(high)) for name, (low, high) in widths.items()})
    census = Census(search(facade, length), EFFORT)
    assert census.ways.exact
    found = [census.words(rank)["R"] for rank in range(census.ways.most)]
    assert len(found) == len(set(found))
    assert set(found) == fitting


@pytest.mark.parametrize(
    ("least", "most", "kind"), [(5, 5, "exact"), (5, None, "at least"), (0, 5, "at most"), (2, 5, "between")]
)
def test_what_a_count_is(least: int, most: int | None, kind: str) -> None:
    assert Count((1.0, 1.0), least, most, "").kind == kind
