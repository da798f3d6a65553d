"""Towers on sites: podiums, shafts and setbacks, merged to one solid each."""

from __future__ import annotations

import math
from collections.abc import Sequence

from facades.drafting.learning import SHARES, Shown, learned
from layoutkit.model import LearningSettings, PlacementModel, Polygon, Scene
from layoutkit.model.face import Point
from layoutkit.operations import Design, Operations
from layoutkit.operations.attributes import Colour
from layoutkit.shipped import shipped
from layoutkit_operations.kinds.boolean import Boolean
from layoutkit_operations.kinds.extrude import Extrude
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.vary import Vary
from layoutkit_operations.recording import Recorder, Step, design

SITE, PAVILION = "Site", "Pavilion"
STONE, STEEL, GRAVEL, COPPER = (214, 208, 196), (84, 92, 100), (150, 152, 148), (116, 158, 142)

#: A middle, a width and a height, as shares.
Box = tuple[float, float, float, float]

#: What tells where in a site a podium may stand.
ROUGH = LearningSettings(
    tolerance=6.0,
    shape_tolerance=0.5,
    relationships=("boundary-distance", "segment-distance", "normalised-bounding-box-coordinates"),
)


def scenes() -> tuple[Scene, ...]:
    """Return the sites that towers are built on."""
    outlines: tuple[tuple[Point, ...], ...] = (
        ((0, 0), (46, 0), (46, 40), (0, 40)),
        ((58, 0), (100, 0), (108, 40), (58, 40)),
        ((114, 0), (158, 0), (158, 36), (146, 44), (122, 40)),
        ((0, 54), (40, 54), (40, 104), (6, 98)),
        ((54, 54), (112, 54), (116, 74), (96, 94), (54, 94)),
        ((128, 56), (160, 58), (164, 106), (132, 110)),
        ((6, 114), (42, 118), (42, 156), (10, 152)),
        ((54, 108), (92, 108), (118, 122), (110, 152), (54, 156)),
    )
    sites = (Polygon(f"Site_{n}", tuple(own), (SITE,)) for n, own in enumerate(outlines, 1))
    round_ones = (_octagon("Pavilion_1", 104.0, 69.0, 6.0), _octagon("Pavilion_2", 98.0, 134.0, 8.5))
    ground = Polygon("Streets", ((-12, -12), (174, -12), (174, 166), (-12, 166)), ("Street",))
    return (Scene("quarter", "m", (ground, *sites, *round_ones)),)


def operations() -> Operations:
    """Return the session that makes towers of sites."""
    session = Recorder(scenes()[0], sites=(SITE,))
    _pavilions(session)
    podiums = session.select(SITE).do(Place(model=_podium(), limit=1, threshold=0.05))
    podiums.do(Extrude(height=11.0, random=0.25, material="stone", colour=STONE, roof_colour=GRAVEL))
    podiums.select("Side").do(Vary(facade=_design("podium"), otherwise=_design("punched")))
    stepped, notched, twins = podiums.split(2, 2, 2)
    _stepped(stepped)
    _notched(notched)
    _twins(twins)
    return session.operations("towers")


def _podium() -> PlacementModel:
    broad = Polygon("Site", ((0, 0), (46, 0), (46, 40), (0, 40)), (SITE,))
    deep = Polygon("Site", ((0, 0), (34, 0), (34, 46), (0, 46)), (SITE,), angle=0.0)
    shown = (Shown(broad, ((23, 20, 34, 28),)), Shown(deep, ((17, 23, 23, 33),)))
    return learned("podiums", "Podium", shown, ROUGH)


def _pavilions(session: Recorder) -> None:
    """Build what is round under a roof."""
    round_ones = session.select(PAVILION)
    round_ones.do(
        Extrude(
            height=5.5, random=0.1, cap="hip", pitch=32.0, material="stone", colour=STONE, roof_colour=COPPER
        )
    )
    round_ones.select("Side").do(Vary(facade=_design("punched")))


def _stepped(podiums: Step) -> None:
    """Build a shaft that draws back twice, with a mast."""
    shafts = _upon(podiums, "Shaft", [(0.46, 0.54, 0.62, 0.66)], _box(34.0, 0.25, STEEL))
    shafts.select("Side").do(Vary(facade=_design("curtain")))
    crowns = _upon(shafts, "Crown", [(0.5, 0.5, 0.7, 0.7)], _box(17.0, 0.35, STEEL))
    crowns.select("Side").do(Vary(facade=_design("curtain")))
    caps = _upon(crowns, "Cap", [(0.5, 0.5, 0.6, 0.6)], _box(5.0, 0.2, STEEL))
    caps.select("Side").do(Vary(facade=_design("curtain")))
    _upon(caps, "Mast", [(0.5, 0.5, 0.07, 0.07)], _box(11.0, 0.3, STEEL))


def _notched(podiums: Step) -> None:
    """Build a slab that a terrace is cut out of."""
    slabs = _upon(podiums, "Slab", [(0.5, 0.5, 0.78, 0.5)], _box(40.0, 0.3, STONE))
    notches = _placed(slabs, "Notch", [(0.66, 0.34, 0.72, 0.72)])
    notches.do(_box(-7.5, 0.2, STONE))
    notches.do(Boolean(action="difference"))
    slabs.select("Side").do(Vary(facade=_design("punched")))


def _twins(podiums: Step) -> None:
    """Build two slender towers, of different height."""
    towers = _placed(podiums, "Tower", [(0.27, 0.4, 0.34, 0.44), (0.74, 0.58, 0.34, 0.48)])
    for tower, height in zip(towers.split(1, 1), (58.0, 42.0), strict=True):
        tower.do(_box(height, 0.15, STEEL))
        tower.do(Boolean(action="union"))
        tower.select("Side").do(Vary(facade=_design("curtain")))
        _upon(tower, "Cap", [(0.5, 0.5, 0.55, 0.6)], _box(4.5, 0.2, STEEL))


def _upon(below: Step, label: str, boxes: Sequence[Box], solid: Extrude) -> Step:
    """Put solids on the tops of others, where shares of a top's box say, and make them one with these."""
    placed = _placed(below, label, boxes)
    placed.do(solid)
    placed.do(Boolean(action="union"))
    return placed


def _placed(below: Step, label: str, boxes: Sequence[Box]) -> Step:
    """Place shapes on tops, where shares of a top's box say: its middle, its width and its height."""
    wide, high = 30.0, 24.0
    top = Polygon.rectangle("Top", 0, 0, wide, high, ("Top",))
    own = tuple((wide * x, high * y, wide * width, high * height) for x, y, width, height in boxes)
    model = learned(label, label, (Shown(top, own),), SHARES)
    return below.select("Top").do(Place(model=model, limit=len(boxes), threshold=0.2))


def _box(height: float, random: float, colour: Colour) -> Extrude:
    return Extrude(height=height, random=random, material="stone", colour=colour, roof_colour=GRAVEL)


def _octagon(name: str, x: float, y: float, radius: float) -> Polygon:
    turns = (math.radians(45.0 * number + 22.5) for number in range(8))
    points = tuple((round(x + radius * math.cos(t), 3), round(y + radius * math.sin(t), 3)) for t in turns)
    return Polygon(name, points, (PAVILION,))


def _design(name: str) -> Design:
    return design(f"{name}.xml", shipped("facades") / "towers")
