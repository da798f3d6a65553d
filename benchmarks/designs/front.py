"""Facades of any size in one style: columns of windows of several kinds, storeys level across them."""

from __future__ import annotations

import math
from itertools import pairwise

from benchmarks.designs.parts import (
    Part,
    alike,
    columns,
    facade,
    in_line,
    leaf,
    rows,
    sequences,
    sizes,
    total,
)
from layoutkit.constraints import Constraint
from layoutkit.model import Facade

#: Terminals of a storey in one column, the wall beside it counted in.
_CELL = 8


def front(terminals: int) -> Facade:
    """Return a facade of about so many terminals, as many storeys as columns; larger ones have more kinds.

    Parameters
    ----------
    terminals
        At least 100.
    """
    storeys = max(3, round(math.sqrt(terminals / _CELL)))
    bays = max(3, round(terminals / _CELL / storeys))
    kinds = [f"W{number}" for number in range(2 + round(math.log2(terminals / 100)))]
    word = " w ".join(kinds[number % len(kinds)] for number in range(max(bays, len(kinds))))
    parts = [_wall(storeys), *(_column(kind, number, storeys) for number, kind in enumerate(kinds))]
    root = columns("Front", _height(storeys), word, parts)
    constraints = [*_words(kinds), *_lines(kinds), *_ranges(kinds)]
    return facade(f"front-{terminals}", root, total(word, parts), _height(storeys), constraints)


def _height(storeys: int) -> float:
    return 1.0 + 3.0 * storeys + 1.2


def _wall(storeys: int) -> Part:
    parts = [leaf("K", 1.0, "Cornice"), leaf("x", _height(storeys) - 1.0, "Wall")]
    return rows("w", 1.2, "K x", parts)


def _column(kind: str, number: int, storeys: int) -> Part:
    """Return a column; kinds differ in width, and in the lights of their windows."""
    leaves = 1 + number % 3
    width = 1.2 + 0.4 * (number % 3)
    pane = (width - 0.2 - 0.1 * (leaves - 1)) / leaves
    lights = [leaf("j", 0.1, "Jamb"), leaf("c", pane, "Light"), leaf("m", 0.1, "Mullion")]
    frame = columns("f", 1.4, " ".join(["j", *["c m"] * (leaves - 1), "c j"]), lights)
    window = rows("u", 1.8, "h f s", [leaf("h", 0.2, "Hood"), frame, leaf("s", 0.2, "Sill")], "Window")
    parts = [leaf("K", 1.0, "Cornice"), leaf("a", 1.2, "Wall"), window]
    return rows(kind, width, f"K {'a u ' * storeys} a", parts)


def _words(kinds: list[str]) -> list[Constraint]:
    openings = "{" + " ".join(kinds) + "}"
    found = sequences("Front", f"⊢ {openings}", f"{openings} w {openings}", f"{openings} ⊣")
    for kind in kinds:
        found += sequences(f"Front/{kind}", "⊢ K a u", "u a u", "u a ⊣")
        found += sequences(f"Front/{kind}/u/f", "⊢ j c", "c m c", "c j ⊣")
    return found


def _lines(kinds: list[str]) -> list[Constraint]:
    found = []
    for one, other in pairwise(kinds):
        found += in_line(f"Front/{one}/u", f"Front/{other}/u", "top bottom")
        found += in_line(f"Front/{one}/K", f"Front/{other}/K", "bottom")
        found += alike("height", f"Front/{one}: a u", f"Front/{other}: a u")
    return found


def _ranges(kinds: list[str]) -> list[Constraint]:
    return [
        *sizes("80%", "130%", "5%", *(f"Front/{kind}" for kind in kinds)),
        *sizes("85%", "120%", "5%", *(f"Front/{kind}/u" for kind in kinds)),
        *sizes("60%", "170%", "15%", "Front/w", *(f"Front/{kind}/a" for kind in kinds)),
    ]
