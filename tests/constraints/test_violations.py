"""The checker: a layout keeps a constraint, or breaks it at a place and by an amount."""

from __future__ import annotations

from dataclasses import replace

import pytest
from houses import broken, floor, house, laid_out, stacked, with_rows

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement, SameSize, Sequence, Size
from layoutkit.constraints.defaults import InputWord
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Word


def regions(text: str) -> RegionSet:
    return RegionSet.parse(text)


CORNICE = Region("C", 7.0, 0.5, labels=("Cornice",))
FREE = [Sequence(within=("H/F", "H/G"), word=Word.parse(text)) for text in ("⊢ P", "{P B} {P B}", "P ⊣")]


def upper(word: str, **widths: float) -> Region:
    """A row F F G whose floors F have another word or other widths; as wide as that makes them."""
    floors = floor("F", word, widths=widths)
    ground = floor("G", word, 3.5, widths)
    return stacked(replace(CORNICE, width=floors.width), floors, floors, ground)


KEPT: list[Constraint] = [
    Size(of=regions("@Pier"), min=Measure(1.0), max=Measure(1.0)),
    Size(of=regions("H/F"), min=Measure(1.0, True), max=Measure(3.0)),
    Sequence(within=("H/F",), word=Word.parse("⊢ P B P B P ⊣")),
    Frequency(of=regions("B"), within="H/F", min=Measure(2.0), max=Measure(2.0)),
    Frequency(of=regions("@Window"), within="H", min=Measure(6.0), max=Measure(6.0)),
    Alignment(first=regions("H/F/B"), second=regions("H/G/B"), lines=("left", "center", "right")),
    Alignment(
        first=regions("H/F/B"), second=regions("@Pier"), lines=("top", "middle", "bottom"), within="H/F"
    ),
    SameSize(first=Extent.parse("@Pier"), dimension="width"),
    SameSize(first=Extent.parse("H/F: P B"), second=Extent.parse("H/G: B P"), dimension="width"),
    SameArrangement(of=("H/F", "H/G")),
]


@pytest.mark.parametrize("constraint", KEPT, ids=str)
def test_the_input_keeps(constraint: Constraint) -> None:
    assert broken(house(constraint)) == []


def test_a_size_out_of_its_range() -> None:
    constraint = Size(of=regions("@Pier"), min=Measure(0.9), max=Measure(1.1))
    facade = house(constraint, *FREE)
    assert broken(facade, upper("PBPBP", P=1.05)) == []
    found = broken(facade, upper("PBP", P=1.25))
    assert [v.path for v in found] == [f"H/{f}/{p}" for f in ("F", "F.2", "G") for p in ("P", "P.2")]
    assert {round(v.amount, 9) for v in found} == {0.15}
    assert "1.25, not between 0.9 and 1.1" in found[0].message
    (short, *_) = broken(facade, upper("PBP", P=0.5))
    assert short.amount == pytest.approx(0.4)


def test_a_size_within_the_tolerance_is_kept() -> None:
    facade = house(Size(of=regions("H/F/P"), max=Measure(1.0)), *FREE)
    size = 1e-6 * facade.root.height
    assert broken(facade, upper("PBPBP", P=1.0 + 0.9 * size)) == []
    assert broken(facade, upper("PBPBP", P=1.0 + 1.5 * size)) != []


def test_a_region_never_vanishes() -> None:
    constraint = Size(of=regions("H/F/P"))
    assert constraint.bounds(house(), "H/F/P") == (0.001, float("inf"))
    facade = house(constraint, *FREE)
    assert broken(facade, upper("PBPBP", P=1e-9)) != []


def test_a_word_that_no_chain_covers() -> None:
    facade = house(*FREE)
    assert broken(facade, upper("PPBBPP")) == []
    found = broken(facade, upper("PBPB"))
    assert [(v.path, v.constraint) for v in found] == [
        ("H/F", FREE[0]),
        ("H/F.2", FREE[0]),
        ("H/G", FREE[0]),
    ]
    assert "'P B P B'" in found[0].message


