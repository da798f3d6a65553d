"""Changes of degree: the round values that are tried, and how few are."""

from __future__ import annotations

import pytest
from conflicting import changed, helps, only, row
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import Constraint, Size
from layoutkit.model import Measure, Region, RegionSet, place
from layoutkit_relayout.explanation.bounds import End, Scale
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.explanation.remedies import edited, first, least

VALUES = st.floats(1e-3, 1e4)


@pytest.mark.parametrize(
    ("start", "end", "counts", "expected"),
    [
        ("1.2", "min", False, ["1.19", "1.18", "1.17"]),
        ("1.2345", "max", False, ["1.24", "1.25", "1.26"]),
        ("14.2", "min", False, ["14.1", "14", "13.9"]),
        ("85%", "min", False, ["84%", "83%", "82%"]),
        ("82.5%", "max", False, ["83%", "84%", "85%"]),
        ("3", "min", True, ["2", "1", "0"]),
        ("0", "max", True, ["1", "2", "3"]),
    ],
)
def test_round_values(start: str, end: End, counts: bool, expected: list[str]) -> None:
    scale = Scale(Measure.parse(start), end, counts)
    assert [str(scale.at(step)) for step in (1, 2, 3)] == expected


@given(VALUES, st.booleans(), st.booleans())
def test_every_step_widens_the_range_and_a_minimum_ends_at_nothing(
    start: float, relative: bool, counts: bool
) -> None:
    down, up = (Scale(Measure(start, relative), end, counts) for end in ("min", "max"))  # type: ignore[arg-type]
    assert start > down.at(1).value or down.at(1).value == 0.0
    assert down.at(1).value >= down.at(2).value >= 0.0
    assert down.at(down.most).value == 0.0
    assert start < up.at(1).value < up.at(2).value


@given(st.integers(1, 5000))
def test_the_first_step_that_holds(wanted: int) -> None:
    assert first(lambda step: step >= wanted, 5000) == wanted
    assert first(lambda step: False, 5000) is None


@given(st.integers(1, 300), st.integers(0, 300), st.integers(0, 40))
def test_the_least_step_is_found_by_few_looks(wanted: int, more: int, slack: int) -> None:
    """A layout of a step needs that step or, with luck, one less; looking for one is what takes long."""
    looks = 0

    def root_at(step: int) -> Region | None:
        nonlocal looks
        looks += 1
        needed = max(wanted, step - slack)
        return Region("R", float(needed), 1.0) if step >= wanted else None

    def needed(root: Region) -> int:
        return int(root.width)

    assert least(root_at, needed, wanted + more) == wanted
    assert looks <= 2 + 2 * (more + 1).bit_length()


def test_edited_arrangements() -> None:
    found = edited(("a", "b", "c"))
    assert ("a", "c") in found
    assert ("a", "b", "b", "c") in found
    assert ("a", "b", "a", "b", "a", "b", "c") in found
    assert ("a", "b", "c") not in found
    assert ("c",) not in found, "less than half of it"
    assert len(edited(tuple("abcdefghij" * 10))) == 160


def test_the_least_change_is_said_and_no_less_helps() -> None:
    """Four of at least 1.2345 m in 4 m: a metre each, and not a centimetre more."""
    sizes: list[Constraint] = [Size(of=RegionSet("R/a"), min=Measure(1.2345))]
    facade = row("aaaa", {"a": 1.5}, sizes)
    (remedy,) = (r for r in only(explain(facade, (4.0, 3.0)).conflicts).remedies if r.member == 0)
    (added,) = remedy.added
    assert isinstance(added, Size)
    assert added.min == Measure(1.0)
    assert remedy.amount is not None
    assert remedy.amount.value == pytest.approx(0.2345)
    assert helps(facade, (4.0, 3.0), remedy)
    assert changed(facade, remedy).constraints == (Size(of=RegionSet("R/a"), min=Measure(1.0)),)


def test_the_size_of_the_facade_that_helps_is_the_nearest() -> None:
    facade = row("aaa", {"a": 1.0}, [Size(of=RegionSet("R/a"), min=Measure(0.97), max=Measure(1.23))])
    for width, expected in ((2.0, 2.91), (5.0, 3.69)):
        remedies = only(explain(facade, (width, 3.0)).conflicts).remedies
        (resized,) = (r for r in remedies if r.size is not None)
        assert resized.size == (pytest.approx(expected), 3.0)
        assert resized.text == f"make the facade {expected:.2f} m wide"
        assert helps(facade, (width, 3.0), resized)


def test_a_best_effort_misses_by_no_more_than_the_remedy() -> None:
    facade = row("aaaa", {"a": 1.5}, [Size(of=RegionSet("R/a"), min=Measure(1.2))])
    effort = explain(facade, (4.0, 3.0)).best_effort
    assert effort is not None
    assert [p.region.width for p in place(effort.root) if p.region.symbol == "a"] == pytest.approx([1.0] * 4)
