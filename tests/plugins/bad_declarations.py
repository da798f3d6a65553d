"""Constraint kinds of which each breaks a promise about its declaration, or about what users read."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, ClassVar

from bad_kinds import Bad, Good, kind

from layoutkit.constraints.attributes import AttributeType, attribute
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Violation


@kind
class NoPlace(Bad):
    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        for fault in super().faults(facade):
            yield Diagnostic(fault.code, fault.message, None, fault.hint)


@kind
class NoHint(Bad):
    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        for fault in super().faults(facade):
            yield Diagnostic(fault.code, fault.message, fault.place)


@kind
class TakesAnyName(Bad):
    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        return iter(())


@kind
class AmountIsNoNumber(Bad):
    def wrong_sizes(self, view: LayoutView) -> Iterator[Violation]:
        for violation in super().wrong_sizes(view):
            yield Violation(self, violation.path, violation.message, math.nan)


@kind
class AmountIsNegative(Bad):
    def wrong_sizes(self, view: LayoutView) -> Iterator[Violation]:
        for violation in super().wrong_sizes(view):
            yield Violation(self, violation.path, violation.message, -violation.amount)


@kind
class NamesSymbolPaths(Bad):
    def wrong_sizes(self, view: LayoutView) -> Iterator[Violation]:
        for violation in super().wrong_sizes(view):
            yield Violation(self, f"window {violation.path}", violation.message, violation.amount)


def _quoted(text: str) -> str:
    return text.strip()


@kind
class NotReadBack(Bad):
    note: str = attribute(AttributeType("note", _quoted, lambda value: f"«{value}»"), "A note.", "none")


def _looked_up(text: str) -> str:
    return {"one": "1"}[text]


@kind
class ChokesOnTexts(Bad):
    number: str = attribute(AttributeType("number", _looked_up, lambda value: "one"), "A number.", "1")


def _listed(text: str) -> list[str]:
    return text.split()


@kind
class NotHashable(Bad):
    names: list[str] = attribute(AttributeType("names", _listed, " ".join), "Names.", None)


class Handle:
    """A value that cannot be pickled."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Handle) and other.text == self.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> Any:
        raise TypeError("a handle stays where it is")


@kind
class NotPickled(Bad):
    handle: Handle | None = attribute(
        AttributeType("handle", Handle, lambda value: value.text), "A handle.", None
    )


@kind
class PatternRefusesItsText(Bad):
    size: float = attribute(AttributeType("size", float, repr, r"[0-9]+"), "A size.", 1.5)


@kind
class NoHelp(Bad):
    size: str = attribute(AttributeType("text", str, str), " ", "")


class Loose(Good):
    """No dataclass of its own."""

    kind: ClassVar[str] = "loose"