def test_without_sequences_the_input_s_word_holds() -> None:
    facade = house()
    found = [v for v in laid_out(facade, upper("PBP")).violations() if "arrangement" in v.message]
    assert [v.path for v in found] == ["H/F", "H/F.2", "H/G"]
    assert {v.constraint for v in found} == {InputWord(path="H/F"), InputWord(path="H/G")}


def test_counts_out_of_their_range() -> None:
    symbols = Frequency(of=regions("B"), within="H/F", min=Measure(2.0), max=Measure(3.0))
    labels = Frequency(of=regions("@Window"), within="H", min=Measure(4.0), max=Measure(8.0))
    facade = house(symbols, labels, *FREE)
    assert broken(facade, upper("PBBP")) == []
    found = broken(facade, upper("PBP"))
    assert [(v.constraint, v.path, v.amount) for v in found] == [
        (symbols, "H/F", 1.0),
        (symbols, "H/F.2", 1.0),
        (labels, "H", 1.0),
    ]
    assert "has 1 of B, not between 2 and 3" in found[0].message
    assert [v.amount for v in broken(facade, upper("PBBBBP"))] == [1.0, 1.0, 4.0]


def test_relative_counts_grow_with_the_region() -> None:
    constraint = Frequency(of=regions("B"), within="H/F", min=Measure(0.9, True), max=Measure(1.1, True))
    facade = house(constraint, *FREE)
    # Twice as wide, 14 m: between 3.6 and 4.4 bays.
    assert broken(facade, upper("PBPBPBPBP", P=1.2)) == []
    found = broken(facade, upper("PBPBPBPBPBP", P=2 / 3))
    assert [v.path for v in found] == ["H/F", "H/F.2"]
    assert {round(v.amount, 9) for v in found} == {0.6}
    assert "has 5 of B, not between 3.6 and 4.4" in found[0].message


def test_lines_out_of_line() -> None:
    constraint = Alignment(first=regions("H/F/B"), second=regions("H/G/B"), lines=("left", "right"))
    facade = house(constraint, *FREE)
    floors = floor("F", "PBPBP")
    moved = floor("G", "PBPBP", 3.5, {"P": 0.8, "B": 2.3})
    found = broken(facade, with_rows(facade, CORNICE, floors, floors, moved))
    # Every bay above overlaps the one below: each pair is off by 0.2 at one edge, 0.1 at the other.
    assert len(found) == 8
    assert {round(v.amount, 9) for v in found} == {0.2, 0.1}
    assert "off that of H/G/B" in found[0].message


def test_regions_that_only_touch_need_not_be_in_line() -> None:
    constraint = Alignment(first=regions("H/F/B"), second=regions("H/G/D"), lines=("left",))
    words = [Sequence(within=("H/G",), word=Word.parse("⊢ D B ⊣"))]
    bare = stacked(floor("F", "PBPBP"), floor("G", "PBPD", widths={"D": 3.0, "P": 1.0}))
    facade = Facade("f", "m", bare, constraints=(constraint, *words))
    touching = stacked(floor("F", "PB", widths={"P": 2.0}), floor("G", "DB", widths={"D": 2.0}))
    assert [v for v in broken(facade, touching) if v.constraint is constraint] == []
    overlapping = stacked(floor("F", "PB", widths={"P": 1.9, "B": 2.1}), floor("G", "DB", widths={"D": 2.0}))
    (found,) = [v for v in broken(facade, overlapping) if v.constraint is constraint]
    assert found.amount == pytest.approx(1.9)


def test_alignment_within_an_encompassing_region() -> None:
    """Piers of one floor are level with each other; those of other floors are not asked."""
    everywhere = Alignment(first=regions("@Pier"), second=regions("@Pier"), lines=("left",))
    inside = replace(everywhere, within="H/F")
    moved = floor("G", "PBPBP", 3.5, {"P": 0.8, "B": 2.3})
    floors = floor("F", "PBPBP")
    for constraint, count in ((everywhere, True), (inside, False)):
        facade = house(constraint)
        assert bool(broken(facade, with_rows(facade, CORNICE, floors, floors, moved))) is count


