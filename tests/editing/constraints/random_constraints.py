"""Random constraints of every built-in kind on random facades, without faults in their documents."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    Repetition,
    Replication,
    Reuse,
    Reversal,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
    TwoShuffle,
)
from layoutkit.constraints import Sequence as Arrangements
from layoutkit.constraints.alignment import LINES
from layoutkit.constraints.answers import faults_of
from layoutkit.constraints.pattern import Pattern
from layoutkit.model import Extent, Facade, Measure, RegionSet, Word

Random = np.random.Generator
T = TypeVar("T")


def constrained(facade: Facade, random: Random, most: int = 6) -> Facade:
    """Return the facade with some constraints, each of which its kind finds nothing wrong with."""
    kept: tuple[Constraint, ...] = ()
    for _ in range(int(random.integers(1, most + 1))):
        more = (*kept, _chosen(random, MAKERS)(facade, random))
        if not any(fault for own in more for fault in faults_of(own, replace(facade, constraints=more))):
            kept = more
    return replace(facade, constraints=kept)


def _chosen(random: Random, values: Sequence[T]) -> T:
    return values[int(random.integers(len(values)))]


def _some(random: Random, values: Sequence[T], most: int) -> list[T]:
    """Return a few values, at least one, in order."""
    number = int(random.integers(1, min(most, len(values)) + 1))
    return [values[place] for place in sorted(random.choice(len(values), number, replace=False).tolist())]


def _set(facade: Facade, random: Random) -> RegionSet:
    """Return a set of paths, labels and insides, joined by any operators."""
    names = [*facade.regions, *(f"@{label}" for label in sorted(facade.labels))]
    names += [f"{path}/*" for path in _composites(facade)]
    found = RegionSet(_chosen(random, names))
    for _ in range(int(random.integers(0, 3))):
        operator = _chosen(random, ("|", "|", "-", "&"))
        found = RegionSet(operator=operator, left=found, right=RegionSet(_chosen(random, names)))
    return found


def _composites(facade: Facade) -> list[str]:
    return [path for path, region in facade.regions.items() if region.split]


def _measure(random: Random) -> Measure | None:
    share = float(random.integers(5, 30)) / 10
    return None if random.random() < 0.3 else Measure(share, relative=True)


def _word(facade: Facade, path: str, random: Random, ends: bool = True) -> Word:
    """Return a part of a region's arrangement, some symbols in sets."""
    own = facade.regions[path].word
    start = int(random.integers(len(own)))
    end = int(random.integers(start + 1, len(own) + 1))
    sets = []
    for symbol in own[start:end]:
        more = _some(random, sorted(set(own)), 2) if random.random() < 0.3 else ()
        sets.append(RegionSet.union(dict.fromkeys((symbol, *more))))
    return Word(tuple(sets), ends and start == 0, ends and end == len(own))


def _size(facade: Facade, random: Random) -> Constraint:
    least, most = _measure(random), _measure(random)
    if least and most and least.value > most.value:
        least, most = most, least
    return Size(of=_set(facade, random), min=least, max=most)


def _sequence(facade: Facade, random: Random) -> Constraint:
    path = _chosen(random, _composites(facade))
    return Arrangements(within=(path,), word=_word(facade, path, random))


def _shared_sequence(facade: Facade, random: Random) -> Constraint:
    paths = _some(random, _composites(facade), 3)
    return Arrangements(within=tuple(paths), word=_word(facade, paths[0], random))


def _generator(facade: Facade, random: Random) -> Constraint:
    path, other = (_chosen(random, _composites(facade)) for _ in range(2))
    return _chosen(
        random,
        (
            Replication(within=(path,)),
            Reversal(within=(path,)),
            Reversal(within=(path,), of=other),
            Reuse(within=RegionSet(path), like=other),
        ),
    )


def _shuffle(facade: Facade, random: Random) -> Constraint:
    return TwoShuffle(within=(_chosen(random, _composites(facade)),))


def _repetition(facade: Facade, random: Random) -> Constraint:
    path = _chosen(random, _composites(facade))
    word = [f"{symbol}{_chosen(random, ('', '', '?', '+', '*'))}" for symbol in facade.regions[path].word]
    return Repetition(within=(path,), pattern=Pattern.parse(" ".join(word)))


def _frequency(facade: Facade, random: Random) -> Constraint:
    within = _chosen(random, _composites(facade))
    of = _chosen(random, (*facade.regions[within].word, *(f"@{label}" for label in sorted(facade.labels))))
    most = _measure(random)
    return Frequency(of=RegionSet(of), within=within, min=Measure(0.5, True), max=most)


def _instances(facade: Facade, random: Random) -> Constraint:
    paths = [path for path in facade.regions if "/" in path]
    return Instances(of=RegionSet.union(_some(random, paths, 2)), max=Measure(float(random.integers(1, 4))))


def _alignment(facade: Facade, random: Random) -> Constraint:
    axis = int(random.integers(2))
    lines = tuple(_some(random, [line for line, (own, _) in LINES.items() if own == axis], 2))
    around = _chosen(random, _composites(facade)) if random.random() < 0.3 else None
    return Alignment(first=_set(facade, random), second=_set(facade, random), lines=lines, within=around)


def _beside(facade: Facade, random: Random) -> Constraint:
    """Return an alignment of what stands beside something."""
    path = _chosen(random, _composites(facade))
    child, beside = (_chosen(random, facade.regions[path].word) for _ in range(2))
    own = RegionSet(f"{path}/{child}")
    word = Word((RegionSet(beside),))
    return Alignment(first=own, second=own, lines=("left",), first_before=word)


def _same_size(facade: Facade, random: Random) -> Constraint:
    dimension = _chosen(random, ("width", "height"))
    if random.random() < 0.5:
        return SameSize(first=Extent(_set(facade, random)), dimension=dimension)
    path = _chosen(random, _composites(facade))
    run = Extent(None, path, _word(facade, path, random, ends=False))
    return SameSize(first=run, second=Extent(_set(facade, random)), dimension=dimension)


def _symmetry(facade: Facade, random: Random) -> Constraint:
    path = _chosen(random, _composites(facade))
    word = facade.regions[path].word
    pairs = ((word[0], word[-1]),) if word[0] != word[-1] else ()
    return Symmetry(of=(path,), pairs=pairs)


def _same_arrangement(facade: Facade, random: Random) -> Constraint:
    return SameArrangement(of=tuple(_some(random, _composites(facade), 3)))


def _lock(facade: Facade, random: Random) -> Constraint:
    keep = tuple(_some(random, ("place", "size", "inside"), 2))
    return Lock(of=_set(facade, random), keep=keep)


MAKERS: tuple[Callable[[Facade, Random], Constraint], ...] = (
    _size,
    _sequence,
    _shared_sequence,
    _generator,
    _shuffle,
    _repetition,
    _frequency,
    _instances,
    _alignment,
    _beside,
    _same_size,
    _symmetry,
    _same_arrangement,
    _lock,
)
