"""Constraints under other names: what is rewritten, and that the meaning stays."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement, SameSize, Sequence, Size
from layoutkit.constraints.attributes import PATH, REGIONS, attribute
from layoutkit.constraints.checking import violations
from layoutkit.constraints.renaming import aliases_of, confined, joins, lifted, mapped, reduced, spread
from layoutkit.model import Extent, Facade, Layout, Measure, Region, RegionSet, Violation, Word

S, W, E = RegionSet.parse, Word.parse, Extent.parse


@dataclass(frozen=True, kw_only=True)
class Wider(Constraint):
    """As a plugin might declare it: one region wider than another, and than some more."""

    kind: ClassVar[str] = "wider"
    summary: ClassVar[str] = "One region is wider than another."
    one: str = attribute(PATH, "The wider one.")
    other: str = attribute(PATH, "The narrower one.")
    also: RegionSet | None = attribute(REGIONS, "Others.", None)


def test_paths_become_all_that_their_steps_become() -> None:
    aliases = {"F/R": ("R", "R~2"), "F/R/S": ("S", "T")}
    assert aliases_of("F/Q/S", aliases) == ("F/Q/S",)
    assert aliases_of("F/R", aliases) == ("F/R", "F/R~2")
    assert aliases_of("F/R/S/U", aliases) == ("F/R/S/U", "F/R/T/U", "F/R~2/S/U", "F/R~2/T/U")
    assert aliases_of("F/R", {"F": ("B/South", "B/East")}) == ("B/South/R", "B/East/R")


def test_sets_become_unions_and_keep_their_structure() -> None:
    aliases = {"F/R": ("R", "R~2")}
    (size,) = spread(Size(of=S("@L - (F/R/A | F/Q) & F/R/*")), aliases)
    assert str(size.of) == "(@L - (F/R/A | F/R~2/A | F/Q)) & (F/R/* | F/R~2/*)"
    (same,) = spread(SameSize(first=E("F/R"), second=E("F/R F/Q: a b"), dimension="width"), aliases)
    assert str(same.first) == "F/R | F/R~2"
    assert str(same.second) == "F/R F/R~2 F/Q: a b"


def test_lists_of_paths_become_longer_and_words_wider() -> None:
    aliases = {"F/R": ("R", "R~2"), "F/Q/a": ("a", "a~2")}
    (sequence,) = spread(Sequence(within=("F", "F/R", "F/Q"), word=W("⊢ R {a b} @L")), aliases)
    assert sequence.within == ("F", "F/R", "F/R~2", "F/Q")
    assert str(sequence.word) == "⊢ {R R~2} {a a~2 b} @L"
    (agreeing,) = spread(SameArrangement(of=("F/R", "F/Q")), aliases)
    assert agreeing.of == ("F/R", "F/R~2", "F/Q")


def test_a_single_path_makes_one_constraint_for_each_alias() -> None:
    aliases = {"F/R": ("R", "R~2"), "F/R/a": ("a", "a~2")}
    found = spread(Frequency(of=S("a | @L | F/R/b"), within="F/R", max=Measure(1.0)), aliases)
    assert [c.within for c in found] == ["F/R", "F/R~2"]
    assert {str(c.of) for c in found} == {"a | a~2 | @L | F/R/b | F/R~2/b"}


def test_paths_in_the_same_region_go_together() -> None:
    aliases = {"F/R": ("R", "R~2"), "F/Q": ("Q", "Q~2")}
    inside = spread(Wider(one="F/R/a", other="F/R/b", also=S("F/R/c")), aliases)
    assert [(c.one, c.other) for c in inside] == [("F/R/a", "F/R/b"), ("F/R~2/a", "F/R~2/b")]
    assert {str(c.also) for c in inside} == {"F/R/c | F/R~2/c"}
    across = spread(Wider(one="F/R", other="F/Q"), aliases)
    assert {(c.one, c.other) for c in across} == {
        (f"F/R{r}", f"F/Q{q}") for r in ("", "~2") for q in ("", "~2")
    }


def test_what_names_nothing_of_it_stays_the_same_object() -> None:
    for constraint in (
        Size(of=S("@R | F/Q")),
        Frequency(of=S("R"), within="F/Q"),  # F/Q/R, not F/R
        Alignment(first=S("@R"), second=S("F/RR"), lines=("left",)),
    ):
        assert spread(constraint, {"F/R": ("R", "R~2")}) == (constraint,)
        assert spread(constraint, {"F/R": ("R", "R~2")})[0] is constraint


def test_labels_are_held_to_a_region() -> None:
    alignment = Alignment(first=S("@L"), second=S("F/R"), lines=("left",))
    held = confined(alignment, "B/South")
    assert (str(held.first), str(held.second)) == ("@L & (B/South | B/South/*)", "F/R")
    assert confined(replace(alignment, first=S("F/R")), "B/South").first == S("F/R")


def test_an_enclosing_region_is_replaced_and_its_meaning_kept() -> None:
    one = lifted(Frequency(of=S("@Door | Bay"), within="F/G"), "B")
    assert (one.within, str(one.of)) == ("B", "(@Door | F/G/Bay) & F/G/*")
    assert str(lifted(Frequency(of=S("@Door | G"), within="F"), "B").of) == "@Door | F/G"
    runs = lifted(
        SameSize(first=E("F/G F/H F/G/I: a b"), second=E("@L"), dimension="width", within="F/G"), "B"
    )
    assert (str(runs.first), str(runs.second), runs.within) == ("F/G F/G/I: a b", "@L & F/G/*", "B")
    outside = lifted(SameSize(first=E("F/H: a b"), dimension="width", within="F/G"), "B")
    assert str(outside.first) == "F/G - F/G"
    free = Alignment(first=S("@L"), second=S("@L"), lines=("left",))
    assert lifted(free, "B") is free


def test_kinds_that_name_one_region_at_a_time_join_nothing() -> None:
    class Lone(Wider):
        """Without a set."""

        @classmethod
        def attributes(cls):  # type: ignore[no-untyped-def]
            return tuple(a for a in super().attributes() if a.name != "also")

    assert joins(Wider)
    assert joins(Frequency)
    assert not joins(Lone)


NAMES = st.sampled_from(["@L", "@M", "F", "F/R", "F/R/a", "F/Q", "F/R/*"])
SETS = st.recursive(
    NAMES.map(RegionSet),
    lambda inner: st.builds(
        lambda left, operator, right: RegionSet(operator=operator, left=left, right=right),
        inner,
        st.sampled_from("|&-"),
        inner,
    ),
    max_leaves=8,
)


@given(SETS)
def test_a_set_with_every_name_kept_contains_the_same(regions: RegionSet) -> None:
    kept = mapped(regions, lambda name: (name,))
    assert kept.names() == regions.names()
    for names in ({"@L"}, {"F/R", "@M"}, {"F", "F/R/a"}):
        assert kept.contains(frozenset(names)) == regions.contains(frozenset(names))


#: A facade of two floors; R and T stand for each other where a test renames occurrences.
COLUMNS = {"P": 1.0, "R": 2.0, "Q": 1.5}


def bay(symbol: str, width: float, sill: float) -> Region:
    parts = (Region("w", width, 3.0 - sill, labels=("Window",)), Region("s", width, sill))
    return Region(symbol, width, 3.0, "rows", parts, ("Bay",))


def floor(symbol: str, columns: list[tuple[str, float, float]]) -> Region:
    children = tuple(Region(s, w, 3.0) if s in "PQ" else bay(s, w, sill) for s, w, sill in columns)
    return Region(symbol, sum(c.width for c in children), 3.0, "columns", children, ("Floor",))


def facade(symbols: str, *constraints: Constraint) -> Facade:
    """A floor F with the columns P R Q R P (and T, if it is among the symbols), and a floor G."""
    upper = floor("F", [("P", 1.0, 1.0), *((s, 2.0, 1.0) for s in symbols), ("P", 1.0, 1.0)])
    rest = upper.width - 3.0
    ground = floor("G", [("P", 1.0, 1.0), ("R", 2.0, 1.0), ("Q", rest, 1.0)])
    return Facade("f", "m", Region("H", upper.width, 6.0, "rows", (upper, ground)), constraints=constraints)


ONES: list[Constraint] = [
    Size(of=S("H/F/R"), min=Measure(1.9), max=Measure(2.1)),
    Size(of=S("@Bay - H/F/R"), max=Measure(2.1)),
    Size(of=S("H/F/R/w | H/F/R/s"), min=Measure(0.9), max=Measure(2.1)),
    Frequency(of=S("R"), within="H/F", min=Measure(2.0), max=Measure(3.0)),
    Frequency(of=S("@Window"), within="H/F/R", min=Measure(1.0), max=Measure(1.0)),
    Frequency(of=S("s"), within="H/F/R", max=Measure(0.0)),
    Alignment(first=S("H/F/R"), second=S("H/G/Q"), lines=("left",)),
    Alignment(first=S("H/F/R/w"), second=S("@Window"), lines=("bottom",)),
    Alignment(first=S("@Window"), second=S("H/F/R/s"), lines=("top",), within="H/F/R"),
    SameSize(first=E("H/F/R"), second=E("H/G/R"), dimension="width"),
    SameSize(first=E("H/F: P R"), dimension="width"),
    SameSize(first=E("H/F/R: w"), second=E("H/G/R: w"), dimension="height"),
]
IN_TURNS = tuple(Sequence(within=("H/F",), word=W(word)) for word in ("⊢ P R", "R Q R", "R P ⊣"))
CASES: list[tuple[Constraint, ...]] = [*((one,) for one in ONES), IN_TURNS]


@given(
    st.sampled_from(CASES),
    st.lists(st.tuples(st.sampled_from("RRQ"), st.booleans()), min_size=1, max_size=5),
    st.sampled_from([2.0, 2.25]),
    st.sampled_from([1.0, 1.25]),
)
def test_spread_constraints_say_of_aliases_what_they_said_of_the_region(
    constraints: tuple[Constraint, ...], word: list[tuple[str, bool]], width: float, sill: float
) -> None:
    columns = [("P", 1.0, 1.0), *((s, width if s == "R" else 1.5, sill) for s, _ in word), ("P", 1.0, 1.0)]
    renamed = [columns[0]]
    renamed += [
        ("T", *c[1:]) if turned and s == "R" else c for c, (s, turned) in zip(columns[1:], word, strict=False)
    ]
    renamed.append(columns[-1])
    both = facade("RQTR")
    spread_ones = tuple(s for c in constraints for s in spread(c, {"H/F/R": ("R", "T")}))
    assert kept(both, spread_ones, renamed) == kept(facade("RQR"), constraints, columns)


def kept(
    source: Facade, constraints: tuple[Constraint, ...], columns: list[tuple[str, float, float]]
) -> bool:
    """Tell whether a layout with an upper floor of these columns keeps the constraints."""
    upper = floor("F", columns)
    ground = floor("G", [("P", 1.0, 1.0), ("R", 2.0, 1.0), ("Q", upper.width - 3.0, 1.0)])
    layout = Layout("l", "m", Region("H", upper.width, 6.0, "rows", (upper, ground)))
    with_them = replace(source, constraints=constraints)
    found: tuple[Violation, ...] = violations(layout, with_them)
    return not any(v.constraint in constraints for v in found)


def test_the_cases_tell_kept_from_broken() -> None:
    end, stray = ("P", 1.0, 1.0), ("Q", 1.5, 1.0)
    words = (
        [end, ("R", 2.0, 1.0), stray, ("R", 2.0, 1.0), end],
        [end, ("R", 2.25, 1.25), stray, stray, ("R", 2.25, 1.25), end],
    )
    seen = {(type(case[0]), kept(facade("RQR"), case, word)) for case in CASES for word in words}
    assert seen == {(type(case[0]), value) for case in CASES for value in (True, False)}


@pytest.mark.parametrize("constraint", ONES, ids=str)
def test_a_moved_constraint_names_nothing_of_the_old_place(constraint: Constraint) -> None:
    (moved,) = spread(constraint, {"H": ("Building/South",)})
    assert "H/" not in str(moved)
    assert str(moved).replace("Building/South", "H") == str(constraint)


def test_sets_lose_what_nothing_goes_by() -> None:
    left = {"a": ("a",), "b": ("b", "b2"), "c": ()}
    become = {
        "a | c": "a",
        "c | a": "a",
        "c | c": None,
        "a & c": None,
        "c & a": None,
        "a - c": "a",
        "c - a": None,
        "a | (b & c)": "a",
        "a - (b - c)": "a - (b | b2)",
        "c | b | a": "b | b2 | a",
        "(a | c) & b": "a & (b | b2)",
    }
    for text, expected in become.items():
        found = reduced(S(text), left.__getitem__)
        assert (None if found is None else str(found)) == expected, text
