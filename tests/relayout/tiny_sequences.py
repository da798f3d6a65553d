"""Sequences and their generators for random tiny facades."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from layoutkit.constraints import Constraint, Repetition, Replication, Reuse, Reversal, TwoShuffle
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.generators import framed, sequences
from layoutkit.constraints.pattern import Pattern
from layoutkit.model import Facade, Region, RegionSet, Word

Random = np.random.Generator

#: Patterns over a region's letters: A and B are two different ones, C is any.
PATTERNS = (
    "A+ B", "A (B A)*", "(A B)+", "A? B+ A?", "(A | B)+", "A B | B A", "{A B}+", "A B? A", "A+[B]", "A*[B] C",
    "(A C)+[B] A?", "A (B | C) A", "@Window+ B?", "(A B?)+", "A B* C",
)  # fmt: skip


def permissions(facade: Facade, random: Random) -> list[Constraint]:
    """Return what says which words each region may have."""
    found: list[Constraint] = []
    spoken: list[str] = []
    for path, region in facade.regions.items():
        if region.split and random.random() < (0.85 if len(set(region.word)) > 1 else 0.5):
            found += _permissions(path, region, spoken, random)
            spoken.append(path)
    return found


def _permissions(path: str, region: Region, spoken: Sequence[str], random: Random) -> Iterator[Constraint]:
    way = random.random()
    if way < 0.5:
        yield from _chain(path, region, random)
    elif way < 0.7:
        yield Repetition(within=(path,), pattern=Pattern.parse(_pattern(region, random)))
    elif way < 0.82:
        run = _some(random, region.word, 2, 3) if random.random() < 0.4 and len(region.word) > 1 else None
        yield TwoShuffle(within=(path,), of=None if run is None else Word(tuple(map(RegionSet, run))))
        yield from _ends(path, region, random)
    elif way < 0.9 and spoken:
        yield Reuse(within=RegionSet(path), like=spoken[-1])
    else:
        yield Replication(within=(path,))
    if random.random() < 0.15:
        start = int(random.integers(len(region.word)))
        run = region.word[start : start + int(random.integers(1, 3))]
        yield Replication(within=(path,), of=Word(tuple(map(RegionSet, run))))
    if random.random() < 0.12:
        yield Reversal(within=(path,), of=spoken[0] if spoken and random.random() < 0.3 else None)


def _some(random: Random, items: Sequence[str], least: int = 1, most: int | None = None) -> list[str]:
    count = int(random.integers(least, min(most or len(items), len(items)) + 1))
    return [items[i] for i in sorted(random.choice(len(items), count, replace=False))]


def _pattern(region: Region, random: Random) -> str:
    letters = [str(s) for s in random.permutation(list(dict.fromkeys(region.word)))]
    named = {"A": letters[0], "B": letters[-1], "C": letters[len(letters) // 2]}
    text = str(random.choice(PATTERNS))
    return "".join(named.get(sign, sign) for sign in text)


def _ends(path: str, region: Region, random: Random) -> list[Constraint]:
    letters = list(dict.fromkeys(region.word))
    starts, ends = (RegionSet.union(_some(random, letters)) for _ in range(2))
    return [
        SequenceConstraint(within=(path,), word=Word((starts,), at_start=True)),
        SequenceConstraint(within=(path,), word=Word((ends,), at_end=True), weight=random.uniform(0.5, 3.0)),
    ]


def _chain(path: str, region: Region, random: Random) -> list[SequenceConstraint]:
    letters = list(dict.fromkeys(region.word))
    names = [*letters, *sorted({f"@{label}" for child in region.children for label in child.labels})]
    after = {s: _some(random, letters) for s in letters if random.random() < 0.9}
    starts, ends = _some(random, letters), _some(random, letters)
    words = list(framed(starts, after, ends))
    for _ in range(int(random.integers(0, 3))):
        sets = tuple(RegionSet.union(_some(random, names)) for _ in range(int(random.integers(2, 4))))
        words.append(Word(sets, random.random() < 0.2, random.random() < 0.2))
    if random.random() < 0.3:  # without the chain's own links: only longer pieces join
        words = [w for w in words if len(w.sets) != 2 or w.at_start or w.at_end] + [words[0], words[-1]]
    if random.random() < 0.4:
        words.append(Word(tuple(RegionSet(s) for s in region.word), True, True))
    return sequences([path], words)
