"""Random facades of three to six floors with long words, coupled with one another in many ways.

Too large for brute force. All ranges are whole multiples of `STEP`, the sizes to lay them out at of `WHOLE`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
)
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.generators import framed, sequences
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Split, Word

Random = np.random.Generator

#: Metres.
STEP, WHOLE = 0.05, 0.5
#: Width and height of every input.
INPUT = 12.0
LABELS = {"a": ("Window",), "b": ("Wall",), "c": ("Window", "Door"), "d": ("Wall",), "B": ("Bay",)}
LABELS |= {"x": ("Window",), "y": ("Wall",)}


@dataclass(frozen=True)
class Ways:
    """The names of what runs along the floors: in columns, or, in a facade on its side, in rows."""

    floors: Split
    bays: Split
    dimension: str
    lines: tuple[str, str, str]


UPRIGHT = Ways("rows", "columns", "width", ("left", "center", "right"))
ON_ITS_SIDE = Ways("columns", "rows", "height", ("top", "middle", "bottom"))


def coupled(seed: int, most: int = 6, longest: float = 16.0) -> tuple[Facade, tuple[float, float]]:
    """Return a facade, and a size to lay it out at.

    Parameters
    ----------
    most
        Floors, at the most; three at the least.
    longest
        How long the floors are at the most, in metres.
    """
    random = np.random.default_rng(seed)
    ways = UPRIGHT if random.random() < 0.6 else ON_ITS_SIDE
    letters = [_letters(random) for _ in range(int(random.integers(3, most + 1)))]
    for number in range(1, len(letters)):
        if random.random() < 0.4:  # as the floor before, so that both can have the same words
            letters[number] = letters[number - 1]
    floors = [f"F{number}" for number in range(1, len(letters) + 1)]
    root = _root(floors, letters, ways, random)
    bare = Facade(f"coupled-{seed}", "m", root)
    constraints = [*_sizes(bare, random), *_stack(floors, random)]
    constraints += _words(bare, random)
    constraints += _couplings(bare, floors, ways, random)
    along = _steps(random.uniform(6.0, longest), WHOLE)
    across = _steps(len(floors) * random.uniform(2.0, 3.4), WHOLE)
    size = (along, across) if ways is UPRIGHT else (across, along)
    return Facade(bare.name, "m", root, constraints=tuple(constraints)), size


def _steps(metres: float, step: float = STEP) -> float:
    return round(round(metres / step) * step, 6)


def _letters(random: Random) -> str:
    return "abcd"[: int(random.integers(2, 5))] + ("B" if random.random() < 0.25 else "")


def _some(random: Random, items: Sequence[str], least: int = 1, most: int | None = None) -> list[str]:
    count = int(random.integers(least, min(most or len(items), len(items)) + 1))
    return [items[i] for i in sorted(random.choice(len(items), count, replace=False))]


def _root(floors: Sequence[str], letters: Sequence[str], ways: Ways, random: Random) -> Region:
    high = INPUT / len(floors)
    made = []
    for symbol, own in zip(floors, letters, strict=True):
        further = random.choice([*own], int(random.integers(1, 4)))
        word = [str(s) for s in random.permutation([*own, *further])]
        made.append(_divided(symbol, word, INPUT, high, ways.bays, random))
    return Region("R", INPUT, INPUT, ways.floors, tuple(made))


def _divided(
    symbol: str, word: Sequence[str], along: float, across: float, split: Split, random: Random
) -> Region:
    """Return a region in which all symbols are equally large; a bay is divided again, the same way."""
    own = along / len(word)
    children = []
    inner: dict[str, Region] = {}
    for letter in word:
        if letter not in inner:
            inner[letter] = (
                _divided("B", ["x", "y", "x"][: int(random.integers(2, 4))], own, across, split, random)
                if letter == "B"
                else _sized(letter, own, across, split)
            )
        children.append(inner[letter])
    width, height = (along, across) if split == "columns" else (across, along)
    return Region(symbol, width, height, split, tuple(children), LABELS.get(symbol, ("Floor",)))


def _sized(symbol: str, along: float, across: float, split: Split) -> Region:
    width, height = (along, across) if split == "columns" else (across, along)
    return Region(symbol, width, height, labels=LABELS[symbol])


def _sizes(facade: Facade, random: Random) -> Iterator[Constraint]:
    """Yield a range for every region, floors and bays included."""
    for path in facade.regions:
        depth = path.count("/")
        if depth == 1:
            low, high = random.uniform(1.5, 2.2), random.uniform(2.8, 3.8)
        elif path.endswith("/B"):
            low, high = random.uniform(1.0, 1.8), random.uniform(2.2, 3.5)
        elif depth:
            low = random.uniform(0.7, 1.6) if depth == 2 else random.uniform(0.4, 0.9)
            high = low + random.uniform(0.1, 1.0)
        else:
            continue
        yield Size(of=RegionSet(path), min=Measure(_steps(low)), max=Measure(_steps(high)))


def _stack(floors: Sequence[str], random: Random) -> list[SequenceConstraint]:
    """Return sequences of the root in which one floor may repeat; most often none: the input's word."""
    if random.random() < 0.6:
        return []
    often = str(random.choice(floors))
    after = {one: [other] for one, other in pairwise(floors)}
    after[often] = [often, *after.get(often, [])]
    return sequences(["R"], framed(floors[:1], after, floors[-1:]))


