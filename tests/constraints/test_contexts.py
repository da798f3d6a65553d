"""Contexts: an alignment or a same size that only asks regions between certain neighbours."""

from __future__ import annotations

import pytest
from houses import broken, floor, house, stacked, with_rows
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import Alignment, Constraint, SameSize, Sequence
from layoutkit.constraints.contexts import Context
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Extent, Facade, Layout, Region, RegionSet, Word

CORNICE = Region("C", 7.0, 0.5, labels=("Cornice",))
FREE = [Sequence(within=("H/F", "H/G"), word=Word.parse(text)) for text in ("⊢ P", "{P B} {P B}", "P ⊣")]


def regions(text: str) -> RegionSet:
    return RegionSet.parse(text)


def paths(constraint: Constraint, upper: Region, lower: Region) -> list[tuple[str, float]]:
    """Return where a house with these two floors breaks the constraint, and by how much."""
    facade = house(constraint, *FREE)
    found = broken(facade, with_rows(facade, CORNICE, upper, lower))
    return [(v.path, round(v.amount, 9)) for v in found if v.constraint is constraint]


MOVED = floor("G", "PBPBP", 3.5, {"P": 0.8, "B": 2.3})
"""Its first bay is off by 0.2 on the left and 0.1 on the right, its second the other way round."""


@pytest.mark.parametrize(
    ("first_before", "first_after", "expected"),
    [
        (None, None, [("H/F/B", 0.2), ("H/F/B.2", 0.1)]),
        ("⊢ P", None, [("H/F/B", 0.2)]),
        ("B @Pier", None, [("H/F/B.2", 0.1)]),
        (None, "P ⊣", [("H/F/B.2", 0.1)]),
        (None, "P B", [("H/F/B", 0.2)]),
        ("P", "{P B}", [("H/F/B", 0.2), ("H/F/B.2", 0.1)]),
        ("⊢ P", "P ⊣", []),
        ("⊢", None, []),
        ("P P", None, []),
    ],
)
def test_bays_align_only_between_such_neighbours(
    first_before: str | None, first_after: str | None, expected: list[tuple[str, float]]
) -> None:
    constraint = Alignment(
        first=regions("H/F/B"),
        second=regions("H/G/B"),
        lines=("left",),
        first_before=first_before and Word.context(first_before),
        first_after=first_after and Word.context(first_after),
    )
    assert paths(constraint, floor("F", "PBPBP"), MOVED) == expected


def test_the_context_of_the_second_regions() -> None:
    constraint = Alignment(
        first=regions("@Bay"), second=regions("H/G/B"), lines=("right",), second_after=Word.context("P ⊣")
    )
    # The last bay of G ends at 6.2, that of F at 6; within G there is nothing to be out of line with.
    assert paths(constraint, floor("F", "PBPBP"), MOVED) == [("H/F/B.2", 0.2)]


def test_a_context_across_the_lines_is_read_in_the_parent_s_word() -> None:
    """Floors stand in rows, and have left ends all the same: only the floor below the cornice is asked."""
    inner = Region("W", 7.0, 3.0, "columns", (Region("A", 1.0, 3.0), Region("B", 6.0, 3.0)))
    other = Region("V", 7.0, 3.0, "columns", (Region("A", 2.0, 3.0), Region("B", 5.0, 3.0)))
    cornice = Region("C", 7.0, 0.5)

    def gaps(before: str, *rows: Region) -> list[float]:
        constraint = Alignment(
            first=regions("H/W"), second=regions("H/V/B"), lines=("left",), first_before=Word.context(before)
        )
        facade = Facade("f", "m", stacked(cornice, inner, other), constraints=(constraint,))
        return [v.amount for v in broken(facade, stacked(*rows)) if v.constraint is constraint]

    assert gaps("C", cornice, inner, other) == [2.0]
    assert gaps("C", inner, cornice, other) == []
    assert gaps("⊢", inner, cornice, other) == [2.0]


