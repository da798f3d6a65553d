"""A small shop house: three unlike storeys in free rhythm, for many sizes.

In the way of the paper's figure 10: few elements, yet many variations, at small and at large sizes.
"""

from __future__ import annotations

from itertools import product

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
    sizes,
    total,
)
from layoutkit.constraints import Constraint
from layoutkit.model import Facade

#: Openings of the upper storeys, and their widths.
OPENINGS = {"W": 1.0, "D": 1.6, "N": 0.6}
WIDTH = 9.4


def shop() -> Facade:
    """Return the facade, 9.4 m wide and 10.9 m high."""
    parts = [_roof(), _storey("T"), _storey("M"), _ground(), leaf("S", 0.3, "String")]
    word = "R T S M S G"
    root = rows("Shop", WIDTH, word, parts)
    constraints = [*_rhythms(), *_words(), *_counts(), *_lines(), *_equal(), *_ranges()]
    return facade("shop", root, WIDTH, total(word, parts), constraints)


def _roof() -> Part:
    parts = [leaf("c", 0.3, "Cornice"), leaf("d", 0.4, "Frieze"), leaf("p", 0.4, "Parapet")]
    return rows("R", 1.1, "c d p", parts)


def _storey(symbol: str) -> Part:
    windows = [_window("W", "j c m c j"), _window("D", "j c m c m c j"), _slit()]
    walls = [leaf("a", 0.7, "Wall"), leaf("b", 0.9, "Wall")]
    return columns(symbol, 2.9, "b N a W a D a W a N b", [*walls, *windows])


def _window(symbol: str, word: str) -> Part:
    width, leaves = OPENINGS[symbol], word.split().count("c")
    casement = leaf("c", (width - 0.2 - 0.1 * (leaves - 1)) / leaves, "Light")
    frame = columns("f", 1.8, word, [leaf("j", 0.1, "Jamb"), casement, leaf("m", 0.1, "Mullion")])
    labels = ("Window", "Wide") if symbol == "D" else ("Window",)
    return rows(symbol, width, "h f s", [leaf("h", 0.4, "Hood"), frame, leaf("s", 0.7, "Apron")], *labels)


def _slit() -> Part:
    return rows("N", OPENINGS["N"], "p s", [leaf("p", 2.2, "Light"), leaf("s", 0.7, "Apron")], "Window")


def _ground() -> Part:
    window = columns(
        "f", 2.0, "j v m v j", [leaf("j", 0.1, "Jamb"), leaf("v", 0.65, "Light"), leaf("m", 0.1, "Mullion")]
    )
    door = columns("f", 2.6, "j d j", [leaf("j", 0.15, "Jamb"), leaf("d", 0.7, "Leaf")])
    parts = [
        rows("O", 1.6, "h f s", [leaf("h", 0.6, "Board"), window, leaf("s", 0.6, "Apron")], "Shop"),
        rows("X", 1.0, "h f", [leaf("h", 0.6, "Board"), door], "Door"),
        leaf("a", 0.7, "Pier"),
        leaf("b", 1.9, "Pier"),
    ]
    return columns("G", 3.2, "b O a X a O b", parts)


def _rhythms() -> list[Constraint]:
    """Return the sequences of the storeys: any opening after any, on walls of two widths."""
    found = []
    for storey in "TM":
        path = f"Shop/{storey}"
        found += sequences(path, *(f"{x} {wall} {y}" for x, wall, y in product(OPENINGS, "ab", OPENINGS)))
        found += sequences(path, *(f"⊢ {wall} {x}" for wall, x in product("ab", OPENINGS)))
        found += sequences(path, *(f"{x} {wall} ⊣" for wall, x in product("ab", OPENINGS)))
    for wall, (x, y) in product("ab", (("O", "O"), ("O", "X"), ("X", "O"))):
        found += sequences("Shop/G", f"{x} {wall} {y}")
    found += sequences("Shop/G", *(f"⊢ {wall} {x}" for wall, x in product("ab", "OX")))
    return found + sequences("Shop/G", *(f"{x} {wall} ⊣" for wall, x in product("ab", "OX")))


def _words() -> list[Constraint]:
    found = sequences("Shop", "⊢ R T S", "⊢ R M S", "S T S", "S M S", "S G ⊣")
    found += sequences("Shop/R", "⊢ c d", "⊢ c p ⊣", "d d", "d p ⊣")
    for storey in "TM":
        for window in "WD":
            found += sequences(f"Shop/{storey}/{window}/f", "⊢ j c", "c m c", "c j ⊣")
        found += sequences(f"Shop/{storey}/N", "⊢ p s ⊣")
    found += sequences("Shop/G/O/f", "⊢ j v", "v m v", "v j ⊣")
    return found + sequences("Shop/G/X/f", "⊢ j d j ⊣", "⊢ j d d j ⊣")


def _counts() -> list[Constraint]:
    return [
        *frequency("X", "Shop/G", "1", "1"),
        *frequency("O", "Shop/G", "50%", "200%"),
        *frequency("N", "Shop/T", most="4"),
        *frequency("@Window - @Wide", "Shop/M", "1"),
    ]


def _lines() -> list[Constraint]:
    found = []
    for one, other in product(OPENINGS, OPENINGS):
        found += in_line(f"Shop/T/{one}", f"Shop/M/{other}", "center")
    for one, other in product(OPENINGS, "OX"):
        found += in_line(f"Shop/M/{one}", f"Shop/G/{other}", "center")
    for one in OPENINGS:
        found += in_line(f"Shop/T/{one}", f"Shop/M/{one}", "left")
    return found + in_line("Shop/T/W/f/m", "Shop/M/W/f/m", "center")


def _equal() -> list[Constraint]:
    return [*alike("height", "Shop/T", "Shop/M"), *alike("width", "Shop/T/N", "Shop/M/N")]


def _ranges() -> list[Constraint]:
    openings = [f"Shop/{storey}/{x}" for storey in "TM" for x in OPENINGS]
    piers = [f"Shop/{storey}/{wall}" for storey in "TMG" for wall in "ab"]
    return [
        *sizes("75%", "140%", "8%", *openings, "Shop/G/O", "Shop/G/X"),
        *sizes("40%", "200%", "20%", *piers),
        *sizes("80%", "125%", "5%", "Shop/T", "Shop/M", "Shop/G"),
    ]
