"""A corner house: window columns in two parts, a door column on the right, pedestals on the roof.

In the way of the paper's figure 2: the door column may move into the grid of windows, the lower part of the
grid may be left out, windows and ornaments keep in line.
"""

from __future__ import annotations

from itertools import combinations, permutations, product

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

BODY = "House/Body"
#: Columns with windows: wide, narrow, and over the door.
OPEN = ("W", "N", "D")
STOREYS = ("⊢ K p U", "U p U", "U p M", "M q L", "L q L")


def corner() -> Facade:
    """Return the facade, 16.1 m wide and 20.5 m high."""
    parts = [_attic(), _body(), leaf("Base", 0.8, "Plinth")]
    root = rows("House", total("Attic Body Base", parts), "Attic Body Base", parts)
    constraints = [*_words(), *_levels(), *_uprights(), *_equal(), *_ranges()]
    return facade("corner", root, 16.1, 20.5, constraints)


def _attic() -> Part:
    panels = [_balustrade("A", 1.2, 3), _balustrade("B", 2.0, 5), _balustrade("C", 2.4, 6)]
    pedestal = rows("P", 0.5, "u k", [leaf("u", 0.9, "Urn"), leaf("k", 0.7, "Pedestal")])
    word = "e P B P A P B P B P A P C P e"
    return columns("Attic", 1.6, word, [leaf("e", 0.9, "Wall"), pedestal, *panels])


def _balustrade(symbol: str, width: float, balusters: int) -> Part:
    gap = (width - 0.15 * balusters) / (balusters + 1)
    word = " ".join(["v", *["b v"] * balusters])
    bars = columns("r", 1.2, word, [leaf("b", 0.15, "Baluster"), leaf("v", gap, "Gap")])
    return rows(symbol, width, "n r f", [leaf("n", 0.2, "Rail"), bars, leaf("f", 0.2, "Rail")])


def _body() -> Part:
    word = "E V W V N V W V W V N V D V E"
    return columns("Body", 18.1, word, [_edge(), _wall(), _windows("W"), _windows("N"), _doors()])


def _edge() -> Part:
    parts = [
        leaf("K", 0.6, "Cornice"),
        leaf("a", 0.7, "Quoin"),
        leaf("b", 0.8, "Quoin"),
        leaf("M", 0.5, "Belt"),
        leaf("Z", 0.6, "Foot"),
    ]
    return rows("E", 0.8, "K a b a b a b a b a b a b a M a b a b a b a b a Z", parts)


def _wall() -> Part:
    medallion = rows("o", 0.7, "g f", [leaf("g", 0.2, "Garland"), leaf("f", 0.5, "Medallion")])
    panel = rows("r", 0.9, "g f", [leaf("g", 0.2, "Rail"), leaf("f", 0.7, "Panel")])
    walls = [leaf("y", 1.6), leaf("w", 2.2), leaf("z", 1.45), leaf("x", 2.0)]
    belts = [leaf("K", 0.6, "Cornice"), leaf("M", 0.5, "Belt"), leaf("Z", 0.6, "Foot")]
    return rows("V", 0.7, "K y o w o w o y M z r x r z Z", [medallion, panel, *walls, *belts])


def _windows(symbol: str) -> Part:
    word = "K p U p U p U p M q L q L q Z"
    width = {"W": 1.8, "N": 1.0}[symbol]
    return rows(symbol, width, word, [*_storeys(symbol), leaf("Z", 0.6, "Foot")])


def _doors() -> Part:
    leaves = columns("d", 2.3, "j l l j", [leaf("j", 0.2, "Jamb"), leaf("l", 0.9, "Leaf")])
    fan = columns("f", 0.8, "j p p p j", [leaf("j", 0.2, "Jamb"), leaf("p", 0.6, "Pane")])
    gate = rows("G", 3.5, "f d t", [fan, leaves, leaf("t", 0.4, "Step")], "Door")
    return rows("D", 2.2, "K p U p U p U p M q L q G", [*_storeys("D"), gate])


def _storeys(symbol: str) -> list[Part]:
    return [
        leaf("K", 0.6, "Cornice"),
        leaf("p", 1.0, "Wall"),
        _window("U", symbol, 1.4),
        leaf("M", 0.5, "Belt"),
        leaf("q", 0.9, "Wall"),
        _window("L", symbol, 1.5),
    ]


