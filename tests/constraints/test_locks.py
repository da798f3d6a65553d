"""Locks: regions that keep their place, their size or their inside, while all else varies."""

from __future__ import annotations

from dataclasses import replace

import pytest
from houses import broken, floor, house, stacked, with_rows
from hypothesis import given, settings
from hypothesis import strategies as st
from readings import kept_by_rules

from layoutkit.constraints import Constraint, Lock, Sequence
from layoutkit.constraints.anchoring import decided, input_offsets, successive
from layoutkit.constraints.word_rules import Admits, Bound, Counts, Exactly
from layoutkit.model import Facade, Region, RegionSet, Violation, Word
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Range

CORNICE = Region("C", 7.0, 0.5, labels=("Cornice",))
FREE = [
    Sequence(within=("H/F", "H/G"), word=Word.parse(text)) for text in ("⊢ {P B}", "{P B} {P B}", "{P B} ⊣")
]
FREE += [
    Sequence(within=("H",), word=Word.parse(text)) for text in ("⊢ C F", "C G", "F F", "F G", "G ⊣", "F ⊣")
]
FLOOR, GROUND = floor("F", "PBPBP"), floor("G", "PBPBP", 3.5)


def lock(of: str, *keep: str, anchor: tuple[str, ...] = ("left", "bottom")) -> Lock:
    return Lock(of=RegionSet.parse(of), keep=keep, anchor=anchor)


def faulted(constraint: Constraint, *rows: Region) -> list[Violation]:
    facade = house(constraint, *FREE)
    found = broken(facade, with_rows(facade, *rows))
    return [v for v in found if v.constraint is constraint]


@pytest.mark.parametrize("keep", ["place", "size", "inside"])
def test_the_input_keeps_every_lock(keep: str) -> None:
    for of in ("H/F", "@Bay", "H/G", "@Pier | H/G"):
        if of != "@Bay" or keep != "inside":
            assert broken(house(lock(of, keep), *FREE)) == []


def test_a_region_that_keeps_its_size() -> None:
    """As wide and as high as in the input, wherever and however often it occurs."""
    bays = lock("H/G/B", "size")
    assert faulted(bays, CORNICE, FLOOR, floor("G", "BPPPB", 3.5)) == []
    assert faulted(bays, CORNICE, FLOOR, floor("G", "PPPPPPP", 3.5)) == [], (
        "where there is none, none changed"
    )
    found = faulted(bays, CORNICE, FLOOR, floor("G", "PBPBP", 3.25, {"P": 0.8, "B": 2.3}))
    assert [(v.path, round(v.amount, 9)) for v in found] == [
        ("H/G/B", 0.3),
        ("H/G/B", 0.25),
        ("H/G/B.2", 0.3),
        ("H/G/B.2", 0.25),
    ]
    assert found[0].message == "its width is 2.3, not 2"


def test_a_region_that_keeps_its_inside() -> None:
    """The same arrangement at the same shares: it may still be stretched as a whole."""
    ground = lock("H/G", "inside")
    wide = [replace(CORNICE, width=14.0), floor("F", "PBPBP", widths={"P": 2.0, "B": 4.0})]
    assert faulted(ground, *wide, floor("G", "PBPBP", 5.0, {"P": 2.0, "B": 4.0})) == []
    moved = faulted(ground, *wide, floor("G", "PBPBP", 3.5, {"P": 3.0, "B": 2.5}))
    assert [(v.path, v.amount) for v in moved] == [
        ("H/G/P", 1.0),
        ("H/G/B", 1.0),
        ("H/G/P.2", 0.5),
        ("H/G/B.2", 1.0),
        ("H/G/P.3", 1.0),
    ]
    (other,) = faulted(ground, CORNICE, FLOOR, floor("G", "PPBBP", 3.5))
    assert (other.path, other.amount) == ("H/G", 1.0)
    assert other.message == "its arrangement is 'P P B B P', not 'P B P B P'"


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(["PBPBP", "PPBBP"]), st.sampled_from([0.5, 1.0, 2.0]), st.sampled_from([0.5, 1.0, 1.25])
)
def test_sizes_keep_an_inside_where_the_checker_finds_it_kept(word: str, scale: float, pier: float) -> None:
    """Piers of that width at full scale, bays that fill up 7 m, all scaled."""
    ground = lock("H/G", "inside")
    widths = {"P": pier * scale, "B": (7.0 - 3 * pier) / 2 * scale}
    rows = replace(CORNICE, width=7.0 * scale), floor("F", word, widths=widths), floor("G", word, 3.0, widths)
    facade = house(ground, *FREE)
    kept = kept_by_rules(ground, facade, with_rows(facade, *rows))
    assert kept is (faulted(ground, *rows) == []) is (word == "PBPBP" and pier == 1.0)