def _words(facade: Facade, random: Random) -> Iterator[SequenceConstraint]:
    """Yield sequences for floors and bays; those of a floor often hold for the next one with its letters."""
    before: tuple[frozenset[str], list[Word]] = frozenset(), []
    for path, region in facade.regions.items():
        if region.split and "/" in path and (path.count("/") == 1 or random.random() < 0.4):
            letters = frozenset(region.word)
            words = before[1] if letters == before[0] and random.random() < 0.7 else _chain(region, random)
            yield from sequences([path], words)
            if path.count("/") == 1:
                before = letters, words


def _chain(region: Region, random: Random) -> list[Word]:
    """Return which letters may stand side by side; most often, the one way round as the other."""
    letters = list(dict.fromkeys(region.word))
    beside = set(pairwise(region.word))
    beside |= {(a, b) for a in letters for b in letters if random.random() < 0.25}
    ends = [{region.word[0], *_some(random, letters)}, {region.word[-1], *_some(random, letters)}]
    if random.random() < 0.6:
        beside |= {(b, a) for a, b in beside}
        ends = [ends[0] | ends[1]] * 2
    after = {s: [other for other in letters if (s, other) in beside] for s in letters}
    words = list(framed(sorted(ends[0]), after, sorted(ends[1])))
    for _ in range(int(random.integers(0, 3))):
        sets = tuple(RegionSet.union(_some(random, letters, 1, 2)) for _ in range(int(random.integers(2, 5))))
        words.append(Word(sets, random.random() < 0.2, random.random() < 0.2))
    if random.random() < 0.25 and len(words) > 3:  # without one of its links: longer pieces have to join
        del words[int(random.integers(1, len(words) - 1))]
    return words


def _couplings(facade: Facade, floors: Sequence[str], ways: Ways, random: Random) -> Iterator[Constraint]:
    for one, other in pairwise(floors):
        if random.random() < 0.5:
            yield _alignment(facade, f"R/{one}", f"R/{other}", ways, random)
        if random.random() < 0.2:
            yield _same_size(facade, f"R/{one}", f"R/{other}", ways, random)
        same = set(facade.regions[f"R/{one}"].word) == set(facade.regions[f"R/{other}"].word)
        if same and random.random() < 0.6:
            yield SameArrangement(of=(f"R/{one}", f"R/{other}"))
    if random.random() < 0.4:
        one, other = _some(random, floors, 2, 2)
        yield _alignment(facade, f"R/{one}", f"R/{other}", ways, random)
    for floor in floors:
        if random.random() < 0.12:
            yield _symmetry(facade, f"R/{floor}", random)
        if random.random() < 0.2:
            yield _frequency(facade, f"R/{floor}", random)
    if random.random() < 0.4:
        yield _frequency(facade, "R", random)


def _inside(facade: Facade, floor: str) -> list[str]:
    return [path for path in facade.regions if path.startswith(f"{floor}/")]


def _alignment(facade: Facade, one: str, other: str, ways: Ways, random: Random) -> Alignment:
    paths = [_inside(facade, floor) for floor in (one, other)]
    first, second = (RegionSet.union(_some(random, own, 1, 2)) for own in paths)
    contexts: dict[str, Word] = {}
    if random.random() < 0.2:
        names = list(dict.fromkeys(facade.regions[one].word))
        chosen = (RegionSet.union(_some(random, names, 1, 2)),) if random.random() < 0.7 else ()
        contexts["first_before"] = Word(chosen, at_start=not chosen)
        first = RegionSet.union(_some(random, [f"{one}/{name}" for name in names], 1, 2))
    lines = tuple(_some(random, ways.lines, 1, 1 + (random.random() < 0.3)))
    return Alignment(first=first, second=second, lines=lines, **contexts)


def _same_size(facade: Facade, one: str, other: str, ways: Ways, random: Random) -> SameSize:
    extents = []
    for floor in (one, other):
        if random.random() < 0.3:
            word = facade.regions[floor].word[:2]
            extents.append(Extent(None, floor, Word(tuple(RegionSet(s) for s in word))))
        else:
            extents.append(Extent(RegionSet.union(_some(random, _inside(facade, floor), 1, 2))))
    return SameSize(first=extents[0], second=extents[1], dimension=ways.dimension)


def _symmetry(facade: Facade, floor: str, random: Random) -> Symmetry:
    symbols = list(dict.fromkeys(facade.regions[floor].word))
    one, other = _some(random, symbols, 2, 2)
    return Symmetry(of=(floor,), pairs=((one, other),) if random.random() < 0.3 else ())


def _frequency(facade: Facade, within: str, random: Random) -> Frequency:
    labels = RegionSet(str(random.choice(["@Window", "@Wall"])))
    symbols = list(dict.fromkeys(facade.regions[within].word))
    of = labels if within == "R" or random.random() < 0.4 else RegionSet.union(_some(random, symbols, 1, 2))
    if random.random() < 0.5:
        low = int(random.integers(0, 4 if within != "R" else 10))
        high = low + int(random.integers(0, 6 if within != "R" else 20))
        return Frequency(of=of, within=within, min=Measure(float(low)), max=Measure(float(high)))
    low = int(random.integers(30, 90))
    high = low + int(random.integers(30, 150))
    return Frequency(of=of, within=within, min=Measure(low / 100, True), max=Measure(high / 100, True))
