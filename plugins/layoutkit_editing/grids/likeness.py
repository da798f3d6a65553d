"""Which places of a facade are like each other, as far as people tell them apart."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.grids.labels import name_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from layoutkit_editing.original import Original

    Floats = NDArray[np.float64]
    Numbers = NDArray[np.int64]

#: Sizes that differ by no more than this share are taken for equal. Lengths seen side by side are told apart
#: from 2 or 3 % on; edges that people drew by hand are off by 1 to 3 pixels at either end of a window of 40.
LIKE = 0.12


def types(original: Original) -> Numbers:
    """Return one number for each source, the same for those that people take for alike (n).

    They go by the same name (see `name_of`), have like interiors: the same splits, and names, in the same
    order, at every level; and all their sizes, and the places of all lines inside as shares of them, differ
    by no more than `LIKE`. Where sizes scatter more, they are divided at the widest gaps: whatever the order
    of sources, the same are alike, and likeness is transitive.
    """
    inside = children(original)
    like: defaultdict[int, list[int]] = defaultdict(list)
    for source, interior in enumerate(_interiors(original, inside).tolist()):
        like[interior].append(source)
    counts = held(inside)
    found = np.empty(len(inside), dtype=np.int64)
    number = 0
    for sources in like.values():
        for part in _divided(_features(original, np.array(sources), counts[sources[0]]), LIKE):
            found[np.array(sources)[part]] = number
            number += 1
    return found


def _interiors(original: Original, inside: Sequence[tuple[int, ...]]) -> Numbers:
    """Return one number for each source, the same for equal names and interiors, whatever their sizes (n)."""
    numbers: dict[Hashable, int] = {}
    found = np.empty(len(inside), dtype=np.int64)
    for source in reversed(range(len(inside))):
        region = original.places[source].region
        key = (name_of(region), region.split, *found[list(inside[source])].tolist())
        found[source] = numbers.setdefault(key, len(numbers))
    return found


def children(original: Original) -> list[tuple[int, ...]]:
    """Return the children of each source, in reading order."""
    found: list[tuple[int, ...]] = []
    roots: list[int] = []  # of the subtrees that have no parent yet, the first on top
    for source in reversed(range(len(original.places))):
        count = len(original.places[source].region.children)
        inner = [roots.pop() for _ in range(count)]
        found.append(tuple(inner))
        roots.append(source)
    return found[::-1]


def held(inside: Sequence[tuple[int, ...]]) -> list[int]:
    """Return how many sources each holds, itself among them: it, and those that follow it."""
    found = [1] * len(inside)
    for source in reversed(range(len(inside))):
        found[source] += sum(found[child] for child in inside[source])
    return found


def _features(original: Original, sources: Numbers, count: int) -> Floats:
    """Return what sources of like interiors are compared by, a row each: sizes, and lines inside.

    Sizes by their logarithms: differences are shares. Lines as shares of the sizes.
    """
    sizes = original.sizes[:, sources]
    within = sources[:, None] + np.arange(1, count)
    starts = original.spans[:, :, 0]
    lines = (starts[:, within] - starts[:, sources, None]) / sizes[:, :, None]
    return np.concatenate([np.log(sizes).T, *lines], axis=1)


def _divided(points: Floats, spread: float) -> list[NDArray[np.intp]]:
    """Divide points at their widest gaps until no part spans more than `spread` in any direction."""
    pending, found = [np.arange(len(points))], []
    while pending:
        part = pending.pop()
        own = np.sort(points[part], axis=0)
        if np.all(own[-1] - own[0] <= spread):
            found.append(part)
            continue
        gaps = np.diff(own, axis=0)
        gaps[:, own[-1] - own[0] <= spread] = 0.0  # no need to divide there
        step, direction = np.unravel_index(np.argmax(gaps), gaps.shape)
        low = points[part, direction] <= own[step, direction]
        pending += [part[~low], part[low]]
    return found
