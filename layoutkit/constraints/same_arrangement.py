"""Same arrangement: regions whose words agree symbol by symbol.

Not in Bao et al. 2013, who couple floors by alignments alone. Floors that share their bays are the common
case in real facades, and an equality of words is what people mean there: it is exact, can be counted, and
needs no guess which of two regions might overlap.
"""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence as ListOf
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import PATHS, attribute
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_composite
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Agree, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Violation

if TYPE_CHECKING:
    from typing import Self


@dataclass(frozen=True, kw_only=True)
class SameArrangement(Constraint):
    """The arrangements of several composite regions are the same word."""

    kind: ClassVar[str] = "same-arrangement"
    summary: ClassVar[str] = (
        "The regions have the same arrangement, symbol by symbol: floors whose bays stand in line."
    )

    of: tuple[str, ...] = attribute(PATHS, "Paths of the composite regions, at least two.")

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown regions, and symbols that one region has and another lacks."""
        yield from (unknown := [d for path in self.of for d in unknown_composite(self, path, facade)])
        if unknown:
            return
        symbols = {path: {c.symbol for c in facade.regions[path].children} for path in self.of}
        for path in self.of[1:]:
            if different := symbols[path] ^ symbols[self.of[0]]:
                yield Diagnostic(
                    "LK208",
                    f"{self.of[0]} and {path} do not have the same symbols: {', '.join(sorted(different))}",
                    self.place,
                    "give subregions that stand one above the other the same symbol",
                    topic="reference",
                )

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield one agreement for each."""
        for constraint in constraints:
            own = {p: {c.symbol: c.symbol for c in facade.regions[p].children} for p in constraint.of}
            yield Agree(own, (constraint,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every region whose word is not that of the first."""
        placed = [p for path in self.of for p in view.places(path)]
        for other in placed[1:]:
            if other.region.word != placed[0].region.word:
                yield Violation(self, other.path, f"its arrangement is not that of {placed[0].path}", 1.0)
