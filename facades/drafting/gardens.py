"""A garden is planted: trees along paths, hedged beds, benches, a pavilion, a pergola and a fountain."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from facades.drafting.parks import APART, examples, park, pond_example
from facades.drafting.parts import part_of
from layoutkit.model import LearningSettings, Placement, Scene
from layoutkit.operations import Operations
from layoutkit.operations.attributes import Colour
from layoutkit_operations.kinds.array import Array
from layoutkit_operations.kinds.boolean import Boolean
from layoutkit_operations.kinds.delete import Delete
from layoutkit_operations.kinds.extrude import Extrude
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.shape import Shape
from layoutkit_operations.kinds.vary import Vary
from layoutkit_operations.recording import Recorder, Step, design

_FOLDER = Path(__file__).parents[1] / "park"

_STONE, _SLATE, _WATER, _SOIL = (212, 204, 188), (112, 122, 136), (126, 176, 200), (112, 86, 64)
_BARK, _OAK, _WHITE = (110, 84, 62), (176, 138, 96), (236, 232, 222)
_LAWN, _SAND, _HEDGE = (158, 190, 116), (226, 210, 176), (84, 122, 70)
_LEAVES = ((98, 142, 74), (122, 158, 82), (82, 126, 84))
_BLOSSOM, _FIR = (224, 172, 178), (62, 104, 80)
_FLOWERS = ((206, 86, 78), (236, 190, 84), (150, 116, 178), (240, 236, 226))

#: Strips of any length along an edge are alike; others keep nearly to their size.
_ANY_LENGTH = LearningSettings(area_tolerance=0.0, shape_tolerance=0.0)
_OWN_SIZE = LearningSettings()

#: One in each part, even where parts are little like the examples.
_ONE = Place(limit=1, threshold=0.15)

#: Centre and size of a box.
Box = tuple[float, float, float, float]


def scenes() -> tuple[Scene, ...]:
    """Return what is planted."""
    return (park(),)


def operations() -> Operations:
    """Return the sessions in which parts of a garden were planted, one for each kind of part."""
    sessions = (
        _session(pond_example(), "Pond", _ponds),
        _session(examples("Lawn"), "Lawn", _lawns),
        _session(examples("Lawn"), "Bed", _beds),
        _session(examples("Plaza"), "Plaza", _plazas),
        _session(examples("Terrace"), "Terrace", _terraces),
        _session(examples("Walk"), "Walk", _walks),
        _session(park(), "Path", lambda path: path.do(Extrude(height=-0.1, colour=_SAND))),
    )
    return Operations("park", "m", tuple(n for s in sessions for n in s.operations("part").roots))


def _session(scene: Scene, label: str, plant: Callable[[Step], object]) -> Recorder:
    session = Recorder(scene)
    plant(session.select(label))
    return session


def _ponds(pond: Step) -> None:
    """Build a rim about the water, and a fountain in it."""
    _hollowed(pond, "Rim", Shape(sides=24, inset=-0.5), Shape(sides=24), Extrude(height=0.45, colour=_STONE))
    part_of(pond, "Column", Shape(width=0.7, height=0.7, sides=8)).do(Extrude(height=1.2, colour=_STONE))
    bowl = part_of(pond, "Bowl", Shape(width=2.2, height=2.2, sides=16))
    bowl.do(Extrude(base=1.2, height=0.2, colour=_STONE, roof_colour=_WATER))
    jet = Extrude(base=1.4, height=0.2, cap="hip", pitch=80, colour=_WATER, roof_colour=(214, 234, 242))
    part_of(pond, "Jet", Shape(width=0.4, height=0.4, sides=8)).do(jet)
    pond.do(Shape(inset=0.01)).do(Extrude(height=0.3, colour=_WATER))


def _hollowed(whole: Step, label: str, outer: Shape, inner: Shape, wall: Extrude) -> None:
    """Build a wall along an outline: what is within it is taken away."""
    part_of(whole, "Hollow", inner).do(Extrude(height=1.0, colour=wall.colour))
    part_of(whole, label, outer).do(wall).do(Boolean(action="difference", with_="intersecting"))
    whole.select("Hollow").do(Delete())


def _beds(bed: Step) -> None:
    """Build a low hedge about soil, and plant flowers of several colours."""
    hedge = Extrude(height=0.5, random=0.1, colour=_HEDGE)
    _hollowed(bed, "Edging", Shape(inset=0.01), Shape(inset=0.4), hedge)
    part_of(bed, "Soil", Shape(inset=0.41)).do(Extrude(height=0.12, colour=_SOIL))
    plants = bed.do(
        Array(label="Flower", each_width=0.42, each_height=0.42, gap_across=0.16, gap_up=0.16, margin=0.55)
    )
    stalk = part_of(plants, "Stalk", Shape(sides=6, inset=0.1))
    stalk.do(Extrude(base=0.1, height=0.3, random=0.2, colour=_HEDGE))
    for part, colour in zip(plants.split(1, 1, 1, 1), _FLOWERS, strict=True):
        blossom = Extrude(
            base=0.3, height=0.1, random=0.3, cap="hip", pitch=40, colour=colour, roof_colour=colour
        )
        part.do(Shape(sides=6)).do(blossom)


def _lawns(lawn: Step) -> None:
    rows = _put(
        lawn,
        "TreeRow",
        [(15.0, 2.6, 16.0, 2.4), (2.6, 12.0, 2.4, 10.0)],
        [(13.0, 2.6, 12.0, 2.4), (2.6, 14.0, 2.4, 14.0)],
        settings=_ANY_LENGTH,
        like=Place(limit=2, threshold=0.15),
    )
    behind = _put(
        lawn,
        "Hedge",
        [(12.8, 19.6, 24.8, 0.8)],
        [(8.8, 23.6, 16.8, 0.8)],
        [(7.5, 16.6, 14.2, 0.8)],
        settings=_ANY_LENGTH,
        like=_ONE,
    ).do(Shape(snap=0.8, height=0.8, up="top"))
    beside = _put(
        lawn,
        "Hedge",
        [(25.6, 9.9, 0.8, 18.2)],
        [(21.6, 10.2, 0.8, 18.8)],
        [(19.6, 6.2, 0.8, 11.2)],
        settings=_ANY_LENGTH,
        like=_ONE,
    ).do(Shape(snap=0.8, width=0.8, across="right"))
    bench = _put(
        lawn,
        "Bench",
        [(10.0, 0.7, 1.8, 0.6), (20.0, 0.7, 1.8, 0.6)],
        [(9.0, 0.7, 1.8, 0.6), (17.0, 0.7, 1.8, 0.6)],
        like=Place(limit=2, threshold=0.15),
    )
    grove = _put(
        lawn,
        "Grove",
        [(16.0, 15.0, 3.8, 3.8), (7.0, 15.5, 3.8, 3.8), (22.0, 15.5, 3.8, 3.8)],
        [(16.0, 19.0, 3.8, 3.8), (8.0, 19.0, 3.8, 3.8), (16.5, 12.0, 3.8, 3.8)],
        like=Place(limit=3, threshold=0.1),
    ).do(Shape(width=2.8, height=2.8))
    trees = rows.do(Array(label="Tree", each_width=2.4, each_height=2.4, gap_across=1.0, gap_up=1.0))
    for part, leaves in zip(trees.split(1, 1, 1), _LEAVES, strict=True):
        _tree(part, 2.0, 1.1, leaves)
    first, second = grove.split(3, 2)
    _fir(first)
    _tree(second, 1.8, 1.0, _BLOSSOM)
    for hedge in (behind, beside):
        hedge.do(Extrude(height=1.3, random=0.08, colour=_HEDGE))
    _benches(bench)
    lawn.do(Extrude(height=-0.1, colour=_LAWN))


def _tree(tree: Step, trunk: float, crown: float, leaves: Colour) -> None:
    """Build a trunk, and a crown of three tiers."""
    part_of(tree, "Trunk", Shape(width=0.32, height=0.32, sides=8)).do(
        Extrude(height=trunk + 0.3, random=0.1, colour=_BARK)
    )
    for tier, (inset, base) in enumerate(((0.25, 0.0), (0.0, 0.45), (0.3, 0.45 + crown * 0.8))):
        crowns = part_of(tree, f"Crown_{tier + 1}", Shape(sides=8, inset=inset) if inset else Shape(sides=8))
        cap = Extrude(
            base=trunk + base,
            height=crown,
            random=0.12,
            cap="hip",
            pitch=42,
            colour=leaves,
            roof_colour=leaves,
        )
        crowns.do(cap)


def _fir(tree: Step) -> None:
    """Build a trunk and three cones, one above the other."""
    part_of(tree, "Trunk", Shape(width=0.35, height=0.35, sides=8)).do(Extrude(height=1.0, colour=_BARK))
    for tier, size in enumerate((2.8, 2.2, 1.5)):
        cone = Extrude(base=0.8 + 1.2 * tier, height=0.15, cap="hip", pitch=62, colour=_FIR, roof_colour=_FIR)
        part_of(tree, f"Crown_{tier + 1}", Shape(width=size, height=size, sides=8)).do(cone)


def _benches(bench: Step) -> None:
    seat = part_of(bench, "Seat", Shape(width=1.8, height=0.5))
    part_of(seat, "Back", Shape(height=0.06, up="top")).do(Extrude(base=0.44, height=0.45, colour=_OAK))
    for side in ("left", "right"):
        part_of(seat, "Leg", Shape(width=0.1, across=side)).do(Extrude(height=0.38, colour=_SLATE))
    seat.do(Extrude(base=0.38, height=0.06, colour=_OAK))


def _plazas(plaza: Step) -> None:
    """Put topiary in pots at the corners of the crossing."""
    corners = [(x * 4.1, y * 4.1, 0.9, 0.9) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    pots = _put(plaza, "Pot", corners, corners, like=Place(limit=4)).do(Shape(width=0.9, height=0.9))
    ball = Extrude(base=0.6, height=0.5, random=0.2, cap="hip", pitch=60, colour=_HEDGE, roof_colour=_HEDGE)
    part_of(pots, "Topiary", Shape(sides=8, inset=0.05)).do(ball)
    part_of(pots, "Box").do(Extrude(height=0.6, colour=_WHITE))
    plaza.do(Extrude(height=-0.1, colour=_SAND))


def _terraces(terrace: Step) -> None:
    hall = _put(terrace, "Pavilion", [(11.0, 5.8, 9.0, 6.0)], [(9.0, 5.2, 8.0, 5.4)], like=Place(limit=1))
    pots = _put(
        terrace,
        "Pot",
        [(2.5, 1.2, 0.9, 0.9), (19.5, 1.2, 0.9, 0.9)],
        [(2.5, 1.2, 0.9, 0.9), (15.5, 1.2, 0.9, 0.9)],
        like=Place(limit=2, threshold=0.15),
    ).do(Shape(width=0.9, height=0.9))
    part_of(hall, "Steps", Shape(inset=-0.35)).do(Extrude(height=0.2, colour=_STONE))
    roofed = Extrude(base=0.2, height=3.4, cap="hip", pitch=32, colour=_WHITE, roof_colour=_SLATE)
    walls = part_of(hall, "House").do(roofed)
    walls.select("Side").do(Vary(facade=design("pavilion.xml", _FOLDER)))
    cone = Extrude(base=0.6, height=0.2, cap="hip", pitch=72, colour=_FIR, roof_colour=_FIR)
    part_of(pots, "Topiary", Shape(sides=8, inset=0.05)).do(cone)
    part_of(pots, "Box").do(Extrude(height=0.6, colour=_WHITE))
    terrace.do(Extrude(height=-0.1, colour=_STONE))


def _walks(walk: Step) -> None:
    """Build a pergola over a walk: posts, beams along it, and rafters across."""
    bower = _put(
        walk,
        "Pergola",
        [(7.0, 1.8, 12.0, 3.0)],
        [(9.0, 1.8, 16.0, 3.0)],
        settings=_ANY_LENGTH,
        like=Place(limit=1),
    )
    bower = bower.do(Shape(height=3.0))
    posts = Array(label="Post", each_width=0.2, each_height=0.2, gap_across=2.0, gap_up=2.0, margin=0.1)
    bower.do(posts).do(Extrude(height=2.4, colour=_OAK))
    beams = Array(label="Beam", each_height=0.2, gap_up=2.0, margin=0.1)
    bower.do(beams).do(Extrude(base=2.4, height=0.16, colour=_OAK))
    rafters = bower.do(Array(label="Rafter", each_width=0.12, gap_across=0.5))
    rafters.do(Extrude(base=2.56, height=0.12, colour=_OAK))
    walk.do(Extrude(height=-0.1, colour=_SAND))


def _put(
    where: Step,
    label: str,
    *shown: Sequence[Box],
    settings: LearningSettings = _OWN_SIZE,
    like: Place = Place(),  # noqa: B008 - frozen
) -> Step:
    """Place shapes as in the first examples of a part: centres and sizes in coordinates of its own."""
    kind = where.output[0].rpartition("_")[0]
    examples = {
        f"{kind}_{number + 1}": [
            Placement(x + APART * number, y, width, height) for x, y, width, height in boxes
        ]
        for number, boxes in enumerate(shown)
    }
    return where.place(label, examples, settings, like)
