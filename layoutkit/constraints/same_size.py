"""Same size: extents that are equal wherever they occur (Bao et al. 2013, section 5.1, same size)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import EXTENT, PATH, attribute, choice
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_composite, unknown_in_word, unknown_names, unknown_path
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Extent, Facade, Violation
from layoutkit.model.extent import occurrences
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot, add
from layoutkit.sizing.rules import Form, Range, SizeRule


@dataclass(frozen=True, kw_only=True)
class SameSize(Constraint):
    """All occurrences of two extents are equally wide, or equally high."""

    kind: ClassVar[str] = "same-size"
    summary: ClassVar[str] = (
        "All occurrences of the first and of the second extent are equally large: single regions, or runs of "
        "neighbouring ones."
    )

    first: Extent = attribute(EXTENT, "Regions (Facade/Floor/Bay, @Window) or a run (Facade/Side: P Q R S).")
    second: Extent | None = attribute(EXTENT, "The others; left out, those of first equal one another.", None)
    dimension: str = attribute(choice("dimension", "width", "height"), "What is equal: width or height.")
    within: str | None = attribute(
        PATH, "Path of an encompassing region: only extents inside the same one are equal.", None
    )

    @property
    def axis(self) -> int:
        """0 for widths, 1 for heights."""
        return 0 if self.dimension == "width" else 1

    @property
    def _extents(self) -> tuple[Extent, ...]:
        return (self.first,) if self.second is None else (self.first, self.second)

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, and runs across the dimension."""
        if self.within is not None:
            yield from unknown_path(self, self.within, facade)
        for extent in self._extents:
            if extent.regions is not None:
                yield from unknown_names(self, extent.regions, facade)
            elif extent.word is not None:
                yield from self._run_faults(extent, facade)

    def _run_faults(self, extent: Extent, facade: Facade) -> Iterator[Diagnostic]:
        yield from (unknown := list(unknown_composite(self, extent.within, facade)))
        if unknown or extent.word is None:
            return
        yield from unknown_in_word(self, extent.word, extent.within, facade)
        split = facade.regions[extent.within].split
        if split is not None and AXIS[split] != self.axis:
            yield Diagnostic(
                "LK207",
                f"{extent.within} is split into {split}: a run in it has no {self.dimension} of its own",
                self.place,
                "exchange width and height, or name a region instead of a run",
                topic="sizing",
            )

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield all regions of both extents together."""
        paths: list[str] = []
        for extent in self._extents:
            paths += facade.select(extent.regions) if extent.regions is not None else [extent.within]
        yield self.axis, tuple(paths)

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield an equality between the first occurrence in each scope and every other."""
        scopes: tuple[Slot | None, ...] = (None,)
        if self.within is not None:
            scopes = arrangement.slots(self.within, self.axis)
        for scope in scopes:
            forms = [form for extent in self._extents for form in self._forms(extent, arrangement, scope)]
            for other in forms[1:]:
                if difference := add(other, forms[0], -1.0):
                    yield Range(self.axis, difference, 0.0, 0.0, self)

    def _forms(self, extent: Extent, arrangement: Arrangement, scope: Slot | None) -> Iterator[Form]:
        """Yield the size of every distinct occurrence in the scope: replicas have one size, so one form."""
        facade = arrangement.facade
        paths = facade.select(extent.regions) if extent.regions is not None else (extent.within,)
        for path in paths:
            slots = arrangement.slots(path, self.axis)
            if not slots or not any(_inside(slot, scope, extent) for slot in slots):
                continue
            if extent.word is None:
                yield arrangement.extent(path, self.axis)
            elif path in arrangement.words:
                for start, end in occurrences(extent.word, facade.regions[path], arrangement.words[path]):
                    yield arrangement.run(path, start, end)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every extent that differs from the first in its scope."""
        scopes = [""] if self.within is None else [f"{p.path}/" for p in view.places(self.within)]
        for scope in scopes:
            sizes = [(p, s) for e in self._extents for p, s in self._sizes(e, view) if p.startswith(scope)]
            for path, size in sizes[1:]:
                amount = abs(size - sizes[0][1])
                if amount > view.tolerance:
                    shown = f"its {self.dimension} {size:g} differs from {sizes[0][1]:g} of {sizes[0][0]}"
                    yield Violation(self, path, shown, amount)

    def _sizes(self, extent: Extent, view: LayoutView) -> Iterator[tuple[str, float]]:
        if extent.regions is not None:
            for path in view.facade.select(extent.regions):
                for placed in view.places(path):
                    yield placed.path, (placed.box.width, placed.box.height)[self.axis]
            return
        assert extent.word is not None
        source = view.facade.regions[extent.within]
        for placed in view.places(extent.within):
            sizes = [(c.width, c.height)[self.axis] for c in placed.region.children]
            for start, end in occurrences(extent.word, source, placed.region.word):
                yield f"{placed.path}/", sum(sizes[start:end])


def _inside(slot: Slot, scope: Slot | None, extent: Extent) -> bool:
    """Tell whether the slot of an extent lies in the scope; a run may stand in the scope itself."""
    return scope is None or slot.inside(scope) or (extent.word is not None and slot is scope)
