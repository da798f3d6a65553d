"""Which constraints a conflict names, for each kind that can take part in one, and which it never names."""

from __future__ import annotations

from dataclasses import dataclass, replace

import pytest
from conflicting import alone, any_word, helps, only, row

from layoutkit.constraints import Alignment, Constraint, Frequency, Instances, SameArrangement, SameSize, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.attributes import MEASURE, REGIONS, attribute
from layoutkit.constraints.defaults import InputWord
from layoutkit.diagnostics import Place
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Violation, Word
from layoutkit.sizing.rules import Range
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.explanation.units import background, units_of


def size(of: str, least: float | None = None, most: float | None = None, **more: object) -> Size:
    ends = (None if end is None else Measure(end) for end in (least, most))
    return Size(of=RegionSet.parse(of), **dict(zip(("min", "max"), ends, strict=True)), **more)  # type: ignore[arg-type]


def frequency(of: str, within: str, least: float | None = None, most: float | None = None) -> Frequency:
    ends = (None if end is None else Measure(end) for end in (least, most))
    return Frequency(of=RegionSet(of), within=within, **dict(zip(("min", "max"), ends, strict=True)))


def floors(constraints: tuple[Constraint, ...] = ()) -> Facade:
    """Return two floors of two bays."""
    upper, lower = (
        Region(s, 4.0, 3.0, "columns", (Region("a", 1.0, 3.0), Region("b", 3.0, 3.0))) for s in "FG"
    )
    return Facade("floors", "m", Region("R", 4.0, 6.0, "rows", (upper, lower)), constraints=constraints)


def kinds(facade: Facade, at: tuple[float, float]) -> list[str]:
    """Return the kinds of the constraints in the one conflict, its remedies checked."""
    conflict = only(explain(facade, at).conflicts)
    assert conflict.minimal
    for remedy in conflict.remedies:
        assert helps(facade, at, remedy), remedy.text
    return [constraint.kind for member in conflict.members for constraint in member.constraints]


def test_counts_and_sizes() -> None:
    """Three of at least a metre do not go into two and a half."""
    constraints = [*any_word("R", "ab"), size("R/a", 1.0), size("R/b", 0.1), frequency("a", "R", 3)]
    facade = row("ab", {"a": 1.0, "b": 1.0}, constraints)
    assert kinds(facade, (2.5, 3.0)) == ["size", "frequency"]
    conflict = only(explain(facade, (2.5, 3.0)).conflicts)
    assert {(some.units, round(some.value, 9)) for some in conflict.short} == {("m", 0.5), ("regions", 1.0)}
    texts = [remedy.text for remedy in conflict.remedies]
    assert "lower the minimum of frequency of a in R to 2" in texts
    assert "lower the minimum of a to 0.83 m" in texts
    assert "make the facade 3.00 m wide" in texts


def test_counts_and_sequences() -> None:
    """Where no word has two of them, it is the sequences that the count cannot go with."""
    words = [Word.parse(text) for text in ("⊢ a b", "a b ⊣")]
    facade = row("ab", {"a": 1.0, "b": 1.0}, [SequenceConstraint(within=("R",), word=w) for w in words])
    facade = replace(facade, constraints=(*facade.constraints, frequency("a", "R", 2)))
    assert kinds(facade, (4.0, 3.0)) == ["sequence", "sequence", "frequency"]
    conflict = only(explain(facade, (4.0, 3.0)).conflicts)
    (permission,) = (remedy for remedy in conflict.remedies if remedy.member == 0)
    (added,) = permission.added
    assert isinstance(added, SequenceConstraint)
    assert [str(s) for s in added.word.sets].count("a") == 2
    assert (added.word.at_start, added.word.at_end) == (True, True)
    assert [(some.units, some.value) for some in conflict.short] == [("regions", 1.0)]


