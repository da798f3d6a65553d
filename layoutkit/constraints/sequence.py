"""Sequences: which arrangements a composite region may have (Bao et al. 2013, section 5.1, sequences)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Sequence as ListOf
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import PATHS, WEIGHT, WORD, attribute
from layoutkit.constraints.claims import Claim, Permits
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.covering import Covering, Piece
from layoutkit.constraints.references import unknown_composite, unknown_in_word
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Region, Violation, Word

if TYPE_CHECKING:
    from typing import Self


@dataclass(frozen=True, kw_only=True)
class Sequence(Constraint):
    """A list of regions that may appear together, in that order, as part of an arrangement.

    Attributes
    ----------
    weight
        How likely, against the others, the search goes on with it where several could follow. A sequence is
        a permission: it is never soft.
    """

    kind: ClassVar[str] = "sequence"
    summary: ClassVar[str] = (
        "All sequences of a region together say which arrangements are valid: those that a chain of "
        "instantiations covers, each next one overlapping the one before in at least one subregion. A region "
        "without sequences keeps the input's arrangement."
    )

    within: tuple[str, ...] = attribute(PATHS, "Paths of the composite regions that it holds for.")
    word: Word = attribute(
        WORD, "Symbols, @labels and {sets} of direct subregions, with a leading ⊢ or trailing ⊣ for its ends."
    )
    weight: float = attribute(
        WEIGHT,
        "How likely, against the others, the search goes on with it where several could follow. A sequence "
        "is a permission, never soft.",
        1.0,
    )

    @property
    def soft(self) -> bool:
        """False: what is permitted is not taken back."""
        return False

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names."""
        for path in self.within:
            yield from (unknown := list(unknown_composite(self, path, facade)))
            if not unknown:
                yield from unknown_in_word(self, self.word, path, facade)

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield the regions whose arrangements it permits."""
        yield from (Permits(path) for path in self.within)

    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        """Return the sequence in each region."""
        return {path: replace(self, within=(path,)) for path in self.within}

    def piece(self, region: Region) -> Piece:
        """Return the sequence as sets of symbols of the region's children."""
        names = {c.symbol: frozenset({c.symbol, *(f"@{n}" for n in c.labels)}) for c in region.children}
        sets = tuple(
            frozenset(symbol for symbol, own in names.items() if regions.contains(own))
            for regions in self.word.sets
        )
        return Piece(sets, self.word.at_start, self.word.at_end, self.weight)

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield one automaton for each region that has sequences; regions with the same ones share it."""
        automata: dict[tuple[Piece, ...], Covering] = {}
        for path in dict.fromkeys(path for c in constraints for path in c.within):
            own = tuple(c for c in constraints if path in c.within)
            pieces = tuple(c.piece(facade.regions[path]) for c in own)
            yield Admits(path, automata.setdefault(pieces, Covering(pieces)), own)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every arrangement that no chain of the region's sequences covers; the first one reports."""
        # Expansion makes sequences of generators, and so looks at this module.
        from layoutkit.constraints.expansion import as_written, together

        for path in self.within:
            own = together(view.facade, type(self)).get(path, ())
            if not own or own[0] is not self:
                continue
            pieces = [c.piece(view.facade.regions[path]) for c in own]
            for placed in view.places(path):
                if not covered(placed.region.word, pieces):
                    word = " ".join(placed.region.word)
                    message = f"no chain of its sequences covers {word!r}"
                    yield Violation(as_written(view.facade, self), placed.path, message, 1.0)


def covered(word: tuple[str, ...], pieces: ListOf[Piece]) -> bool:
    """Tell whether a chain of instantiations covers the whole word, from ⊢ to ⊣.

    Written for checking, from the definition: ends[p] says that some chain from the start ends with an
    instantiation whose last position is p.
    """
    framed = ("⊢", *word, "⊣")
    spelled = [
        ((frozenset("⊢"),) if p.at_start else ()) + p.sets + ((frozenset("⊣"),) if p.at_end else ())
        for p in pieces
    ]
    reached = {
        len(sets) - 1
        for piece, sets in zip(pieces, spelled, strict=True)
        if piece.at_start and _fits(framed, 0, sets)
    }
    pending = list(reached)
    while pending:
        end = pending.pop()
        for sets in spelled:
            # A common subregion is needed: neither ⊢ nor ⊣ is one.
            for start in range(max(1, end - len(sets) + 2), min(end, len(word)) + 1):
                last = start + len(sets) - 1
                if last not in reached and _fits(framed, start, sets):
                    reached.add(last)
                    pending.append(last)
    return len(framed) - 1 in reached


def _fits(framed: tuple[str, ...], start: int, sets: tuple[frozenset[str], ...]) -> bool:
    inside = start + len(sets) <= len(framed)
    return inside and all(framed[start + i] in allowed for i, allowed in enumerate(sets))
