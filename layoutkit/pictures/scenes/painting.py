"""Scenes in pixels: polygons coloured by label, inner ones upon outer ones, placements outlined."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from layoutkit.model import Polygon, Scene
from layoutkit.pictures.legend import with_legend
from layoutkit.pictures.palette import colour_of_labels, darker
from layoutkit.pictures.scenes.frame import Frame, ground
from layoutkit.pictures.scenes.marks import number_placements, outline_placements, stroke
from layoutkit.pictures.scenes.meanings import entries, meanings
from layoutkit.pictures.scenes.order import outermost_first

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: Pixels of the longer side of a picture of a scene without a photo.
NATURAL = 1200
#: The longest side of a picture, in pixels, unless asked otherwise.
LONGEST = 2400
#: How much of a photo polygons cover, of 255.
OVER_PHOTO = 72
#: Lines are this share of a picture's shorter side wide, but at least a pixel.
LINE = 1 / 400
#: What is drawn is drawn so many times as large: edges at any angle are then smooth.
SMOOTH = 2

BACKGROUND = "#ffffff"


def render_scene(
    scene: Scene, photo: Image | None = None, *, scale: float = 1.0, longest: int = LONGEST
) -> Image:
    """Return a picture of a scene, with a legend that says which colour is which label.

    The legend stands below, or beside what is much higher than wide; the parameters are those of `drawing`.
    A scene without any shape has none.
    """
    page, found = drawing(scene, photo, scale=scale, longest=longest), meanings(scene)
    return with_legend(page, entries(found)) if found else page


def drawing(scene: Scene, photo: Image | None = None, *, scale: float = 1.0, longest: int = LONGEST) -> Image:
    """Return a picture of a scene without a legend.

    Polygons are coloured by label, over the photo if there is one; edges and corners that have labels of
    their own are drawn in their colours. Placements are outlined, with half an arrow along their own x axis;
    those with scores are numbered in their order. Lines and numbers are smaller on small shapes.

    Parameters
    ----------
    photo
        The part of the scene's picture that it covers.
    scale
        Size, as a multiple of the photo's own, or of 1200 pixels where there is none.
    longest
        Greatest width or height in pixels; a larger picture is made smaller as a whole.
    """
    frame = frame_of(scene, photo, scale, longest)
    page = painted(scene, frame, photo)
    number_placements(page, frame, scene.placements)
    return page


def frame_of(scene: Scene, photo: Image | None, scale: float = 1.0, longest: int = LONGEST) -> Frame:
    """Return the frame of a picture of a scene."""
    frame = Frame.around(scene, NATURAL * scale)
    if photo is not None:
        x0, y0, x1, y1 = ground(scene)
        natural = max(photo.width, photo.height) / (max(x1 - x0, y1 - y0) or 1.0)
        frame = Frame.around(scene, max(frame.columns, frame.rows) * natural * scale / frame.zoom)
    return frame if max(frame.columns, frame.rows) <= longest else Frame.around(scene, longest)


def painted(scene: Scene, frame: Frame, photo: Image | None) -> Image:
    """Return a picture of a scene in a frame, placements outlined but not numbered."""
    large = frame.times(SMOOTH)
    page = _ground(scene, large, photo)
    line = line_of(large)
    page.paste(*_layer(scene.polygons, large, line, 255 if photo is None else OVER_PHOTO))
    outline_placements(page, large, scene.placements, 2 * line, SMOOTH)
    return page.reduce(SMOOTH)


def line_of(frame: Frame) -> int:
    """Return how many pixels the lines of a picture are wide."""
    return max(1, round(min(frame.columns, frame.rows) * LINE))


def _ground(scene: Scene, frame: Frame, photo: Image | None) -> Image:
    """Return what polygons are painted on: the photo in its place, or nothing."""
    from PIL import Image

    page = Image.new("RGB", (frame.columns, frame.rows), BACKGROUND)
    if photo is not None:
        left, top, right, bottom = frame.cell(ground(scene))
        page.paste(photo.resize((right - left, bottom - top), Image.Resampling.LANCZOS), (left, top))
    return page


def _layer(
    polygons: Sequence[Polygon], frame: Frame, line: int, cover: int
) -> tuple[Image, tuple[int, int], Image]:
    """Return polygons, where they are to be pasted, and how much they cover: outlines all of it."""
    from PIL import Image, ImageDraw

    size = (frame.columns, frame.rows)
    layer, mask = Image.new("RGB", size, BACKGROUND), Image.new("L", size, 0)
    draw, cut = ImageDraw.Draw(layer), ImageDraw.Draw(mask)
    for polygon in outermost_first(polygons):
        colour, ring = colour_of_labels(polygon.labels), frame.pixels(polygon.points)
        around = [*ring, *ring[:2]]
        thin = round(stroke(side_of(ring), line, 1))
        draw.polygon(ring, colour)
        cut.polygon(ring, cover)
        draw.line(around, darker(colour), thin, joint="curve")
        cut.line(around, 255, thin, joint="curve")
    for polygon in polygons:
        _own_labels(draw, cut, polygon, frame.pixels(polygon.points), line)
    return layer, (0, 0), mask


def _own_labels(
    draw: ImageDraw, cut: ImageDraw, polygon: Polygon, ring: Sequence[tuple[float, float]], line: int
) -> None:
    """Draw the edges and corners that have labels of their own."""
    thick = max(line, round(stroke(side_of(ring), 3 * line, 1)))
    for index, labels in polygon.edges:
        ends = [ring[index], ring[(index + 1) % len(ring)]]
        draw.line(ends, colour_of_labels(labels), thick)
        cut.line(ends, 255, thick)
    for index, labels in polygon.corners:
        draw.circle(ring[index], thick, colour_of_labels(labels))
        cut.circle(ring[index], thick, 255)


def side_of(ring: Sequence[tuple[float, float]]) -> float:
    """Return the shorter side of the upright box about some points."""
    xs, ys = [x for x, _ in ring], [y for _, y in ring]
    return min(max(xs) - min(xs), max(ys) - min(ys))
