"""Constraints of every kind, sequences aside, for random tiny facades."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
)
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Word

Random = np.random.Generator


def sizes(facade: Facade, random: Random) -> list[Constraint]:
    """Return ranges for most regions, one by one, and at times for a label's."""
    found: list[Constraint] = []
    for path, region in facade.regions.items():
        if random.random() < (0.05 if "/" not in path else 1.0 if region.split else 0.8):
            found.append(_size(RegionSet(path), region, random))
    if random.random() < 0.15:
        found.append(_size(_several(facade, random), None, random))
    return found


def _size(of: RegionSet, region: Region | None, random: Random) -> Size:
    """Return a range; absolute only where it is of one region."""
    low, high = Measure(random.uniform(0.6, 0.95), True), Measure(random.uniform(1.05, 1.6), True)
    if region is not None and region.terminal and random.random() < 0.2:
        least = min(region.width, region.height)
        low, high = Measure(low.value * least), Measure(high.value * max(region.width, region.height))
    way = random.random()
    if way < 0.1:
        return Size(of=of, min=low, centre=Measure(random.uniform(0.9, 1.4), True))
    if way < 0.15:
        return Size(of=of, min=low if region is not None else None, max=high, deviation=Measure(0.0))
    if way < 0.25:
        return Size(of=of, min=low, max=high, distribution="uniform")
    if way < 0.4:
        return Size(of=of, min=low, max=high, distribution="triangular", bias=random.uniform(-1.0, 1.0))
    bias = random.uniform(-1.0, 1.0) if random.random() < 0.2 else 0.0
    return Size(of=of, min=low, max=high, bias=bias)


def _some(random: Random, items: Sequence[str], least: int = 1, most: int | None = None) -> list[str]:
    count = int(random.integers(least, min(most or len(items), len(items)) + 1))
    return [items[i] for i in sorted(random.choice(len(items), count, replace=False))]


def _one(random: Random, items: Sequence[str]) -> str:
    return items[int(random.integers(len(items)))]


def _several(facade: Facade, random: Random, paths: Sequence[str] = ()) -> RegionSet:
    """Return a set of one or two regions; at times by labels, by what they stand in, by all operations."""
    way = random.random()
    if way > 0.25:
        return RegionSet.union(_some(random, paths or _inner(facade), 1, 2))
    if way > 0.15:
        return RegionSet.parse(_one(random, ["@Window", "@Wall"]))
    around = _one(random, _composites(facade))
    return RegionSet.parse(
        _one(random, [f"@Window & {around}/*", f"{around}/* - @Wall", "@Window - @Door", f"{around}/*"])
    )


def _composites(facade: Facade) -> list[str]:
    return [path for path, region in facade.regions.items() if region.split]


def _inner(facade: Facade) -> list[str]:
    return [path for path in facade.regions if "/" in path]


def frequency(facade: Facade, random: Random) -> list[Constraint]:
    """Return a range of counts, absolute, relative, or each end in its own way."""
    within = _one(random, _composites(facade))
    symbols = list(dict.fromkeys(facade.regions[within].word))
    of = RegionSet.union(_some(random, ["@Window", "@Wall", *symbols], 1, 2))
    if random.random() < 0.15:
        of = RegionSet.parse(_one(random, ["@Window - @Door", "@Window & @Door", f"@Window - {symbols[0]}"]))
    low = int(random.integers(0, 3))
    share = random.uniform(0.3, 0.9)
    least = [Measure(float(low)), Measure(share, True)][relative := int(random.random() < 0.5)]
    most = [Measure(float(low + random.integers(0, 3))), Measure(share + random.uniform(0.3, 1.0), True)]
    way = random.integers(3)
    return [
        Frequency(
            of=of,
            within=within,
            min=None if way == 1 else least,
            max=None if way == 2 else most[relative if random.random() < 0.9 else 1 - relative],
        )
    ]


def instances(facade: Facade, random: Random) -> list[Constraint]:
    """Return a range of different instances of what occurs twice, if anything does."""
    inner = _inner(facade)
    often = [p for p in inner if facade.regions[p.rpartition("/")[0]].word.count(p.rpartition("/")[2]) > 1]
    composite = [p for p in often if facade.regions[p].split]
    of = _one(random, composite if composite and random.random() < 0.7 else often or inner)
    least = [None, None, Measure(2.0), Measure(random.uniform(0.5, 1.0), True)][random.integers(4)]
    most = [None, Measure(2.0), Measure(random.uniform(1.0, 1.6), True)][random.integers(3)]
    return [Instances(of=RegionSet(of), min=least, max=most)]


