"""Random facades and words for them, and the sizing of one axis, as the search would do it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from layoutkit.model import Facade, Region, Split
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Range, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, Drawn, Sized, size_axis

Random = np.random.Generator
Words = dict[str, tuple[str, ...]]


def random_facade(random: Random, depth: int = 3) -> Facade:
    """Return a facade without constraints, of any shape."""
    root = _region("R", random.uniform(4.0, 12.0), random.uniform(4.0, 12.0), depth, random)
    return Facade("random", "m", root)


def _region(symbol: str, width: float, height: float, depth: int, random: Random) -> Region:
    if depth == 0 or (symbol != "R" and random.random() < 0.35):
        return Region(symbol, width, height)
    split: Split = "columns" if random.random() < 0.5 else "rows"
    letters = "abc"[: int(random.integers(1, 4))]
    word = [str(s) for s in random.permutation([*letters, *random.choice([*letters], random.integers(0, 3))])]
    share = {s: random.uniform(0.3, 1.0) for s in letters}
    total = sum(share[s] for s in word)
    made = {}
    for s in letters:
        part = share[s] / total
        along, across = (width * part, height) if split == "columns" else (width, height * part)
        made[s] = _region(s, along, across, depth - 1, random)
    return Region(symbol, width, height, split, tuple(made[s] for s in word))


def random_words(facade: Facade, random: Random) -> Words:
    """Return a word for every composite region that the words themselves reach."""
    words: Words = {}
    pending = [facade.root.symbol]
    while pending:
        path = pending.pop()
        region = facade.regions[path]
        if region.split is None:
            continue
        letters = list(dict.fromkeys(region.word))
        words[path] = tuple(str(s) for s in random.choice(letters, int(random.integers(1, 5))))
        pending += [f"{path}/{s}" for s in dict.fromkeys(words[path])]
    return words


def pulls(facade: Facade, arrangement: Arrangement, axis: int) -> list[SizeRule]:
    """Pull every region to its size in the input."""
    found: list[SizeRule] = []
    for path in arrangement.frames:
        size = (facade.regions[path].width, facade.regions[path].height)[axis]
        found.append(Target(axis, arrangement.extent(path, axis), size, size, 0.0, np.inf))
    return found


def positive(facade: Facade, arrangement: Arrangement, axis: int, share: float = 0.01) -> list[SizeRule]:
    """Keep every region from vanishing."""
    return [
        Range(axis, arrangement.extent(path, axis), share * facade.root.width / 50, np.inf, path)
        for path in arrangement.frames
    ]


def axis_of(arrangement: Arrangement, axis: int, rules: Sequence[SizeRule]) -> Axis:
    """State the sizing of one axis."""
    own = [rule for rule in (*rules, *arrangement.tilings) if rule.axis == axis]
    regions = arrangement.facade.regions
    nominal = arrangement.nominal(axis, 1.0, lambda path: (regions[path].width, regions[path].height)[axis])
    return Axis(axis, arrangement.variables[axis], own, (np.array(nominal),))


def size(axis: Axis, extent: float, budget: int, backends: Sequence[Backend] = BACKENDS) -> Sized:
    """Size an axis, its regions pulled to the centres of their targets."""
    drawn = Drawn(
        np.array([t.centre for t in axis.targets]), np.array([t.deviation**-2.0 for t in axis.targets])
    )
    return size_axis(axis, extent, drawn, backends, Budget(budget))


def two_rows(
    upper: dict[str, float], lower: dict[str, float], words: tuple[str, str], width: float
) -> Facade:
    """Return a facade of two floors F and G; sizes of their symbols, and their words."""
    floors = []
    for symbol, sizes, word in zip("FG", (upper, lower), words, strict=True):
        children = tuple(Region(s, sizes[s], 1.0) for s in word)
        floors.append(Region(symbol, width, 1.0, "columns", children))
    return Facade("two", "m", Region("R", width, 2.0, "rows", tuple(floors)))


def with_constraints(facade: Facade, *constraints: object) -> Facade:
    """Return the facade with constraints."""
    return replace(facade, constraints=constraints)  # type: ignore[arg-type]
