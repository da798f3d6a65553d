"""Nine facades of our own design, as large and as constrained as those of Bao et al. 2013, Table I."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from benchmarks.designs.block import block
from benchmarks.designs.corner import corner
from benchmarks.designs.flats import flats
from benchmarks.designs.hotel import hotel
from benchmarks.designs.house import house
from benchmarks.designs.mansion import mansion
from benchmarks.designs.palazzo import palazzo
from benchmarks.designs.shop import shop
from benchmarks.designs.tower import tower
from layoutkit.model import Facade

#: The designs by name, in the order of the paper's table.
DESIGNS: Mapping[str, Callable[[], Facade]] = {
    "corner": corner,
    "palazzo": palazzo,
    "mansion": mansion,
    "shop": shop,
    "tower": tower,
    "hotel": hotel,
    "house": house,
    "flats": flats,
    "block": block,
}
