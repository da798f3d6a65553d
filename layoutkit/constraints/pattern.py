"""Patterns: whole arrangements, written with marks for what may be left out or repeated.

A pattern such as ``O (P Q R)+[S] T`` is made of what sequences are made of, symbols, @labels and {sets}, and
of marks behind them: ``?`` for what may be left out, ``+`` for what may be repeated, ``*`` for both. What
stands in brackets behind ``+`` or ``*`` comes between each two repetitions. Parentheses group, and ``|``
stands between alternatives.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass

from layoutkit.constraints.attributes import AttributeType
from layoutkit.model import RegionSet, Word
from layoutkit.model.selection import SYMBOL

#: Deeper patterns are refused: nobody reads them, and the functions here call themselves.
_DEEPEST = 40

_TOKEN = re.compile(rf"\s*(?P<token>\{{[^{{}}]*\}}|@?{SYMBOL}|[()\[\]?*+]|\|(?!-))")


@dataclass(frozen=True, slots=True)
class Pattern(ABC):
    """What a composite region's arrangement looks like, from its start to its end."""

    @staticmethod
    def parse(text: str) -> Pattern:
        """Read a pattern.

        Raises
        ------
        ValueError
            If the text is not of that form; the message says where.
        """
        return _Reader(text).whole()

    @abstractmethod
    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets that it is made of, in order."""


@dataclass(frozen=True, slots=True)
class One(Pattern):
    """A single region of a set."""

    regions: RegionSet

    def sets(self) -> Iterator[RegionSet]:
        """Yield the set."""
        yield self.regions

    def __str__(self) -> str:
        return str(Word((self.regions,)))


@dataclass(frozen=True, slots=True)
class Row(Pattern):
    """Parts one after the other; at least two."""

    parts: tuple[Pattern, ...]

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of the parts."""
        for part in self.parts:
            yield from part.sets()

    def __str__(self) -> str:
        return " ".join(f"({part})" if isinstance(part, Row | Either) else str(part) for part in self.parts)


@dataclass(frozen=True, slots=True)
class Either(Pattern):
    """One of several; at least two."""

    ways: tuple[Pattern, ...]

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of all alternatives."""
        for way in self.ways:
            yield from way.sets()

    def __str__(self) -> str:
        return " | ".join(f"({way})" if isinstance(way, Either) else str(way) for way in self.ways)


@dataclass(frozen=True, slots=True)
class Marked(Pattern):
    """A part that may be left out, repeated, or both.

    Attributes
    ----------
    mark
        ``?``, ``+`` or ``*``.
    between
        What comes between each two repetitions; None if nothing does.
    """

    part: Pattern
    mark: str
    between: Pattern | None = None

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of the part, and of what comes between."""
        yield from self.part.sets()
        if self.between is not None:
            yield from self.between.sets()

    def __str__(self) -> str:
        part = str(self.part) if isinstance(self.part, One) else f"({self.part})"
        return f"{part}{self.mark}" + (f"[{self.between}]" if self.between is not None else "")


def row(*parts: Pattern) -> Pattern:
    """Return parts one after the other; a single one stays as it is."""
    flat = tuple(inner for part in parts for inner in (part.parts if isinstance(part, Row) else (part,)))
    return flat[0] if len(flat) == 1 else Row(flat)


def either(*ways: Pattern) -> Pattern:
    """Return alternatives; a single one stays as it is."""
    flat = tuple(inner for way in ways for inner in (way.ways if isinstance(way, Either) else (way,)))
    return flat[0] if len(flat) == 1 else Either(flat)


class _Reader:
    """Reads the text of a pattern from left to right."""

    def __init__(self, text: str) -> None:
        self.text, self.depth, self.read = text, 0, 0
        self.tokens: list[str] = []
        self.starts: list[int] = []
        position, end = 0, len(text.rstrip())
        while position < end:
            token = _TOKEN.match(text, position)
            if token is None:
                raise self.unexpected(position)
            self.tokens.append(token["token"])
            self.starts.append(token.start("token"))
            position = token.end()

    def unexpected(self, position: int) -> ValueError:
        """Return an error for what is no token."""
        rest = self.text[position:].lstrip()
        if rest.startswith(("⊢", "⊣", "|-", "-|")):
            return self.fault("a pattern is the whole arrangement: ⊢ and ⊣ are not written", position)
        return self.fault(f"{rest[0]!r} is not expected", position)

    def fault(self, message: str, position: int | None = None) -> ValueError:
        """Return an error with the text up to where reading stopped."""
        if position is None:
            position = self.starts[self.read] if self.read < len(self.starts) else len(self.text)
        read = self.text[:position].strip()
        where = f"behind {read!r}" if read else "at the beginning"
        return ValueError(f"{message} ({where} of the pattern {self.text.strip()!r})")

    def next(self) -> str:
        """Return the next token; empty at the end of the text."""
        return self.tokens[self.read] if self.read < len(self.tokens) else ""

    def take(self) -> str:
        """Return the next token, and go on behind it."""
        self.read += 1
        return self.tokens[self.read - 1]

    def whole(self) -> Pattern:
        """Return the pattern that the text spells."""
        found = self.alternatives()
        if self.next():
            raise self.fault(f"{self.next()!r} closes nothing")
        return found

    def alternatives(self) -> Pattern:
        ways = [self.items()]
        while self.next() == "|":
            self.take()
            ways.append(self.items())
        return either(*ways)

    def items(self) -> Pattern:
        parts = []
        while self.next() not in ("", "|", ")", "]"):
            parts.append(self.item())
        if not parts:
            raise self.fault("a region is missing")
        return row(*parts)

    def item(self) -> Pattern:
        part = self.atom()
        if self.next() not in ("?", "*", "+"):
            return part
        mark = self.take()
        between = self.enclosed("]") if mark != "?" and self.next() == "[" else None
        if self.next() in ("?", "*", "+", "["):
            raise self.fault(f"{self.next()!r} does not go with the mark {mark!r} before it")
        return Marked(part, mark, between)

    def atom(self) -> Pattern:
        token = self.next()
        if token == "(":
            return self.enclosed(")")
        if token in ("?", "*", "+", "["):
            raise self.fault(f"{token!r} stands behind nothing")
        self.take()
        try:
            return One(Word.parse(token).sets[0])
        except ValueError as error:
            raise self.fault(str(error)) from None

    def enclosed(self, end: str) -> Pattern:
        start = self.take()
        self.depth += 1
        if self.depth > _DEEPEST:
            raise self.fault(f"more than {_DEEPEST} parentheses stand inside one another")
        found = self.alternatives()
        if self.next() != end:
            raise self.fault(f"{start!r} is not closed")
        self.take()
        self.depth -= 1
        return found


PATTERN = AttributeType("pattern", Pattern.parse)