def _contexts(parents: Sequence[Region], side: str, random: Random) -> dict[str, Word]:
    """Return what stands before or after a region of these parents; most often nothing is said."""
    symbols = list(dict.fromkeys(s for parent in parents for s in parent.word))
    names = [*symbols, *sorted({f"@{n}" for p in parents for c in p.children for n in c.labels})]
    found: dict[str, Word] = {}
    for where in ("before", "after"):
        if names and random.random() < 0.3:
            sets = tuple(RegionSet.union(_some(random, names, 1, 2)) for _ in range(random.integers(0, 2)))
            end = not sets or random.random() < 0.25
            found[f"{side}_{where}"] = Word(sets, end and where == "before", end and where == "after")
    return found


def _parents(facade: Facade, regions: RegionSet) -> list[Region]:
    return [facade.regions[path.rpartition("/")[0]] for path in facade.select(regions) if "/" in path]


def alignment(facade: Facade, random: Random) -> list[Constraint]:
    """Return an alignment, most often of a region in each of two floors."""
    paths = [p for p in _inner(facade) if p.count("/") == 2] or _inner(facade)
    first, second = (_several(facade, random, paths) for _ in range(2))
    if (floors := [p for p in _composites(facade) if p[-1] in "FG"]) and random.random() < 0.8:
        inside = [[p for p in facade.regions if p.startswith(f"{floor}/")] for floor in floors]
        first, second = (RegionSet.union(_some(random, own, 1, 2)) for own in (inside[0], inside[-1]))
    lines = ("left", "center", "right") if random.random() < 0.8 else ("top", "middle", "bottom")
    within = _one(random, _composites(facade)) if random.random() < 0.2 else None
    contexts: dict[str, Word] = {}
    if random.random() < 0.35:
        for side, regions in (("first", first), ("second", second)):
            contexts |= _contexts(_parents(facade, regions), side, random)
    return [
        Alignment(
            first=first, second=second, lines=tuple(_some(random, lines, 1, 2)), within=within, **contexts
        )
    ]


def same_size(facade: Facade, random: Random) -> list[Constraint]:
    """Return equal sizes, of regions or of a run."""
    dimension = "width" if random.random() < 0.7 else "height"
    first, second = (Extent(_several(facade, random)) for _ in range(2))
    split = "columns" if dimension == "width" else "rows"
    if columns := [p for p in _composites(facade) if facade.regions[p].split == split]:
        if random.random() < 0.4:
            first = _run(columns, facade, random)
        if random.random() < 0.3:
            second = _run(columns, facade, random)
    scope = _one(random, _composites(facade)) if random.random() < 0.3 else None
    both = random.random() < 0.7
    contexts: dict[str, Word] = {}
    if random.random() < 0.35:
        for side, extent in (("first", first), ("second", second))[: 1 + both]:
            parents = (
                [facade.regions[p] for p in extent.paths]
                if extent.regions is None
                else _parents(facade, extent.regions)
            )
            contexts |= _contexts(parents, side, random)
    return [
        SameSize(first=first, second=second if both else None, dimension=dimension, within=scope, **contexts)
    ]


def _run(paths: Sequence[str], facade: Facade, random: Random) -> Extent:
    """Return the first neighbours of a region's input word, or two of its letters."""
    within = _one(random, paths)
    word = facade.regions[within].word
    run = word[:2] if random.random() < 0.7 else tuple(_one(random, word) for _ in range(2))
    tied = random.random() < 0.2
    return Extent(None, within, Word(tuple(RegionSet(s) for s in run), at_start=tied))


def same_arrangement(facade: Facade, random: Random) -> list[Constraint]:
    """Return that two floors, or all instances of one, have the same word."""
    pair = ("R/F", "R/B/G" if "R/B/G" in facade.regions else "R/G")
    if not set(pair) <= facade.regions.keys():
        return [SameArrangement(of=(_one(random, _composites(facade)),))]
    return [SameArrangement(of=pair)]


def symmetry(facade: Facade, random: Random) -> list[Constraint]:
    """Return that one or two regions mirror themselves, at times with a pair of symbols."""
    of = _some(random, _composites(facade), 1, 2)
    symbols = sorted(set.intersection(*({c.symbol for c in facade.regions[p].children} for p in of)))
    pairs: tuple[tuple[str, str], ...] = ()
    if len(symbols) > 1 and random.random() < 0.5:
        one, other = _some(random, symbols, 2, 2)
        pairs = ((one, other),)
    return [Symmetry(of=tuple(of), pairs=pairs)]


def lock(facade: Facade, random: Random) -> list[Constraint]:
    """Return that a region keeps its place, its size or its inside."""
    paths = _composites(facade) if random.random() < 0.4 else _inner(facade)
    of = RegionSet(_one(random, paths)) if random.random() < 0.8 else _several(facade, random)
    keep = tuple(_some(random, ("place", "size", "inside"), 1, 2 if random.random() < 0.3 else 1))
    if random.random() < 0.4:
        return [Lock(of=of, keep=keep)]
    upright, level = _one(random, ("left", "center", "right")), _one(random, ("top", "middle", "bottom"))
    return [Lock(of=of, keep=keep, anchor=(upright, level) if random.random() < 0.7 else (upright,))]
