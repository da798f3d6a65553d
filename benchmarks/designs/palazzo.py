"""A palazzo: storeys of windows in line, whose casements and panes come in several kinds.

In the way of the paper's figure 3: all windows are in line, and window frames are laid out anew.
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
    shuffled,
    sizes,
    total,
)
from layoutkit.constraints import Constraint
from layoutkit.model import Facade

#: Storeys from the top down, each with its narrow and its wide opening.
STOREYS = {"T": ("W", "D"), "U": ("W", "D"), "P": ("W", "B"), "G": ("O", "X")}
#: Openings with casements: all but the gate.
GLAZED = [f"Palazzo/{storey}/{one}" for storey, openings in STOREYS.items() for one in openings if one != "X"]


def palazzo() -> Facade:
    """Return the facade, 15.8 m wide and 21.4 m high."""
    word = "R T S U S U S P S G"
    parts = [_roof(), *(_storey(symbol) for symbol in STOREYS), leaf("S", 0.3, "String")]
    root = rows("Palazzo", 15.8, word, parts)
    constraints = [*_words(), *_counts(), *_lines(), *_equal(), *_ranges()]
    return facade("palazzo", root, 15.8, total(word, parts), constraints)


def _roof() -> Part:
    teeth = [leaf("e", 0.7), leaf("d", 0.4, "Dentil"), leaf("g", 0.6)]
    dentils = columns("d", 0.5, f"e d {'g d ' * 14} e", teeth)
    return rows("R", 1.0, "c d", [leaf("c", 0.5, "Cornice"), dentils])


def _storey(symbol: str) -> Part:
    narrow, wide = STOREYS[symbol]
    word = " w ".join(["e", narrow, narrow, wide, narrow, narrow, narrow, "e"])
    parts = [
        leaf("e", 0.7, "Pilaster"),
        leaf("w", 1.0, "Wall"),
        _opening(narrow, symbol, 1.1),
        _gate() if wide == "X" else _opening(wide, symbol, 1.9),
    ]
    return columns(symbol, 3.8 if symbol == "G" else 3.2, word, parts)


def _opening(symbol: str, storey: str, width: float) -> Part:
    height = 3.8 if storey == "G" else 3.2
    glass = height - 1.4
    word = "j c m c j" if width < 1.5 else "j c m c m c j"
    parts = [leaf("j", 0.1, "Jamb"), _casement(glass, 0.4 if width < 1.5 else 0.5), leaf("m", 0.1, "Mullion")]
    inner = [
        leaf("h", 0.5, "Hood"),
        columns("g", glass, word, parts, "Glazing"),
        leaf("s", 0.2, "Balcony" if symbol == "B" else "Sill"),
        leaf("a", 0.7, "Apron"),
    ]
    labels = ("Window", "Wide") if width > 1.5 else ("Window",)
    return rows(symbol, width, "h g s a", inner, *labels)


def _casement(height: float, width: float) -> Part:
    pane = (height - 0.5) / 2
    parts = [leaf("t", 0.4, "Light"), leaf("r", 0.05, "Rail"), leaf("l", pane, "Light")]
    return rows("c", width, "t r l r l", parts)


def _gate() -> Part:
    leaves = columns("l", 3.2, "j d d j", [leaf("j", 0.25, "Jamb"), leaf("d", 0.7, "Leaf")])
    return rows("X", 1.9, "h l", [leaf("h", 0.6, "Hood"), leaves], "Door")


def _words() -> list[Constraint]:
    found = sequences("Palazzo", "⊢ R T S", "S U S", "S P S", "S G ⊣")
    for storey, (narrow, wide) in STOREYS.items():
        found += sequences(f"Palazzo/{storey}", "⊢ e w", *shuffled(f"w {narrow} w {wide} w"), "w e ⊣")
    for path in GLAZED:
        found += sequences(f"{path}/g", "⊢ j c", "c m c", "c j ⊣")
        found += sequences(f"{path}/g/c", "⊢ t r", "r l r", "r l ⊣")
    return found


def _counts() -> list[Constraint]:
    return [
        *frequency("P", "Palazzo", "1", "1"),
        *frequency("X", "Palazzo/G", "1", "1"),
        *frequency("B", "Palazzo/P", "1", "300%"),
        *frequency("@Wide", "Palazzo/U", most="3"),
        *frequency("@Window - @Wide", "Palazzo/T", "50%"),
    ]


def _lines() -> list[Constraint]:
    found = []
    for upper, lower in ("TU", "UP", "PG"):
        for one, other in product(STOREYS[upper], STOREYS[lower]):
            found += in_line(f"Palazzo/{upper}/{one}", f"Palazzo/{lower}/{other}", "center")
    return found


def _equal() -> list[Constraint]:
    return [
        *alike("width", "Palazzo/U/W", "Palazzo/T/W", "Palazzo/P/W"),
        *alike("width", "Palazzo/U/D", "Palazzo/T/D"),
    ]


def _ranges() -> list[Constraint]:
    openings = [f"Palazzo/{storey}/{one}" for storey, both in STOREYS.items() for one in both]
    return [
        *sizes("80%", "130%", "5%", *openings),
        *sizes("50%", "200%", "15%", *(f"Palazzo/{storey}/w" for storey in STOREYS)),
        *sizes("80%", "125%", "5%", *(f"Palazzo/{storey}" for storey in STOREYS)),
        *sizes("70%", "140%", "5%", *(f"Palazzo/{storey}/e" for storey in STOREYS)),
    ]
