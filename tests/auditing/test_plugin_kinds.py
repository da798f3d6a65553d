"""Constraint kinds of others take part in the audit by what they say through the interface."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

from audited_houses import FREE, audited, house

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import PATH, attribute
from layoutkit.constraints.claims import Claim, InLine, Relates
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, Anything, WordRule
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.model import Facade, Violation
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Range, SizeRule

ACME = Namespace("acme", "urn:acme:1")
PLACE = Place("house.xml", 99, 5)


@dataclass(frozen=True, kw_only=True)
class Narrow(Constraint):
    """A region is at most 1 m wide."""

    kind: ClassVar[str] = "narrow"
    namespace: ClassVar[Namespace] = ACME
    summary: ClassVar[str] = "The region is at most 1 m wide."

    of: str = attribute(PATH, "The region.")

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        if self.of in arrangement.frames:
            words = (self.of.rpartition("/")[0],)
            yield Range(0, arrangement.extent(self.of, 0), 0.0, 1.0, self, words)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        for placed in view.places(self.of):
            if (amount := placed.box.width - 1.0) > view.tolerance:
                yield Violation(self, placed.path, "is too wide", amount)


class Told(Narrow):
    """The same, that says of its rules that they hang on no word."""

    def relations(self, facade: Facade) -> Iterable[Relates] | None:
        return ()


class Hushed(Narrow):
    """The same, that says nothing of what its rules hang on."""

    def relations(self, facade: Facade) -> Iterable[Relates] | None:
        return None


class _Odd:
    """Accepts words of an odd number of symbols, two at most."""

    def start(self) -> int:
        return 0

    def step(self, state: int, symbol: str) -> int | None:
        return state + 1 if state < 2 else None

    def accepts(self, state: int) -> bool:
        return state == 1


@dataclass(frozen=True, kw_only=True)
class Alone(Constraint):
    """A region has one child."""

    kind: ClassVar[str] = "alone"
    namespace: ClassVar[Namespace] = ACME
    summary: ClassVar[str] = "The region has one child."

    of: str = attribute(PATH, "The region.")

    @classmethod
    def word_rules(cls, constraints: Sequence[Alone], facade: Facade) -> Iterator[WordRule]:  # type: ignore[override]
        for constraint in constraints:
            yield Admits(constraint.of, _Odd(), (constraint,))
            yield Admits(constraint.of, Anything(), (constraint,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        for placed in view.places(self.of):
            if len(placed.region.children) != 1:
                yield Violation(self, placed.path, "is not alone", 1.0)


@dataclass(frozen=True, kw_only=True)
class Level(Constraint):
    """Two regions begin at the same height."""

    kind: ClassVar[str] = "level"
    namespace: ClassVar[Namespace] = ACME
    summary: ClassVar[str] = "Two regions begin at the same height, where they are beside each other."

    one: str = attribute(PATH, "The one.")
    other: str = attribute(PATH, "The other.")

    def claims(self, facade: Facade) -> Iterator[Claim]:
        yield InLine(1, (self.one,), (self.other,), (0.0,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        return iter(())


def said(folder: Path, own: Constraint, *constraints: str) -> list[Diagnostic]:
    facade = house(folder, *constraints)
    return list(audited(replace(facade, constraints=(*facade.constraints, replace(own, place=PLACE)))))


def test_rows_that_always_hold_contradict_a_size(tmp_path: Path) -> None:
    for kind in (Told, Hushed):  # words without a choice need no promise
        (fault,) = said(tmp_path, kind(of="House/Floor/Bay"), '<size of="@Window" min="1.5"/>')
        assert (fault.code, str(fault.severity)) == ("LK226", "error")
        assert PLACE in fault.related
        assert "acme:narrow of House/Floor/Bay" in str(fault)
        assert "0.50 m" in str(fault)


def test_rows_that_may_hang_on_words_prove_nothing_of_other_words(tmp_path: Path) -> None:
    (fault,) = said(tmp_path, Told(of="House/Floor/Bay"), *FREE, '<size of="@Window" min="1.5"/>')
    assert (fault.code, str(fault.severity)) == ("LK226", "error")
    found = said(tmp_path, Hushed(of="House/Floor/Bay"), *FREE, '<size of="@Window" min="1.5"/>')
    assert all(fault.code == "LK227" for fault in found), "at most of the facade's own size"


def test_rules_on_words_leave_no_arrangement(tmp_path: Path) -> None:
    (fault,) = said(tmp_path, Alone(of="House/Floor"), *FREE)
    assert (fault.code, str(fault.severity)) == ("LK225", "error")
    assert PLACE in fault.related
    assert "acme:alone" in str(fault)


def test_lines_that_are_never_beside_each_other(tmp_path: Path) -> None:
    (fault,) = said(tmp_path, Level(one="House/Floor", other="House/Ground"))
    assert (fault.code, fault.place) == ("LK229", PLACE)
    assert "acme:level" in fault.message
    assert said(tmp_path, Level(one="House/Floor/Bay", other="House/Floor/Pier")) == []
