"""Generators as elements of documents: the sequences that they stand for, and what they are refused for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations, product
from pathlib import Path
from typing import ClassVar

import pytest
from houses import broken, floor, house, laid_out, stacked, with_rows
from hypothesis import given, settings
from hypothesis import strategies as st
from patterns import patterns, spelled_out

from layoutkit.constraints import (
    BUILT_IN,
    Constraint,
    Repetition,
    Replication,
    Reuse,
    Reversal,
    TwoShuffle,
)
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.chains import Inexpressible
from layoutkit.constraints.defaults import InputWord, default_words, effective_constraints
from layoutkit.constraints.expansion import as_written, expanded, sequences_of
from layoutkit.constraints.generator import Generator, Given
from layoutkit.constraints.generators import repetition, reversal
from layoutkit.constraints.pattern import Pattern
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.documents import check, facade_bytes, read, save
from layoutkit.model import Facade, Region, RegionSet, Word

KINDS = {kind.kind: kind for kind in BUILT_IN}
HERE = Place("house.xml", 12, 3)


def repeated(path: str, pattern: str, **more: object) -> Repetition:
    return Repetition(within=(path,), pattern=Pattern.parse(pattern), **more)  # type: ignore[arg-type]


def words(facade: Facade) -> dict[str, list[str]]:
    """Return all sequences of each region, as text."""
    return {path: [str(c.word) for c in own] for path, own in sequences_of(facade).items()}


def messages(constraint: Constraint, *others: Constraint) -> list[Diagnostic]:
    return list(constraint.faults(house(constraint, *others)))


def test_replication_of_the_whole_arrangement_and_of_runs() -> None:
    whole, run = (
        Replication(within=("H/F", "H/G")),
        Replication(within=("H/F",), of=Word.parse("⊢ P {B @Pier}")),
    )
    found = words(house(whole, run))
    assert found == {"H/F": ["⊢ P B P B P ⊣", "⊢ P {B @Pier}"], "H/G": ["⊢ P B P B P ⊣"]}


def test_repetition_in_the_labels_of_the_region() -> None:
    assert words(house(repeated("H/F", "@Pier+[B]")))["H/F"] == ["⊢ @Pier", "@Pier ⊣", "@Pier B", "B @Pier"]


def test_two_shuffle_of_the_input_or_of_a_run() -> None:
    found = words(house(TwoShuffle(within=("H/F",)), TwoShuffle(within=("H/G",), of=Word.parse("B @Pier"))))
    assert found == {"H/F": ["P B", "B P"], "H/G": ["B @Pier", "@Pier B"]}


def test_reversal_of_another_region_or_of_the_same() -> None:
    own = [SequenceConstraint(within=("H/F",), word=Word.parse(text)) for text in ("⊢ P B", "B B P ⊣")]
    facade = house(Reversal(within=("H/G",), of="H/F"), *own)
    assert words(facade)["H/G"] == ["B P ⊣", "⊢ P B B"]
    both = house(*own, Reversal(within=("H/F",)))
    assert words(both)["H/F"] == ["⊢ P B", "B B P ⊣", "B P ⊣", "⊢ P B B"]


def test_generators_go_by_one_another_in_any_order() -> None:
    constraints = [
        Reuse(within=RegionSet("H/G"), like="H/F"),
        Reversal(within=("H/F",)),
        repeated("H/F", "P B+ P?"),
    ]
    found = {frozenset(words(house(*some))["H/G"]) for some in permutations(constraints)}
    own = repetition("P B+ P?")
    assert found == {frozenset(map(str, (*own, *reversal(own))))}


def test_two_regions_may_reuse_each_other() -> None:
    one, other = Reuse(within=RegionSet("H/F"), like="H/G"), Reuse(within=RegionSet("H/G"), like="H/F")
    facade = house(one, other, Replication(within=("H/F",)))
    assert words(facade) == {path: ["⊢ P B P B P ⊣"] for path in ("H/F", "H/G")}


def unlike() -> Region:
    """Two floors of the same structure under other names, and a third of another structure."""
    upper, lower = floor("F", "PBPBP"), floor("G", "QDQDQ", widths={"D": 2.0, "Q": 1.0})
    return stacked(upper, lower, floor("K", "PDBBP", widths={"D": 1.0}))


def test_reuse_for_regions_of_the_same_structure_under_other_names() -> None:
    pattern = repeated("H/F", "P+[B]")
    reuse = Reuse(within=RegionSet.parse("@Floor - H/K"), like="H/F")
    facade = Facade("f", "m", unlike(), constraints=(pattern, reuse))
    assert list(reuse.faults(facade)) == []
    assert set(words(facade)["H/G"]) == {"⊢ Q", "Q ⊣", "Q D", "D Q"}


def test_reuse_by_symbols_that_are_said_to_correspond() -> None:
    pattern = repeated("H/G", "Q+[D]", place=HERE)
    refused = Reuse(within=RegionSet("H/K"), like="H/G", place=HERE)
    facade = Facade("f", "m", unlike(), constraints=(pattern, refused))
    (fault,) = refused.faults(facade)
    assert (fault.code, fault.place) == ("LK222", HERE)
    assert fault.details == ("H/G: Q D Q D Q", "H/K: P D B B P")
    assert "it has no Q" in fault.message
    said = replace(refused, symbols=(("Q", "P"),))
    facade = Facade("f", "m", unlike(), constraints=(pattern, said))
    assert list(said.faults(facade)) == []
    assert set(words(facade)["H/K"]) == {"⊢ P", "P ⊣", "P D", "D P"}


def test_sequences_have_the_place_the_comment_and_the_weight_of_their_generator() -> None:
    written = repeated("H/F", "P+[B]", place=HERE, comment="bays between piers", weight=2.0)
    facade = house(written)
    for sequence in sequences_of(facade)["H/F"]:
        assert (sequence.place, sequence.comment, sequence.weight) == (HERE, "bays between piers", 2.0)
        assert as_written(facade, sequence) is written
    assert not written.soft


def test_regions_with_the_same_sequences_share_them() -> None:
    facade = house(Repetition(within=("H/F", "H/G"), pattern=Pattern.parse("P+[B]")))
    assert {c.within for c in sequences_of(facade)["H/F"]} == {("H/F", "H/G")}


def test_what_is_there_already_is_not_added_again() -> None:
    pair = SequenceConstraint(within=("H/F",), word=Word.parse("P B"))
    facade = house(TwoShuffle(within=("H/F",)), pair, TwoShuffle(within=("H/F",), of=Word.parse("B P")))
    assert sorted(words(facade)["H/F"]) == ["B P", "P B"]
    assert as_written(facade, pair) is pair


def test_expansion_keeps_everything_else_in_its_order() -> None:
    constraints = [
        SequenceConstraint(within=("H/G",), word=Word.parse("⊢ P")),
        Replication(within=("H/F",)),
        SequenceConstraint(within=("H/G",), word=Word.parse("P ⊣")),
    ]
    found = expanded(house(*constraints))
    assert [type(c) for c in found] == [SequenceConstraint] * 3
    assert (found[0], found[2]) == (constraints[0], constraints[2])


def test_a_region_with_a_generator_does_not_keep_the_input_s_word_by_default() -> None:
    facade = house(repeated("H/F", "P+[B]"))
    assert default_words(facade) == (InputWord(path="H"), InputWord(path="H/G"))
    assert not any(isinstance(c, Generator) for c in effective_constraints(facade))


def test_layouts_are_checked_against_the_pattern() -> None:
    constraint = Repetition(within=("H/F", "H/G"), pattern=Pattern.parse("(P B)+ P"), place=HERE)
    facade = house(constraint)
    cornice = Region("C", 5.0, 0.5, labels=("Cornice",))

    def changed(word: str) -> Region:
        upper, ground = floor("F", word), floor("G", word, 3.5)
        return with_rows(facade, replace(cornice, width=upper.width), upper, upper, ground)

    assert broken(facade, changed("PBP")) == []
    assert broken(facade, changed("PBPBPBP")) == []
    found = [v for v in laid_out(facade, changed("PBBP")).violations() if v.constraint is constraint]
    assert [v.path for v in found] == ["H/F", "H/F.2", "H/G"]
    assert "'P B B P'" in found[0].message


ROWS = patterns(st.sampled_from("PB"), leaves=5)


@settings(max_examples=40)
@given(ROWS)
def test_the_checker_finds_what_the_pattern_does_not_allow(pattern: Pattern) -> None:
    try:
        repetition(pattern)
    except Inexpressible:
        return
    facade = Facade("f", "m", stacked(floor("F", "PBPBP")))
    facade = replace(facade, constraints=(Repetition(within=("H/F",), pattern=pattern),))
    names = {"P": frozenset("P"), "B": frozenset("B")}
    allowed = spelled_out(pattern, names, 4)
    for word in ("".join(w) for n in range(1, 5) for w in product("PB", repeat=n)):
        found = laid_out(facade, stacked(floor("F", word))).violations()
        assert any("no chain" in v.message for v in found) is (word not in allowed), word


REFUSED: list[tuple[Constraint, str, str]] = [
    (Replication(within=("H/FF",), place=HERE), "LK201", "'H/FF'"),
    (Replication(within=("H/C",), place=HERE), "LK205", "H/C"),
    (Replication(within=("H/F",), of=Word.parse("P X"), place=HERE), "LK201", "'X'"),
    (Replication(within=("H/F",), of=Word.parse("B B"), place=HERE), "LK223", "no run B B"),
    (Replication(within=("H/F",), of=Word.parse("⊢ B"), place=HERE), "LK223", "no run ⊢ B"),
    (repeated("H/F", "P+[X @Bay]", place=HERE), "LK201", "'X'"),
    (repeated("H/F", "P (B P)+ B B (P B)+ P", place=HERE), "LK220", "say exactly P (B P)+ B B (P B)+ P"),
    (repeated("H/F", "{P B}* P " + "{P B} " * 16, place=HERE), "LK220", "too large"),
    (TwoShuffle(within=("H/F",), of=Word.parse("P @Bays"), place=HERE), "LK201", "'@Bays'"),
    (Reversal(within=("H/F",), of="H/K", place=HERE), "LK201", "'H/K'"),
    (Reversal(within=("H/F",), place=HERE), "LK221", "sequences of H/F, which has none"),
    (Reuse(within=RegionSet("H/F"), like="H/G", place=HERE), "LK221", "sequences of H/G, which has none"),
    (Reuse(within=RegionSet("@Flor"), like="H/G", place=HERE), "LK201", "'Flor'"),
    (Reuse(within=RegionSet("@Cornice"), like="H/G", place=HERE), "LK205", "H/C"),
]


@pytest.mark.parametrize(("constraint", "code", "shown"), REFUSED, ids=[str(c)[:60] for c, _, _ in REFUSED])
def test_what_generators_are_refused_for(constraint: Constraint, code: str, shown: str) -> None:
    (fault,) = messages(constraint)
    assert (fault.code, fault.place) == (code, HERE)
    assert shown in fault.message
    assert fault.hint
    with pytest.raises(Faulty, match=code):
        effective_constraints(house(constraint))


def test_a_pattern_that_sequences_cannot_say_shows_what_they_would_admit() -> None:
    (fault,) = messages(repeated("H/F", "P B+[P] B B+[P] P", place=HERE))
    assert fault.code == "LK220"
    assert fault.details[0].startswith("they would also admit: P B")


def test_sequences_that_name_what_the_other_region_lacks() -> None:
    root = stacked(floor("F", "PBPBP"), floor("G", "PDPDP", widths={"D": 2.0}))
    own = SequenceConstraint(within=("H/F",), word=Word.parse("⊢ P B"))
    reversed_ = Reversal(within=("H/G",), of="H/F", place=HERE)
    (fault,) = reversed_.faults(Facade("f", "m", root, constraints=(own, reversed_)))
    assert (fault.code, fault.place) == ("LK201", HERE)
    assert "'B'" in fault.message


def test_a_generator_at_fault_is_not_laid_at_another_s_door() -> None:
    """What goes by a region with a misspelt sequence is sound as long as another sequence is."""
    misspelt = SequenceConstraint(within=("H/F",), word=Word.parse("P XX"))
    reversed_ = Reversal(within=("H/G",), of="H/F")
    assert messages(reversed_, misspelt, Replication(within=("H/F",))) == []
    assert [d.code for d in messages(reversed_, misspelt)] == ["LK221"]


@pytest.mark.parametrize("of", ["P", "⊢ P B", "P B ⊣"])
def test_a_two_shuffle_is_of_a_run_without_ends(of: str) -> None:
    with pytest.raises(ValueError, match="two or more regions"):
        TwoShuffle(within=("H/F",), of=Word.parse(of))


EVERY: list[Constraint] = [
    Replication(within=("H/F",), of=Word.parse("⊢ P {B @Pier}"), comment="as in the input"),
    Replication(within=("H/G",)),
    repeated("H/F", "@Pier+[{B @Bay}]"),
    TwoShuffle(within=("H/F", "H/G"), of=Word.parse("P B")),
    Reversal(within=("H/F",), weight=0.5),
    Reversal(within=("H/G",), of="H/F"),
    Reuse(within=RegionSet.parse("@Floor - H/F"), like="H/F", symbols=(("P", "P"),)),
]


def test_documents_hold_every_generator(tmp_path: Path) -> None:
    facade = house(*EVERY)
    save(tmp_path / "house.xml", facade_bytes(facade))
    assert check(tmp_path / "house.xml", KINDS) == []
    again = read(tmp_path / "house.xml", KINDS).model
    assert isinstance(again, Facade)
    assert again == facade
    assert words(again) == words(facade)
    assert facade_bytes(again) == (tmp_path / "house.xml").read_bytes()


@pytest.mark.parametrize(
    ("element", "code", "shown"),
    [
        ('<repetition within="H/F" pattern="P (B"/>', "LK105", "'(' is not closed (behind 'P (B'"),
        ('<repetition within="H/F"/>', "LK104", "pattern"),
        ('<repetition within="H/F" patern="P"/>', "LK103", "patern"),
        ('<two-shuffle within="H/F" of="P"/>', "LK105", "two or more regions"),
        ('<repetition within="H/F" pattern="P (B P)+ B B (P B)+ P"/>', "LK220", "say exactly"),
    ],
)
def test_faults_stand_at_the_element(tmp_path: Path, element: str, code: str, shown: str) -> None:
    source = facade_bytes(house(Replication(within=("H/G",)))).decode()
    source = source.replace("<constraints>", f"<constraints>\n      {element}")
    save(tmp_path / "house.xml", source.encode())
    found = check(tmp_path / "house.xml", KINDS)
    line = next(n for n, text in enumerate(source.splitlines(), 1) if element in text)
    assert found[0].code == code
    assert found[0].place == Place(str(tmp_path / "house.xml"), line, 7)
    assert shown in found[0].message
    assert found[0].hint


@dataclass(frozen=True, kw_only=True)
class Twice(Generator):
    """A plugin's generator: every symbol may stand beside itself."""

    kind: ClassVar[str] = "twice"
    summary: ClassVar[str] = "Every region may repeat."

    def targets(self, facade: Facade) -> Sequence[str]:  # type: ignore[override]
        return [path for path, region in facade.regions.items() if region.split]

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        return tuple(Word((RegionSet(s),) * 2) for s in dict.fromkeys(facade.regions[path].word))

    def unknown(self, facade: Facade) -> Iterator[Diagnostic]:
        return iter(())


def test_a_plugin_s_generator_takes_part() -> None:
    facade = house(Twice(), Replication(within=("H/F",)))
    assert words(facade)["H/F"] == ["P P", "B B", "⊢ P B P B P ⊣"]
    assert set(words(facade)) == {"H", "H/F", "H/G"}
