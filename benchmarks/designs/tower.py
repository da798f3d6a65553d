"""A skyscraper: blocks between ornamented beams, bays in the blocks, strips of windows in the bays.

In the way of the paper's figure 11: a symmetric design of three nested grids, with an ornamental structure on
top and on the thick beams.
"""

from __future__ import annotations

from itertools import permutations, product

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
from layoutkit.constraints import Constraint, Symmetry
from layoutkit.model import Facade

#: Bays and their widths: at the corners, between, in the middle; with their panels on beams and on the crown.
BAYS = {"c": 3.0, "s": 3.8, "m": 5.0}
BEAM, CROWN = dict(zip(BAYS, "xyz", strict=True)), dict(zip(BAYS, "bdg", strict=True))
#: Strips of each kind of block, from the top down, walls left out: plain and ornamented ones.
BLOCKS = {"X": "tttttutttt", "Y": "ttttuttt", "V": "utttttu", "Z": "tttu"}
#: Ornaments on the panels of the beams and of the crown.
ORNAMENTS = {"x": 5, "y": 6, "z": 9, "b": 6, "d": 8, "g": 10}
PIER = 0.8
WORD = "p c p s p s p m p s p s p c p"


def tower() -> Facade:
    """Return the facade, 32.6 m wide and 210.2 m high."""
    parts = [_crown(), _beam(), *(_block(symbol) for symbol in BLOCKS)]
    word = "K B X B Y B X B V B Y B X B V B Z"
    height = total(word, parts)
    root = rows("Tower", _width(), word, parts)
    constraints = [*_words(), *_inner_words(), *_lines(), *_equal(), *_symmetric(), *_ranges()]
    return facade("tower", root, _width(), height, constraints)


def _width() -> float:
    return total(WORD, [leaf("p", PIER), *(leaf(bay, width) for bay, width in BAYS.items())])


def _crown() -> Part:
    panels = [_panel(CROWN[bay], width, 2.4) for bay, width in BAYS.items()]
    word = _replaced({"p": "f", **CROWN})
    band = columns("k", 2.4, word, [leaf("f", PIER, "Finial"), *panels])
    return rows("K", 4.0, "h k", [leaf("h", 1.6, "Parapet"), band], "Crown")


def _beam() -> Part:
    panels = [_panel(BEAM[bay], width - 0.8, 1.0) for bay, width in BAYS.items()]
    word = _replaced({"p": "r", **{bay: f"e {panel} e" for bay, panel in BEAM.items()}})
    band = columns("o", 1.0, word, [leaf("r", PIER, "Rosette"), leaf("e", 0.4), *panels])
    return rows("B", 2.0, "g o f", [leaf("g", 0.5, "Ledge"), band, leaf("f", 0.5, "Ledge")], "Beam")


def _replaced(letters: dict[str, str]) -> str:
    """Return the word of a block with other letters for its piers and bays."""
    return " ".join(letters[letter] for letter in WORD.split())


def _panel(symbol: str, width: float, height: float) -> Part:
    count = ORNAMENTS[symbol]
    inner = [leaf("i", 0.5 * width / (count + 1), "Gap"), leaf("d", 0.5 * width / count, "Ornament")]
    return columns(symbol, width, f"i {'d i ' * count}", inner, "Panel")


def _block(symbol: str) -> Part:
    strips = BLOCKS[symbol]
    height = 0.9 * (len(strips) + 1) + 2.1 * len(strips)
    bays = [_bay(bay, " ".join(["a", *(f"{strip} a" for strip in strips)])) for bay in BAYS]
    return columns(symbol, height, WORD, [leaf("p", PIER, "Pier"), *bays], "Block")


def _bay(symbol: str, word: str) -> Part:
    strips = [leaf("a", 0.9, "Spandrel"), _strip("t", "v", symbol), _strip("u", "w", symbol)]
    return rows(symbol, BAYS[symbol], word, strips, "Bay")


def _strip(symbol: str, window: str, bay: str) -> Part:
    count = {"c": 2, "s": 3, "m": 4}[bay] - (symbol == "u")
    width = (BAYS[bay] - 0.2 * (count + 1)) / count
    word = f"n {f'{window} n ' * count}"
    return columns(symbol, 2.1, word, [leaf("n", 0.2, "Mullion"), _window(window, width)], "Strip")


