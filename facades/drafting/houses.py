"""Houses on plots: what is placed where, and what comes of it."""

from __future__ import annotations

from facades.drafting.learning import SHARES, Shown, learned
from facades.drafting.streets import village
from facades.painting.buildings import BRICK, CREAM, WHITE
from layoutkit.model import LearningSettings, PlacementModel, Polygon, Scene
from layoutkit.operations import Operations
from layoutkit.operations.attributes import Colour
from layoutkit.shipped import shipped
from layoutkit_operations.kinds.array import Array
from layoutkit_operations.kinds.boolean import Boolean
from layoutkit_operations.kinds.delete import Delete
from layoutkit_operations.kinds.extrude import Extrude
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.vary import Vary
from layoutkit_operations.recording import Recorder, Step, design

#: What plots are called: in our own scene, and in the data of a city's survey.
PLOT, SURVEYED = "Plot", "plots"
TILES, SLATE, TAR, BARK = (168, 84, 62), (92, 94, 104), (120, 122, 124), (110, 84, 62)

#: What tells where in any plot a house may stand: few functions, and these with tolerance.
ROUGH = LearningSettings(
    tolerance=7.0,
    shape_tolerance=0.4,
    relationships=("boundary-distance", "segment-distance", "normalised-bounding-box-coordinates"),
)


def scenes() -> tuple[Scene, ...]:
    """Return the scenes that houses are built on."""
    return (village(),)


def operations() -> Operations:
    """Return the session that makes houses of plots."""
    session = Recorder(village(), sites=(PLOT, SURVEYED))
    session.select(PLOT).do(Place(model=at_street(), limit=1, threshold=0.0, inside=1.0))
    session.select(SURVEYED).do(Place(model=anywhere(), limit=1, threshold=0.0, inside=1.0))
    _planted(session)
    houses = session.select("House")
    tall, low, winged, modern = houses.split(3, 2, 3, 2)
    _tall(tall)
    _low(low)
    _winged(winged)
    _modern(modern)
    _grown(session)
    return session.operations("houses")


def at_street() -> PlacementModel:
    """Return where houses stand on plots whose edge at the street is known."""
    front = ((0, ("Front",)),)
    wide = Polygon("Plot", ((0, 0), (24, 0), (24, 30), (0, 30)), (PLOT,), edges=front, angle=0.0)
    narrow = Polygon("Plot", ((0, 0), (16, 0), (16, 28), (0, 28)), (PLOT,), edges=front, angle=0.0)
    askew = Polygon("Plot", ((0, 0), (19, 0), (21, 29), (-2, 27)), (PLOT,), edges=front, angle=0.0)
    shown = (
        Shown(wide, ((12, 9.5, 14, 9.5),)),
        Shown(narrow, ((8, 9.5, 9.5, 9.5),)),
        Shown(askew, ((9.5, 9.5, 11, 9),)),
    )
    return learned("houses-at-streets", "House", shown, ROUGH)


def anywhere() -> PlacementModel:
    """Return where houses stand on plots of which no more is known than their outline.

    They face the longest edges, since a polygon that says nothing else is taken to run along these.
    """
    small = Polygon("Plot", ((0, 0), (11, 0), (11, 11), (0, 11)), (SURVEYED,), angle=0.0)
    large = Polygon("Plot", ((0, 0), (22, 0), (22, 20), (0, 20)), (SURVEYED,), angle=0.0)
    shown = (Shown(small, ((5.5, 5.5, 5, 5),)), Shown(large, ((11, 10, 10, 9),)))
    return learned("houses-anywhere", "House", shown, ROUGH)


def _planted(session: Recorder) -> None:
    """Say where trees stand, behind houses that are not built yet."""
    house = Polygon.rectangle("House", 4, 5, 14, 14, ("House",))
    outline = ((0.0, 0.0), (18.0, 0.0), (18.0, 30.0), (0.0, 30.0))
    plots = (
        Polygon("Plot", outline, (PLOT,), edges=((0, ("Front",)),), angle=0.0),
        Polygon("Plot", outline, (SURVEYED,), angle=0.0),
    )
    for plot in plots:
        shown = Shown(plot, ((3.5, 26, 3, 3), (14.5, 23, 3, 3)), (house,))
        model = learned("trees", "Tree", (shown,), ROUGH)
        session.select(*plot.labels).do(Place(model=model, limit=3, threshold=0.3, share=0.8, clear=True))


