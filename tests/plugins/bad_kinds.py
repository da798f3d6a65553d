"""A constraint kind that keeps its promises, and others like it of which each breaks one."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import Any, ClassVar

import numpy as np

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import REGIONS, attribute
from layoutkit.constraints.claims import Claim, Permits, Relates, Sized
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, Anything, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, RegionSet, Violation
from layoutkit.sizing.arrangement import Arrangement, add
from layoutkit.sizing.rules import Convex, Range, Rows, SizeRule


class FirstOnce:
    """Accepts words whose first symbol does not come again, whatever the others do."""

    def start(self) -> Any:
        return ""

    def step(self, state: Any, symbol: str) -> Any:
        return None if symbol == state else state or symbol

    def accepts(self, state: Any) -> bool:
        return bool(state)


@dataclass(frozen=True, kw_only=True)
class Good(Constraint):
    """Regions are at most 2 units wide, and what stands first in their parents stands there only."""

    kind: ClassVar[str] = "good"
    namespace: ClassVar[Namespace] = Namespace("bad", "urn:test:bad")
    summary: ClassVar[str] = (
        "Regions are at most 2 wide; the first symbol of their parent does not come again."
    )

    of: RegionSet = attribute(REGIONS, "The regions.")

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        yield from unknown_names(self, self.of, facade)

    @classmethod
    def automaton(cls) -> Any:
        return FirstOnce()

    def parents(self, facade: Facade) -> list[str]:
        return list(dict.fromkeys(path.rpartition("/")[0] for path in facade.select(self.of)))

    @classmethod
    def word_rules(cls, constraints: Sequence[Any], facade: Facade) -> Iterator[WordRule]:
        for constraint in constraints:
            for parent in constraint.parents(facade):
                yield Admits(parent, cls.automaton(), (constraint,))

    most: ClassVar[float] = 2.0

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        for path in arrangement.facade.select(self.of):
            if path in arrangement.frames:
                yield self.row(arrangement, path)

    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        return Range(0, arrangement.extent(path, 0), 0.0, self.most, self)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        yield from self.wrong_words(view)
        yield from self.wrong_sizes(view)

    def wrong_words(self, view: LayoutView) -> Iterator[Violation]:
        for parent in self.parents(view.facade):
            for placed in view.places(parent):
                word = placed.region.word
                if again := word.count(word[0]) - 1:
                    yield Violation(self, placed.path, f"has {word[0]} again", float(again))

    def wrong_sizes(self, view: LayoutView) -> Iterator[Violation]:
        for path in view.facade.select(self.of):
            for placed in view.places(path):
                if (over := placed.box.width - self.most) > view.tolerance:
                    yield Violation(self, placed.path, f"is {placed.box.width:g} wide", over)


class Bad(Good):
    """The base of the others."""


def kind(cls: Any) -> Any:
    """Make a class a kind of its own name."""
    cls.kind = cls.__name__.lower()
    return dataclass(frozen=True, kw_only=True)(cls)


@kind
class RowsTooTight(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        return Range(0, arrangement.extent(path, 0), 0.5, self.most, self)


@kind
class RowsTooLoose(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        return Range(0, arrangement.extent(path, 0), 0.0, 1.05 * self.most, self)


@kind
class NoRows(Bad):
    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        return iter(())


class NeverTwice(FirstOnce):
    """Refuses also what ends as it begins with another symbol in between, and lone symbols."""

    def accepts(self, state: Any) -> bool:
        return False


class OnlyShort(FirstOnce):
    """Refuses words of more than four symbols."""

    def start(self) -> Any:
        return ("", 0)

    def step(self, state: Any, symbol: str) -> Any:
        first, read = state
        return None if symbol == first or read >= 4 else (first or symbol, read + 1)

    def accepts(self, state: Any) -> bool:
        return bool(state[0])


@kind
class PrunesAll(Bad):
    @classmethod
    def automaton(cls) -> Any:
        return NeverTwice()


@kind
class PrunesLongWords(Bad):
    @classmethod
    def automaton(cls) -> Any:
        return OnlyShort()


@kind
class PrunesNothing(Bad):
    @classmethod
    def automaton(cls) -> Any:
        return Anything()


class Counting(FirstOnce):
    """Counts what it reads, for ever."""

    def start(self) -> Any:
        return ("", 0)

    def step(self, state: Any, symbol: str) -> Any:
        return None if symbol == state[0] else (state[0] or symbol, state[1] + 1)

    def accepts(self, state: Any) -> bool:
        return bool(state[0])


@kind
class CountsForEver(Bad):
    @classmethod
    def automaton(cls) -> Any:
        return Counting()


class Listing(FirstOnce):
    """Its states are lists."""

    def start(self) -> Any:
        return [""]

    def step(self, state: Any, symbol: str) -> Any:
        return None if symbol == state[0] else [state[0] or symbol]

    def accepts(self, state: Any) -> bool:
        return bool(state[0])


@kind
class StatesAreLists(Bad):
    @classmethod
    def automaton(cls) -> Any:
        return Listing()


@kind
class OrderOfASet(Bad):
    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        for path in set(arrangement.facade.select(self.of)) & set(arrangement.frames):
            yield self.row(arrangement, path)


@kind
class NumberOfTheProcess(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        return Range(0, arrangement.extent(path, 0), -float(os.getpid()), self.most, self)


@kind
class DrawsAnew(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        least = -float(np.random.default_rng().random())
        return Range(0, arrangement.extent(path, 0), least, self.most, self)


@kind
class DrawsGlobally(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        np.random.random()  # noqa: NPY002 - this is what is bad about it
        return super().row(arrangement, path)


_CALLS = count()


@kind
class CountsItsCalls(Bad):
    def wrong_sizes(self, view: LayoutView) -> Iterator[Violation]:
        for violation in super().wrong_sizes(view):
            yield Violation(self, violation.path, f"call {next(_CALLS)}", violation.amount)


_WIDTHS: dict[str, float] = {}


@kind
class RemembersPaths(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        width = _WIDTHS.setdefault(path, arrangement.facade.regions[path].width)
        return Range(0, arrangement.extent(path, 0), -width, self.most, self)


@kind
class RemembersOnItself(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        widths = vars(self).setdefault("_widths", {})
        width = widths.setdefault(path, arrangement.facade.regions[path].width)
        return Range(0, arrangement.extent(path, 0), -width, self.most, self)


@kind
class ChangesTheFacade(Bad):
    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        facade.places["Facade/Attic"] = facade.places["Facade"]  # type: ignore[index]
        facade.regions["Facade/Attic"] = facade.regions["Facade"]  # type: ignore[index]
        return super().faults(facade)


@kind
class ChangesTheWords(Bad):
    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        arrangement.words["Facade/Attic"] = ("Attic",)  # type: ignore[index]
        return super().size_rules(arrangement)


@kind
class NoOrigin(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        return Range(0, arrangement.extent(path, 0), 0.0, self.most, None)


@kind
class WordsWithoutOrigin(Bad):
    @classmethod
    def word_rules(cls, constraints: Sequence[Any], facade: Facade) -> Iterator[WordRule]:
        for rule in super().word_rules(constraints, facade):
            assert isinstance(rule, Admits)
            yield Admits(rule.path, rule.automaton, ())


@kind
class RowsOfNoNumbers(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        own = (arrangement.size(path, 0),)
        return Rows(own, np.array([[math.nan]]), np.zeros(1), np.ones(1), self)


@kind
class WrongShape(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        own = (arrangement.size(path, 0),)
        return Rows(own, np.ones((1, 2)), np.zeros(1), np.ones(1), self)


@kind
class NotConvex(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        def excess(width: Any) -> Any:
            import cvxpy

            return self.most - cvxpy.square(width)

        return Convex((arrangement.size(path, 0),), excess, self)


@kind
class Raises(Bad):
    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        yield from super().size_rules(arrangement)
        raise KeyError("lost")


@kind
class AsksAheadOfWords(Bad):
    """At least two thirds of what is reached is narrow: which may change with words still to come."""

    def wide(self, widths: list[float]) -> float:
        return sum(widths) / len(widths) - 1.5 if widths else 0.0

    @classmethod
    def word_rules(cls, constraints: Sequence[Any], facade: Facade) -> Iterator[WordRule]:
        return iter(())

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        own = [path for path in arrangement.facade.select(self.of) if path in arrangement.frames]
        if own:
            mean = np.full((1, len(own)), 1 / len(own))
            sizes = tuple(arrangement.size(path, 0) for path in own)
            yield Rows(sizes, mean, np.full(1, -np.inf), np.full(1, 1.5), self)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        places = [view.places(path) for path in view.facade.select(self.of)]
        over = self.wide([own[0].box.width for own in places if own])
        if over > view.tolerance:
            yield Violation(self, view.layout.root.symbol, "is wide in the mean", over)


@kind
class ClaimsTooMuch(Bad):
    def claims(self, facade: Facade) -> Iterator[Claim]:
        for path in facade.select(self.of):
            yield Sized(path, 0.0, 1.0, 1.0, 0.1)


@kind
class PermitsWithoutRule(Bad):
    def claims(self, facade: Facade) -> Iterator[Claim]:
        yield Permits(facade.root.symbol)

    @classmethod
    def word_rules(cls, constraints: Sequence[Any], facade: Facade) -> Iterator[WordRule]:
        return iter(())


@kind
class PartsOfLess(Bad):
    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        first, *_ = facade.select(self.of)
        return {first: replace(self, of=RegionSet(first))}


@kind
class RelatesAfterAll(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        form = add(arrangement.extent(path, 0), arrangement.extent("Facade", 0), -0.5)
        return Range(0, form, -10.0, 10.0, self)

    def relations(self, facade: Facade) -> Iterable[Relates]:
        return ()


@kind
class RelatesBothAxes(Bad):
    def row(self, arrangement: Arrangement, path: str) -> SizeRule:
        sides = arrangement.size(path, 0), arrangement.size(path, 1)
        return Rows(sides, np.array([[1.0, 0.0]]), np.zeros(1), np.full(1, self.most), self)

    def relations(self, facade: Facade) -> Iterable[Relates]:
        for path in facade.select(self.of):
            yield Relates(frozenset({(path, 0), (path, 1)}))
