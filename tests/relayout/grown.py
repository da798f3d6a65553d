"""Random facades of several levels, replicas and all, with constraints of many kinds."""

from __future__ import annotations

import numpy as np

from layoutkit.constraints import Alignment, Constraint, Frequency, SameSize, Size
from layoutkit.constraints.generators import sequences, two_shuffle
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Split, Word

Random = np.random.Generator
LABELS = ("Window", "Wall", "Door", "Bay")


def grown(seed: int, depth: int = 3) -> Facade:
    """Return a facade that keeps its own constraints."""
    random = np.random.default_rng(seed)
    root = _region("R", random.uniform(4.0, 12.0), random.uniform(4.0, 12.0), depth, random)
    bare = Facade(f"grown-{seed}", "m", root)
    constraints: list[Constraint] = []
    for path, region in bare.regions.items():
        if region.split and random.random() < 0.5:
            constraints += sequences([path], _freed(region, random), "neighbours as in the input, either way")
        if "/" in path and random.random() < 0.4:
            constraints.append(_size(path, random))
        if region.split and random.random() < 0.2:
            symbol = str(random.choice(region.word))
            most = Measure(float(region.word.count(symbol) + random.integers(0, 3)))
            constraints.append(Frequency(of=RegionSet(symbol), within=path, max=most))
    labelled = sorted(bare.labels)
    if labelled and random.random() < 0.4:
        alike = RegionSet(f"@{labelled[int(random.integers(len(labelled)))]}")
        constraints.append(Alignment(first=alike, second=alike, lines=("left",), within=_some(bare, random)))
        constraints.append(SameSize(first=Extent(RegionSet(_some(bare, random))), dimension="width"))
    facade = Facade(bare.name, "m", root, constraints=tuple(constraints))
    return facade


def _some(facade: Facade, random: Random) -> str:
    paths = list(facade.regions)
    return paths[int(random.integers(len(paths)))]


def _region(symbol: str, width: float, height: float, depth: int, random: Random) -> Region:
    labels = (LABELS[int(random.integers(len(LABELS)))],) if random.random() < 0.7 else ()
    if depth == 0 or (symbol != "R" and random.random() < 0.3):
        return Region(symbol, width, height, labels=labels)
    split: Split = "columns" if random.random() < 0.5 else "rows"
    letters = [*"abc"[: int(random.integers(1, 4))]]
    word = [
        str(s) for s in random.permutation([*letters, *random.choice(letters, int(random.integers(0, 4)))])
    ]
    share = {s: random.uniform(0.3, 1.0) for s in letters}
    total = sum(share[s] for s in word)
    made = {}
    for s in letters:
        part = share[s] / total
        size = (width * part, height) if split == "columns" else (width, height * part)
        made[s] = _region(s, *size, depth - 1, random)
    return Region(symbol, width, height, split, tuple(made[s] for s in word), labels)


def _freed(region: Region, random: Random) -> list[Word]:
    ends = {region.word[0], region.word[-1]}
    pairs = list(two_shuffle(region.word))
    if random.random() < 0.5:
        pairs += [Word((RegionSet(s), RegionSet(s))) for s in dict.fromkeys(region.word)]
    return [
        Word((RegionSet.union(sorted(ends)),), at_start=True),
        *pairs,
        Word((RegionSet.union(sorted(ends)),), at_end=True),
    ]


def _size(path: str, random: Random) -> Size:
    return Size(
        of=RegionSet(path),
        min=Measure(random.uniform(0.4, 0.95), True),
        max=Measure(random.uniform(1.05, 3.0), True),
        deviation=Measure(random.uniform(0.0, 0.2), True),
    )
