"""Contexts: what stands directly before and after a region (Bao et al. 2013, section 5.1, alignment).

A context is read in the word of the region's parent, whichever way that one is split.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_neighbours
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Region, Word
from layoutkit.model.extent import occurrences
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot

Run = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Context:
    """The words before and after a region or run; None where anything may stand."""

    before: Word | None
    after: Word | None

    @property
    def stated(self) -> bool:
        """Whether anything is said of what stands beside."""
        return self != ANYWHERE

    def faults(self, constraint: Constraint, parents: Iterable[str], facade: Facade) -> Iterator[Diagnostic]:
        """Yield names that no child of the parents goes by, and ends on the wrong side."""
        parents = tuple(dict.fromkeys(parents))
        for word in (self.before, self.after):
            if word is not None:
                yield from unknown_neighbours(constraint, word, parents, facade)
        if self.before is not None and self.before.at_end:
            yield _meaningless(constraint, f"nothing stands behind the end that {self.before} begins with")
        if self.after is not None and self.after.at_start:
            yield _meaningless(constraint, f"nothing stands before the start that {self.after} begins with")

    def runs(self, runs: Iterable[Run], source: Region, word: tuple[str, ...]) -> Iterator[Run]:
        """Yield those of the runs (start, and end exclusive) in a word that stand in the context."""
        starts = ends = None
        if self.before is not None:
            starts = {end for _, end in occurrences(self.before, source, word)}
        if self.after is not None:
            ends = {start for start, _ in occurrences(self.after, source, word)}
        for start, end in runs:
            if (starts is None or start in starts) and (ends is None or end in ends):
                yield start, end

    def slots(self, arrangement: Arrangement, path: str, axis: int) -> tuple[Slot, ...]:
        """Return the places of a region along an axis that stand in the context; the root is in none."""
        found = arrangement.slots(path, axis)
        if not self.stated or not found:
            return found
        parent, _, symbol = path.rpartition("/")
        if not parent:
            return ()
        source, word = arrangement.facade.regions[parent], arrangement.words[parent]
        own = ((index, index + 1) for index, other in enumerate(word) if other == symbol)
        inside = {start for start, _ in self.runs(own, source, word)}
        if source.split is not None and AXIS[source.split] == axis:
            return tuple(slot for slot in found if slot.order[-1] in inside)
        return found if inside else ()  # they all reach across the parent: one in the context is enough


ANYWHERE = Context(None, None)


def parents_of(paths: Iterable[str]) -> tuple[str, ...]:
    """Return the paths of the regions that others stand in, each once."""
    return tuple(dict.fromkeys(parent for path in paths if (parent := path.rpartition("/")[0])))


def without_extent(constraint: Constraint, context: Context) -> Iterator[Diagnostic]:
    """Yield a diagnostic if there is a context, but no extent that it could be of."""
    if context != ANYWHERE:
        yield _meaningless(constraint, "there is a context of second, and no second")


def _meaningless(constraint: Constraint, message: str) -> Diagnostic:
    hint = "exchange before and after, or delete the one that is meant for nothing"
    return Diagnostic("LK215", message, constraint.place, hint, topic=constraint.kind)
