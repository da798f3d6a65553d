"""Size constraints about the input's sizes: firm for elements, soft for the space between them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from layoutkit.constraints import Size
from layoutkit.constraints.defaults import divided
from layoutkit.constraints.size import axis_of
from layoutkit.model import Facade, Measure, Region, RegionSet
from layoutkit_relayout.inference.freedom import Freedom, Span
from layoutkit_relayout.inference.labels import BANDS, BAY, FLOOR, HARD, PIER, ROOMS, WALLS
from layoutkit_relayout.inference.lockstep import locksteps

#: A column that takes more than this share of the facade's width grows with it.
_WIDE = 0.3


def sizes(facade: Facade, freedom: Freedom) -> Iterator[Size]:
    """Yield size constraints for space and for elements, by their labels, then for what has no label."""
    wide = [path for path in facade.regions if "/" in path and _wide(facade, path)]
    soft = _without(_labelled(WALLS & facade.labels), [f"@{BAY}"] if BAY in facade.labels else [])
    roomy = [path for path in _roomy(facade) if path not in wide]
    piers = [f"@{PIER}"] if PIER in facade.labels else []
    firm = _without(_labelled(facade.labels - WALLS - ROOMS), [*piers, *wide, *roomy])
    floors = _labelled({FLOOR} & facade.labels)
    yield from _size(soft, freedom.walls, "walls and piers take up what is left over")
    yield from _size(firm, freedom.elements, "windows, doors and ornaments keep about their size")
    yield from _size(_union(roomy), freedom.rooms, "bays with wall beside their elements may be wider")
    yield from _size(floors, freedom.floors, "floors keep about their height")
    given = [regions for regions in (soft, firm, floors, _union(roomy)) if regions is not None]
    sized = {path for regions in given for path in facade.select(regions)}
    rest = [path for path in facade.regions if "/" in path and path not in sized and _undivided(facade, path)]
    broad = [path for path in rest if path in wide]
    groups = [path for path in rest if path not in wide]
    yield from _size(_union(broad), freedom.walls, "what runs along the facade grows with it")
    yield from _size(_union(groups), freedom.elements, "groups of elements keep about their size")


def _wide(facade: Facade, path: str) -> bool:
    """Tell whether a column must grow with the facade: a large part of it, or a piece of a band."""
    region, labels = facade.regions[path], set(facade.regions[path].labels)
    if axis_of(facade, path) != 0 or labels & WALLS or not _undivided(facade, path):
        return False
    return region.width > _WIDE * facade.root.width or (region.terminal and bool(labels) and labels <= BANDS)


def _roomy(facade: Facade) -> Iterator[str]:
    """Yield the bays that no window or other hard element fills from side to side in any of their floors."""
    for lockstep in locksteps(facade):
        for symbol in dict.fromkeys(lockstep.word):
            stacked = [f"{path}/{symbol}" for path in lockstep.paths]
            bays = [facade.regions[path] for path in stacked]
            if any(BAY in bay.labels for bay in bays) and not any(map(_filled, bays)):
                yield from (path for path, bay in zip(stacked, bays, strict=True) if BAY in bay.labels)


def _filled(region: Region) -> bool:
    """Tell whether a hard element reaches from the left to the right of a region."""
    if region.split is None:
        return bool(HARD & set(region.labels))
    return region.split == "rows" and any(map(_filled, region.children))


def _undivided(facade: Facade, path: str) -> bool:
    return not divided(facade.regions[path], axis_of(facade, path))


def _labelled(labels: Iterable[str]) -> RegionSet | None:
    return _union([f"@{label}" for label in sorted(labels)])


def _union(names: Sequence[str]) -> RegionSet | None:
    return RegionSet.union(names) if names else None


def _without(regions: RegionSet | None, names: Sequence[str]) -> RegionSet | None:
    for name in names if regions is not None else ():
        regions = RegionSet(operator="-", left=regions, right=RegionSet(name))
    return regions


def _size(regions: RegionSet | None, span: Span, comment: str) -> Iterator[Size]:
    if regions is not None:
        yield Size(
            of=regions,
            min=Measure(span.least, relative=True),
            max=Measure(span.most, relative=True),
            deviation=Measure(span.deviation, relative=True),
            comment=comment,
        )
