"""A city block: single, double and bow windows in any order on five unlike storeys, in line.

In the way of the paper's figure 16: elements drawn at random for each storey, and coordinated across storeys.
"""

from __future__ import annotations

from itertools import pairwise, product

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

WIDTH = 30.0
#: Windows and their widths: single, double, bow; a bow takes two places of the input's grid.
WINDOWS = {"W": 1.0, "D": 1.8, "T": 4.4}
#: Words of the storeys, walls left out, from the top down.
STOREYS = {
    "A": "DWWDTWDWDW",
    "B": "WDWDWDWDTW",
    "C": "DDTWDWWWDD",
    "E": "WWWDTWDWDW",
    "F": "DWDDWDTDDW",
}
PITCH = 2.6


def block() -> Facade:
    """Return the facade, 30 m wide."""
    parts = [_roof(), *(_storey(symbol) for symbol in STOREYS), _ground()]
    word = "R A A B B C C E E F F G"
    root = rows("Block", WIDTH, word, parts)
    constraints = [*_words(), *_frames(), *_lines(), *_equal(), *_ranges()]
    return facade("block", root, WIDTH, total(word, parts), constraints)


def _roof() -> Part:
    parapet = columns("p", 0.8, f"q {'t q ' * 18}", [leaf("q", 0.3, "Pedestal"), leaf("t", 1.35, "Panel")])
    return rows("R", 1.4, "c p g", [leaf("c", 0.4, "Cornice"), parapet, leaf("g", 0.2, "Gutter")])


def _storey(symbol: str) -> Part:
    windows = [_window("W", 2), _window("D", 3), _window("T", 5)]
    return columns(symbol, 3.2, _word(STOREYS[symbol], WINDOWS), [*_walls(STOREYS[symbol][-1]), *windows])


def _word(openings: str, widths: dict[str, float]) -> str:
    """Return the word with its walls: short ones after wide openings, so that all stand in a grid."""
    walls = ["v" if widths[opening] < 1.5 else "w" for opening in openings[:-1]]
    middle = [letter for pair in zip(openings, walls, strict=False) for letter in pair]
    return " ".join(["e", *middle, openings[-1], "f"])


def _walls(last: str) -> list[Part]:
    width = {"W": 1.0, "Y": 1.0, "D": 1.8}[last]
    end = WIDTH - 0.8 - 10 * PITCH - width
    short, long = leaf("w", PITCH - 1.8, "Wall"), leaf("v", PITCH - 1.0, "Wall")
    return [leaf("e", 0.8, "Wall"), leaf("f", end, "Wall"), short, long]


def _window(symbol: str, leaves: int) -> Part:
    width = (WINDOWS[symbol] - 0.2 - 0.1 * (leaves - 1)) / leaves
    parts = [leaf("j", 0.1, "Jamb"), leaf("c", width, "Light"), leaf("m", 0.1, "Mullion")]
    frame = columns("f", 1.8, " ".join(["j", *["c m"] * (leaves - 1), "c j"]), parts)
    inner = [leaf("h", 0.5, "Lintel"), frame, leaf("s", 0.9, "Apron")]
    return rows(symbol, WINDOWS[symbol], "h f s", inner, "Window")


def _ground() -> Part:
    front = columns("f", 2.8, "j v v j", [leaf("j", 0.1, "Jamb"), leaf("v", 0.8, "Light")])
    door = columns("f", 3.2, "j d d j", [leaf("j", 0.2, "Jamb"), leaf("d", 0.7, "Leaf")])
    slit = columns("f", 1.6, "j v j", [leaf("j", 0.1, "Jamb"), leaf("v", 0.8, "Light")])
    parts = [
        *_walls("Y"),
        rows("O", 1.8, "h f s", [leaf("h", 0.7, "Board"), front, leaf("s", 0.5, "Apron")], "Shop"),
        rows("X", 1.8, "h f", [leaf("h", 0.8, "Canopy"), door], "Door"),
        rows("Y", 1.0, "h f s", [leaf("h", 0.8, "Lintel"), slit, leaf("s", 1.6, "Apron")], "Window"),
    ]
    widths = {"O": 1.8, "X": 1.8, "Y": 1.0}
    return columns("G", 4.0, _word("OYOOYXOOOOY", widths), parts)


def _words() -> list[Constraint]:
    found = sequences("Block", "⊢ R A", *(f"{one} {one}" for one in STOREYS))
    found += sequences("Block", *(f"{one} {other}" for one, other in pairwise(STOREYS)), "F G ⊣")
    for storey in STOREYS:
        path = f"Block/{storey}"
        found += sequences(path, "⊢ e {W D T}", "{W D T} f ⊣")
        found += sequences(path, *(f"{x} {wall} {y}" for x, wall, y in product(WINDOWS, "wv", WINDOWS)))
    pairs = ("Y v O", "Y v Y", "Y v X", "O w {O Y}", "O w X", "X w {O Y}")
    return found + sequences("Block/G", "⊢ e {O Y}", *pairs, "{O Y} f ⊣")


def _frames() -> list[Constraint]:
    found = []
    for storey in "ABCE":
        found += sequences(f"Block/{storey}/W/f", "⊢ j c", "c m c", "c j ⊣")
    return found + sequences("Block/F/W/f", "⊢ j c m c j ⊣", "⊢ j c j ⊣")


def _lines() -> list[Constraint]:
    found = []
    for upper, lower in pairwise(STOREYS):
        for one, other, lines in (
            ("W", "W", "left right"),
            ("D", "D", "left right"),
            ("T", "T", "center"),
            ("W", "D", "left"),
            ("D", "W", "left"),
            ("D", "T", "right"),
            ("T", "D", "right"),
        ):
            found += in_line(f"Block/{upper}/{one}", f"Block/{lower}/{other}", lines)
    for window, opening in ("WY", "DO", "DX"):
        found += in_line(f"Block/F/{window}", f"Block/G/{opening}", "center")
    return found + in_line("Block/F/W", "Block/G/O", "left")


def _equal() -> list[Constraint]:
    return [
        *alike("width", "Block/A/W", *(f"Block/{storey}/W" for storey in "BCEF")),
        *alike("width", "Block/A/D", "Block/F/D"),
        *alike("height", "Block/B", "Block/C", "Block/E"),
    ]


def _ranges() -> list[Constraint]:
    windows = [f"Block/{storey}/{window}" for storey, window in product(STOREYS, "WD")]
    walls = [f"Block/{storey}/{wall}" for storey, wall in product((*STOREYS, "G"), "wv")]
    ends = [f"Block/{storey}/{end}" for storey, end in product((*STOREYS, "G"), "ef")]
    return [
        *sizes("80%", "130%", "5%", *windows, *(f"Block/G/{opening}" for opening in "OXY")),
        *sizes("60%", "130%", "10%", *(f"Block/{storey}/T" for storey in STOREYS)),
        *sizes("50%", "200%", "15%", *walls),
        *sizes("30%", "250%", "20%", *ends),
        *sizes("80%", "125%", "5%", *(f"Block/{storey}" for storey in (*STOREYS, "G"))),
    ]
