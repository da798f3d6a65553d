"""Size constraints about the input's sizes: firm for elements, soft for the space between them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from layoutkit.constraints import Size
from layoutkit.constraints.size import axis_of
from layoutkit.model import Facade, Measure, Region, RegionSet
from layoutkit.sizing.arrangement import AXIS

from layoutkit_relayout.inference.freedom import Freedom, Span

#: Labels of space that may be stretched, and of things that run along a facade.
WALLS = frozenset({"Wall", "Pier", "Facade", "Background", "Sky", "Roof"})
BANDS = frozenset({"Cornice", "Molding", "Balcony", "Sill", "Shop", "Deco"})


def sizes(facade: Facade, freedom: Freedom) -> Iterator[Size]:
    """Yield three size constraints: for elements, bands and walls, as far as there are any."""
    undivided = [
        path
        for path, region in facade.regions.items()
        if "/" in path and not divided(region, axis_of(facade, path))
    ]
    sorts: dict[str, list[str]] = {"walls": [], "bands": [], "elements": []}
    for path in undivided:
        sorts[_sort(facade, path)].append(path)
    texts = {
        "walls": (freedom.walls, "walls and piers take up what is left over"),
        "bands": (freedom.bands, "bands keep about their height"),
        "elements": (freedom.elements, "windows, doors and ornaments keep about their size"),
    }
    for sort, paths in sorts.items():
        if paths:
            span, comment = texts[sort]
            yield _size(named(facade, paths), span, comment)


def divided(region: Region, axis: int) -> bool:
    """Tell whether a split inside the region runs along the axis."""
    if region.split is None:
        return False
    return AXIS[region.split] == axis or any(divided(child, axis) for child in region.children)


def _sort(facade: Facade, path: str) -> str:
    region = facade.regions[path]
    if region.terminal and region.labels and set(region.labels) <= WALLS:
        return "walls"
    along_rows = axis_of(facade, path) == 1
    return "bands" if along_rows and region.terminal and set(region.labels) & BANDS else "elements"


def _size(regions: RegionSet, span: Span, comment: str) -> Size:
    return Size(
        of=regions,
        min=Measure(span.least, relative=True),
        max=Measure(span.most, relative=True),
        deviation=Measure(span.deviation, relative=True),
        comment=comment,
    )


def named(facade: Facade, paths: Sequence[str]) -> RegionSet:
    """Return a set of just these regions, by labels as far as they go, the rest by paths."""
    wanted, names = set(paths), []
    for label in sorted(facade.labels):
        own = facade.select(RegionSet(f"@{label}"))
        if wanted.issuperset(own):
            names.append(f"@{label}")
    covered = {p for name in names for p in facade.select(RegionSet(name))}
    return RegionSet.union([*_needed(facade, names), *(p for p in paths if p not in covered)])


def _needed(facade: Facade, names: Iterable[str]) -> list[str]:
    """Drop labels whose regions others have already."""
    kept, covered = [], set()
    for name in sorted(names, key=lambda n: -len(facade.select(RegionSet(n)))):
        own = set(facade.select(RegionSet(name)))
        if not own <= covered:
            kept.append(name)
            covered |= own
    return kept
