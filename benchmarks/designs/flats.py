"""A house of flats: windows of four kinds scattered over storeys of four kinds, in any order.

In the way of the paper's figure 14: a dense model of windows in random order, which are in line all the same.
"""

from __future__ import annotations

from itertools import combinations, product

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

#: Openings of a storey, and their widths: small, medium, large, and with a balcony.
OPENINGS = {"S": 0.8, "M": 1.2, "L": 1.6, "B": 1.4}
STOREYS = "PQRU"
WIDTH = 19.2


def flats() -> Facade:
    """Return the facade."""
    parts = [_roof(), *(_storey(symbol) for symbol in STOREYS), _ground()]
    word = "C P Q R U Q P G"
    root = rows("Flats", WIDTH, word, parts)
    constraints = [*_storeys(), *_rhythms(), *_windows(), *_lines(), *_ranges()]
    return facade("flats", root, WIDTH, total(word, parts), constraints)