def _window(symbol: str, column: str, height: float) -> Part:
    word, pane = {"W": ("j p m p j", 0.75), "N": ("j p j", 0.8), "D": ("j p m p m p j", 0.6)}[column]
    lights = [leaf("t", 0.4, "Light"), leaf("b", height - 0.4, "Light")]
    glass = rows("p", pane, "t b", lights) if column == "W" else leaf("p", pane, "Light")
    parts = [leaf("j", 0.1, "Jamb"), glass, leaf("m", 0.1, "Mullion")]
    glazing = columns("g", height, word, parts, "Glazing")
    hood, sill = leaf("h", 0.3, "Hood"), leaf("s", 0.2, "Sill")
    return rows(symbol, height + 0.5, "h g s", [hood, glazing, sill], "Window")


def _words() -> list[Constraint]:
    """Return the sequences; no narrow column stands beside another one."""
    found = sequences(
        BODY,
        *(f"⊢ E V {column}" for column in OPEN),
        *(f"{one} V {other}" for one, other in product(OPEN, OPEN) if one != other or one == "W"),
        "{W N D} V E ⊣",
    )
    for column in ("W", "N"):
        found += sequences(f"{BODY}/{column}", *STOREYS, "L q Z ⊣", "M Z ⊣")
    found += sequences(f"{BODY}/D", *STOREYS, "L q G ⊣", "M q G ⊣")
    found += sequences(f"{BODY}/V", "⊢ K y o", "o w o", "o y M", "M z r", "r x r", "r z Z ⊣", "M Z ⊣")
    found += sequences(f"{BODY}/E", "⊢ K a", "a b", "b a", "a M", "M a", "a Z ⊣", "M Z ⊣")
    found += sequences("House/Attic", "⊢ e P", *shuffled("P A P B P C P"), "P e ⊣")
    found += sequences(f"{BODY}/D/G/d", "⊢ j l l j ⊣", "⊢ j l j ⊣")
    return found + frequency("D", BODY, "1", "1")


def _levels() -> list[Constraint]:
    """Return what keeps windows, ornaments and belts of all columns level."""
    found = []
    for one, other in permutations(OPEN, 2):
        found += in_line(f"{BODY}/{one}/U", f"{BODY}/{other}/L", "top bottom")
    for one, other in combinations(OPEN, 2):
        found += in_line(f"{BODY}/{one}/U", f"{BODY}/{other}/U", "top bottom")
        found += in_line(f"{BODY}/{one}/L", f"{BODY}/{other}/L", "top bottom")
    for ornament, column, window in product("or", OPEN, "UL"):
        found += in_line(f"{BODY}/V/{ornament}", f"{BODY}/{column}/{window}", "middle")
    for one, other in ("WN", "WD", "WV", "WE", "ND", "NV", "DV", "VE"):
        found += in_line(f"{BODY}/{one}/M", f"{BODY}/{other}/M", "top bottom")
    for other in "NDVE":
        found += in_line(f"{BODY}/W/K", f"{BODY}/{other}/K", "bottom")
    for other in "NVE":
        found += in_line(f"{BODY}/W/Z", f"{BODY}/{other}/Z", "top")
    return found


def _uprights() -> list[Constraint]:
    """Return what keeps pedestals off the edges of windows, and mullions above one another."""
    found = []
    for column in OPEN:
        found += in_line("House/Attic/P", f"{BODY}/{column}", "center")
    for column in "WD":
        found += in_line(f"{BODY}/{column}/U/g/m", f"{BODY}/{column}/L/g/m", "center")
    return found


def _equal() -> list[Constraint]:
    found = []
    for run in ("U", "L"):
        found += alike("height", f"{BODY}/W/{run}", f"{BODY}/N/{run}", f"{BODY}/D/{run}")
    for run in ("U p", "q L"):
        found += alike("height", f"{BODY}/W: {run}", f"{BODY}/N: {run}", f"{BODY}/D: {run}")
    return found


def _ranges() -> list[Constraint]:
    windows = [f"{BODY}/{column}/{window}" for column in OPEN for window in "UL"]
    walls = [f"{BODY}/{column}/{wall}" for column in OPEN for wall in "pq"]
    return [
        *sizes("80%", "130%", "5%", *(f"{BODY}/{column}" for column in "WNDE")),
        *sizes("60%", "180%", "15%", f"{BODY}/V"),
        *sizes("85%", "120%", "5%", *windows),
        *sizes("60%", "170%", "15%", *walls),
        *sizes("40%", "200%", "20%", *(f"{BODY}/V/{wall}" for wall in "ywzx")),
    ]
