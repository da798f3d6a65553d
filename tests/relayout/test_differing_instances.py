"""Instances that have to differ do so, wherever they can; and it is proved where they cannot."""

from __future__ import annotations

import pytest

from layoutkit.constraints import Constraint, Instances, Repetition, SameArrangement, SameSize, Size
from layoutkit.constraints.pattern import Pattern
from layoutkit.model import Extent, Facade, Layout, Measure, Region, RegionSet
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Found, Search

SIZE = (6.0, 3.0)


def bays(*constraints: Constraint) -> Facade:
    """Return two bays of two parts each, side by side."""
    bay = Region("B", 3.0, 3.0, "columns", (Region("x", 1.5, 3.0), Region("y", 1.5, 3.0)))
    return Facade("bays", "m", Region("R", 6.0, 3.0, "columns", (bay, bay)), constraints=constraints)


def differing(path: str = "R/B") -> Instances:
    return Instances(of=RegionSet(path), min=Measure(2.0))


def fixed(path: str, size: float) -> Size:
    return Size(of=RegionSet(path), min=Measure(size), max=Measure(size))


def varied(facade: Facade, size: tuple[float, float] = SIZE) -> Found:
    found = Search(Model(facade), size, BACKENDS).variation(0, 0, 2_000)
    if found.root is not None:
        assert Layout("bays", "m", found.root, facade).violations() == ()
    return found


@pytest.mark.parametrize(
    "rest",
    [
        (Size(of=RegionSet("R/B/x"), min=Measure(1.5), max=Measure(1.5), deviation=Measure(0.0)),),
        (fixed("R/B", 3.0), Size(of=RegionSet("R/B/x"), deviation=Measure(0.0))),
        (Size(of=RegionSet("R/B | R/B/x | R/B/y"), deviation=Measure(0.0)),),
    ],
)
def test_where_every_draw_is_alike_a_size_differs_visibly(rest: tuple[Constraint, ...]) -> None:
    found = varied(bays(differing(), *rest))
    assert found.root is not None
    one, other = found.root.children
    assert max(abs(a.width - b.width) for a, b in zip(one.children, other.children, strict=True)) > 0.05


def test_a_narrow_range_leaves_a_narrow_difference() -> None:
    narrow = Size(of=RegionSet("R/B/x"), min=Measure(1.5), max=Measure(1.501))
    found = varied(bays(differing(), fixed("R/B", 3.0), narrow))
    assert found.root is not None
    one, other = (bay.children[0].width for bay in found.root.children)
    assert 1e-6 < abs(one - other) <= 1e-3 + 1e-6


@pytest.mark.parametrize(
    "rest",
    [
        (fixed("R/B/x", 1.5), fixed("R/B/y", 1.5)),
        (fixed("R/B", 3.0), fixed("R/B/x", 1.5)),
        (
            SameSize(first=Extent(RegionSet("R/B")), dimension="width"),
            SameSize(first=Extent(RegionSet("R/B/x")), dimension="width"),
        ),
    ],
)
def test_it_is_proved_that_no_size_can_differ(rest: tuple[Constraint, ...]) -> None:
    assert varied(bays(differing(), *rest)).status == "infeasible"


def floors(*constraints: Constraint) -> Facade:
    """Return two floors of the same three windows."""
    row = tuple(Region("a", 2.0, 2.0) for _ in range(3))
    made = [Region(symbol, 6.0, 2.0, "columns", row) for symbol in "FG"]
    return Facade("floors", "m", Region("R", 6.0, 4.0, "rows", tuple(made)), constraints=constraints)


def test_floors_agree_though_their_instances_do_not() -> None:
    """One floor has replicas alone, the other three windows that all differ."""
    facade = floors(
        SameArrangement(of=("R/F", "R/G")),
        Instances(of=RegionSet("R/G/a"), min=Measure(3.0)),
        Repetition(within=("R/F",), pattern=Pattern.parse("a+")),
        Repetition(within=("R/G",), pattern=Pattern.parse("a+")),
        Size(of=RegionSet("R/F/a"), min=Measure(1.0)),
        Size(of=RegionSet("R/G/a"), min=Measure(1.0), deviation=Measure(0.0)),
    )
    found = varied(facade, (6.0, 4.0))
    assert found.root is not None
    widths = [[window.width for window in floor.children] for floor in found.root.children]
    assert len(widths[0]) == len(widths[1])
    assert max(widths[0]) - min(widths[0]) < 1e-6
    assert len({round(width, 5) for width in widths[1]}) >= 3


def test_floors_do_not_agree_where_one_has_no_room() -> None:
    facade = floors(
        SameArrangement(of=("R/F", "R/G")),
        Instances(of=RegionSet("R/G/a"), min=Measure(3.0)),
        Repetition(within=("R/F",), pattern=Pattern.parse("a+")),
        Repetition(within=("R/G",), pattern=Pattern.parse("a+")),
        Size(of=RegionSet("R/F/a"), min=Measure(2.5)),
        Size(of=RegionSet("R/G/a"), min=Measure(0.5)),
    )
    assert varied(facade, (6.0, 4.0)).status == "infeasible"