def _window(symbol: str, width: float) -> Part:
    leaves = 2 if symbol == "v" else 3
    pane = (width - 0.1 * (leaves + 1)) / leaves
    lights = [leaf("j", 0.1, "Jamb"), leaf("p", pane, "Light"), leaf("m", 0.1, "Mullion")]
    frame = columns("f", 1.5, " ".join(["j", *["p m"] * (leaves - 1), "p j"]), lights)
    inner = [leaf("h", 0.3, "Light"), frame, leaf("s", 0.3, "Sill")]
    return rows(symbol, width, "h f s", inner, "Window")


def _grid(pier: str, bays: dict[str, str], edge: str = "") -> tuple[str, ...]:
    """Return the sequences of a grid: corner bays at the ends, and the others in any order between."""
    corner, side, middle = (f"{edge} {bays[bay]} {edge}" for bay in BAYS)
    inside = (f"{one} {pier} {other}" for one, other in product((side, middle), repeat=2))
    starts = (f"⊢ {pier} {corner} {pier} {one}" for one in (side, middle))
    ends = (f"{one} {pier} {corner} {pier} ⊣" for one in (side, middle))
    return *starts, *inside, *ends


def _words() -> list[Constraint]:
    found = sequences("Tower", "⊢ K B", "B X B", "B Y B", "B V B", "B Z ⊣")
    found += sequences("Tower/K/k", *_grid("f", CROWN))
    found += sequences("Tower/B/o", *_grid("r", BEAM, "e"))
    for block in BLOCKS:
        found += sequences(f"Tower/{block}", *_grid("p", dict(zip(BAYS, BAYS, strict=True))))
    return found


def _inner_words() -> list[Constraint]:
    found = []
    for path in (*(f"Tower/K/k/{x}" for x in CROWN.values()), *(f"Tower/B/o/{x}" for x in BEAM.values())):
        found += sequences(path, "⊢ i d", "d i d", "d i ⊣")
    for block, bay in product(BLOCKS, BAYS):
        path = f"Tower/{block}/{bay}"
        found += sequences(path, "⊢ a {t u}", "t a t", "t a u", "u a t", "{t u} a ⊣")
        for strip, window in ("tv", "uw"):
            found += sequences(f"{path}/{strip}", f"⊢ n {window}", f"{window} n {window}", f"{window} n ⊣")
            found += sequences(f"{path}/{strip}/{window}/f", "⊢ j p", "p m p", "p j ⊣")
    return found


def _lines() -> list[Constraint]:
    found = []
    for block in BLOCKS:
        found += in_line("Tower/B/o/r", f"Tower/{block}/p", "center")
        for bay, panel in BEAM.items():
            found += in_line(f"Tower/B/o/{panel}", f"Tower/{block}/{bay}", "center")
        for one, other in ("cs", "sm"):
            found += _level(f"Tower/{block}/{one}", f"Tower/{block}/{other}")
    found += in_line("Tower/K/k/f", "Tower/B/o/r", "center")
    for bay in BAYS:
        found += in_line(f"Tower/K/k/{CROWN[bay]}", f"Tower/B/o/{BEAM[bay]}", "center")
    return found + in_line("Tower/X/p", "Tower/V/p", "left right")


def _level(one: str, other: str) -> list[Constraint]:
    """Return what keeps the strips of two bays level."""
    found = []
    for strip in "tu":
        found += in_line(f"{one}/{strip}", f"{other}/{strip}", "top bottom")
    for first, second in permutations("tu"):
        found += in_line(f"{one}/{first}", f"{other}/{second}", "top")
    return found


def _equal() -> list[Constraint]:
    found = alike("width", "Tower/X/p", *(f"Tower/{block}/p" for block in "YVZ"))
    for block in BLOCKS:
        run = {bay: f"Tower/{block}/{bay}: t a" for bay in BAYS}
        found += alike("height", run["c"], run["s"], run["m"])
    return found


def _symmetric() -> list[Constraint]:
    """Return the symmetries, which the paper's table does not count."""
    return [Symmetry(of=("Tower/K/k", "Tower/B/o", *(f"Tower/{block}" for block in BLOCKS)))]


def _ranges() -> list[Constraint]:
    bays = [f"Tower/{block}/{bay}" for block, bay in product(BLOCKS, BAYS)]
    strips = [f"{bay}/{strip}" for bay, strip in product(bays, "tu")]
    return [
        *sizes("70%", "150%", "8%", *bays, *(f"Tower/{block}/p" for block in BLOCKS)),
        *sizes("85%", "120%", "5%", *strips),
        *sizes("60%", "170%", "15%", *(f"{bay}/a" for bay in bays)),
        *sizes("40%", "250%", "20%", "Tower/B/o/e"),
    ]
