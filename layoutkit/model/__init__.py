"""The core model: regions, facades and layouts as plain immutable data, no I/O, no solver."""

from layoutkit.model.box import Box
from layoutkit.model.extent import Extent
from layoutkit.model.facade import Facade, Picture
from layoutkit.model.layout import Layout, Violation
from layoutkit.model.measure import Measure
from layoutkit.model.region import Fill, PlacedRegion, Region, Split, place
from layoutkit.model.selection import RegionSet
from layoutkit.model.word import END, START, Word

__all__ = [
    "END",
    "START",
    "Box",
    "Extent",
    "Facade",
    "Fill",
    "Layout",
    "Measure",
    "Picture",
    "PlacedRegion",
    "Region",
    "RegionSet",
    "Split",
    "Violation",
    "Word",
    "place",
]
