"""The checker: finds every rule that a layout breaks, and shares nothing with the search or sizing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from layoutkit.constraints.answers import failure, violations_of
from layoutkit.constraints.defaults import effective_constraints
from layoutkit.constraints.instances import varied
from layoutkit.constraints.view import LayoutView, alike
from layoutkit.diagnostics import Diagnostic
from layoutkit.diagnostics.blame import ANYTHING
from layoutkit.model import Box, Facade, Layout, PlacedRegion, Region, Violation, place
from layoutkit.model.region import TILING_TOLERANCE, place_children


def violations(layout: Layout, facade: Facade) -> tuple[Violation, ...]:
    """Return every rule and hard constraint that the layout breaks, the rules of all layouts first."""
    view = LayoutView(layout, facade)
    broken = [*_tree_faults(view)]
    for constraint in effective_constraints(facade):
        if not constraint.soft:
            broken += violations_of(constraint, view)
    return tuple(broken)


@dataclass(frozen=True)
class Checked:
    """All that there is to say of a layout.

    Attributes
    ----------
    broken
        Every rule and hard constraint that it breaks, the rules of all layouts first.
    unkept
        Where it does not keep a soft constraint. That is no fault: the constraint may be one that cannot be
        kept together with weightier ones.
    failed
        What is wrong with constraint kinds that could not check it.
    """

    broken: tuple[Violation, ...]
    unkept: tuple[Violation, ...]
    failed: tuple[Diagnostic, ...]


def checked(layout: Layout, facade: Facade) -> Checked:
    """Check a layout, and go on where a plugin's constraint fails to."""
    view = LayoutView(layout, facade)
    broken, unkept, failed = [*_tree_faults(view)], list[Violation](), list[Diagnostic]()
    for constraint in effective_constraints(facade):
        try:
            found = tuple(violations_of(constraint, view))
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            failed.append(failure(type(constraint), error, constraint.place))
        else:
            (unkept if constraint.soft else broken).extend(found)
    return Checked(tuple(broken), tuple(unkept), tuple(failed))


def _tree_faults(view: LayoutView) -> Iterator[Violation]:
    """Check what every layout keeps: known symbols, exact tiling, replicas that are identical."""
    root = view.layout.root
    if root.symbol != view.facade.root.symbol:
        yield Violation(None, root.symbol, f"the root is not {view.facade.root.symbol}", 1.0)
        return
    for placed in place(root):
        yield from _region_faults(placed, view.facade)
        yield from _replica_faults(placed, view)


def _region_faults(placed: PlacedRegion, facade: Facade) -> Iterator[Violation]:
    region, source = placed.region, facade.regions.get(placed.symbol_path)
    if source is None:
        yield Violation(None, placed.path, f"the facade has no region {placed.symbol_path}", 1.0)
        return
    if region.split != source.split or set(region.labels) != set(source.labels):
        yield Violation(None, placed.path, "split or labels differ from the facade's", 1.0)
    if region.depth != source.depth or region.material != source.material:
        yield Violation(None, placed.path, "depth or material differ from the facade's", 1.0)
    if region.split == "faces":
        yield from _face_faults(placed, facade)
    elif region.children:
        yield from _tiling_faults(placed)


def _face_faults(building: PlacedRegion, facade: Facade) -> Iterator[Violation]:
    """Compare each face with what the mass asks for; that all are there, in order, is a matter of words."""
    whole = (max(box.x1 for box in facade.faces.values()), max(box.y1 for box in facade.faces.values()))
    parts = [(building, Box(0.0, 0.0, *whole))]
    parts += [
        (p, facade.faces[p.symbol_path]) for p in place_children(building) if p.symbol_path in facade.faces
    ]
    for placed, wanted in parts:
        (left, foot, _, _), region = placed.box, placed.region
        actual = Box(left, foot, left + region.width, foot + region.height)
        gap = max(abs(one - other) for one, other in zip(actual, wanted, strict=True))
        if gap > TILING_TOLERANCE * max(whole):
            yield Violation(None, placed.path, "is not where the mass has it, or of another size", gap)


def _tiling_faults(placed: PlacedRegion) -> Iterator[Violation]:
    region = placed.region
    along = [child.extent(region.split or "columns") for child in region.children]
    across = [child.height if region.split == "columns" else child.width for child in region.children]
    size = region.extent(region.split or "columns")
    other = region.height if region.split == "columns" else region.width
    gap = max(abs(sum(along) - size) / size, *(abs(a - other) / other for a in across))
    if gap > TILING_TOLERANCE or min(along) <= 0:
        yield Violation(None, placed.path, "its children do not tile it", gap * size)


def _replica_faults(parent: PlacedRegion, view: LayoutView) -> Iterator[Violation]:
    """Compare siblings of one symbol: what is inside replicas is then compared as well."""
    first: dict[str, Region] = {}
    seen: Counter[str] = Counter()
    for child in parent.region.children:
        seen[child.symbol] += 1
        original = first.setdefault(child.symbol, child)
        path = f"{parent.symbol_path}/{child.symbol}"
        if path not in varied(view.facade) and not alike(child, original, view.tolerance):
            where = f"{parent.path}/{child.symbol}.{seen[child.symbol]}"
            yield Violation(None, where, f"is no replica of the first {path}", 1.0)
