"""Pictures of scenes as SVG: every polygon tells its name, every placement its score."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

from layoutkit.model import Placement, Polygon, Scene
from layoutkit.model.face import Point
from layoutkit.pictures.palette import colour_of_labels, darker
from layoutkit.pictures.scenes.frame import Frame, ground
from layoutkit.pictures.scenes.marks import PLACED, arrow, stroke
from layoutkit.pictures.scenes.meanings import meanings
from layoutkit.pictures.scenes.order import outermost_first
from layoutkit.pictures.scenes.painting import LINE, OVER_PHOTO, side_of
from layoutkit.pictures.scenes.svg_legend import Legend
from layoutkit.pictures.svg import SHOWN, hexadecimal, legal, tooltip

if TYPE_CHECKING:
    from PIL.Image import Image


def render_scene_svg(scene: Scene, photo: Image | None = None) -> bytes:
    """Return an SVG drawing of a scene, in document units, y flipped.

    A legend below, or beside what is much higher than wide, says which colour is which label.
    Polygons have their name and labels as tooltip, placements their label, size and score; `data-name`,
    `data-labels` and `data-score` serve style sheets and scripts. A photo is embedded. The same scene gives
    the same bytes.

    Parameters
    ----------
    photo
        The part of the scene's picture that it covers.
    """
    return "\n".join([*_lines(scene, photo), ""]).encode()


def _lines(scene: Scene, photo: Image | None) -> Iterator[str]:
    frame = Frame.around(scene, SHOWN)
    x0, y0, x1, y1 = frame.bounds
    legend = Legend.of(meanings(scene), frame)
    across, down = legend.size
    box = " ".join(map(number, (x0, -y1, across / frame.zoom, down / frame.zoom)))
    line = min(x1 - x0, y1 - y0) * LINE
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" width="{across}" height="{down}" viewBox="{box}">')
    yield f"<title>{tooltip([scene.name])}</title>"
    if photo is not None:
        yield _image(photo, *ground(scene))
    cover = "" if photo is None else f' fill-opacity="{number(OVER_PHOTO / 255)}"'
    yield f'<g stroke-width="{number(line)}" stroke-linejoin="round"{cover}>'
    for polygon in outermost_first(scene.polygons):
        yield _polygon(polygon, line)
    for polygon in scene.polygons:
        yield from _own_labels(polygon, line)
    yield "</g>"
    yield f'<g stroke-width="{number(2 * line)}" stroke-linejoin="round" stroke="{hexadecimal(PLACED)}">'
    for position, placement in enumerate(scene.placements, 1):
        yield _placement(placement, position, scene.units, (2 * line, 1 / frame.zoom))
    yield "</g>"
    yield from legend.lines()
    yield "</svg>"


def _image(photo: Image, x0: float, y0: float, x1: float, y1: float) -> str:
    buffer = io.BytesIO()
    photo.save(buffer, "JPEG", quality=88)
    data = base64.b64encode(buffer.getvalue()).decode()
    return (
        f'<image x="{number(x0)}" y="{number(-y1)}" width="{number(x1 - x0)}" height="{number(y1 - y0)}"'
        f' preserveAspectRatio="none" href="data:image/jpeg;base64,{data}"/>'
    )


def _polygon(polygon: Polygon, line: float) -> str:
    colour, labels = colour_of_labels(polygon.labels), " ".join(polygon.labels)
    thin = stroke(side_of(polygon.points), line, line / 4)
    return (
        f"<polygon data-name={quoteattr(legal(polygon.name))} data-labels={quoteattr(legal(labels))}"
        f' points="{_points(polygon.points)}" fill="{hexadecimal(colour)}"'
        f' stroke="{hexadecimal(darker(colour))}" stroke-width="{number(thin)}">'
        f"<title>{tooltip([polygon.name, labels])}</title></polygon>"
    )


def _own_labels(polygon: Polygon, line: float) -> Iterator[str]:
    """Yield the edges and corners that have labels of their own."""
    points = polygon.points
    thick = max(line, stroke(side_of(points), 3 * line, line))
    for index, labels in polygon.edges:
        shape = (
            f'<polyline points="{_points((points[index], points[(index + 1) % len(points)]))}" fill="none"'
        )
        colour = hexadecimal(colour_of_labels(labels))
        yield f'{shape} stroke="{colour}" stroke-width="{number(thick)}">{_title(labels)}</polyline>'
    for index, labels in polygon.corners:
        (x, y), colour = points[index], hexadecimal(colour_of_labels(labels))
        shape = f'<circle cx="{number(x)}" cy="{number(-y)}" r="{number(thick)}" stroke="none"'
        yield f'{shape} fill="{colour}" fill-opacity="1">{_title(labels)}</circle>'


def _title(labels: Iterable[str]) -> str:
    return f"<title>{tooltip([' '.join(labels)])}</title>"


def _placement(placement: Placement, position: int, units: str, lines: tuple[float, float]) -> str:
    """Return a placement, its lines between the widest and the narrowest as goes with its size."""
    width = stroke(min(placement.width, placement.height), *lines)
    size = f"{number(placement.width)} × {number(placement.height)} {units}, {number(placement.angle)}°"
    score = "" if placement.score is None else f"score {placement.score:.3g}"
    told = tooltip([f"{position} {placement.label}".rstrip(), size, score, "mirrored" * placement.mirrored])
    kept = f' data-score="{number(placement.score)}"' if placement.score is not None else ""
    return (
        f'<g data-label={quoteattr(legal(placement.label))}{kept} stroke-width="{number(width)}">'
        f'<polygon points="{_points(placement.points)}" fill="{hexadecimal(PLACED)}" fill-opacity="0.12"/>'
        f'<polyline points="{_points(arrow(placement))}" fill="none"/><title>{told}</title></g>'
    )


def _points(points: Iterable[Point]) -> str:
    return " ".join(f"{number(x)},{number(-y)}" for x, y in points)


def number(value: float) -> str:
    """Return a number without the noise of floats: coordinates of maps have many digits that count."""
    return f"{value:.10g}"
