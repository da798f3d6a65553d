"""A plain block of flats: columns of windows, of loggias, and a staircase with windows at half height.

In the way of the paper's figure 13: a simple facade, modelled in a few minutes.
"""

from __future__ import annotations

from itertools import permutations

from benchmarks.designs.parts import (
    Part,
    alike,
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

HEIGHT = 19.8
#: Columns of flats: with windows, and with loggias.
FLATS = {"W": 1.6, "L": 2.4}


def house() -> Facade:
    """Return the facade, 26.1 m wide and 19.8 m high."""
    word = "W w W w L w W w S w W w L w W w W"
    parts = [_wall(), *(_flats(symbol) for symbol in FLATS), _stairs()]
    root = columns("House", HEIGHT, word, parts)
    constraints = [*_words(), *_lines(), *_equal(), *_ranges()]
    return facade("house", root, total(word, parts), HEIGHT, constraints)


def _bands() -> list[Part]:
    return [leaf("K", 0.8, "Cornice"), leaf("Z", 0.8, "Plinth")]


def _wall() -> Part:
    return rows("w", 1.2, "K x Z", [*_bands(), leaf("x", 18.2, "Wall")])


def _flats(symbol: str) -> Part:
    parts = [*_bands(), leaf("a", 1.2, "Wall"), _opening("u", symbol, 1.8), _opening("g", symbol, 2.0)]
    return rows(symbol, FLATS[symbol], "K a u a u a u a u a u a g Z", parts)


def _opening(symbol: str, column: str, height: float) -> Part:
    leaves = 2 if column == "W" else 3
    width = (FLATS[column] - 0.2 - 0.1 * (leaves - 1)) / leaves
    lights = [leaf("t", 0.4, "Light"), leaf("b", height - 1.0, "Light")]
    parts = [leaf("j", 0.1, "Jamb"), rows("c", width, "t b", lights), leaf("m", 0.1, "Mullion")]
    frame = columns("f", height - 0.6, " ".join(["j", *["c m"] * (leaves - 1), "c j"]), parts)
    inner = [leaf("h", 0.2, "Box"), frame, leaf("s", 0.4, "Rail")]
    return rows(symbol, height, "h f s", inner, "Window")


def _stairs() -> Part:
    glass = [leaf("j", 0.15, "Jamb"), leaf("c", 0.9, "Light")]
    window = columns("v", 1.2, "j c c j", glass, "Window")
    leaves = columns("f", 2.2, "j d d j", [leaf("j", 0.15, "Jamb"), leaf("d", 0.9, "Leaf")])
    door = rows("d", 3.2, "n f", [leaf("n", 1.0, "Canopy"), leaves], "Door")
    walls = [leaf("y", 3.0, "Wall"), leaf("b", 1.8, "Wall")]
    return rows("S", 2.1, "K y v b v b v b v b d Z", [*_bands(), *walls, window, door])


def _words() -> list[Constraint]:
    found = sequences("House", "⊢ {W L} w", *shuffled("w W w L w S w"), "w {W L} ⊣")
    for column in FLATS:
        found += sequences(f"House/{column}", "⊢ K a u", "u a u", "u a g", "g Z ⊣")
    found += sequences("House/S", "⊢ K y v", "v b v", "v b d", "d Z ⊣")
    for column in FLATS:
        for window in "ug":
            found += sequences(f"House/{column}/{window}/f", "⊢ j c", "c m c", "c j ⊣")
    return found + sequences("House/S/d/f", "⊢ j d d j ⊣")


def _lines() -> list[Constraint]:
    found = []
    for window in "ug":
        found += in_line(f"House/W/{window}", f"House/L/{window}", "top bottom")
    for one, other in permutations(FLATS, 2):
        found += in_line(f"House/{one}/u", f"House/{other}/g", "top bottom")
    for column in FLATS:
        found += in_line("House/S/v", f"House/{column}/a", "middle")
        found += in_line("House/S/d", f"House/{column}/g", "bottom")
        found += in_line(f"House/{column}/u/f/m", f"House/{column}/g/f/m", "center")
    found += in_line("House/S/d", "House/W/u", "top")
    for other in "LSw":
        found += in_line("House/W/K", f"House/{other}/K", "bottom")
        found += in_line("House/W/Z", f"House/{other}/Z", "top")
    found += in_line("House/S/K", "House/L/K", "bottom")
    return found + in_line("House/S/Z", "House/L/Z", "top")


def _equal() -> list[Constraint]:
    return [
        *alike("height", "House/W/u", "House/L/u"),
        *alike("height", "House/W/g", "House/L/g"),
        *alike("height", "House/W: u a", "House/L: u a", "House/S: v b"),
        *alike("height", "House/W/K", "House/S/K"),
    ]


def _ranges() -> list[Constraint]:
    openings = [f"House/{column}/{window}" for column in FLATS for window in "ug"]
    walls = ["House/w", "House/W/a", "House/L/a", "House/S/y", "House/S/b"]
    return [
        *sizes("80%", "130%", "5%", *(f"House/{column}" for column in "WLS")),
        *sizes("85%", "120%", "5%", *openings, "House/S/v"),
        *sizes("50%", "200%", "15%", *walls),
        *sizes("30%", "300%", "30%", "House/w/x"),
    ]
