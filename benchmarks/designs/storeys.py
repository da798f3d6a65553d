"""Ninety-six windows: eight storeys of twelve, each with its own symbols, in line from storey to storey."""

from __future__ import annotations

from itertools import pairwise, product

from benchmarks.designs.parts import (
    Part,
    columns,
    facade,
    in_line,
    leaf,
    rows,
    sequences,
    shuffled,
    sizes,
    total,
)
from layoutkit.constraints import Constraint
from layoutkit.model import Facade

STOREYS = tuple(f"S{number}" for number in range(8))
#: Windows of a storey: narrow and wide ones.
WINDOWS = {"W": 1.0, "D": 1.6}
WORD = "e W w W w D w W w W w D w D w W w W w D w W w W e"


def storeys() -> Facade:
    """Return the facade, 27.6 m wide and 26.2 m high."""
    parts = [leaf("R", 1.2, "Cornice"), *(_storey(symbol) for symbol in STOREYS), leaf("B", 1.0, "Base")]
    word = " ".join(["R", *STOREYS, "B"])
    width = total(WORD, _row_parts())
    root = rows("Front", width, word, parts)
    return facade("storeys", root, width, total(word, parts), [*_words(), *_lines(), *_ranges()])


def _row_parts() -> list[Part]:
    return [leaf("e", 1.1, "Wall"), leaf("w", 1.0, "Wall"), *map(_window, WINDOWS)]


def _storey(symbol: str) -> Part:
    return columns(symbol, 3.0, WORD, _row_parts())


def _window(symbol: str) -> Part:
    leaves = 2 if symbol == "W" else 3
    pane = (WINDOWS[symbol] - 0.2 - 0.1 * (leaves - 1)) / leaves
    lights = [leaf("j", 0.1, "Jamb"), leaf("c", pane, "Light"), leaf("m", 0.1, "Mullion")]
    frame = columns("f", 1.6, " ".join(["j", *["c m"] * (leaves - 1), "c j"]), lights)
    inner = [leaf("h", 0.6, "Lintel"), frame, leaf("s", 0.8, "Apron")]
    return rows(symbol, WINDOWS[symbol], "h f s", inner, "Window")


def _words() -> list[Constraint]:
    found = []
    for storey in STOREYS:
        found += sequences(f"Front/{storey}", "⊢ e {W D}", *shuffled("w W w D w"), "{W D} e ⊣")
    return found


def _lines() -> list[Constraint]:
    found = []
    for upper, lower in pairwise(STOREYS):
        for window in WINDOWS:
            found += in_line(f"Front/{upper}/{window}", f"Front/{lower}/{window}", "left right")
        found += in_line(f"Front/{upper}/W", f"Front/{lower}/D", "center")
        found += in_line(f"Front/{upper}/D", f"Front/{lower}/W", "center")
    return found


def _ranges() -> list[Constraint]:
    windows = [f"Front/{storey}/{window}" for storey, window in product(STOREYS, WINDOWS)]
    return [
        *sizes("70%", "150%", "5%", *windows, *(f"Front/{storey}" for storey in STOREYS)),
        *sizes("40%", "250%", "15%", *(f"Front/{storey}/{wall}" for storey in STOREYS for wall in "we")),
    ]