def test_the_inside_of_what_is_inside_is_kept() -> None:
    def building(inner: str) -> Region:
        block = Region("K", 7.0, 6.5, "rows", (FLOOR, floor("G", inner, 3.5)))
        return Region("H", 7.0, 6.5, "columns", (block,))

    constraint = lock("H/K", "inside")
    free = [Sequence(within=("H/K/G",), word=c.word) for c in FREE[:3]]
    facade = Facade("f", "m", building("PBPBP"), constraints=(constraint, *free))
    (found,) = broken(facade, building("BPPPB"))
    assert (found.path, found.constraint) == ("H/K/G", constraint)
    rules = list(Lock.word_rules([constraint], facade))
    assert [
        (rule.path, rule.automaton.word)
        for rule in rules
        if isinstance(rule, Admits) and isinstance(rule.automaton, Exactly)
    ] == [
        ("H/K", ("F", "G")),
        ("H/K/F", tuple("PBPBP")),
        ("H/K/G", tuple("PBPBP")),
    ]


@pytest.mark.parametrize(
    ("anchor", "moved"), [(("left", "bottom"), 3.0), (("left", "top"), 0.0), (("center", "middle"), 1.5)]
)
def test_a_region_stays_where_it_is_from_its_anchor(anchor: tuple[str, ...], moved: float) -> None:
    """The cornice is at the top; a storey more moves it away from the bottom, and from the middle by half."""
    cornice = lock("H/C", "place", anchor=anchor)
    assert faulted(cornice, CORNICE, FLOOR, FLOOR, GROUND) == []
    found = faulted(cornice, CORNICE, FLOOR, FLOOR, FLOOR, GROUND)
    assert [(v.path, v.amount) for v in found] == ([("H/C", moved)] if moved else [])
    assert all(f"its {' '.join(anchor)} is {moved:g} off" in v.message for v in found)


def test_regions_in_place_may_grow_away_from_their_anchor() -> None:
    bays = lock("H/G/B", "place", anchor=("center", "bottom"))
    # Bays 0.6 wider, the piers beside them narrower: the centres of the bays stay at 2 and 5.
    assert faulted(bays, CORNICE, FLOOR, FLOOR, floor("G", "PBPBP", 3.5)) == []
    slim = replace(
        GROUND,
        children=tuple(
            replace(c, width=w) for c, w in zip(GROUND.children, (0.7, 2.6, 0.4, 2.6, 0.7), strict=True)
        ),
    )
    assert faulted(bays, CORNICE, FLOOR, FLOOR, slim) == []
    assert [
        round(v.amount, 9)
        for v in faulted(replace(bays, anchor=("left", "bottom")), CORNICE, FLOOR, FLOOR, slim)
    ] == [0.3, 0.3]


def test_as_many_as_in_the_input() -> None:
    """Two floors F: one more, or one less, is one too many or too few, wherever they are."""
    floors = lock("H/F", "place")
    for count, amount in ((1, 1.0), (3, 1.0), (4, 2.0)):
        (found,) = faulted(floors, CORNICE, *[FLOOR] * count, GROUND)
        assert (found.path, found.amount) == ("H", amount)
        assert found.message == f"has {count} of H/F, not 2"


def test_a_region_that_is_gone_from_its_place() -> None:
    """Floors exchange places with the ground floor: both are 3 or 3.5 m off."""
    floors = lock("H/F", "place")
    assert [(v.path, v.amount) for v in faulted(floors, CORNICE, GROUND, FLOOR, FLOOR)] == [
        ("H/F", 3.5),
        ("H/F.2", 3.5),
    ]


def test_the_whole_facade_is_always_in_its_place() -> None:
    whole = lock("H", "place")
    assert list(Lock.word_rules([whole], house(whole))) == []
    assert faulted(whole, CORNICE, FLOOR, FLOOR, FLOOR, GROUND) == []