def bays(symbol: str, *above: float) -> Region:
    """A floor whose windows hang that far below its top."""
    made = []
    for number, height in enumerate(above):
        parts = (Region("Wall", 1.0, height), Region("Win", 1.0, 3.0 - height, labels=("Window",)))
        made.append(Region(f"Bay{number}", 1.0, 3.0, "rows", parts))
    return Region(symbol, float(len(made)), 3.0, "columns", tuple(made))


def test_only_what_is_inside_the_encompassing_region_is_asked() -> None:
    """Windows of a floor F are level with one another; those of other floors need not be."""
    level = Alignment(first=regions("@Window"), second=regions("@Window"), lines=("top",), within="H/F")
    facade = Facade("f", "m", stacked(bays("F", 1.0, 1.0), bays("G", 1.0, 1.0)), constraints=(level,))
    assert broken(facade, stacked(bays("F", 1.25, 1.25), bays("G", 1.0, 1.5))) == []
    (found,) = broken(facade, stacked(bays("F", 1.25, 1.0), bays("G", 1.0, 1.5)))
    assert (found.path, found.amount) == ("H/F/Bay0/Win", 0.25)


def test_the_root_stands_between_no_neighbours() -> None:
    constraint = Alignment(
        first=regions("H"), second=regions("H/F/B"), lines=("left",), first_before=Word.context("⊢")
    )
    assert paths(constraint, floor("F", "PBPBP"), MOVED) == []


def test_regions_of_the_same_size_only_between_such_neighbours() -> None:
    """Bays behind the first pier are as wide as other bays; those further on need not be."""
    ends = SameSize(
        first=Extent.parse("H/F/B"),
        second=Extent.parse("H/G/B"),
        dimension="width",
        second_before=Word.context("⊢ P"),
    )
    assert paths(ends, floor("F", "PBPBP"), MOVED) == [("H/G/B", 0.3)]
    other = SameSize(
        first=Extent.parse("H/F/B"),
        second=Extent.parse("H/G/B"),
        dimension="width",
        second_before=Word.context("⊢"),
    )
    assert paths(other, floor("F", "PBPBP"), MOVED) == []


def test_runs_of_the_same_size_only_between_such_neighbours() -> None:
    runs = SameSize(
        first=Extent.parse("H/F: P B"),
        second=Extent.parse("H/G: P B"),
        dimension="width",
        first_after=Word.context("P ⊣"),
        second_before=Word.context("⊢"),
    )
    # P B before the last pier of F are 3 wide, P B at the start of G 3.1.
    assert paths(runs, floor("F", "PBPBP"), MOVED) == [("H/G/", 0.1)]


WORDS = st.text("PBQ", min_size=1, max_size=6)
SETS = st.sampled_from(["P", "B", "@Pier", "{B Q}", "@Bay"])


@st.composite
def ends(draw: st.DrawFn, token: str) -> Word | None:
    sets = draw(st.lists(SETS, max_size=2))
    parts = [token, *sets] if token == "⊢" else [*sets, token]
    text = " ".join(parts if draw(st.booleans()) else sets)
    return Word.context(text) if text else None


@given(WORDS, ends("⊢"), ends("⊣"), st.integers(1, 2))
def test_rules_and_checker_find_the_same_places(
    word: str, before: Word | None, after: Word | None, length: int
) -> None:
    root = floor("F", word)
    view = LayoutView(Layout("l", "m", root), Facade("f", "m", root))
    runs = [(start, start + length) for start in range(len(word) - length + 1)]
    found = list(Context(before, after).runs(runs, root, root.word))
    parent = view.by_path["F"]
    assert found == [run for run in runs if view.surrounded(parent, *run, before, after)]


def test_a_context_reads_like_a_word() -> None:
    for text in ("⊢", "⊣", "⊢ A {B @C}", "A B ⊣", "A"):
        assert str(Word.context(text)) == text
    assert Word.context("|- A") == Word.context("⊢ A")
    with pytest.raises(ValueError, match="names no region"):
        Word.context(" ")
    with pytest.raises(ValueError, match="names no region"):
        Word.parse("⊢ ⊣")
