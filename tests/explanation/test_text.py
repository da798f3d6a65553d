"""Explanations as diagnostics: what a user reads, in names and lines of the document."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from conflicting import RIVOLI, any_word, row

from layoutkit.constraints import BUILT_IN, Frequency, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.diagnostics import Place
from layoutkit.documents import read
from layoutkit.model import Facade, Measure, Region, RegionSet, Word
from layoutkit.model.conflict import Amount, Conflict, Explanation, Member
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.explanation.report import details, diagnostics, hint
from layoutkit_relayout.explanation.units import Unit

KINDS = {kind.kind: kind for kind in BUILT_IN}


def document(text: str, folder: Path) -> Facade:
    (folder / "rivoli.xml").write_text(text, encoding="utf-8")
    facade = read(folder / "rivoli.xml", KINDS).model
    assert isinstance(facade, Facade)
    return facade


def told(facade: Facade, size: tuple[float, float], folder: Path) -> str:
    (diagnostic,) = diagnostics(explain(facade, size), facade)
    return str(diagnostic).replace(str(folder), "facades")


def test_two_sizes_that_cannot_hold_together(tmp_path: Path) -> None:
    assert told(document(RIVOLI, tmp_path), (7.0, 4.0), tmp_path) == "\n".join(
        [
            "facades/rivoli.xml:16:5: error LK203 sizing: these constraints cannot hold together at 7 × 4 m",
            "  size of Facade/B          at most 3.00 m          (line 15)",
            "  size of Facade/B/C, 3 of  at least 1.20 m each    (line 16)",
            "  arrangement of Facade     as in the input: A B A  (by default)",
            "  arrangement of Facade/B   as in the input: C C C  (by default)",
            "  short by 0.60 m",
            "  hint: lower the minimum of C to 1.00 m, raise the maximum of B to 3.60 m, allow A A in "
            "Facade by a further sequence, or allow C C in B by a further sequence",
        ]
    )


def test_the_places_of_all_members_go_with_it(tmp_path: Path) -> None:
    facade = document(RIVOLI, tmp_path)
    (diagnostic,) = diagnostics(explain(facade, (7.0, 4.0)), facade)
    file = str(tmp_path / "rivoli.xml")
    assert diagnostic.place == Place(file, 16, 5)
    assert diagnostic.related == (Place(file, 15, 5), Place(file, 16, 5))
    assert diagnostic.as_dict()["related"] == (
        {"file": file, "line": 15, "column": 5},
        {"file": file, "line": 16, "column": 5},
    )


def test_sequences_are_told_with_all_their_lines(tmp_path: Path) -> None:
    sequences = '<sequence within="Facade/B" word="⊢ C"/>\n    <sequence within="Facade/B" word="C ⊣"/>\n    '
    text = RIVOLI.replace("<!-- the lease ends here -->", sequences).replace('max="3"', 'min="3"')
    text = text.replace('min="1.2"', 'max="1.2"')
    lines = told(document(text, tmp_path), (7.0, 4.0), tmp_path).splitlines()
    assert [" ".join(line.split()) for line in lines[1:4]] == [
        "sequences of Facade/B ⊢ C, C ⊣ (lines 14, 15)",
        "size of Facade/B at least 3.00 m (line 17)",
        "size of Facade/B/C at most 1.20 m (line 18)",
    ]


def test_other_units_and_percentages(tmp_path: Path) -> None:
    text = RIVOLI.replace('units="m"', 'units="px"').replace('min="1.2"', 'min="120%"')
    lines = told(document(text, tmp_path), (7.0, 4.0), tmp_path).splitlines()
    assert lines[0].endswith("at 7 × 4 px")
    assert "at least 1.2 px (120%) each" in lines[2]
    assert "short by 0.6 px" in lines[5]
    assert "lower the minimum of C to 100% (1 px)" in lines[6]


def test_doubts_are_told() -> None:
    sure, doubtful = (
        Member((), (), subject, "", False, needed) for subject, needed in (("one", True), ("two", False))
    )
    conflict = Conflict((sure, doubtful))
    assert not conflict.minimal
    lines = list(details(conflict, row("a", {"a": 1.0})))
    assert lines[-1] == "not proved that all of them are needed: two"
    assert hint(conflict).startswith("ask for another size")
    found = diagnostics(Explanation((1.0, 1.0), (conflict,), False), row("a", {"a": 1.0}))
    assert [d.message.partition("(")[2] for d in found] == ["1 of 1 or more conflicts)"]


@pytest.mark.parametrize(
    ("value", "units", "expected"),
    [
        (3.0, "m", "3.00 m"),
        (0.6, "m", "0.60 m"),
        (0.0123, "m", "0.012 m"),
        (120.0, "px", "120 px"),
        (3.25, "px", "3.2 px"),
    ],
)
def test_sizes(value: float, units: str, expected: str) -> None:
    facade = replace(row("a", {"a": 1.0}), units=units)
    assert wording.length(value, facade) == expected
    assert wording.amount(Amount(value, units), facade) == expected


def test_counts() -> None:
    facade = row("a", {"a": 1.0})
    assert wording.amount(Amount(1.0, "regions"), facade) == "1 region"
    assert wording.amount(Amount(2.0, "regions"), facade) == "2 regions"


def test_names_are_as_short_as_they_can_be() -> None:
    floors = tuple(
        Region(s, 2.0, 1.0, "columns", (Region("Bay", 1.0, 1.0), Region(f"Own{s}", 1.0, 1.0))) for s in "FG"
    )
    facade = Facade("f", "m", Region("R", 2.0, 2.0, "rows", floors))
    assert wording.name("R/F/Bay", facade) == "F/Bay"
    assert wording.name("R/F/OwnF", facade) == "OwnF"
    assert wording.name("R", facade) == "R"


def test_long_lists_are_cut() -> None:
    facade = row("abcdef", dict.fromkeys("abcdef", 1.0))
    of = " | ".join(f"R/{letter}" for letter in "abcdef")
    many = Size(of=RegionSet.parse(f"{of} | R/a | R/b | R/c"), min=Measure(2.0), place=Place("f", 7))
    unit = Unit.of(many)
    regions = [f"R/{letter}" for letter in "abcdef"]
    assert wording.subject(unit, regions) == "size of R/a, R/b and 4 more"
    assert (
        wording.widening(unit, "min", Measure(1.0), facade)
        == "lower the minimum of the size in line 7 to 1.00 m"
    )
    assert wording.permission("R", [tuple("abcdefabcdef")], facade).startswith(
        "allow a b c d e f a … f (12 regions) in R"
    )


def test_kinds_are_told_by_their_attributes() -> None:
    facade = row("ab", {"a": 1.0, "b": 1.0})
    frequency = Unit.of(Frequency(of=RegionSet("a"), within="R", min=Measure(1.0), max=Measure(2.0, True)))
    assert wording.subject(frequency, ()) == "frequency of a in R"
    assert wording.demand(frequency, frequency.constraints, facade) == "at least 1, at most 200%"
    sequence = SequenceConstraint(within=("R",), word=Word.parse("⊢ a"))
    unit = Unit((sequence,), (sequence,), "R")
    assert (wording.subject(unit, ()), wording.demand(unit, unit.constraints, facade)) == (
        "sequences of R",
        "⊢ a",
    )


def test_what_needs_no_arrangement_names_none() -> None:
    sizes = [Size(of=RegionSet(f"R/{s}"), min=Measure(2.0)) for s in "ab"]
    facade = row("ab", {"a": 1.0, "b": 1.0}, [*any_word("R", "ab"), *sizes])
    (diagnostic,) = diagnostics(explain(facade, (1.0, 3.0)), facade)
    assert [line.split("  ")[0] for line in diagnostic.details] == [
        "size of R/a",
        "size of R/b",
        "short by 1.00 m",
    ]
    assert diagnostic.place is None
