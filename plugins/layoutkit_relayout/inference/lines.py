"""Alignments that the input keeps: elements of a floor in height, elements of a bay in width."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from layoutkit.constraints import Alignment
from layoutkit.model import Facade, PlacedRegion, RegionSet
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.labels import WALLS
from layoutkit_relayout.inference.lockstep import Lockstep, locksteps

#: Lines coincide within this share of the facade's size.
_COINCIDE = 1e-6
_LEVEL, _UPRIGHT = ("top", "bottom"), ("left", "right")


def lines(facade: Facade, freedom: Freedom) -> Iterator[Alignment]:
    """Yield alignments of like elements: level ones within a floor, upright ones within a bay."""
    for lockstep in locksteps(facade):
        for number, path in enumerate(lockstep.paths):
            yield from _level(facade, path, "elements of a floor stay level" if number == 0 else "")
        if len(lockstep.paths) > 1 and freedom.lockstep:
            yield from _upright(facade, lockstep)


def _level(facade: Facade, floor: str, comment: str) -> Iterator[Alignment]:
    """Yield alignments of elements of one floor whose tops or bottoms coincide in the input.

    Those that coincide with the floor's own do so anyway.
    """
    first = facade.places[floor][0]
    shared = _shared(facade, [(first, p) for p in _elements(facade, floor, first.path)], _LEVEL)
    for number, (paths, found) in enumerate(shared.items()):
        yield _aligned(paths, found, floor, comment if number == 0 else "")


def _upright(facade: Facade, lockstep: Lockstep) -> Iterator[Alignment]:
    """Yield alignments of elements that stand above one another in a bay, floor by floor."""
    comment = "elements of a bay stay in line"
    for symbol in dict.fromkeys(lockstep.word):
        stacked = []
        for path in lockstep.paths:
            bay = facade.places[f"{path}/{symbol}"][0]
            stacked += [(bay, p) for p in _elements(facade, f"{path}/{symbol}", bay.path)]
        for paths, found in _shared(facade, stacked, _UPRIGHT).items():
            yield _aligned(paths, found, None, comment)
            comment = ""


def _shared(
    facade: Facade, elements: Sequence[tuple[PlacedRegion, PlacedRegion]], names: Sequence[str]
) -> Mapping[tuple[str, ...], tuple[str, ...]]:
    """Return the lines that like elements share, by their symbol paths; those of their frame aside.

    Parameters
    ----------
    elements
        Each behind the floor or bay that it stands in.
    """
    unit = _COINCIDE * max(facade.root.width, facade.root.height)
    clusters: defaultdict[tuple[str, str, int], dict[str, None]] = defaultdict(dict)
    for frame, placed in elements:
        for name in names:
            at = round(_line(placed, name) / unit)
            if at not in {round(_line(frame, other) / unit) for other in names}:
                clusters[(placed.region.labels[0], name, at)][placed.symbol_path] = None
    found: defaultdict[tuple[str, ...], tuple[str, ...]] = defaultdict(tuple)
    for (_, name, _), paths in clusters.items():
        if len(paths) > 1:
            found[tuple(paths)] = (*found[tuple(paths)], name)
    return found


def _line(placed: PlacedRegion, name: str) -> float:
    box = placed.box
    return {"left": box.x0, "right": box.x1, "top": box.y1, "bottom": box.y0}[name]


def _elements(facade: Facade, path: str, first: str) -> list[PlacedRegion]:
    """Return the first places of all elements inside the region placed at `first`."""
    return [
        next(p for p in places if p.path.startswith(f"{first}/"))
        for inner, places in facade.places.items()
        if inner.startswith(f"{path}/")
        and places[0].region.terminal
        and places[0].region.labels
        and places[0].region.labels[0] not in WALLS
    ]


def _aligned(paths: Sequence[str], names: tuple[str, ...], within: str | None, comment: str) -> Alignment:
    others = RegionSet.union(paths[1:])
    return Alignment(first=RegionSet(paths[0]), second=others, lines=names, within=within, comment=comment)
