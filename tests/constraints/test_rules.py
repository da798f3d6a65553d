"""What constraints ask of the search and of sizing: their word rules and size rules."""

from __future__ import annotations

import math

import pytest
from houses import house

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement, SameSize, Sequence, Size
from layoutkit.constraints.defaults import default_sizes, default_words, effective_constraints
from layoutkit.constraints.word_rules import Admits, Agree, Bound, Counts
from layoutkit.model import Extent, Measure, RegionSet, Word
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Aligned, Range, SizeRule, Target


def regions(text: str) -> RegionSet:
    return RegionSet.parse(text)


def rules(constraint: Constraint, **words: tuple[str, ...]) -> tuple[Arrangement, list[SizeRule]]:
    """Return the size rules for the input's words, or others by the floor's symbol."""
    facade = house(constraint)
    chosen = {path: region.word for path, region in facade.regions.items() if region.split}
    chosen |= {f"H/{symbol}": word for symbol, word in words.items()}
    arrangement = Arrangement(facade, chosen)
    return arrangement, list(constraint.size_rules(arrangement))


def test_a_size_is_a_range_and_a_target() -> None:
    constraint = Size(of=regions("H/F/P"), min=Measure(0.5, True), max=Measure(3.0), deviation=Measure(0.1))
    arrangement, (bounds, target) = rules(constraint)
    form = arrangement.extent("H/F/P", 0)
    assert bounds == Range(0, form, 0.5, 3.0, constraint, ("H/F",))
    assert target == Target(0, form, 1.0, 0.1, 0.5, 3.0, 3.0), "three occurrences weigh as three"


def test_a_size_is_along_the_split_that_the_region_stands_in() -> None:
    arrangement, found = rules(Size(of=regions("H/F | @Pier"), min=Measure(1.0)))
    assert {rule.axis: rule.form for rule in found if isinstance(rule, Range)}.keys() == {0, 1}
    heights = [rule for rule in found if rule.axis == 1 and isinstance(rule, Target)]
    assert [(rule.centre, rule.weight) for rule in heights] == [(3.0, 2.0)]
    assert heights[0].form == arrangement.extent("H/F", 1)


def test_sizes_of_what_no_word_reaches_are_not_asked() -> None:
    assert rules(Size(of=regions("H/F/B")), F=("P", "P"))[1] == []


def test_an_alignment_is_one_rule_a_scope() -> None:
    constraint = Alignment(first=regions("H/F/B"), second=regions("H/G/B"), lines=("left", "center"))
    _, (rule,) = rules(constraint)
    assert isinstance(rule, Aligned)
    assert (rule.axis, rule.lines, rule.origin) == (0, (0.0, 0.5), constraint)
    assert [len(rule.first), len(rule.second)] == [2, 2], "both floors F stand in the same place along x"
    level = Alignment(first=regions("@Pier"), second=regions("@Bay"), lines=("bottom",), within="H/F")
    _, scoped = rules(level)
    assert [rule.axis for rule in scoped] == [1, 1], "one for each floor F"
    assert rules(constraint, G=("P",))[1] == [], "no bay below"
    assert list(constraint.ties(house())) == [(0, ("H/F/B", "H/G/B"))]


def test_same_sizes_are_equalities_with_the_first() -> None:
    constraint = SameSize(first=Extent.parse("H/F/P"), second=Extent.parse("@Bay"), dimension="width")
    arrangement, found = rules(constraint)
    assert all(isinstance(rule, Range) and rule.least == rule.most == 0.0 for rule in found)
    assert len(found) == 2, "bays of F and of G, replicas aside"
    runs = SameSize(first=Extent.parse("H/F: P P"), second=Extent.parse("H/F: B P"), dimension="width")
    assert len(rules(runs, F=("P", "P", "B", "P", "B"))[1]) == 1, "each run occurs once"
    assert rules(runs, F=("P", "B", "P", "B", "B"))[1] == [], "runs of the same symbols are equal anyway"
    assert rules(runs, F=("P", "P"))[1] == []
    cuts = arrangement.frames["H/F"].cuts
    assert len(cuts) == 6


def test_a_scope_is_not_inside_itself() -> None:
    """The floor F is no extent inside F; runs in it are."""
    own = SameSize(first=Extent.parse("H/F | H/F/P"), dimension="height", within="H/F")
    assert rules(own)[1] == []
    run = SameSize(
        first=Extent.parse("H/F: P"), second=Extent.parse("H/F: B"), dimension="width", within="H/F"
    )
    assert rules(run)[1] != []
    aligned = Alignment(first=regions("H/F"), second=regions("H/F/P"), lines=("right",), within="H/F")
    assert rules(aligned)[1] == []


