"""Alignments that the input keeps: elements of a floor in height, elements of a bay in width."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence

from layoutkit.constraints import Alignment
from layoutkit.model import Facade, PlacedRegion, RegionSet

from layoutkit_relayout.inference.bays import Lockstep, locksteps
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.sizes import WALLS

#: Lines coincide within this share of the facade's size.
_COINCIDE = 1e-6
_ACROSS = {"left": 0.0, "right": 1.0, "center": 0.5}
_DOWN = {"top": 1.0, "bottom": 0.0, "middle": 0.5}


def lines(facade: Facade, freedom: Freedom) -> Iterator[Alignment]:
    """Yield alignments of like elements: level ones within a floor, upright ones within a bay."""
    tolerance = _COINCIDE * max(facade.root.width, facade.root.height)
    for lockstep in locksteps(facade):
        for path in lockstep.paths:
            yield from _level(facade, path, tolerance)
        if len(lockstep.paths) > 1 and freedom.lockstep:
            yield from _upright(facade, lockstep, tolerance)


def _level(facade: Facade, floor: str, tolerance: float) -> Iterator[Alignment]:
    """Yield alignments of elements of one floor whose tops or bottoms coincide in the input."""
    first = facade.places[floor][0].path
    inside = _elements(facade, floor, first)
    for line in ("top", "bottom"):
        share = _DOWN[line]
        clusters: defaultdict[tuple[str, int], dict[str, None]] = defaultdict(dict)
        for placed in inside:
            at = placed.box.y0 + share * placed.box.height
            clusters[(placed.region.labels[0], round(at / tolerance))][placed.symbol_path] = None
        for paths in clusters.values():
            yield from _aligned(tuple(paths), line, floor, "elements of a floor stay level")


def _upright(facade: Facade, lockstep: Lockstep, tolerance: float) -> Iterator[Alignment]:
    """Yield alignments of elements that stand above one another in a bay, floor by floor."""
    for symbol in dict.fromkeys(lockstep.word):
        stacked = []
        for path in lockstep.paths:
            bay = facade.places[f"{path}/{symbol}"][0]
            stacked += _elements(facade, f"{path}/{symbol}", bay.path)
        for line, share in _ACROSS.items():
            clusters: defaultdict[tuple[str, int], dict[str, None]] = defaultdict(dict)
            for placed in stacked:
                at = placed.box.x0 + share * placed.box.width
                clusters[(placed.region.labels[0], round(at / tolerance))][placed.symbol_path] = None
            for paths in clusters.values():
                if line != "center" and len({p.split("/")[1] for p in paths}) > 1:
                    yield from _aligned(tuple(paths), line, None, "elements of a bay stay in line")


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


def _aligned(
    paths: Sequence[str], line: str, within: str | None, comment: str
) -> Iterator[Alignment]:
    if len(paths) > 1:
        yield Alignment(
            first=RegionSet(paths[0]),
            second=RegionSet.union(paths[1:]),
            lines=(line,),
            within=within,
            comment=comment,
        )

