"""A house of flats: windows of four kinds scattered over storeys of four kinds, in any order.

In the way of the paper's figure 14: a dense model of windows in random order, which are in line all the same.
"""

from __future__ import annotations

from itertools import combinations, pairwise, product

from benchmarks.designs.parts import (
    Part,
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

WIDTH = 20.0
#: Openings, and their widths: small, medium, large, and with a balcony.
OPENINGS = {"S": 0.8, "M": 1.2, "L": 1.6, "B": 1.4}
#: Words of the storeys, walls between openings left out: these stand at one pitch.
STOREYS = {"P": "SLSLMBMLS", "Q": "MBMLSLMMB", "R": "LSLMBMMLS", "U": "BMMLSLMMB"}
PITCH = 2.1
#: Widths of the walls between openings.
WALLS = {"a": 0.9, "b": 0.8, "c": 0.7}


def flats() -> Facade:
    """Return the facade, 20 m wide and 24.2 m high."""
    parts = [_roof(), *(_storey(symbol) for symbol in STOREYS), _ground()]
    word = "C P Q R U Q P G"
    root = rows("Flats", WIDTH, word, parts)
    constraints = [*_storeys(), *_rhythms(), *_windows(), *_lines(), *_ranges()]
    return facade("flats", root, WIDTH, total(word, parts), constraints)


def _roof() -> Part:
    panels = [leaf("t", 1.55, "Panel"), leaf("q", 0.5, "Pedestal")]
    parapet = columns("p", 0.7, f"t {'q t ' * 9}", panels)
    return rows("C", 1.2, "c p", [leaf("c", 0.5, "Cornice"), parapet])


def _storey(symbol: str) -> Part:
    openings = STOREYS[symbol]
    word = [openings[0]]
    for one, other in pairwise(openings):
        wall = PITCH - (OPENINGS[one] + OPENINGS[other]) / 2
        word += [next(name for name, width in WALLS.items() if abs(width - wall) < 1e-9), other]
    ends = _ends(OPENINGS[openings[0]], OPENINGS[openings[-1]])
    walls = [leaf(name, width, "Wall") for name, width in WALLS.items()]
    return columns(symbol, 3.2, " ".join(["e", *word, "f"]), [*ends, *walls, *map(_window, OPENINGS)])


def _ends(first: float, last: float) -> list[Part]:
    margin = (WIDTH - 8 * PITCH) / 2
    return [leaf("e", margin - first / 2, "Wall"), leaf("f", margin - last / 2, "Wall")]


def _window(symbol: str) -> Part:
    leaves = 3 if symbol == "L" else 2
    width = (OPENINGS[symbol] - 0.2 - 0.1 * (leaves - 1)) / leaves
    parts = [leaf("j", 0.1, "Jamb"), leaf("c", width, "Light"), leaf("m", 0.1, "Mullion")]
    word = " ".join(["j", *["c m"] * (leaves - 1), "c j"])
    if symbol == "B":
        ends = [leaf("h", 0.4, "Hood"), leaf("r", 0.9, "Rail"), leaf("k", 0.2)]
        inner = [*ends, columns("f", 1.7, word, parts)]
        return rows(symbol, OPENINGS[symbol], "h f r k", inner, "Window", "Balcony")
    inner = [leaf("h", 0.7, "Lintel"), columns("f", 1.6, word, parts), leaf("s", 0.9, "Apron")]
    return rows(symbol, OPENINGS[symbol], "h f s", inner, "Window")


def _ground() -> Part:
    front = columns("f", 2.6, "j v v j", [leaf("j", 0.1, "Jamb"), leaf("v", 0.5, "Light")])
    door = columns("f", 3.0, "j d d j", [leaf("j", 0.1, "Jamb"), leaf("d", 0.5, "Leaf")])
    parts = [
        *_ends(1.2, 1.2),
        leaf("a", 0.9, "Pier"),
        rows("V", 1.2, "h f s", [leaf("h", 0.6, "Board"), front, leaf("s", 0.6, "Apron")], "Shop"),
        rows("X", 1.2, "h f", [leaf("h", 0.8, "Canopy"), door], "Door"),
    ]
    return columns("G", 3.8, "e V a V a V a V a X a V a V a V a V f", parts)


def _storeys() -> list[Constraint]:
    return [
        *sequences("Flats", *(f"⊢ C {storey}" for storey in STOREYS)),
        *sequences("Flats", *(f"{one} {other}" for one, other in product(STOREYS, STOREYS))),
        *sequences("Flats", *(f"{storey} G ⊣" for storey in STOREYS)),
        *sequences("Flats/G", "⊢ e V", "V a V", "V a X", "X a V", "V f ⊣"),
        *frequency("X", "Flats/G", "1", "1"),
        *frequency("@Balcony", "Flats", "20%", "300%"),
    ]


def _rhythms() -> list[Constraint]:
    """Return the sequences of the storeys: any opening after any, on walls of three widths."""
    found = []
    for storey in STOREYS:
        path = f"Flats/{storey}"
        found += sequences(path, *(f"⊢ e {x}" for x in OPENINGS), *(f"{x} f ⊣" for x in OPENINGS))
        found += sequences(path, *(f"{x} {wall} {y}" for x, wall, y in product(OPENINGS, WALLS, OPENINGS)))
    return found


def _windows() -> list[Constraint]:
    found = []
    for storey, window in product(STOREYS, "SML"):
        found += sequences(f"Flats/{storey}/{window}/f", "⊢ j c", "c m c", "c j ⊣")
    for storey in STOREYS:
        found += sequences(f"Flats/{storey}/B/f", "⊢ j c m c j ⊣", "⊢ j c c j ⊣")
    return found


def _lines() -> list[Constraint]:
    found = []
    for upper, lower in combinations(STOREYS, 2):
        for one, other in product(OPENINGS, OPENINGS):
            found += in_line(f"Flats/{upper}/{one}", f"Flats/{lower}/{other}", "center")
    for storey in STOREYS:
        windows = " | ".join(f"Flats/{storey}/{window}" for window in OPENINGS)
        found += in_line(windows, "Flats/G/V | Flats/G/X", "center")
    return found


def _ranges() -> list[Constraint]:
    openings = [f"Flats/{storey}/{window}" for storey, window in product(STOREYS, OPENINGS)]
    walls = [f"Flats/{storey}/{wall}" for storey, wall in product(STOREYS, WALLS)]
    ends = [f"Flats/{storey}/{end}" for storey, end in product((*STOREYS, "G"), "ef")]
    return [
        *sizes("75%", "140%", "6%", *openings, "Flats/G/V", "Flats/G/X"),
        *sizes("50%", "200%", "15%", *walls, "Flats/G/a"),
        *sizes("30%", "250%", "20%", *ends),
        *sizes("80%", "125%", "5%", *(f"Flats/{storey}" for storey in (*STOREYS, "G"))),
    ]
