"""A mansion: shuffled window and door columns, ledges that may come between storeys, a sign.

In the way of the paper's figure 9: windows and doors keep in line, the ornamental row between storeys is
optional and may be repeated, and the panels of the door-sized windows are laid out anew.
"""

from __future__ import annotations

from itertools import combinations, permutations

from benchmarks.designs.parts import (
    Part,
    alike,
    columns,
    facade,
    frequency,
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

#: Columns with openings and their widths: plain, with balconies, arched, with the door.
OPEN = {"C": 1.3, "B": 1.7, "A": 1.5, "D": 2.0}
HEIGHT = 19.8


def mansion() -> Facade:
    """Return the facade, 19.8 m high."""
    word = "E w C w B w C w A w C S D w C w A w C w B w C w B w C w E"
    parts = [_edge(), _wall(), _signs(), *(_column(symbol) for symbol in OPEN)]
    width = total(word, parts)
    root = columns("Mansion", HEIGHT, word, parts)
    constraints = [*_words(), *_openings(), *_counts(), *_lines(), *_equal(), *_ranges()]
    return facade("mansion", root, width, HEIGHT, constraints)


def _edge() -> Part:
    shaft = [leaf("x", 3.8, "Shaft"), leaf("z", 3.8, "Shaft"), leaf("y", 10.3, "Shaft")]
    return rows("E", 0.8, "K x l z l y Z", [*_bands("l"), *shaft])


def _wall() -> Part:
    plain = [leaf("x", 3.8, "Wall"), leaf("z", 3.8, "Wall"), leaf("y", 10.3, "Wall")]
    return rows("w", 1.1, "K x l z l y Z", [*_bands("l"), *plain])


def _signs() -> Part:
    plain = [leaf("x", 3.8, "Wall"), leaf("y", 4.6, "Wall"), leaf("v", 4.3, "Wall")]
    return rows("S", 1.6, "K x l x l y s v Z", [*_bands("l"), *plain, _sign()])


def _sign() -> Part:
    letters = [leaf("e", 0.115), leaf("n", 0.07, "Letter"), leaf("g", 0.03)]
    name = columns("n", 0.8, f"e n {'g n ' * 13} e", letters)
    frame = [leaf("t", 0.2, "Frame"), leaf("u", 0.1, "Rule"), leaf("b", 0.3, "Frame")]
    return rows("s", 1.4, "t n u b", [name, *frame], "Sign")


def _bands(ledge: str) -> list[Part]:
    return [leaf("K", 0.6, "Cornice"), leaf(ledge, 0.4, "Ledge"), leaf("Z", 0.5, "Plinth")]


def _column(symbol: str) -> Part:
    parts = [
        *_bands("o"),
        leaf("a", 0.9, "Wall"),
        leaf("b", 1.0, "Wall"),
        _window(symbol),
        _french(symbol),
        _ground(symbol),
    ]
    return rows(symbol, OPEN[symbol], "K a u a o a u a o a u b d b g Z", parts)


def _window(column: str) -> Part:
    lights = [leaf("t", 0.4, "Light"), leaf("r", 0.05, "Rail"), leaf("l", 0.5, "Light")]
    glazing = _casements(column, rows("c", 1.0, "t r l r l", lights), 1.5)
    return rows("u", 2.0, "h f s", [leaf("h", 0.3, "Hood"), glazing, leaf("s", 0.2, "Sill")], "Window")


def _french(column: str) -> Part:
    lights = [
        leaf("t", 0.4, "Light"),
        leaf("r", 0.05, "Rail"),
        leaf("p", 0.8, "Light"),
        leaf("q", 0.55, "Light"),
        leaf("k", 0.5, "Panel"),
    ]
    glazing = _casements(column, rows("c", 1.0, "t r p r q r k", lights), 2.4)
    parts = [leaf("h", 0.2, "Hood"), glazing, leaf("s", 0.2, "Balcony")]
    return rows("d", 2.8, "h f s", parts, "Window", "French")


def _casements(column: str, casement: Part, height: float) -> Part:
    leaves = 2 if OPEN[column] < 1.6 else 3
    width = (OPEN[column] - 0.2 - 0.1 * (leaves - 1)) / leaves
    parts = [
        leaf("j", 0.1, "Jamb"),
        leaf("m", 0.1, "Mullion"),
        Part("c", width, casement.split, casement.children),
    ]
    return columns("f", height, " ".join(["j", *["c m"] * (leaves - 1), "c j"]), parts)


def _ground(column: str) -> Part:
    pane = leaf("v", (OPEN[column] - 0.4) / 2, "Light")
    label = "Shop"
    if column == "D":
        panels = [leaf("t", 0.5, "Light"), leaf("r", 0.1, "Rail"), leaf("p", 0.75, "Panel")]
        pane, label = rows("v", 0.8, "t r p r p", panels), "Door"
    front = columns("f", 2.2, "j v m v j", [leaf("j", 0.15, "Jamb"), pane, leaf("m", 0.1, "Mullion")])
    return rows("g", 2.6, "h f s", [leaf("h", 0.3, "Board"), front, leaf("s", 0.1, "Step")], label)


def _words() -> list[Constraint]:
    found = sequences(
        "Mansion",
        "⊢ E w",
        *shuffled("w C w B w A w D w"),
        *("C S D", "D S C", "B S D", "D S B", "w S w"),
        "w E ⊣",
    )
    for column in OPEN:
        storeys = ("⊢ K a u", "u a u", "u a o", "o a u", "u b d", "d b d", "d b g", "g Z ⊣")
        found += sequences(f"Mansion/{column}", *storeys)
    for wall in "Ew":
        found += sequences(f"Mansion/{wall}", "⊢ K x", "⊢ K y", "x l", "l z", "z l", "l y", "y Z ⊣")
    walls = ("⊢ K x", "⊢ K y", "x l", "l x", "l y", "x y", "y s", "s v", "v Z ⊣")
    return found + sequences("Mansion/S", *walls)


def _openings() -> list[Constraint]:
    """Return the sequences of frames, casements and panels."""
    found = []
    for column in OPEN:
        for window in "ud":
            found += sequences(f"Mansion/{column}/{window}/f", "⊢ j c", "c m c", "c j ⊣")
        found += sequences(f"Mansion/{column}/u/f/c", "⊢ t r", "r l r", "r l ⊣")
        panels = ("⊢ t r", "r p r", "r q r", "r k ⊣", "r q r q r")
        found += sequences(f"Mansion/{column}/d/f/c", *panels)
        found += sequences(f"Mansion/{column}/g/f", "⊢ j v", "v m v", "v j ⊣")
    return found + sequences("Mansion/D/g/f/v", "⊢ t r", "r p r", "r p ⊣")


def _counts() -> list[Constraint]:
    return [
        *frequency("D", "Mansion", "1", "2"),
        *frequency("S", "Mansion", most="2"),
        *frequency("B", "Mansion", "1", "200%"),
        *frequency("A", "Mansion", "50%", "200%"),
        *frequency("o", "Mansion/C", most="2"),
    ]


def _lines() -> list[Constraint]:
    found = []
    for one, other in combinations(OPEN, 2):
        for part in "udgo":
            found += in_line(f"Mansion/{one}/{part}", f"Mansion/{other}/{part}", "top bottom")
    for one, other in permutations(OPEN, 2):
        found += in_line(f"Mansion/{one}/u", f"Mansion/{other}/d", "top")
    for column in OPEN:
        for wall in "Ew":
            found += in_line(f"Mansion/{wall}/l", f"Mansion/{column}/o", "top bottom")
        found += in_line("Mansion/S/l", f"Mansion/{column}/o", "bottom")
        found += in_line("Mansion/S/s", f"Mansion/{column}/d", "middle")
    for other in "SCE":
        found += in_line("Mansion/w/K", f"Mansion/{other}/K", "bottom")
    return found


def _equal() -> list[Constraint]:
    return [
        *alike("height", "Mansion/C: u a", "Mansion/B: u a"),
        *alike("height", "Mansion/C: d b", "Mansion/D: d b"),
    ]


def _ranges() -> list[Constraint]:
    walls = [f"Mansion/{column}/{wall}" for column in OPEN for wall in "ab"]
    shafts = [f"Mansion/{wall}/{part}" for wall in "Ew" for part in "xyz"]
    return [
        *sizes("80%", "130%", "5%", *(f"Mansion/{column}" for column in (*OPEN, "S", "E"))),
        *sizes("50%", "200%", "15%", "Mansion/w", *walls),
        *sizes("85%", "120%", "5%", *(f"Mansion/{column}/{part}" for column in OPEN for part in "udg")),
        *sizes("10%", "300%", "50%", *shafts, *(f"Mansion/S/{part}" for part in "xyv")),
    ]
