"""Pictures of worlds: seen from above and from one side, without perspective, in sun and shadow.

>>> for side in SIDES:
...     path.write_bytes(png_bytes(render_view(world, side)))
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.model.scene import Polygon
from layoutkit.model.world import Vector, World
from layoutkit.pictures.worlds.camera import Camera, Floats, bearing_of
from layoutkit.pictures.worlds.floor import SMOOTH, Floor
from layoutkit.pictures.worlds.gathered import Gathered, Integers, gather
from layoutkit.pictures.worlds.light import SHADE, SHADE_ON_PAGE, Sun
from layoutkit.pictures.worlds.lines import lines
from layoutkit.pictures.worlds.raster import BATCH, rasterise
from layoutkit.pictures.worlds.textures import Colours, painted

if TYPE_CHECKING:
    from PIL.Image import Image

#: Two sides, opposite each other: between them they show every wall.
SIDES = ("south-west", "north-east")
#: Greatest columns and rows of a picture, unless asked otherwise.
SIZE = (1600, 1000)
#: How high above the ground the viewer stands, in degrees.
ELEVATION = 33.0
#: From lower down the ground would be a line.
LOWEST = 1.0
#: What stays free about a world, as a share of the picture's longer side.
MARGIN = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Shown:
    """What is seen in each pixel, before light falls on it.

    Attributes
    ----------
    triangles, corners
        Those that face the viewer; where they are in the picture, shape (triangles, 3, 2), in pixels.
    triangle, depth
        Shape (rows, columns): the number of the triangle, -1 for the ground; how deep it is, in pixels.
    colours
        Shape (rows, columns, 3): red, green and blue, 0 to 255.
    """

    triangles: Gathered
    corners: Floats
    triangle: Integers
    depth: Floats
    colours: Colours


def render_view(
    world: World,
    side: str | float = SIDES[0],
    size: tuple[int, int] = SIZE,
    *,
    elevation: float = ELEVATION,
) -> Image:
    """Return a picture of a world: an axonometric view from above.

    Polygons of the ground are coloured by label, smaller ones upon larger ones. Bodies show the colours or
    pictures of their skins, lit by a sun behind the viewer's left shoulder, and cast shadows. The picture is
    as high and wide as the world needs. The same world gives the same pixels.

    Parameters
    ----------
    side
        Where the viewer stands: a direction of the compass by name (``south-west``), or in degrees from north
        over east.
    size
        Greatest columns and rows.
    elevation
        How high the viewer stands, in degrees above the ground: from 1 to 90, from straight above. Rooms with
        walls are best seen from 50 or more.

    Raises
    ------
    Faulty
        If there is no such side or elevation (LK701), or a picture cannot be read (LK010).
    """
    from PIL import Image

    bearing = bearing_of(side)
    _check(elevation)
    centre = _centre(world)
    triangles, rings = gather(world.bodies, centre), [_ring(polygon, centre) for polygon in world.ground]
    points = np.concatenate([triangles.corners.reshape(-1, 3), *rings])
    camera = Camera.from_side(bearing, elevation).around(points, size, MARGIN).times(SMOOTH)
    floor, sun = Floor.of(world.ground, rings, camera), Sun.over(triangles, bearing, camera.size)
    shown = _with_bodies(floor, triangles, camera, world.pictures)
    drawn = _lit(shown, floor.covered, camera, sun)
    drawn *= lines(shown.triangle, shown.triangles, shown.corners, camera.zoom)[:, :, None]
    return Image.fromarray(np.clip(np.rint(drawn), 0, 255).astype(np.uint8)).reduce(SMOOTH)


def _check(elevation: float) -> None:
    if not LOWEST <= elevation <= 90.0:
        message, hint = f"an elevation of {elevation:g} degrees shows no ground", "give one from 1 to 90"
        raise Faulty([Diagnostic("LK701", message, hint=hint, topic="usage")])


def _centre(world: World) -> Vector:
    """Return the middle of what the world covers, on the ground."""
    spots = [point for polygon in world.ground for point in polygon.points]
    for body in (body for body in world.bodies if len(body.points)):
        for x, y, _ in (body.points.min(axis=0), body.points.max(axis=0)):
            spots.append((body.origin[0] + float(x), body.origin[1] + float(y)))
    if not spots:
        return 0.0, 0.0, 0.0
    xs, ys = [x for x, _ in spots], [y for _, y in spots]
    return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, 0.0


def _ring(polygon: Polygon, centre: Vector) -> Floats:
    """Return the corners of a polygon of the ground, shape (points, 3), counted from the centre."""
    flat = np.array(polygon.points, dtype=float).reshape(-1, 2) - np.array(centre[:2])
    return np.concatenate([flat, np.zeros((len(flat), 1))], axis=1)


def _with_bodies(floor: Floor, triangles: Gathered, camera: Camera, pictures: Mapping[str, bytes]) -> Shown:
    """Return what is seen of the ground and of bodies, as it is before light falls on it."""
    facing = triangles.seen_from(camera.toward)
    corners = camera.pixels(facing.corners)
    raster = rasterise(corners, camera.depths(facing.corners), camera.size)
    ground = np.broadcast_to(camera.deep_ground(), raster.depth.shape)
    # A pixel's depth is that of its middle: what stands on the ground may be a little below it.
    buried = floor.covered & (raster.depth > ground + 1.0)
    triangle = np.where(buried, -1, raster.triangle)
    colours = np.asarray(floor.image).reshape(-1, 3).astype(np.float32)
    solid = np.flatnonzero(triangle >= 0)
    seen, centres = triangle.ravel()[solid], camera.centres(solid)
    colours[solid] = painted(facing, corners, seen, centres, pictures)
    depth = np.where(triangle < 0, ground, raster.depth)
    return Shown(facing, corners, triangle, depth, colours.reshape(*triangle.shape, 3))


def _lit(shown: Shown, covered: NDArray[np.bool_], camera: Camera, sun: Sun) -> Colours:
    """Return the colours of pixels in sun and shadow, some of the ground covered by polygons."""
    lit, triangle = shown.colours.reshape(-1, 3).copy(), shown.triangle.ravel()
    for pixels, points in _points(triangle >= 0, shown.depth, camera):
        lit[pixels] *= sun.light(points, shown.triangles.normals[triangle[pixels]])
    for pixels, points in _points(triangle < 0, shown.depth, camera):
        dark = pixels[sun.leaves_dark(points)]
        lit[dark] *= np.where(covered.ravel()[dark, None], SHADE, SHADE_ON_PAGE)
    return lit.reshape(shown.colours.shape)


def _points(chosen: NDArray[np.bool_], depth: Floats, camera: Camera) -> Iterator[tuple[Integers, Floats]]:
    """Yield numbers of pixels, and the points of the world that they show, some at a time."""
    pixels, deep = np.flatnonzero(chosen), depth.ravel()
    for begin in range(0, len(pixels), BATCH):
        part = pixels[begin : begin + BATCH]
        yield part, camera.points(camera.centres(part), deep[part])
