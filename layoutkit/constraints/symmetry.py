"""Symmetry: regions that mirror themselves (Bao et al. 2013, section 5.1, symmetry)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from collections.abc import Sequence as ListOf
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import PAIRS, PATHS, attribute
from layoutkit.constraints.claims import Relates
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.instances import original
from layoutkit.constraints.references import unknown_composite, unknown_symbols
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Mirrored, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, PlacedRegion, Violation
from layoutkit.sizing.arrangement import AXIS, Arrangement, add
from layoutkit.sizing.rules import Range, SizeRule

if TYPE_CHECKING:
    from typing import Self


@dataclass(frozen=True, kw_only=True)
class Symmetry(Constraint):
    """Composite regions whose arrangement reads the same from both ends, in symbols and in sizes."""

    kind: ClassVar[str] = "symmetry"
    summary: ClassVar[str] = (
        "The arrangement of each region is a palindrome, in which a symbol may be paired with another that "
        "stands for it on the other side, and what mirrors each other is equally large."
    )

    of: tuple[str, ...] = attribute(PATHS, "Paths of the composite regions.")
    pairs: tuple[tuple[str, str], ...] = attribute(
        PAIRS, "Symbols that mirror each other, such as `E:K L:R`; all others mirror themselves.", ()
    )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, terminals, and symbols in two pairs."""
        symbols = [symbol for pair in self.pairs for symbol in pair]
        for path in self.of:
            unknown = list(unknown_composite(self, path, facade))
            yield from unknown or unknown_symbols(self, dict.fromkeys(symbols), path, facade)
        for symbol in (symbol for symbol, times in Counter(symbols).items() if times > 1):
            yield Diagnostic(
                "LK217",
                f"{symbol} stands in the pairs more than once",
                self.place,
                "name each symbol once; one that mirrors itself needs no pair",
                topic="symmetry",
            )

    def partners(self, facade: Facade, path: str) -> Mapping[str, str]:
        """Return the partner of every symbol of a region."""
        paired = dict(self.pairs) | {other: one for one, other in self.pairs}
        return {
            child.symbol: paired.get(child.symbol, child.symbol) for child in facade.regions[path].children
        }

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield a mirrored word for each region."""
        for constraint in constraints:
            for path in constraint.of:
                own = {a: (b,) for a, b in constraint.partners(facade, path).items()}
                yield Mirrored(path, own, (constraint,), equal=True)

    def relations(self, facade: Facade) -> Iterator[Relates]:
        """Yield the children of each region with pairs: in a word that mirrors itself, both occur, or none.

        Where one instance of a region may mirror another, the order says which ones do.
        """
        for path in self.of:
            region = facade.regions[path]
            axis = AXIS[region.split or "columns"]
            children = [f"{path}/{symbol}" for symbol in dict.fromkeys(c.symbol for c in region.children)]
            instances = any(original(child) != child for child in children)
            if self.pairs or instances:
                ordered = (path,) if instances else ()
                yield Relates(frozenset((child, axis) for child in children), ordered=ordered, whole=False)

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield the pairs of each region."""
        for path in self.of:
            axis = AXIS[facade.regions[path].split or "columns"]
            for one, other in self.pairs:
                yield axis, (f"{path}/{one}", f"{path}/{other}")

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield an equality for each two symbols that mirror each other.

        That the word mirrors itself is what the word rules see to; of one symbol, all are equally large.
        """
        facade = arrangement.facade
        for path in (path for path in self.of if path in arrangement.words):
            axis, word = AXIS[facade.regions[path].split or "columns"], arrangement.words[path]
            half = len(word) // 2
            pairs = (sorted(pair) for pair in zip(word[:half], reversed(word), strict=False))
            for pair in dict.fromkeys(map(tuple, pairs)):
                one, other = (arrangement.extent(f"{path}/{symbol}", axis) for symbol in pair)
                if difference := add(one, other, -1.0):
                    yield Range(axis, difference, 0.0, 0.0, self, (path,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every region whose word is no palindrome, and every two partners of different sizes."""
        for path in self.of:
            partners = self.partners(view.facade, path)
            for placed in view.places(path):
                word = placed.region.word
                wrong = sum(partners.get(a) != b for a, b in zip(word, reversed(word), strict=True))
                if wrong:
                    shown = f"its arrangement {' '.join(word)!r} does not mirror itself"
                    yield Violation(self, placed.path, shown, float((wrong + 1) // 2))
                else:
                    yield from self._unequal(placed, view.tolerance)

    def _unequal(self, placed: PlacedRegion, tolerance: float) -> Iterator[Violation]:
        region = placed.region
        sizes = [child.extent(region.split or "columns") for child in region.children]
        for index in range(len(sizes) // 2):
            one, other = sizes[index], sizes[-1 - index]
            if (amount := abs(one - other)) > tolerance:
                names = region.word[index], region.word[-1 - index]
                shown = f"{names[0]} and {names[1]} mirror each other, of sizes {one:g} and {other:g}"
                yield Violation(self, placed.path, shown, amount)
