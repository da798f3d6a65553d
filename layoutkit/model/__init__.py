"""The core model: regions, facades and layouts as plain immutable data, no I/O, no solver."""

from layoutkit.model.box import Box
from layoutkit.model.building import Building
from layoutkit.model.count import Count
from layoutkit.model.extent import Extent
from layoutkit.model.facade import Facade, Picture
from layoutkit.model.face import Face
from layoutkit.model.layout import Layout, Violation
from layoutkit.model.mass import Block, Footprint, Mass, Part
from layoutkit.model.measure import Measure
from layoutkit.model.region import Fill, PlacedRegion, Region, Split, place
from layoutkit.model.selection import RegionSet
from layoutkit.model.word import END, START, Word

__all__ = [
    "END",
    "START",
    "Block",
    "Box",
    "Building",
    "Count",
    "Extent",
    "Facade",
    "Face",
    "Fill",
    "Footprint",
    "Layout",
    "Mass",
    "Measure",
    "Part",
    "Picture",
    "PlacedRegion",
    "Region",
    "RegionSet",
    "Split",
    "Violation",
    "Word",
    "place",
]
