"""A flat is furnished: piece after piece, each placed as in two examples, by what stands there already."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Literal

from facades.drafting.parts import part_of
from facades.drafting.rooms import APART, examples, floor
from layoutkit.model import LearningSettings, Placement, Scene
from layoutkit.operations import Operations
from layoutkit_operations.kinds.array import Array
from layoutkit_operations.kinds.extrude import Extrude
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.shape import Shape
from layoutkit_operations.kinds.vary import Vary
from layoutkit_operations.recording import Recorder, Step, design

_FOLDER = Path(__file__).parents[1] / "flat"

_OAK, _WALNUT, _LINEN, _WHITE = (196, 160, 116), (142, 104, 74), (226, 218, 204), (240, 238, 232)
_STEEL, _BLACK, _LIGHT = (186, 190, 194), (52, 52, 56), (244, 226, 178)
_SAGE, _BLUE, _RUST = (136, 152, 130), (96, 116, 138), (176, 104, 78)
_GREEN, _CLAY, _GLASS, _PLASTER = (96, 132, 82), (182, 116, 86), (178, 206, 220), (232, 228, 220)
_CARPETS = ((206, 176, 152), (158, 168, 172))
_COVERS = ((132, 146, 156), (196, 178, 156))

#: Boxes of any length along a wall are alike; others keep nearly to their size; rugs lie under furniture.
_ANY_LENGTH = LearningSettings(area_tolerance=0.0, shape_tolerance=0.0)
_OWN_SIZE = LearningSettings()
_CROSSING = LearningSettings(crossing=True)
#: One in each room, even where rooms are little like the examples.
_ONE = Place(limit=1, threshold=0.12)

#: Centre and size of a box.
Box = tuple[float, float, float, float]
_BOTH: tuple[Literal["top", "bottom"], ...] = ("top", "bottom")
#: Builds what was placed.
Builder = Callable[[], object]


def scenes() -> tuple[Scene, ...]:
    """Return what the flat is furnished in."""
    return (floor(),)


def operations() -> Operations:
    """Return the sessions in which example rooms were furnished, one for each kind of room, then walls."""
    roots = [
        node
        for label, furnish in (("Kitchen", _kitchens), ("Bedroom", _bedrooms), ("LivingRoom", _living_rooms))
        for node in _session(label, furnish).operations(label).roots
    ]
    shell = Recorder(floor())
    _shell(shell)
    return Operations("flat", "m", (*roots, *shell.operations("shell").roots))


def _session(label: str, furnish: Callable[[Step], Iterator[Builder]]) -> Recorder:
    """Return the session in which the example rooms of a kind were furnished: all is placed, then built."""
    session = Recorder(examples(label))
    for build in tuple(furnish(session.select(label))):
        build()
    return session


def _kitchens(kitchen: Step) -> Iterator[Builder]:
    fridge = _put(
        kitchen, "Fridge", [(3.7, 2.875, 0.6, 0.65)], [(0.3, 3.475, 0.6, 0.65)], [(0.3, 2.775, 0.6, 0.65)]
    )
    fridge = fridge.do(Shape(snap=0.25, width=0.6, height=0.65, up="top"))
    counters = [(1.7, 2.9, 3.4, 0.6)], [(2.6, 3.5, 4.0, 0.6)], [(2.1, 2.8, 3.0, 0.6)]
    row = _put(kitchen, "Counter", *counters, settings=_ANY_LENGTH)
    row = row.do(Shape(snap=0.3, height=0.6, up="top"))
    dining = _put(kitchen, "Dining", [(1.6, 1.15, 1.3, 1.7)], [(2.7, 1.4, 1.3, 1.7)])
    dining = dining.do(Shape(width=1.3, height=1.75))
    yield lambda: _dining(dining, 1.3)
    sink, hob = _let_in(row)
    yield lambda: _sink(sink)
    yield lambda: _hob(hob)
    yield lambda: _counter(row)
    yield lambda: fridge.do(Extrude(height=1.85, random=0.05, colour=_STEEL))


def _let_in(row: Step) -> tuple[Step, Step]:
    """Place what is let into the top of a counter: a sink, and a hob."""
    sink = _put(row, "Sink", [(1.0, 2.88, 0.8, 0.45)], [(3.6, 3.48, 0.8, 0.45)], [(2.8, 2.78, 0.8, 0.45)])
    hob = _put(row, "Hob", [(2.5, 2.9, 0.6, 0.5)], [(1.9, 3.5, 0.6, 0.5)], [(1.5, 2.8, 0.6, 0.5)])
    return sink.do(Shape(width=0.8, height=0.46)), hob.do(Shape(width=0.58, height=0.5))


def _sink(sink: Step) -> None:
    bowl = part_of(sink, "Bowl", Shape(width=0.4, across="left"), Shape(sides=8, inset=0.05))
    bowl.do(Extrude(base=0.912, height=0.004, colour=(120, 124, 128)))
    part_of(sink, "Tap", Shape(width=0.04, height=0.04, up="top")).do(
        Extrude(base=0.9, height=0.25, colour=_STEEL)
    )
    sink.do(Extrude(base=0.9, height=0.012, colour=_STEEL))


def _hob(hob: Step) -> None:
    ring = Array(label="Ring", each_width=0.17, each_height=0.17, gap_across=0.08, gap_up=0.06, margin=0.06)
    hob.do(ring).do(Shape(sides=16)).do(Extrude(base=0.915, height=0.008, colour=(120, 60, 52)))
    hob.do(Extrude(base=0.9, height=0.015, colour=_BLACK))


def _counter(row: Step) -> None:
    """Build cabinets under a worktop, tiles on the wall, and cupboards above."""
    part_of(row, "Worktop").do(Extrude(base=0.86, height=0.04, colour=_OAK))
    tiles = part_of(row, "Tiles", Shape(height=0.03, up="top"))
    tiles.do(Extrude(base=0.9, height=0.55, colour=_WHITE))
    above = part_of(row, "Cupboard", Shape(height=0.36, up="top"))
    above = above.do(Extrude(base=1.45, height=0.7, colour=_WHITE))
    above.select("Front").do(Vary(facade=design("cupboard.xml", _FOLDER)))
    cabinets = part_of(row, "Cabinets").do(Extrude(height=0.86, colour=_SAGE))
    cabinets.select("Front").do(Vary(facade=design("cabinet.xml", _FOLDER)))


def _dining(place: Step, length: float) -> None:
    """Build a table with chairs at both long sides, each with its back away from it."""
    for up in _BOTH:
        row = part_of(place, "Seats", Shape(width=length - 0.15, height=0.45, up=up))
        _chairs(row.do(Array(label="Chair", each_width=0.44, gap_across=0.1)), up)
    _table(part_of(place, "Table", Shape(width=length, height=0.8)), 0.71)


def _chairs(chair: Step, up: Literal["top", "bottom"]) -> None:
    back = part_of(chair, "Back", Shape(height=0.05, up=up))
    back.do(Extrude(base=0.46, height=0.42, colour=_WALNUT))
    _legs(chair, 0.42, 0.22, 0.22)
    part_of(chair, "Seat").do(Extrude(base=0.42, height=0.04, colour=_OAK))


def _table(table: Step, height: float) -> None:
    _legs(table, height, 0.7, 0.35)
    part_of(table, "Top").do(Extrude(base=height, height=0.04, colour=_OAK))


def _legs(top: Step, height: float, across: float, up: float) -> None:
    """Put legs under what they carry, so close that there are two along each side."""
    legs = Array(label="Leg", each_width=0.05, each_height=0.05, gap_across=across, gap_up=up, margin=0.03)
    top.do(legs).do(Extrude(height=height, colour=_WALNUT))


def _bedrooms(bedroom: Step) -> Iterator[Builder]:
    bed = _put(bedroom, "Bed", [(2.1, 2.8, 1.6, 2.0)], [(2.3, 2.6, 1.6, 2.0)])
    bed = bed.do(Shape(snap=0.2, width=1.6, height=2.0, up="top"))
    left, right = (
        [(1.025, 3.6, 0.45, 0.4), (3.175, 3.6, 0.45, 0.4)],
        [(1.225, 3.4, 0.45, 0.4), (3.375, 3.4, 0.45, 0.4)],
    )
    tables = _put(bedroom, "NightTable", left, right, like=Place(limit=2, threshold=0.12))
    tables = tables.do(Shape(snap=0.12, width=0.45, height=0.4, up="top"))
    wardrobe = _put(bedroom, "Wardrobe", [(3.1, 0.3, 2.2, 0.6)], [(1.1, 0.3, 2.2, 0.6)])
    wardrobe = wardrobe.do(Shape(snap=0.25, height=0.6, up="bottom"))
    rug = _put(bedroom, "Rug", [(2.1, 2.0, 2.6, 1.5)], [(2.3, 1.8, 2.6, 1.5)], settings=_CROSSING)
    yield lambda: _rugs(rug)
    yield lambda: _beds(bed)
    yield lambda: _night_tables(tables)
    yield lambda: _wardrobes(wardrobe)


def _beds(bed: Step) -> None:
    board = part_of(bed, "Headboard", Shape(height=0.07, up="top"))
    board.do(Extrude(height=1.0, colour=_WALNUT))
    mattress = part_of(bed, "Mattress", Shape(inset=0.08))
    pillows = mattress.do(Array(label="Pillow", each_width=0.6, gap_across=0.1, margin=0.06))
    pillows.do(Shape(height=0.38, up="top")).do(Extrude(base=0.5, height=0.09, colour=_WHITE))
    cover = part_of(mattress, "Cover", Shape(height=1.25, up="bottom"))
    for part, colour in zip(cover.split(1, 1, 1), (_BLUE, _RUST, _SAGE), strict=True):
        part.do(Extrude(base=0.5, height=0.05, colour=colour))
    mattress.do(Extrude(base=0.3, height=0.2, colour=_LINEN))
    part_of(bed, "Frame").do(Extrude(height=0.3, colour=_WALNUT))


def _night_tables(tables: Step) -> None:
    foot = part_of(tables, "Foot", Shape(width=0.05, height=0.05))
    foot.do(Extrude(base=0.5, height=0.12, colour=_STEEL))
    shade = Extrude(base=0.62, height=0.14, cap="hip", pitch=50, colour=_LIGHT, roof_colour=_LIGHT)
    part_of(tables, "Lamp", Shape(width=0.24, height=0.24, sides=8)).do(shade)
    part_of(tables, "Chest").do(Extrude(height=0.5, colour=_WALNUT))


def _wardrobes(wardrobe: Step) -> None:
    built = wardrobe.do(Extrude(height=2.1, colour=_WHITE))
    built.select("Back").do(Vary(facade=design("wardrobe.xml", _FOLDER)))


def _living_rooms(room: Step) -> Iterator[Builder]:
    sofa = _put(room, "Sofa", [(3.7, 3.75, 2.2, 0.9)], [(4.4, 3.95, 2.2, 0.9)])
    sofa = sofa.do(Shape(snap=0.2, width=2.2, height=0.9, up="top"))
    low = _put(room, "CoffeeTable", [(3.7, 2.55, 1.1, 0.6)], [(4.4, 2.75, 1.1, 0.6)])
    low = low.do(Shape(width=1.1, height=0.6))
    bench = _put(room, "Bench", [(3.7, 0.2, 1.8, 0.4)], [(4.4, 0.2, 1.8, 0.4)])
    bench = bench.do(Shape(snap=0.25, width=1.8, height=0.4, up="bottom"))
    shelf = _put(room, "Bookshelf", [(5.42, 2.4, 0.36, 1.8)], [(6.42, 2.5, 0.36, 1.8)])
    shelf = shelf.do(Shape(snap=0.2, width=0.36, across="right"))
    dining = _put(room, "Dining", [(1.2, 2.3, 1.7, 1.75)], [(1.5, 2.5, 1.7, 1.75)])
    dining = dining.do(Shape(width=1.7, height=1.75))
    plant = _put(room, "Plant", [(0.35, 3.85, 0.45, 0.45)], [(0.35, 4.05, 0.45, 0.45)])
    rug = _put(room, "Rug", [(3.7, 2.6, 2.8, 1.9)], [(4.4, 2.8, 2.8, 1.9)], settings=_CROSSING)
    yield lambda: _dining(dining, 1.7)
    yield lambda: _rugs(rug)
    yield lambda: _sofas(sofa)
    yield lambda: _table(low, 0.36)
    yield lambda: _benches(bench)
    yield lambda: _shelves(shelf)
    yield lambda: _plants(plant)


def _rugs(rug: Step) -> None:
    for part, colour in zip(rug.split(1, 1), _CARPETS, strict=True):
        part.do(Extrude(height=0.012, colour=colour))


def _sofas(sofa: Step) -> None:
    for part, cover in zip(sofa.split(1, 1), _COVERS, strict=True):
        for side in ("left", "right"):
            part_of(part, "Arm", Shape(width=0.18, across=side)).do(Extrude(height=0.6, colour=cover))
        part_of(part, "Back", Shape(height=0.2, up="top")).do(Extrude(height=0.82, colour=cover))
        middle = part_of(part, "Middle", Shape(width=1.82), Shape(height=0.68, up="bottom"))
        seats = middle.do(Array(label="Seat", each_width=0.9, gap_across=0.01))
        seats.do(Extrude(base=0.3, height=0.16, colour=_LINEN))
        part_of(part, "Frame").do(Extrude(height=0.3, colour=cover))


def _benches(bench: Step) -> None:
    screen = part_of(bench, "Screen", Shape(width=1.3, height=0.05))
    screen.do(Extrude(base=0.5, height=0.72, colour=_BLACK))
    part_of(bench, "Chest").do(Extrude(height=0.45, colour=_OAK))


def _shelves(shelf: Step) -> None:
    built = shelf.do(Extrude(height=2.0, colour=_WALNUT))
    built.select("Left").do(Vary(facade=design("shelf.xml", _FOLDER)))


def _plants(plant: Step) -> None:
    leaves = Extrude(
        base=0.45, height=0.5, random=0.3, cap="hip", pitch=55, colour=_GREEN, roof_colour=_GREEN
    )
    part_of(plant, "Leaves", Shape(sides=8, inset=-0.08)).do(leaves)
    part_of(plant, "Pot", Shape(sides=8, inset=0.06)).do(Extrude(height=0.45, colour=_CLAY))


def _shell(session: Recorder) -> None:
    """Build walls, cut at the height of the elbow, windows, leaves of open doors; then floors."""
    session.select("Wall").do(Extrude(height=1.25, colour=_PLASTER, roof_colour=(120, 116, 110)))
    window = session.select("Window")
    part_of(window, "Pane", Shape(height=0.04)).do(Extrude(base=0.8, height=0.45, colour=_GLASS))
    window.do(Extrude(height=0.8, colour=_PLASTER, roof_colour=_WHITE))
    session.select("Door").do(Shape(width=0.05, across="left")).do(Extrude(height=1.25, colour=_OAK))
    session.select("Kitchen", "Hall", "Threshold").do(Extrude(height=-0.1, colour=(222, 220, 212)))
    session.select("Bedroom", "LivingRoom").do(Extrude(height=-0.1, colour=(222, 192, 152)))


def _put(
    room: Step,
    label: str,
    *shown: Sequence[Box],
    settings: LearningSettings = _OWN_SIZE,
    like: Place = _ONE,
) -> Step:
    """Place shapes as in the example rooms of a kind: centres and sizes in each room's own coordinates."""
    return room.place(label, _in(room, shown), settings, like)


def _in(where: Step, shown: Sequence[Sequence[Box]]) -> dict[str, list[Placement]]:
    """Return examples by the names of rooms, or of what there is in each of them."""
    return {
        name: [Placement(x + APART * number, y, width, height) for x, y, width, height in boxes]
        for number, (name, boxes) in enumerate(zip(where.output, shown, strict=False))
    }