def test_sequences_are_left_out_together() -> None:
    """Without one of them, fewer words are valid, not more: each alone would be no reason."""
    words = [Word.parse(text) for text in ("⊢ a", "a a", "a ⊣")]
    sequences = [SequenceConstraint(within=("R",), word=w) for w in words]
    facade = row("aab", {"a": 1.0, "b": 1.0}, [*sequences, size("R/a", 1.0, 1.0)])
    conflict = only(explain(facade, (3.5, 3.0)).conflicts)
    assert [member.constraints for member in conflict.members] == [tuple(sequences), (facade.constraints[3],)]


def test_a_sequence_of_several_regions_is_a_member_for_each() -> None:
    sequences = [SequenceConstraint(within=("R/F", "R/G"), word=Word.parse("⊢ a b ⊣"))]
    facade = floors((*sequences, size("R/F/a", 1.0, 1.0), size("R/F/b", 2.0, 2.0)))
    (first, *_) = only(explain(facade, (4.0, 6.0)).conflicts).members
    assert (first.regions, first.constraints) == (("R/F",), tuple(sequences))
    units = [unit for unit in units_of(facade) if unit.region]
    assert [unit.region for unit in units] == ["R/F", "R/G", "R"]
    assert units[0].constraints == (SequenceConstraint(within=("R/F",), word=sequences[0].word),)


def test_alignments() -> None:
    alignment = Alignment(first=RegionSet("R/F/a"), second=RegionSet("R/G/a"), lines=("right",))
    facade = floors((size("R/F/a", 1.0, 1.0), size("R/G/a", 2.0, 2.0), alignment))
    assert kinds(facade, (4.0, 6.0))[:3] == ["size", "size", "alignment"]
    conflict = only(explain(facade, (4.0, 6.0)).conflicts)
    assert "leave out the alignment" in [remedy.text for remedy in conflict.remedies]


def test_same_sizes() -> None:
    same = SameSize(first=Extent(RegionSet("R/F/a")), second=Extent(RegionSet("R/G/a")), dimension="width")
    facade = floors((size("R/F/a", 1.0, 1.5), same, size("R/G/a", 2.0, 2.5)))
    conflict = only(explain(facade, (4.0, 6.0)).conflicts)
    assert [c.kind for m in conflict.members for c in m.constraints if not m.by_default] == [
        "size",
        "same-size",
        "size",
    ]
    assert [(some.units, round(some.value, 9)) for some in conflict.short] == [("m", 0.5)]
    assert {remedy.text for remedy in conflict.remedies} >= {
        "raise the maximum of F/a to 2.00 m",
        "lower the minimum of G/a to 1.50 m",
        "leave out the same-size",
    }


def test_same_arrangements() -> None:
    one = SequenceConstraint(within=("R/F",), word=Word.parse("⊢ a b ⊣"))
    other = SequenceConstraint(within=("R/G",), word=Word.parse("⊢ b a ⊣"))
    facade = floors((one, SameArrangement(of=("R/F", "R/G")), other))
    conflict = only(explain(facade, (4.0, 6.0)).conflicts)
    own = [c.kind for m in conflict.members for c in m.constraints if not m.by_default]
    assert own == ["sequence", "same-arrangement", "sequence"]


def test_different_instances() -> None:
    """Two occurrences cannot be three different ones."""
    instances = Instances(of=RegionSet("R/a"), min=Measure(3.0))
    facade = row("aba", {"a": 1.0, "b": 1.0}, [instances])
    assert "instances" in kinds(facade, (3.0, 3.0))


def test_defaults_take_part_only_where_it_cannot_be_told_without_them() -> None:
    facade = row("aab", {"a": 1.0, "b": 1.0}, [size("R/a", 1.0)])
    conflict = only(explain(facade, (2.2, 3.0)).conflicts)
    assert [(m.by_default, m.subject) for m in conflict.members] == [
        (False, "size of R/a, 2 of"),
        (True, "arrangement of R"),
        (True, "size of R/b"),
    ]
    texts = [remedy.text for remedy in conflict.remedies]
    assert "give b a size of its own, at least 20% (0.20 m)" in texts
    own = replace(facade, constraints=(*facade.constraints, *any_word("R", "ab"), frequency("a", "R", 3)))
    assert not any(m.by_default for m in only(explain(own, (2.2, 3.0)).conflicts).members)


