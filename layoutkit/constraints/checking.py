"""The checker: finds every rule that a layout breaks, and shares nothing with the search or sizing."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.constraints.defaults import effective_constraints
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, PlacedRegion, Region, Violation, place
from layoutkit.model.region import TILING_TOLERANCE


def violations(layout: Layout, facade: Facade) -> tuple[Violation, ...]:
    """Return every rule and constraint that the layout breaks, the rules of all layouts first."""
    view = LayoutView(layout, facade)
    broken = [*_tree_faults(view)]
    for constraint in effective_constraints(facade):
        broken += constraint.violations(view)
    return tuple(broken)


def _tree_faults(view: LayoutView) -> Iterator[Violation]:
    """Check what every layout keeps: known symbols, exact tiling, identical replicas."""
    root = view.layout.root
    if root.symbol != view.facade.root.symbol:
        yield Violation(None, root.symbol, f"the root is not {view.facade.root.symbol}", 1.0)
        return
    for placed in place(root):
        yield from _region_faults(placed, view.facade)
    for path in list(view.facade.regions):
        yield from _replica_faults(path, view)


def _region_faults(placed: PlacedRegion, facade: Facade) -> Iterator[Violation]:
    region, source = placed.region, facade.regions.get(placed.symbol_path)
    if source is None:
        yield Violation(None, placed.path, f"the facade has no region {placed.symbol_path}", 1.0)
        return
    if region.split != source.split or set(region.labels) != set(source.labels):
        yield Violation(None, placed.path, "split or labels differ from the facade's", 1.0)
    if not region.children:
        return
    along = [child.extent(region.split or "columns") for child in region.children]
    across = [child.height if region.split == "columns" else child.width for child in region.children]
    size = region.extent(region.split or "columns")
    other = region.height if region.split == "columns" else region.width
    gap = max(abs(sum(along) - size) / size, *(abs(a - other) / other for a in across))
    if gap > TILING_TOLERANCE or min(along) <= 0:
        yield Violation(None, placed.path, "its children do not tile it", gap * size)


def _replica_faults(path: str, view: LayoutView) -> Iterator[Violation]:
    first: Region | None = None
    for placed in view.places(path):
        first = first or placed.region
        if placed.region is not first and not _same(placed.region, first, view.tolerance):
            yield Violation(None, placed.path, f"is no replica of the first {path}", 1.0)


def _same(one: Region, other: Region, tolerance: float) -> bool:
    return (
        one.word == other.word
        and abs(one.width - other.width) <= tolerance
        and abs(one.height - other.height) <= tolerance
        and all(_same(a, b, tolerance) for a, b in zip(one.children, other.children, strict=True))
    )
