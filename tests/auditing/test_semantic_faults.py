"""What the audit says of constraints that cannot mean what they say, and where."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import pytest
from audited_houses import FIRST, FREE, audited, house

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit_relayout.auditing.stage import AuditOptions


@dataclass(frozen=True)
class Case:
    """Constraints, and what is said: severity, code, number of the constraint; and parts of the text."""

    name: str
    constraints: tuple[str, ...]
    expected: tuple[str, ...]
    says: tuple[str, ...] = ()


CASES = [
    Case("nothing", ('<size of="@Window" min="1"/>',), ()),
    Case("a choice", FREE, ()),
    # Sizes
    Case(
        "storeys higher than the house",
        ('<size of="House" max="5"/>', '<size of="House/Floor | House/Ground" min="3"/>'),
        ("error LK224 1",),
        ("at least 6.00 m high, and may be at most 5.00 m", "short by 1.00 m", "by 1.00 m in all"),
    ),
    Case(
        "a door higher than its floor",
        (
            '<size of="House/Ground" max="2"/>',
            '<size of="House/Ground/Door/Leaf" min="2"/>',
            '<size of="House/Ground/Door/Over" min="0.5"/>',
        ),
        ("error LK224 1",),
        ("the sizes in House/Ground cannot add up", "0.50 m"),
    ),
    Case(
        "ranges of one region that do not meet",
        ('<size of="House/Floor" min="3.5"/>', '<size of="House/Floor | House/Ground" max="3"/>'),
        ("error LK226 1",),
        ("the sizes of House/Floor contradict each other", "0.50 m"),
    ),
    Case(
        "a lock against a size",
        (*FREE, '<lock of="House/Floor/Bay" keep="size"/>', '<size of="@Window" min="2.5"/>'),
        ("error LK226 4",),
        ("the sizes of House/Floor/Bay contradict each other", "by 0.50 m"),
    ),
    Case(
        "equal sizes that are not",
        (
            '<size of="House/Floor" max="2.8"/>',
            '<size of="House/Ground" min="3"/>',
            '<same-size first="House/Floor" second="House/Ground" dimension="height"/>',
        ),
        ("error LK226 1",),
        ("contradict each other at any size", "loosen one of them by 0.20 m"),
    ),
    # Arrangements
    Case(
        "a sequence without ends",
        ('<sequence within="House/Floor" word="Pier Bay Pier"/>',),
        ("error LK225 1",),
        ("admit no arrangement at all", "no sequence begins with ⊢", "no sequence ends with ⊣"),
    ),
    Case(
        "sequences that do not overlap",
        (
            '<sequence within="House/Floor" word="|- Pier Bay"/>',
            '<sequence within="House/Floor" word="Pier Pier -|"/>',
        ),
        ("error LK225 1",),
        ("each overlaps the one before",),
    ),
    Case(
        "more bays than the input's arrangement has",
        ('<frequency of="Bay" within="House/Floor" min="4"/>',),
        ("error LK225 1",),
        ("as in the input: Pier Bay Pier Bay Pier", "short by 2 regions", "by 2 regions"),
    ),
    Case(
        "labels counted from floor to floor",
        ('<frequency of="@Window | @Door" within="House" max="2"/>',),
        ("error LK225 1",),
        ("short by 1 region",),
    ),
    Case(
        "no mirror image",
        ('<sequence within="House/Floor" word="|- Pier Bay -|"/>', '<symmetry of="House/Floor"/>'),
        ("error LK225 1",),
        ("no arrangement of House/Floor satisfies all",),
    ),
    Case(
        "at least four, and at most three",
        (
            *FREE,
            '<frequency of="Bay" within="House/Floor" min="4"/>',
            '<frequency of="@Window" within="House/Floor" max="3"/>',
        ),
        ("error LK226 4",),
        ("these constraints on House/Floor contradict each other", "loosen one by 1 region"),
    ),
    Case(
        "two faults, each by itself",
        (
            '<sequence within="House/Floor" word="Pier Bay"/>',
            '<size of="House/Ground/Pier" max="0.8"/>',
            '<size of="House/Ground/Pier" min="1"/>',
        ),
        ("error LK225 1", "error LK226 2"),
    ),
    Case(
        "an optional region that cannot be",
        (
            '<sequence within="House/Floor" word="|- Pier"/>',
            '<sequence within="House/Floor" word="{Pier Bay} {Pier Bay}"/>',
            '<sequence within="House/Floor" word="Pier -|"/>',
            '<lock of="House/Floor/Bay" keep="size"/>',
            '<size of="@Window" min="2.5"/>',
        ),
        ("warning LK226 4",),
        ("House/Floor/Bay is in no layout",),
    ),
    # The facade's own size
    Case(
        "lower than it is",
        ('<size of="House/Floor" max="2"/>', '<size of="House/Ground" max="3"/>'),
        ("warning LK227 1",),
        ("6.00 m high: each is at most 5.00 m high", "ask for 5.00 m (--height)"),
    ),
    Case(
        "no number of bays that fits",
        (
            *FREE,
            '<size of="House/Floor/Bay" min="2.4" max="2.4"/>',
            '<size of="House/Floor/Pier" min="1" max="1"/>',
        ),
        ("warning LK227 5",),
        ("no layout has the facade's own size: these constraints cannot hold together",),
    ),
    Case("other sizes than the input's, at its own size", ('<size of="House/Floor" min="3.5"/>',), ()),
    # What can never matter
    Case(
        "a floor that no arrangement has",
        (
            '<sequence within="House" word="|- Floor Floor -|"/>',
            '<size of="House/Ground/Door" min="4"/>',
            '<alignment first="@Window" second="@Door" lines="left"/>',
            '<frequency of="@Door" within="House" max="2"/>',
            '<frequency of="Pier" within="House/Ground" min="9"/>',
        ),
        ("warning LK228 1",),
        ("Ground stands in no arrangement that House can have", "so it asks nothing: alignment"),
    ),
    Case(
        "side by side",
        ('<alignment first="House/Floor/Pier" second="House/Floor/Bay" lines="left"/>',),
        ("warning LK229 1",),
    ),
    Case("one above the other", ('<alignment first="House/Floor" second="House/Ground" lines="left"/>',), ()),
    Case(
        "never both at once",
        (
            '<sequence within="House" word="|- {Floor Ground} -|"/>',
            '<alignment first="@Window" second="@Door" lines="left"/>',
        ),
        ("warning LK229 2",),
    ),
    Case(
        "nothing to count",
        ('<frequency of="@Window - House/Floor/Bay" within="House" max="3"/>',),
        ("warning LK229 1",),
        ("have nothing in them",),
    ),
    Case(
        "no range",
        ('<frequency of="Bay" within="House/Floor"/>',),
        ("warning LK229 1",),
        ("neither min nor max",),
    ),
    Case("instances of what stands once", ('<instances of="House/Ground"/>',), ("warning LK229 1",)),
    Case("instances of what stands twice", ('<instances of="House/Floor/Bay"/>',), ()),
    Case(
        "a context that is nowhere",
        ('<alignment first="@Window" second="@Door" lines="left" first-before="Bay"/>',),
        ("warning LK230 1",),
        ("the context of first (before Bay)",),
    ),
    Case(
        "a context that another arrangement has",
        (
            '<sequence within="House/Floor" word="|- Pier Bay {Pier Bay}"/>',
            '<sequence within="House/Floor" word="{Pier Bay} Bay Pier -|"/>',
            '<alignment first="@Window" second="@Door" lines="left" first-before="Bay"/>',
        ),
        (),
    ),
    Case(
        "a run that is nowhere",
        ('<same-size first="House/Floor: Bay Bay" second="House/Ground: Door" dimension="width"/>',),
        ("warning LK230 1",),
        ("the run Bay Bay of first",),
    ),
    Case(
        "a sequence that nothing leads to",
        (*FREE, '<sequence within="House/Floor" word="Pier Pier"/>'),
        ("warning LK230 4",),
        ("no arrangement contains this sequence",),
    ),
]


def told(diagnostic: Diagnostic) -> str:
    number = diagnostic.place.line - FIRST + 1 if diagnostic.place else 0
    return f"{diagnostic.severity} {diagnostic.code} {number}"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_semantic_faults(case: Case, tmp_path: Path) -> None:
    found = audited(house(tmp_path, *case.constraints))
    assert tuple(map(told, found)) == case.expected, "\n".join(map(str, found))
    text = "\n".join(map(str, found))
    for part in case.says:
        assert part in text


def test_faults_name_all_places_and_hint_at_a_remedy(tmp_path: Path) -> None:
    for case in CASES:
        for diagnostic in audited(house(tmp_path, *case.constraints)):
            assert diagnostic.hint, case.name
            assert diagnostic.topic == "semantics", case.name
            assert not diagnostic.related or diagnostic.place in diagnostic.related, case.name
    (fault,) = audited(
        house(tmp_path, '<size of="House/Floor" min="4"/>', '<size of="@Wall | House/Floor" max="3"/>')
    )
    assert [place.line - FIRST + 1 for place in fault.related] == [1, 2]


def test_an_error_says_more_than_a_warning(tmp_path: Path) -> None:
    """The same fault in a region that no layout needs."""
    needless = ('<sequence within="House" word="|- Ground {Ground Floor} -|"/>',)
    fault = ('<sequence within="House/Floor" word="Pier Bay"/>',)
    (error,) = audited(house(tmp_path, *fault))
    (warning,) = audited(house(tmp_path, *needless, *fault))
    assert (error.severity, warning.severity) == (Severity.ERROR, Severity.WARNING)
    assert warning.message.startswith(error.message)


def test_what_takes_longer_is_not_told(tmp_path: Path) -> None:
    (case,) = (case for case in CASES if case.name == "no number of bays that fits")
    facade = house(tmp_path, *case.constraints)
    (little,) = audited(facade, AuditOptions(effort=20))
    (more,) = audited(facade)
    assert little.code == more.code
    assert "`layoutkit explain` at this size tells" in little.hint
    assert "`layoutkit explain`" not in more.hint


def test_a_label_that_is_nearly_named(tmp_path: Path) -> None:
    def notes(label: str, named: str = "@Window") -> list[str]:
        facade = house(tmp_path, f'<size of="{named}" min="1"/>')
        file = tmp_path / "house.xml"
        file.write_text(file.read_text().replace('labels="Door"', f'labels="{label}"'), encoding="utf-8")
        from audited_houses import KINDS

        from layoutkit.documents import read
        from layoutkit.model import Facade

        facade = read(file, KINDS).model  # type: ignore[assignment]
        assert isinstance(facade, Facade)
        return [re.sub(r" \(.*", "", d.message) for d in audited(facade)]

    assert notes("Door") == []
    assert notes("window") == ["no constraint names the label 'window'"]
    assert notes("Windows") == ["no constraint names the label 'Windows'"]
    assert notes("Window2") == []
    assert notes("Hall", named="@Wall") == []