def test_soft_constraints_never_take_part() -> None:
    soft = [size("R/a", 3.0, weight=5.0), frequency("a", "R", 3)]
    facade = row(
        "ab", {"a": 1.0, "b": 1.0}, [*any_word("R", "ab"), *soft, size("R/a", 1.0), size("R/b", 0.2)]
    )
    conflict = only(explain(facade, (2.5, 3.0)).conflicts)
    assert soft[0] not in [constraint for member in conflict.members for constraint in member.constraints]
    assert not [unit for unit in units_of(facade) if unit.constraints[0].soft]


def test_what_is_always_held_asks_nothing_that_a_constraint_does_not() -> None:
    facade = row("ab", {"a": 1.0, "b": 1.0}, [size("R/a", 0.02), size("R/b", 0.5)])
    held = {str(c.of): c.min for c in background(facade) if isinstance(c, Size)}
    assert held == {"R/a": Measure(0.02, True), "R/b": Measure(0.1, True)}


@dataclass(frozen=True, kw_only=True)
class Proportion(Constraint):
    """Regions are not too slender: a kind as a plugin would add it."""

    kind = "proportion"
    summary = "The regions' width is at least a share of their input height."

    of: RegionSet = attribute(REGIONS, "The regions.")
    least: Measure = attribute(MEASURE, "Least width, as a share of the height.", Measure(0.5, True))

    def size_rules(self, arrangement):  # type: ignore[no-untyped-def]
        for path in arrangement.facade.select(self.of):
            if path in arrangement.frames:
                least = self.least.of(arrangement.facade.regions[path].height)
                yield Range(0, arrangement.extent(path, 0), least, float("inf"), self)

    def violations(self, view):  # type: ignore[no-untyped-def]
        for path in view.facade.select(self.of):
            least = self.least.of(view.facade.regions[path].height)
            for placed in view.places(path):
                if (short := least - placed.box.width) > view.tolerance:
                    yield Violation(self, placed.path, f"is narrower than {least:g}", short)


def test_a_kind_of_a_plugin_takes_part_like_any_other() -> None:
    slender = Proportion(of=RegionSet("R/a"), least=Measure(0.75, True), place=Place("f.xml", 9))
    facade = row("ab", {"a": 1.0, "b": 1.0}, [slender, size("R/a", most=2.0)])
    conflict = only(explain(facade, (3.0, 3.0)).conflicts)
    assert [(m.subject, m.demand) for m in conflict.members] == [
        ("proportion of R/a", "least 75%"),
        ("size of R/a", "at most 2.00 m"),
        ("arrangement of R", "as in the input: a b"),
    ]
    texts = [remedy.text for remedy in conflict.remedies]
    assert texts[0] == "raise the maximum of a to 2.25 m"
    assert "leave out the proportion (line 9)" in texts


@pytest.mark.parametrize("units", ["m", "px"])
def test_a_feasible_facade_has_nothing_to_explain(units: str) -> None:
    facade = replace(floors(), units=units)
    explanation = explain(facade, (4.0, 6.0))
    assert (explanation.conflicts, explanation.complete) == ((), True)
    assert explanation.best_effort is not None
    assert explanation.best_effort.violations() == ()


def test_members_alone_are_what_the_conflict_says() -> None:
    """The helper of these tests: what a conflict names, and nothing else."""
    facade = row("aab", {"a": 1.0, "b": 1.0}, [size("R/a", 1.0)])
    members = only(explain(facade, (2.2, 3.0)).conflicts).members
    held = alone(facade, members).constraints
    assert InputWord(path="R") not in held
    assert size("R/a", 1.0) in held