def test_sizes_that_differ() -> None:
    constraint = SameSize(first=Extent.parse("H/F/P"), second=Extent.parse("H/G/P"), dimension="width")
    facade = house(constraint)
    floors, moved = floor("F", "PBPBP"), floor("G", "PBPBP", 3.5, {"P": 0.8, "B": 2.3})
    found = broken(facade, with_rows(facade, CORNICE, floors, floors, moved))
    assert [v.path for v in found] == ["H/G/P", "H/G/P.2", "H/G/P.3"]
    assert {round(v.amount, 9) for v in found} == {0.2}


def test_runs_that_differ() -> None:
    """P B at the start of a floor against B P at its end."""
    constraint = SameSize(
        first=Extent.parse("H/F: ⊢ P B"), second=Extent.parse("H/G: B P ⊣"), dimension="width"
    )
    facade = house(constraint)
    floors, moved = floor("F", "PBPBP"), floor("G", "PBPBP", 3.5, {"P": 0.8, "B": 2.3})
    assert broken(facade) == []
    (found,) = broken(facade, with_rows(facade, CORNICE, floors, floors, moved))
    assert found.path.startswith("H/G")
    assert found.amount == pytest.approx(0.1)


def test_same_size_within_a_scope() -> None:
    constraint = SameSize(first=Extent.parse("@Pier"), dimension="height", within="H/F")
    facade = house(constraint)
    assert broken(facade) == [], "piers of the ground floor are higher, and in no floor F"
    assert broken(house(replace(constraint, within="H"))) != []


def test_words_that_differ() -> None:
    constraint = SameArrangement(of=("H/F", "H/G"))
    facade = house(constraint, *FREE)
    floors, other = floor("F", "PBPBP"), floor("G", "PBBPP", 3.5)
    (found,) = broken(facade, with_rows(facade, CORNICE, floors, floors, other))
    assert (found.path, found.constraint) == ("H/G", constraint)


def test_the_rules_of_every_layout() -> None:
    """Known symbols, exact tiling, replicas alike."""
    facade = house()
    floors, ground = floor("F", "PBPBP"), floor("G", "PBPBP", 3.5)
    rows = facade.root.children

    def messages(root: Region) -> str:
        return " | ".join(v.message for v in laid_out(facade, root).violations() if v.constraint is None)

    assert messages(facade.root) == ""
    assert "the root is not H" in messages(replace(facade.root, symbol="X"))
    assert "has no region H/X" in messages(
        replace(facade.root, children=(*rows[:3], replace(ground, symbol="X")))
    )
    assert "do not tile" in messages(replace(facade.root, height=facade.root.height + 1e-6))
    assert "do not tile" in messages(replace(facade.root, width=7.1))
    assert "no replica" in messages(with_rows(facade, CORNICE, floors, floor("F", "PBPBP", 3.2), ground))
    narrow = floor("F", "PBPBP", widths={"P": 1.2, "B": 1.7})
    assert "no replica" in messages(with_rows(facade, CORNICE, floors, narrow, ground))
    unlabelled = replace(CORNICE, labels=())
    assert "labels differ" in messages(with_rows(facade, unlabelled, floors, floors, ground))


def test_default_sizes_hold_where_none_is_given() -> None:
    facade = house(*FREE)
    found = laid_out(facade, upper("PBPBP", P=2.5)).violations()
    assert {v.path.partition(".")[0] for v in found} >= {"H/F/P", "H/G/P"}
    assert {round(v.amount, 9) for v in found} == {0.5}
    given = house(Size(of=regions("@Pier"), max=Measure(3.0)), *FREE)
    assert laid_out(given, upper("PBPBP", P=2.5)).violations() == ()
