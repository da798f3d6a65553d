"""The promises of every constraint kind; and the search compared with brute force over all words."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby, pairwise, product

import pytest
from shop_doors.constraints import Apart, Mixed

from layoutkit.constraints import Constraint, Sequence, Size
from layoutkit.diagnostics import Place
from layoutkit.hooks.host import Host
from layoutkit.model import Facade, Measure, Region, RegionSet, Word
from layoutkit.testing import ConstraintSuite

#: Widths of the symbols of a row: whole numbers, so that which words fit is told by a sum.
WIDTHS = {"Door": 1.0, "Show": 2.0, "Pier": 1.0}
LABELS = {"Door": ("Door",), "Show": ("Shop",), "Pier": ("Wall",)}


class TestApart(ConstraintSuite):
    kind = Apart
    elements = ['<shop:apart of="@Door"/>', '<shop:apart of="@Door | @Shop" across="@Wall" weight="1"/>']


class TestMixed(ConstraintSuite):
    kind = Mixed
    elements = [
        '<shop:mixed within="Facade"/>',
        '<shop:mixed within="Facade" run="2" across="@Wall | @Roof"/>',
    ]


def row(*constraints: Constraint) -> Facade:
    """Return a row of doors, show windows and piers in any order, each of one width."""
    children = tuple(Region(s, WIDTHS[s], 3.0, labels=LABELS[s]) for s in ("Door", "Show", "Pier"))
    root = Region("Row", 4.0, 3.0, "columns", children)
    any_of = RegionSet.union(WIDTHS)
    free = (
        Sequence(within=("Row",), word=Word((any_of,), at_start=True)),
        Sequence(within=("Row",), word=Word((any_of, any_of))),
        Sequence(within=("Row",), word=Word((any_of,), at_end=True)),
    )
    fixed = tuple(
        Size(of=RegionSet(f"Row/{s}"), min=Measure(1.0, True), max=Measure(1.0, True)) for s in WIDTHS
    )
    return Facade("row", "m", root, constraints=(*free, *fixed, *constraints))


def words(width: int) -> list[tuple[str, ...]]:
    """Return all words that are so wide."""
    return [
        word
        for length in range(1, width + 1)
        for word in product(WIDTHS, repeat=length)
        if sum(WIDTHS[s] for s in word) == width
    ]


def apart(word: tuple[str, ...], across: tuple[str, ...]) -> bool:
    kept = [symbol for symbol in word if symbol not in across]
    return ("Door", "Door") not in pairwise(kept)


def mixed(word: tuple[str, ...], run: int, across: tuple[str, ...]) -> bool:
    kept = [symbol for symbol in word if symbol not in across]
    return all(len(list(group)) < run for _, group in groupby(kept))


WALL = RegionSet.parse("@Wall")
CASES = [
    ((Apart(of=RegionSet.parse("@Door")),), lambda w: apart(w, ())),
    ((Apart(of=RegionSet.parse("@Door"), across=WALL),), lambda w: apart(w, ("Pier",))),
    ((Mixed(within=("Row",)),), lambda w: mixed(w, 3, ())),
    ((Mixed(within=("Row",), run=2, across=WALL),), lambda w: mixed(w, 2, ("Pier",))),
    (
        (Apart(of=RegionSet.parse("@Door"), across=WALL), Mixed(within=("Row",))),
        lambda w: apart(w, ("Pier",)) and mixed(w, 3, ()),
    ),
]


@pytest.mark.parametrize("width", [1, 4, 7, 9])
@pytest.mark.parametrize("case", range(len(CASES)))
def test_the_search_finds_as_many_words_as_brute_force(case: int, width: int) -> None:
    constraints, admits = CASES[case]
    stage = Host.load().stages.find("count")
    options = replace(stage.options(), width=Measure(float(width)))
    (outcome,) = stage.run(row(*constraints), options)
    assert outcome.count is not None
    expected = sum(map(admits, words(width)))
    assert (outcome.count.least, outcome.count.most) == (expected, expected)


@pytest.mark.parametrize("case", range(len(CASES)))
def test_what_is_drawn_evenly_is_admitted_and_checked(case: int) -> None:
    constraints, admits = CASES[case]
    stage = Host.load().stages.find("relayout")
    options = replace(stage.options(), count=20, width=Measure(9.0), sampling="uniform")
    found = {outcome.document.root.word for outcome in stage.run(row(*constraints), options)}
    assert len(found) > 10
    assert all(map(admits, found))


def test_what_cannot_be_is_refused_with_a_proof() -> None:
    only = RegionSet.union(["Door"])
    doors = (
        Sequence(within=("Row",), word=Word((only,), at_start=True)),
        Sequence(within=("Row",), word=Word((only, only))),
        Sequence(within=("Row",), word=Word((only,), at_end=True)),
    )
    facade = row(Apart(of=RegionSet.parse("@Door")))
    kept = tuple(c for c in facade.constraints if not isinstance(c, Sequence))
    stage = Host.load().stages.find("relayout")
    options = replace(stage.options(), count=1, width=Measure(3.0))
    (outcome,) = stage.run(replace(facade, constraints=(*doors, *kept)), options)
    assert outcome.status == "infeasible"


def test_a_run_of_one_is_a_fault() -> None:
    place = Place("shops.xml", 3, 5)
    (fault,) = Mixed(within=("Row",), run=1, place=place).faults(row())
    assert (fault.code, fault.place) == ("SHOP1", place)
