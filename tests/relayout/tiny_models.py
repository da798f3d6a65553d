"""Random tiny facades with constraints of every kind, small enough for brute force."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement, SameSize, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.generators import framed
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Word

Random = np.random.Generator


def tiny(seed: int) -> tuple[Facade, tuple[float, float]]:
    """Return a facade of one to four composite regions, and a size to lay it out at."""
    random = np.random.default_rng(seed)
    root = (_row, _floors, _bays, _stacked)[random.choice(4, p=(0.3, 0.3, 0.3, 0.1))](random)
    bare = Facade(f"tiny-{seed}", "m", root)
    constraints: list[Constraint] = list(_sizes(bare, random))
    for path, region in bare.regions.items():
        if region.split and random.random() < (0.85 if len(set(region.word)) > 1 else 0.5):
            constraints += _sequences(path, region, random)
    for make, chance in ((_frequency, 0.4), (_alignment, 0.6), (_same_size, 0.35), (_same_words, 0.35)):
        if random.random() < chance:
            constraints += make(bare, random)
    facade = Facade(bare.name, "m", root, constraints=tuple(constraints))
    size = root.width * random.uniform(0.7, 1.5), root.height * random.uniform(0.75, 1.35)
    return facade, size


def _some(random: Random, items: Sequence[str], least: int = 1, most: int | None = None) -> list[str]:
    count = int(random.integers(least, min(most or len(items), len(items)) + 1))
    return [items[i] for i in sorted(random.choice(len(items), count, replace=False))]


def _word(random: Random, letters: str, least: int, most: int) -> list[str]:
    """Return a word that has every letter."""
    word = [
        *letters,
        *random.choice([*letters], max(0, int(random.integers(least, most + 1)) - len(letters))),
    ]
    return [str(s) for s in random.permutation(word)]


def _split(
    random: Random, symbol: str, word: Sequence[str], split: str, width: float, height: float
) -> Region:
    """Return a region of terminals, its symbols' sizes random."""
    share = {s: random.uniform(0.6, 1.4) for s in word}
    total = sum(share[s] for s in word)
    labels = {"a": ("Window",), "b": ("Wall",), "c": ("Window", "Door"), "x": ("Window",), "y": ("Wall",)}
    children = tuple(
        Region(s, width * share[s] / total, height, labels=labels[s])
        if split == "columns"
        else Region(s, width, height * share[s] / total, labels=labels[s])
        for s in word
    )
    return Region(symbol, width, height, "columns" if split == "columns" else "rows", children)


def _row(random: Random) -> Region:
    letters = "abc"[: int(random.integers(2, 4))]
    split = "columns" if random.random() < 0.8 else "rows"
    return _split(random, "R", _word(random, letters, 2, 4), split, 6.0, 5.0)


def _floors(random: Random) -> Region:
    words = [_word(random, "abc"[: int(random.integers(2, 4))] if random.random() < 0.4 else "ab", 2, 3)]
    words.append(words[0] if random.random() < 0.6 else _word(random, "ab", 2, 3))
    heights = {"F": random.uniform(2.0, 3.0), "G": random.uniform(2.0, 3.0)}
    order = [["F", "G"], ["F", "F", "G"], ["F", "G", "F"]][random.integers(3)]
    first = _split(random, "F", words[0], "columns", 6.0, heights["F"])
    second = _split(random, "G", words[1], "columns", 6.0, heights["G"])
    made = {"F": first, "G": second}
    return Region("R", 6.0, sum(heights[s] for s in order), "rows", tuple(made[s] for s in order))


def _bays(random: Random) -> Region:
    """A row of terminals and one bay, which is split again, either way."""
    split = "rows" if random.random() < 0.5 else "columns"
    wide, narrow = random.uniform(2.2, 3.2), random.uniform(1.2, 2.0)
    bay = _split(random, "B", _word(random, "xy", 2, 3), split, wide, 5.0)
    word = [["a", "B"], ["a", "B", "a"], ["B", "a", "B"], ["a", "B", "B"]][random.integers(4)]
    made = {"a": Region("a", narrow, 5.0, labels=("Window",)), "B": bay}
    return Region("R", sum(made[s].width for s in word), 5.0, "columns", tuple(made[s] for s in word))


def _stacked(random: Random) -> Region:
    """A floor, and a block that holds another one of the same bays."""
    word = _word(random, "ab", 2, 2)
    heights = [random.uniform(2.0, 3.0) for _ in range(3)]
    floor = _split(random, "F", word, "columns", 6.0, heights[0])
    other = _split(random, "G", word, "columns", 6.0, heights[1])
    block = Region("B", 6.0, heights[1] + heights[2], "rows", (other, Region("h", 6.0, heights[2])))
    return Region("R", 6.0, floor.height + block.height, "rows", (floor, block))