def test_sequences_of_a_region_make_one_automaton() -> None:
    constraints = [
        Sequence(within=("H/F", "H/G"), word=Word.parse("⊢ P")),
        Sequence(within=("H/F",), word=Word.parse("{P @Window} P ⊣")),
    ]
    facade = house(*constraints)
    found = list(Sequence.word_rules(constraints, facade))
    assert all(isinstance(rule, Admits) for rule in found)
    assert [(rule.path, rule.origin) for rule in found] == [
        ("H/F", tuple(constraints)),
        ("H/G", (constraints[0],)),
    ]
    piece = constraints[1].piece(facade.regions["H/F"])
    assert piece.sets == (frozenset("PB"), frozenset("P"))
    assert (piece.at_start, piece.at_end) == (False, True)


def test_regions_with_the_same_sequences_share_their_automaton() -> None:
    constraints = [Sequence(within=("H/F", "H/G"), word=Word.parse("⊢ P B P B P ⊣"))]
    one, other = Sequence.word_rules(constraints, house(*constraints))
    assert isinstance(one, Admits)
    assert isinstance(other, Admits)
    assert one.automaton is other.automaton


@pytest.mark.parametrize(
    ("least", "most", "bounds"),
    [
        (None, None, (Bound(0.0, False), Bound(math.inf, False))),
        (Measure(1.0), Measure(4.0), (Bound(1.0, False), Bound(4.0, False))),
        (Measure(0.5, True), Measure(1.5, True), (Bound(1.0, True), Bound(3.0, True))),
    ],
)
def test_frequencies_are_counts(
    least: Measure | None, most: Measure | None, bounds: tuple[Bound, Bound]
) -> None:
    constraint = Frequency(of=regions("B"), within="H/F", min=least, max=most)
    (rule,) = Frequency.word_rules([constraint], house(constraint))
    assert rule == Counts("H/F", frozenset({"H/F/B"}), *bounds, (constraint,))


def test_relative_counts_are_of_one_region_and_grow() -> None:
    """Labels count all inside: six windows in the house, two in each floor."""
    for within, count in (("H", 6.0), ("H/F", 2.0)):
        constraint = Frequency(of=regions("@Window"), within=within, min=Measure(1.0, True))
        least, _ = constraint.ends(house())
        assert least == Bound(count, True)
        assert (least.at(1.0), least.at(1.5)) == (count, 1.5 * count)


def test_relative_counts_bound_the_region_s_size() -> None:
    """Four bays, where the input's 7 m have two and 110 % may be: at least 4 / 2.2 times 7 m."""
    most = Frequency(of=regions("B"), within="H/F", max=Measure(1.1, True))
    arrangement, (rule,) = rules(most, F=("B",) * 4)
    assert isinstance(rule, Range)
    assert rule.form == arrangement.extent("H/F", 0)
    assert (rule.least, rule.most) == (pytest.approx(4 / 2.2 * 7), math.inf)
    least = Frequency(of=regions("B"), within="H/F", min=Measure(0.9, True))
    _, (rule,) = rules(least, F=("B",) * 4)
    assert isinstance(rule, Range)
    assert (rule.least, rule.most) == (0.0, pytest.approx(4 / 1.8 * 7))
    absolute = Frequency(of=regions("B"), within="H/F", min=Measure(1.0), max=Measure(2.0))
    assert rules(absolute)[1] == []


def test_same_arrangement_is_an_agreement() -> None:
    constraint = SameArrangement(of=("H/F", "H/G"))
    (rule,) = SameArrangement.word_rules([constraint], house(constraint))
    own = {"P": "P", "B": "B"}
    assert rule == Agree({"H/F": own, "H/G": own}, (constraint,))


def test_default_sizes_are_of_what_nothing_divides() -> None:
    facade = house()
    found = {str(c.of): c for c in default_sizes(facade)}
    # The floors' heights come from nothing inside: their columns do not divide them in height.
    assert set(found) == {"H/C", "H/F", "H/G", "H/F/P", "H/F/B", "H/G/P", "H/G/B"}
    assert found["H/F/P"].bounds(facade, "H/F/P") == (0.5, 2.0)
    given = house(Size(of=regions("@Pier | H/F")))
    assert {str(c.of) for c in default_sizes(given)} == {"H/C", "H/G", "H/F/B", "H/G/B"}
    assert effective_constraints(given)[0] is given.constraints[0]
    assert len(effective_constraints(given)) == 5 + len(default_words(given))


def test_regions_without_sequences_are_replicated() -> None:
    assert [c.path for c in default_words(house())] == ["H", "H/F", "H/G"]
    freed = house(Sequence(within=("H/G",), word=Word.parse("⊢ P ⊣")))
    assert [c.path for c in default_words(freed)] == ["H", "H/F"]