def _grown(session: Recorder) -> None:
    """Let trees grow, once houses are built: else they would be taken for parts of them."""
    trees = session.select("Tree")
    trees.do(Array(label="Trunk", each_width=0.4, each_height=0.4, gap_across=9.0, gap_up=9.0)).do(
        Extrude(height=1.8, material="bark", colour=BARK)
    )
    slender, broad = trees.split(1, 2)
    slender.do(_crown(2.0, 72.0, (84, 126, 82)))
    broad.do(_crown(1.3, 60.0, (116, 152, 78)))


def _crown(height: float, pitch: float, leaves: Colour) -> Extrude:
    return Extrude(
        height=height,
        base=1.5,
        random=0.3,
        cap="hip",
        pitch=pitch,
        material="leaves",
        colour=leaves,
        roof_colour=leaves,
    )


def _tall(houses: Step) -> None:
    """Build two storeys of plaster under a gable, with a chimney."""
    _chimney(houses)
    houses.do(
        Extrude(
            height=6.1,
            random=0.06,
            cap="gable",
            pitch=38.0,
            material="plaster",
            colour=CREAM,
            roof_colour=TILES,
        )
    )
    _dressed(houses, "plaster")
    _smoking(houses, 10.6)


def _low(houses: Step) -> None:
    """Build one storey of brick under hips, with a chimney."""
    _chimney(houses)
    houses.do(
        Extrude(
            height=3.5, random=0.06, cap="hip", pitch=34.0, material="brick", colour=BRICK, roof_colour=SLATE
        )
    )
    _dressed(houses, "brick")
    _smoking(houses, 7.1)


def _winged(houses: Step) -> None:
    """Build two storeys of brick under a gable, and beside them a garage with a flat roof."""
    whole = Polygon.rectangle("House", 0, 0, 12, 9, ("House",))
    core = learned("cores", "Core", (Shown(whole, ((4, 4.5, 8, 9),)),), SHARES)
    wing = learned("wings", "Wing", (Shown(whole, ((9.7, 5.2, 4.6, 6.4),)),), SHARES)
    cores = houses.do(Place(model=core, limit=1, threshold=0.0))
    wings = houses.do(Place(model=wing, limit=1, threshold=0.0))
    cores.do(
        Extrude(
            height=6.0,
            random=0.05,
            cap="gable",
            pitch=40.0,
            material="brick",
            colour=BRICK,
            roof_colour=SLATE,
        )
    )
    wings.do(Extrude(height=3.0, random=0.03, material="brick", colour=BRICK, roof_colour=TAR))
    _joined(houses, "brick")


def _modern(houses: Step) -> None:
    """Build two white boxes, one upon the other's edge, under flat roofs."""
    whole = Polygon.rectangle("House", 0, 0, 12, 9, ("House",))
    core = learned("blocks", "Core", (Shown(whole, ((4.2, 5.2, 8.4, 7.6),)),), SHARES)
    wing = learned("terraces", "Wing", (Shown(whole, ((7, 3.4, 10, 6.8),)),), SHARES)
    cores = houses.do(Place(model=core, limit=1, threshold=0.0))
    wings = houses.do(Place(model=wing, limit=1, threshold=0.0))
    cores.do(Extrude(height=6.4, random=0.04, material="render", colour=WHITE, roof_colour=TAR))
    wings.do(Extrude(height=3.2, random=0.03, material="render", colour=WHITE, roof_colour=TAR))
    _joined(houses, "modern")


def _joined(houses: Step, style: str) -> None:
    """Make cores and wings one, and take away the outlines that they were placed in."""
    houses.select("Core").do(Boolean(action="union", with_="intersecting"))
    _dressed(houses.select("Core", "Wing"), style)
    houses.do(Delete())


def _chimney(houses: Step) -> None:
    """Say where the chimney stands within a house that is not built yet."""
    whole = Polygon.rectangle("House", 0, 0, 12, 9, ("House",))
    model = learned("chimneys", "Chimney", (Shown(whole, ((9, 5.2, 1.1, 0.8),)),), SHARES)
    houses.do(Place(model=model, limit=1, threshold=0.0))


def _smoking(houses: Step, height: float) -> None:
    """Put the chimney up, from the ground through the roof, and make it one with the house."""
    houses.select("Chimney").do(Extrude(height=height, random=0.04, material="chimney", colour=BRICK))
    houses.do(Boolean(action="union", with_="intersecting"))


def _dressed(built: Step, style: str) -> None:
    """Lay out a front with a door, and sides without."""
    folder = shipped("facades") / "houses"
    front, side = (design(f"{style}-{name}.xml", folder) for name in ("front", "side"))
    built.select("Front", without=("Gable", "Roof")).do(Vary(facade=front, otherwise=side))
    built.select("Side", without=("Front",)).do(Vary(facade=side))
