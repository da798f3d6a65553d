"""Random tiny facades with constraints of every kind, small enough for brute force."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from tiny_constraints import (
    alignment,
    frequency,
    instances,
    lock,
    same_arrangement,
    same_size,
    sizes,
    symmetry,
)
from tiny_sequences import permissions

from layoutkit.constraints import Constraint
from layoutkit.diagnostics import Severity
from layoutkit.model import Facade, Region, Split

Random = np.random.Generator

#: Makers of constraints, with how often each is asked.
MAKERS: Sequence[tuple[Callable[[Facade, Random], list[Constraint]], float]] = (
    (frequency, 0.35),
    (frequency, 0.1),
    (instances, 0.3),
    (alignment, 0.4),
    (alignment, 0.15),
    (same_size, 0.3),
    (same_arrangement, 0.3),
    (symmetry, 0.2),
    (lock, 0.25),
)
#: How many constraints are soft, of the models that have some.
SOFT = 0.35
LABELS = {"a": ("Window",), "b": ("Wall",), "c": ("Window", "Door"), "x": ("Window",), "y": ("Wall",)}


def tiny(seed: int) -> tuple[Facade, tuple[float, float]]:
    """Return a facade of one to four composite regions, and a size to lay it out at."""
    random = np.random.default_rng(seed)
    root = SHAPES[random.choice(len(SHAPES), p=CHANCES)](random)
    bare = Facade(f"tiny-{seed}", "m", root)
    constraints = [*sizes(bare, random), *permissions(bare, random)]
    for make, chance in MAKERS:
        if random.random() < chance:
            constraints += make(bare, random)
    if random.random() < 0.35:
        constraints = [_softened(constraint, random) for constraint in constraints]
    facade = _sound(replace(bare, constraints=tuple(constraints)))
    size = root.width * random.uniform(0.7, 1.5), root.height * random.uniform(0.75, 1.35)
    if random.random() < 0.15:
        size = root.width, root.height
    return facade, size


def _softened(constraint: Constraint, random: Random) -> Constraint:
    """Return the constraint, soft or hard; sequences stay what they are."""
    weight = float(random.choice([0.5, 1.0, 1.0, 2.0]))
    if constraint.weight is not None or random.random() >= SOFT:
        return constraint
    return replace(constraint, weight=weight)


def _sound(facade: Facade) -> Facade:
    """Return the facade without the constraints at fault: a random pattern may be beyond sequences."""
    while wrong := [c for c in facade.constraints if errors(c, facade)]:
        facade = replace(facade, constraints=tuple(c for c in facade.constraints if c not in wrong))
    return facade


def errors(constraint: Constraint, facade: Facade) -> list[str]:
    """Return what is wrong with a constraint."""
    return [str(fault) for fault in constraint.faults(facade) if fault.severity is Severity.ERROR]


def _word(random: Random, letters: str, least: int, most: int) -> list[str]:
    """Return a word that has every letter."""
    further = max(0, int(random.integers(least, most + 1)) - len(letters))
    word = [*letters, *random.choice([*letters], further)]
    return [str(symbol) for symbol in random.permutation(word)]


def _split(
    random: Random, symbol: str, word: Sequence[str], split: Split, width: float, height: float
) -> Region:
    """Return a region of terminals, its symbols' sizes random."""
    share = {s: random.uniform(0.6, 1.4) for s in word}
    total = sum(share[s] for s in word)
    children = tuple(
        Region(s, width * share[s] / total, height, labels=LABELS[s])
        if split == "columns"
        else Region(s, width, height * share[s] / total, labels=LABELS[s])
        for s in word
    )
    return Region(symbol, width, height, split, children)


def _row(random: Random) -> Region:
    letters = "abc"[: int(random.integers(2, 4))]
    split: Split = "columns" if random.random() < 0.8 else "rows"
    return _split(random, "R", _word(random, letters, 2, 4), split, 6.0, 5.0)


def _floors(random: Random) -> Region:
    """Two floors, of which one may stand twice."""
    words = [_word(random, "abc"[: int(random.integers(2, 4))] if random.random() < 0.4 else "ab", 2, 3)]
    words.append(words[0] if random.random() < 0.6 else _word(random, "ab", 2, 3))
    heights = {"F": random.uniform(2.0, 3.0), "G": random.uniform(2.0, 3.0)}
    order = [["F", "G"], ["F", "F", "G"], ["F", "G", "F"]][random.integers(3)]
    made = {
        symbol: _split(random, symbol, word, "columns", 6.0, heights[symbol])
        for symbol, word in zip("FG", words, strict=True)
    }
    return Region("R", 6.0, sum(heights[s] for s in order), "rows", tuple(made[s] for s in order))


def _bays(random: Random) -> Region:
    """A row of terminals and one bay, which is split again, either way."""
    split: Split = "rows" if random.random() < 0.5 else "columns"
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


def _windows(random: Random) -> Region:
    """A floor of bays, each a window over a wall, beside a pier; and another floor below, or none."""
    pier, wide, high = random.uniform(0.8, 1.5), random.uniform(2.0, 3.0), random.uniform(2.2, 3.0)
    bay = _split(random, "B", _word(random, "xy", 2, 2), "rows", wide, high)
    made = {"a": Region("a", pier, high, labels=LABELS["a"]), "B": bay}
    word = [["B", "B"], ["B", "a", "B"], ["a", "B"]][random.integers(3)]
    floor = Region("F", sum(made[s].width for s in word), high, "columns", tuple(made[s] for s in word))
    rest = random.uniform(1.0, 2.0)
    if random.random() < 0.5:
        return Region("R", floor.width, 2 * high, "rows", (floor, floor))
    ground = _split(random, "G", _word(random, "ab", 2, 2), "columns", floor.width, rest)
    return Region("R", floor.width, high + rest, "rows", (floor, ground))


SHAPES = (_row, _floors, _bays, _stacked, _windows)
CHANCES = (0.25, 0.3, 0.2, 0.1, 0.15)
