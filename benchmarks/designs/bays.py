"""Facades of storeys, each with bays of three kinds: what stands side by side is stated storey by storey."""

from __future__ import annotations

import math

from layoutkit.model import Facade, Region

#: Widths of the kinds of bays, and of the windows in them; all storeys are equally high.
KINDS = {"A": (3.0, 1.2), "B": (3.6, 1.8), "C": (2.4, 0.9)}
WORD = "ABABCCBABACB"
HEIGHT, SILL, LINTEL, PIER = 3.2, 0.7, 0.5, 0.4
#: Terminals of a bay, the pier beside it counted in.
_CELL = 6


def bays(terminals: int) -> Facade:
    """Return a facade of about so many terminals, as many storeys as bays.

    Parameters
    ----------
    terminals
        At least 100.
    """
    count = max(3, round(math.sqrt(terminals / _CELL)))
    word = "".join(WORD[number % len(WORD)] for number in range(count))
    rows = [_storey(f"S{number}", word) for number in range(count)]
    width = rows[0].width
    cornice = Region("Cornice", width, 1.0, labels=("Cornice",))
    plinth = Region("Plinth", width, 1.0, labels=("Wall",))
    root = Region("F", width, HEIGHT * count + 2.0, "rows", (cornice, *rows, plinth))
    return Facade(f"bays-{terminals}", "m", root)


def _storey(symbol: str, word: str) -> Region:
    pier = Region("Pier", PIER, HEIGHT, labels=("Wall",))
    children = [pier]
    for kind in word:
        children += [_bay(kind), pier]
    return Region(symbol, sum(child.width for child in children), HEIGHT, "columns", tuple(children))


def _bay(kind: str) -> Region:
    width, window = KINDS[kind]
    inside = (
        Region("Lintel", window, LINTEL, labels=("Wall",)),
        Region("Window", window, HEIGHT - SILL - LINTEL, labels=("Window",)),
        Region("Sill", window, SILL, labels=("Sill",)),
    )
    jamb = Region("Jamb", (width - window) / 2, HEIGHT, labels=("Wall",))
    middle = Region("Middle", window, HEIGHT, "rows", inside)
    return Region(kind, width, HEIGHT, "columns", (jamb, middle, jamb))