def test_what_keeps_its_place_occurs_as_often() -> None:
    bays = lock("H/F/B", "place")
    number = Bound(4.0, False)
    assert list(Lock.word_rules([bays], house(bays))) == [
        Counts("H", frozenset({"H/F/B"}), number, number, (bays,))
    ]


def arranged(facade: Facade, **words: str) -> Arrangement:
    chosen = {path: region.word for path, region in facade.regions.items() if region.split}
    return Arrangement(
        facade, {**chosen, **{f"H/{path}".rstrip("/"): tuple(word) for path, word in words.items()}}
    )


def test_other_places_than_the_input_has_cannot_be_kept_by_any_size() -> None:
    bays = lock("H/G/B", "place")
    facade = house(bays, *FREE)
    for word, axes in (("PBPBP", []), ("PPBPB", []), ("BPPPB", [0]), ("PBBBP", [0])):
        found = [rule for rule in bays.size_rules(arranged(facade, G=word)) if isinstance(rule, Range)]
        assert [rule.axis for rule in found if not rule.form] == axes
        assert all(rule.least > 0 for rule in found if not rule.form), "nothing is not above 0"


def test_nothing_is_said_of_places_before_the_words_are_known() -> None:
    bays = lock("H/F/B", "place")
    facade = house(bays, *FREE)
    open_ = Arrangement(facade, {"H": tuple("CFFG")})
    assert not decided(open_, ["H/F/B"])
    assert list(bays.size_rules(open_)) == []
    none = Arrangement(facade, {"H": tuple("CG"), "H/G": tuple("PBPBP")})
    assert decided(none, ["H/F/B"])
    assert [rule.form for rule in bays.size_rules(none) if isinstance(rule, Range)] == [{}, {}]


def test_places_of_copies_that_vary_are_taken_together() -> None:
    """Two floors, laid out apart: in each, the first bay is in the first place, the second in the second."""
    one, other = floor("F", "PBPBP"), floor("F~2", "PBPBP")
    facade = Facade("f", "m", stacked(one, other))
    arrangement = Arrangement(facade, {"H": ("F", "F~2"), "H/F": tuple("PBPBP"), "H/F~2": tuple("BPPPB")})
    columns = successive(arrangement, ["H/F/B", "H/F~2/B"], 0)
    assert columns is not None
    assert [{(slot.symbol_path, slot.order) for slot in slots} for slots in columns] == [
        {("H/F/B", (1,)), ("H/F~2/B", (0,))},
        {("H/F/B", (3,)), ("H/F~2/B", (4,))},
    ]
    rows = successive(arrangement, ["H/F/B", "H/F~2/B"], 1)
    assert rows is not None
    assert [[slot.order for slot in slots] for slots in rows] == [[(0,)], [(1,)]]
    uneven = Arrangement(facade, {"H": ("F", "F~2"), "H/F": tuple("PBPBP"), "H/F~2": tuple("PPBP")})
    assert successive(uneven, ["H/F/B", "H/F~2/B"], 0) is None


def test_places_in_the_input() -> None:
    facade = house()
    assert input_offsets(facade, "H/F/B", 0, 0.0) == [1.0, 4.0]
    assert input_offsets(facade, "H/F/B", 0, 1.0) == pytest.approx([-4.0, -1.0])
    assert input_offsets(facade, "H/F/B", 1, 0.0) == [0.5, 3.5]
    assert input_offsets(facade, "H/F", 0, 0.5) == [0.0]


@settings(max_examples=200, deadline=None)
@given(
    st.sampled_from(["H/F/B", "H/G/B", "H/F", "H/C", "H/F/P"]),
    st.sampled_from([("left", "bottom"), ("right", "top"), ("center", "middle")]),
    st.permutations("CFFG"),
    st.permutations("PBPBP"),
    st.permutations("PBPBP"),
)
def test_words_and_sizes_keep_a_place_where_the_checker_finds_it_kept(
    of: str, anchor: tuple[str, ...], rows: list[str], upper: list[str], lower: list[str]
) -> None:
    made = {"C": CORNICE, "F": floor("F", "".join(upper)), "G": floor("G", "".join(lower), 3.5)}
    constraint = lock(of, "place", anchor=anchor)
    facade = house(constraint, *FREE)
    root = with_rows(facade, *(made[symbol] for symbol in rows))
    assert kept_by_rules(constraint, facade, root) is (faulted(constraint, *root.children) == [])