def _sizes(facade: Facade, random: Random) -> list[Constraint]:
    found: list[Constraint] = []
    for path, region in facade.regions.items():
        if "/" in path and (region.split or random.random() < 0.8):
            low, high = random.uniform(0.6, 0.95), random.uniform(1.05, 1.6)
            found.append(Size(of=RegionSet(path), min=Measure(low, True), max=Measure(high, True)))
    return found


def _sequences(path: str, region: Region, random: Random) -> list[Constraint]:
    letters = list(dict.fromkeys(region.word))
    after = {s: _some(random, letters) for s in letters if random.random() < 0.9}
    starts, ends = _some(random, letters), _some(random, letters)
    words = list(framed(starts, after, ends))
    for _ in range(int(random.integers(0, 3))):
        sets = tuple(RegionSet.union(_some(random, letters)) for _ in range(int(random.integers(2, 4))))
        words.append(Word(sets, random.random() < 0.2, random.random() < 0.2))
    if random.random() < 0.3:  # without the chain's own links: only longer pieces join
        words = [w for w in words if len(w.sets) != 2 or w.at_start or w.at_end] + [words[0], words[-1]]
    if random.random() < 0.4:
        words.append(Word(tuple(RegionSet(s) for s in region.word), True, True))
    return [SequenceConstraint(within=(path,), word=word) for word in words]


def _composites(facade: Facade) -> list[str]:
    return [path for path, region in facade.regions.items() if region.split]


def _frequency(facade: Facade, random: Random) -> list[Constraint]:
    within = _some(random, _composites(facade), 1, 1)[0]
    symbols = list(dict.fromkeys(facade.regions[within].word))
    names = ["@Window", "@Wall", *symbols]
    of = RegionSet.union(_some(random, names, 1, 2))
    if random.random() < 0.5:
        low = int(random.integers(0, 3))
        least, most = Measure(float(low)), Measure(float(low + random.integers(0, 3)))
    else:
        least = Measure(random.uniform(0.3, 0.9), True)
        most = Measure(least.value + random.uniform(0.3, 1.0), True)
    way = random.integers(3)
    return [Frequency(of=of, within=within, min=None if way == 1 else least, max=None if way == 2 else most)]


def _inner(facade: Facade) -> list[str]:
    return [path for path in facade.regions if "/" in path]


def _alignment(facade: Facade, random: Random) -> list[Constraint]:
    paths = [p for p in _inner(facade) if p.count("/") == 2] or _inner(facade)
    first, second = (RegionSet.union(_some(random, paths, 1, 2)) for _ in range(2))
    if floors := [p for p in _composites(facade) if p[-1] in "FG"]:  # one set from each
        inside = [[p for p in facade.regions if p.startswith(f"{floor}/")] for floor in floors]
        first, second = (RegionSet.union(_some(random, own, 1, 2)) for own in inside)
    lines = ("left", "center", "right") if random.random() < 0.8 else ("top", "middle", "bottom")
    within = "R/B" if "R/B" in facade.regions and random.random() < 0.3 else None
    chosen = tuple(_some(random, lines, 1, 2))
    return [Alignment(first=first, second=second, lines=chosen, within=within)]


def _same_size(facade: Facade, random: Random) -> list[Constraint]:
    paths = _inner(facade)
    dimension = "width" if random.random() < 0.7 else "height"
    first, second = (Extent(RegionSet.union(_some(random, paths, 1, 2))) for _ in range(2))
    columns = [p for p in _composites(facade) if facade.regions[p].split == "columns"]
    if columns and dimension == "width" and random.random() < 0.4:
        within = _some(random, columns, 1, 1)[0]
        word = facade.regions[within].word[:2]
        first = Extent(None, within, Word(tuple(RegionSet(s) for s in word)))
    scope = _some(random, _composites(facade), 1, 1)[0] if random.random() < 0.3 else None
    return [
        SameSize(
            first=first, second=second if random.random() < 0.7 else None, dimension=dimension, within=scope
        )
    ]


def _same_words(facade: Facade, random: Random) -> list[Constraint]:
    pair = ("R/F", "R/B/G" if "R/B/G" in facade.regions else "R/G")
    if not set(pair) <= facade.regions.keys():
        return []
    symbols = [set(facade.regions[path].word) for path in pair]
    return [SameArrangement(of=pair)] if symbols[0] == symbols[1] else []
