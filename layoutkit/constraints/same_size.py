"""Same size: extents that are equal wherever they occur (Bao et al. 2013, section 5.1, same size)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import CONTEXT, ENCLOSING, EXTENT, attribute, choice
from layoutkit.constraints.claims import Claim, EquallyLarge, Frame, Relates
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.contexts import Context, parents_of, without_extent
from layoutkit.constraints.references import unknown_composite, unknown_in_word, unknown_names, unknown_path
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Extent, Facade, Violation, Word
from layoutkit.model.extent import occurrences
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot, add
from layoutkit.sizing.rules import Form, Range, SizeRule


@dataclass(frozen=True, kw_only=True)
class SameSize(Constraint):
    """All occurrences of two extents are equally wide, or equally high."""

    kind: ClassVar[str] = "same-size"
    summary: ClassVar[str] = (
        "All occurrences of the first and of the second extent are equally large: single regions, or runs of "
        "neighbouring ones. With a context, only those between such neighbours are asked."
    )

    first: Extent = attribute(EXTENT, "Regions (Facade/Floor/Bay, @Window) or a run (Facade/Side: P Q R S).")
    second: Extent | None = attribute(EXTENT, "The others; left out, those of first equal one another.", None)
    dimension: str = attribute(choice("dimension", "width", "height"), "What is equal: width or height.")
    within: str | None = attribute(
        ENCLOSING, "Path of an encompassing region: only extents inside the same one are equal.", None
    )

    first_before: Word | None = attribute(
        CONTEXT, "What stands directly before the first extent in its parent, down to the start itself.", None
    )
    first_after: Word | None = attribute(CONTEXT, "What stands directly after it.", None)
    second_before: Word | None = attribute(CONTEXT, "What stands directly before the second extent.", None)
    second_after: Word | None = attribute(CONTEXT, "What stands directly after it.", None)

    @property
    def axis(self) -> int:
        """0 for widths, 1 for heights."""
        return 0 if self.dimension == "width" else 1

    @property
    def _extents(self) -> tuple[Extent, ...]:
        return (self.first,) if self.second is None else (self.first, self.second)

    @property
    def _contexts(self) -> tuple[Context, ...]:
        """The contexts of the first and of the second extent."""
        return (
            Context(self.first_before, self.first_after),
            Context(self.second_before, self.second_after),
        )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, runs across the dimension, and contexts that mean nothing."""
        if self.within is not None:
            yield from unknown_path(self, self.within, facade)
        if self.second is None:
            yield from without_extent(self, self._contexts[1])
        for extent, context in zip(self._extents, self._contexts, strict=False):
            found = list(self._extent_faults(extent, facade))
            yield from found or context.faults(self, _parents(extent, facade), facade)

    def _extent_faults(self, extent: Extent, facade: Facade) -> Iterator[Diagnostic]:
        if extent.regions is not None:
            yield from unknown_names(self, extent.regions, facade)
        elif extent.word is not None:
            for path in extent.paths:
                yield from self._run_faults(extent.word, path, facade)

    def _run_faults(self, word: Word, path: str, facade: Facade) -> Iterator[Diagnostic]:
        yield from (unknown := list(unknown_composite(self, path, facade)))
        if unknown:
            return
        yield from unknown_in_word(self, word, path, facade)
        split = facade.regions[path].split
        if split is not None and AXIS[split] != self.axis:
            yield Diagnostic(
                "LK207",
                f"{path} is split into {split}: a run in it has no {self.dimension} of its own",
                self.place,
                "exchange width and height, or name a region instead of a run",
                topic="sizing",
            )

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield that all extents are equally large, where nothing is said of what stands beside them."""
        if not any(context.stated for context in self._contexts):
            yield EquallyLarge(self.axis, self._extents, self.within)

    def relations(self, facade: Facade) -> Iterator[Relates]:
        """Yield all extents together: which of them there are hangs on which regions occur, if on no more.

        Where there is a run, or a context, the order of letters says which they are.
        """
        frames: set[Frame] = set()
        ordered: list[str] = []
        for extent, context in zip(self._extents, self._contexts, strict=False):
            parents = _parents(extent, facade)
            if extent.regions is not None:
                frames |= {(path, self.axis) for path in facade.select(extent.regions)}
            else:
                inside = (f"{path}/{c.symbol}" for path in parents for c in facade.regions[path].children)
                frames |= {(path, self.axis) for path in inside}
            if extent.regions is None or context.stated:
                ordered += parents
        paths = frozenset((self.within,) if self.within else ())
        yield Relates(frozenset(frames), ordered=tuple(dict.fromkeys(ordered)), paths=paths)

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield all regions of both extents together."""
        paths: list[str] = []
        for extent in self._extents:
            paths += facade.select(extent.regions) if extent.regions is not None else extent.paths
        yield self.axis, tuple(paths)

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield an equality between the first occurrence in each scope and every other."""
        scopes: tuple[Slot | None, ...] = (None,)
        if self.within is not None:
            scopes = arrangement.slots(self.within, self.axis)
        for scope in scopes:
            sides = zip(self._extents, self._contexts, strict=False)
            forms = [form for side in sides for form in self._forms(*side, arrangement, scope)]
            for path, other in forms[1:]:
                if difference := add(other, forms[0][1], -1.0):
                    yield Range(self.axis, difference, 0.0, 0.0, self, (forms[0][0], path))

    def _forms(
        self, extent: Extent, context: Context, arrangement: Arrangement, scope: Slot | None
    ) -> Iterator[tuple[str, Form]]:
        """Yield the parent and the size of every distinct occurrence in the scope: replicas have one size."""
        facade = arrangement.facade
        if extent.regions is not None:
            for path in facade.select(extent.regions):
                slots = context.slots(arrangement, path, self.axis)
                if any(scope is None or slot.inside(scope) for slot in slots):
                    yield path.rpartition("/")[0], arrangement.extent(path, self.axis)
        elif extent.word is not None:
            for path in (p for p in extent.paths if p in arrangement.words):
                # A run may stand in the scope itself.
                slots = arrangement.slots(path, self.axis)
                if any(scope is None or slot is scope or slot.inside(scope) for slot in slots):
                    source, word = facade.regions[path], arrangement.words[path]
                    runs = occurrences(extent.word, source, word)
                    for start, end in context.runs(runs, source, word):
                        yield path, arrangement.run(path, start, end)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every extent that differs from the first in its scope."""
        sizes: defaultdict[str, list[tuple[str, float]]] = defaultdict(list)
        for extent, context in zip(self._extents, self._contexts, strict=False):
            for parent, path, size in self._sizes(extent, context, view):
                if (scope := self._scope(parent)) is not None:
                    sizes[scope].append((path, size))
        for (first, size), *others in sizes.values():
            for path, other in others:
                if (amount := abs(other - size)) > view.tolerance:
                    shown = f"its {self.dimension} {other:g} differs from {size:g} of {first}"
                    yield Violation(self, path, shown, amount)

    def _scope(self, parent: str) -> str | None:
        """Return the path of the encompassing region that an extent within `parent` stands in, if any."""
        if self.within is None:
            return ""
        start = "/".join(parent.split("/")[: self.within.count("/") + 1])
        plain = "/".join(step.partition(".")[0] for step in start.split("/"))
        return start if plain == self.within else None

    def _sizes(self, extent: Extent, context: Context, view: LayoutView) -> Iterator[tuple[str, str, float]]:
        """Yield the path of each extent's parent, that of the extent (of its region, for runs), its size."""
        before, after = context.before, context.after
        if extent.regions is not None:
            for placed in (p for path in view.facade.select(extent.regions) for p in view.places(path)):
                if view.stands(placed, before, after):
                    size = (placed.box.width, placed.box.height)[self.axis]
                    yield placed.path.rpartition("/")[0], placed.path, size
            return
        assert extent.word is not None
        for placed in (p for path in extent.paths for p in view.places(path)):
            sizes = [(c.width, c.height)[self.axis] for c in placed.region.children]
            for start, end in view.runs(placed, extent.word):
                if view.surrounded(placed, start, end, before, after):
                    yield placed.path, f"{placed.path}/", sum(sizes[start:end])


def _parents(extent: Extent, facade: Facade) -> tuple[str, ...]:
    """Return the paths of the regions that occurrences of the extent stand in."""
    return extent.paths if extent.regions is None else parents_of(facade.select(extent.regions))
