"""A hotel: storeys that look alike, with small and large ornaments between the windows, and bands.

In the way of the paper's figure 12: of regular appearance, yet several structures interact, and the
variations of the ornaments have to be in line.
"""

from __future__ import annotations

from itertools import product

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

WIDTH = 29.4
#: What stands between the windows of the input: a small or a large ornament.
RHYTHM = "oxooxooxooxo"


def hotel() -> Facade:
    """Return the facade, 29.4 m wide and 24.8 m high."""
    parts = [_roof(), _storey("A", 3.0, "WW", "ox"), _storey("M", 3.2, "WW", "ox"), _band(), _ground()]
    word = "R A N M N M N M N M N G"
    root = rows("Hotel", WIDTH, word, parts)
    constraints = [*_words(), *_lines(), *_ranges()]
    return facade("hotel", root, WIDTH, total(word, parts), constraints)


def _roof() -> Part:
    teeth = [leaf("e", 0.8), leaf("d", 0.3, "Dentil"), leaf("g", 0.25)]
    dentils = columns("d", 0.4, f"e d {'g d ' * 50} e", teeth)
    parts = [leaf("p", 0.8, "Parapet"), leaf("c", 0.4, "Cornice"), dentils, leaf("f", 0.4, "Frieze")]
    return rows("R", 2.0, "p c d f", parts)


def _rhythm(openings: str) -> str:
    """Return the word of a storey; the second opening stands in the middle."""
    usual, middle = openings[0], openings[1]
    shown = [middle if number == len(RHYTHM) // 2 else usual for number in range(len(RHYTHM) + 1)]
    word = [shown[0]]
    for ornament, opening in zip(RHYTHM, shown[1:], strict=True):
        word += [ornament, opening]
    return " ".join(["e", *word, "e"])


def _storey(symbol: str, height: float, openings: str, ornaments: str) -> Part:
    parts = [leaf("e", 0.8, "Pilaster"), _window(height), *_ornaments(height)]
    return columns(symbol, height, _rhythm(openings), parts)


def _window(height: float) -> Part:
    casements = [leaf("j", 0.1, "Jamb"), leaf("c", 0.55, "Light"), leaf("m", 0.1, "Mullion")]
    frame = columns("f", height - 1.2, "j c m c j", casements)
    parts = [leaf("h", 0.5, "Hood"), frame, leaf("s", 0.7, "Apron")]
    return rows("W", 1.4, "h f s", parts, "Window")


def _ornaments(height: float) -> list[Part]:
    small = [leaf("k", 0.4, "Capital"), leaf("p", height - 0.4, "Shaft")]
    large = [leaf("k", 0.4, "Capital"), leaf("n", height - 0.9, "Niche"), leaf("b", 0.5, "Base")]
    return [
        rows("o", 0.6, "k p", small, "Ornament"),
        rows("x", 1.2, "k n b", large, "Ornament"),
    ]


def _band() -> Part:
    parts = [
        leaf("e", 0.8, "Pilaster"),
        leaf("g", 1.4, "Panel"),
        leaf("d", 0.6, "Drop"),
        leaf("c", 1.2, "Cartouche"),
    ]
    word = _rhythm("gg").replace("o", "d").replace("x", "c")
    return columns("N", 0.6, word, parts, "Band")


def _ground() -> Part:
    height = 4.0
    front = columns("f", height - 1.0, "j v v j", [leaf("j", 0.1, "Jamb"), leaf("v", 0.6, "Light")])
    leaves = columns("f", height - 0.8, "j d d j", [leaf("j", 0.1, "Jamb"), leaf("d", 0.6, "Leaf")])
    parts = [
        leaf("e", 0.8, "Pilaster"),
        rows("V", 1.4, "h f s", [leaf("h", 0.6, "Board"), front, leaf("s", 0.4, "Apron")], "Shop"),
        rows("X", 1.4, "h f", [leaf("h", 0.8, "Canopy"), leaves], "Door"),
        *_ornaments(height),
    ]
    return columns("G", height, _rhythm("VX"), parts)


def _words() -> list[Constraint]:
    found = sequences("Hotel", "⊢ R A N", "N M N", "N G ⊣")
    for storey in "AM":
        found += sequences(f"Hotel/{storey}", "⊢ e W", *shuffled("W o W x W"), "W e ⊣")
        found += sequences(f"Hotel/{storey}/W/f", "⊢ j c", "c m c", "c j ⊣")
    found += sequences("Hotel/N", "⊢ e g", *shuffled("g d g c g"), "g e ⊣")
    found += sequences("Hotel/G", "⊢ e V", *shuffled("V o V x V"), "{o x} X {o x}", "V e ⊣")
    found += sequences("Hotel/G/V/f", "⊢ j v", "v v", "v j ⊣")
    return found + sequences("Hotel/G/X/f", "⊢ j d d j ⊣", "⊢ j d d d j ⊣", "⊢ j d j ⊣")


def _lines() -> list[Constraint]:
    found = []
    for storey, openings in (("A", "W"), ("M", "W"), ("G", "VX")):
        for ornament, drop in product("ox", "dc"):
            found += in_line(f"Hotel/{storey}/{ornament}", f"Hotel/N/{drop}", "center")
        for opening in openings:
            found += in_line(f"Hotel/{storey}/{opening}", "Hotel/N/g", "left right")
    for one, other in product("ox", "ox"):
        found += in_line(f"Hotel/A/{one}", f"Hotel/M/{other}", "center")
    found += in_line("Hotel/A/W", "Hotel/M/W", "left center")
    for opening in "VX":
        found += in_line("Hotel/M/W", f"Hotel/G/{opening}", "center")
    return found + in_line("Hotel/M/e", "Hotel/G/e", "right")


def _ranges() -> list[Constraint]:
    openings = ["Hotel/A/W", "Hotel/M/W", "Hotel/N/g", "Hotel/G/V", "Hotel/G/X"]
    small = [f"Hotel/{storey}/{ornament}" for storey in "AMG" for ornament in "ox"]
    return [
        *sizes("80%", "130%", "5%", *openings),
        *sizes("60%", "160%", "10%", *small, "Hotel/N/d", "Hotel/N/c"),
        *sizes("80%", "125%", "5%", *(f"Hotel/{storey}" for storey in "RAMNG")),
        *sizes("60%", "150%", "5%", *(f"Hotel/{storey}/e" for storey in "AMNG")),
    ]
