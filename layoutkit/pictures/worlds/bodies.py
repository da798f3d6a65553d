"""The bodies of a world as models show them: the ground's flat ones first, all counted from the middle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model.scene import Polygon
from layoutkit.model.world import Body, Skin, Vector, World
from layoutkit.pictures.palette import colour_of_labels

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: By how much a polygon of the ground lies above those that it covers, in units of the world.
LIFT = 0.01

#: The share of a polygon's area from which on it counts as covering another: neighbours touch, and no more.
_COVERED = 1e-6

#: The material of ground that has no label.
_GROUND = "Ground"


@dataclass(frozen=True, slots=True, eq=False)
class Corners:
    """The corners of a body's triangles: one for each place, and for each place in a picture that it shows.

    Attributes
    ----------
    places
        Shape (corners,): the number of the point that each is at.
    shares
        Shape (corners, 2): where in its picture each is, from left and bottom; None without pictures.
    triangles
        Shape (triangles, 3): numbers of corners.
    """

    places: NDArray[np.int64]
    shares: NDArray[np.float32] | None
    triangles: NDArray[np.int64]


def corners(body: Body) -> Corners:
    """Return the corners of a body, split only where its pictures ask for it."""
    import numpy as np

    pictured = np.array([bool(skin.picture) for skin in body.skins], dtype=bool)[body.skin]
    if not pictured.any():
        return Corners(np.arange(len(body.points)), None, body.triangles)
    shares = np.where(pictured[:, None, None], body.shares, 0.0).astype("<f4").reshape(-1, 2) + np.float32(0)
    kinds, kind = np.unique(np.ascontiguousarray(shares).view("<u8").ravel(), return_inverse=True)
    keys = body.triangles.ravel() * len(kinds) + kind
    _, first, corner = np.unique(keys, return_index=True, return_inverse=True)
    return Corners(body.triangles.ravel()[first], shares[first], corner.reshape(-1, 3))


def by_skin(body: Body) -> list[tuple[Skin, NDArray[np.int64]]]:
    """Return the numbers of a body's triangles by skin, those skins left out that none of them has."""
    import numpy as np

    order = np.argsort(body.skin, kind="stable")
    ends = np.searchsorted(body.skin[order], np.arange(1, len(body.skins)))
    runs = zip(body.skins, np.split(order, ends), strict=True) if body.skins else ()
    return [(skin, run) for skin, run in runs if len(run)]


def middle(world: World) -> Vector:
    """Return where models of a world have their origin: its middle in plan, in whole units, on the ground."""
    import numpy as np

    boxes = [np.array(polygon.points) for polygon in world.ground]
    boxes += [body.points[:, :2] + body.origin[:2] for body in world.bodies if len(body.points)]
    if not boxes:
        return 0.0, 0.0, 0.0
    low = np.min([box.min(axis=0) for box in boxes], axis=0)
    high = np.max([box.max(axis=0) for box in boxes], axis=0)
    x, y = (np.round((low + high) / 2) + 0.0).tolist()
    return x, y, 0.0


def shown(world: World) -> tuple[Body, ...]:
    """Return what is to be seen of a world: polygons of the ground as flat bodies, then its bodies."""
    lifts = _lifts(world.ground)
    flats = (_flat(polygon, LIFT * lift) for polygon, lift in zip(world.ground, lifts, strict=True))
    return (*flats, *world.bodies)


def _flat(polygon: Polygon, height: float) -> Body:
    """Return a polygon of the ground as a body that encloses nothing, to be seen from above."""
    import numpy as np
    from mapbox_earcut import triangulate_float64

    x, y = polygon.points[0]
    plan = np.array(polygon.points) - (x, y)
    cut = triangulate_float64(plan, np.array([len(plan)], dtype=np.uint32))
    triangles = np.array(cut, dtype=np.int64).reshape(-1, 3)
    one, other = plan[triangles[:, 1]] - plan[triangles[:, 0]], plan[triangles[:, 2]] - plan[triangles[:, 0]]
    under = one[:, 0] * other[:, 1] < one[:, 1] * other[:, 0]
    triangles[under] = triangles[under][:, ::-1]
    none = np.zeros(len(triangles), dtype=np.int64)
    skin = Skin(polygon.labels[0] if polygon.labels else _GROUND, colour_of_labels(polygon.labels))
    return Body(
        name=polygon.name,
        labels=polygon.labels,
        parent="",
        origin=(x, y, height),
        points=np.column_stack((plan, np.zeros(len(plan)))),
        triangles=triangles,
        surface=none,
        opening=none - 1,
        skin=none,
        shares=np.zeros((len(triangles), 3, 2)),
        surfaces=(),
        openings=(),
        skins=(skin,),
        closed=False,
    )


def _lifts(ground: Sequence[Polygon]) -> list[int]:
    """Return over how many others, one above another, each polygon lies: the smaller one over the larger."""
    import numpy as np
    import shapely

    outlines = shapely.make_valid([shapely.Polygon(polygon.points) for polygon in ground])
    areas = shapely.area(outlines)
    one, other = shapely.STRtree(outlines).query(outlines, predicate="intersects")
    # of equal ones, that which is listed first is below: as pictures of scenes have it
    below = (areas[one] > areas[other]) | ((areas[one] == areas[other]) & (one < other))
    one, other = one[below], other[below]
    common = shapely.area(shapely.intersection(outlines[one], outlines[other]))
    over = common > _COVERED * areas[other]
    covers: list[list[int]] = [[] for _ in ground]
    for low, high in zip(one[over].tolist(), other[over].tolist(), strict=True):
        covers[high].append(low)
    lifts = [0] * len(ground)
    for number in np.lexsort((np.arange(len(areas)), -areas)).tolist():
        lifts[number] = max((lifts[low] + 1 for low in covers[number]), default=0)
    return lifts
