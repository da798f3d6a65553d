"""The core model: regions, facades and layouts as plain immutable data, no I/O, no solver."""

from layoutkit.model.box import Box
from layoutkit.model.building import Building
from layoutkit.model.count import Count
from layoutkit.model.evidence import Evidence, HeatMap
from layoutkit.model.extent import Extent
from layoutkit.model.facade import Facade, Picture
from layoutkit.model.face import Face
from layoutkit.model.grid import Grid
from layoutkit.model.layout import Layout, Violation
from layoutkit.model.learning import Example, LearningSettings, PlacementModel, Spacing
from layoutkit.model.mass import Block, Footprint, Mass, Part
from layoutkit.model.measure import Measure
from layoutkit.model.piece import Piece
from layoutkit.model.proposal import DroppedEdit, ProposedEdit
from layoutkit.model.region import Fill, PlacedRegion, Region, Split, place
from layoutkit.model.scene import Placement, Polygon, Pose, Scene
from layoutkit.model.selection import RegionSet
from layoutkit.model.session import Drag, Edit, RegionSize, Resize, Session, Step
from layoutkit.model.word import END, START, Word
from layoutkit.model.world import GROUND, Body, BodySurface, Frame, Opening, Skin, World

__all__ = [
    "END",
    "GROUND",
    "START",
    "Block",
    "Body",
    "BodySurface",
    "Box",
    "Building",
    "Count",
    "Drag",
    "DroppedEdit",
    "Edit",
    "Evidence",
    "Example",
    "Extent",
    "Facade",
    "Face",
    "Fill",
    "Footprint",
    "Frame",
    "Grid",
    "HeatMap",
    "Layout",
    "LearningSettings",
    "Mass",
    "Measure",
    "Opening",
    "Part",
    "Picture",
    "Piece",
    "PlacedRegion",
    "Placement",
    "PlacementModel",
    "Polygon",
    "Pose",
    "ProposedEdit",
    "Region",
    "RegionSet",
    "RegionSize",
    "Resize",
    "Scene",
    "Session",
    "Skin",
    "Spacing",
    "Split",
    "Step",
    "Violation",
    "Word",
    "World",
    "place",
]
