"""SVG drawings: what is filled or closed becomes a polygon, y turned upwards.

svgelements parses them: it knows all of paths, units, transforms, nested drawings, and `use`, in one module
of pure Python without dependencies.
"""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Scene
from layoutkit.model.face import Point
from layoutkit_formats.scenes.drawing import Drawing, loaded, unreadable
from layoutkit_formats.scenes.expansion import expanded
from layoutkit_formats.scenes.labels import labels
from layoutkit_formats.scenes.nesting import nested

#: Curves are drawn as chords that turn by this many degrees at most, so that features take them for round.
_TURN = 12.0
#: More chords than this no curve needs.
_MOST = 256
#: Fewer might miss a wave.
_FEWEST = 4
#: How much of a chord shows the tangent at an end, where the next curve goes on.
_NEAR = 1 / 16
#: Elements that a drawing may have once every `use` is written out.
ELEMENT_LIMIT = 200_000
_NUMBER = re.compile(r"[\W_]*\d+$")


class SvgFormat(SceneFormat):
    """Reads shapes, paths and groups, in pixels."""

    name = "svg"
    summary = "SVG: closed or filled shapes, labelled by data-labels or class, their group's, or their id."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file is XML whose root is `<svg>`."""
        text = head.decode("utf-8", "replace")
        return re.search(r"<(?:\w+:)?svg[\s>]", re.sub(r"<!--.*?-->", "", text, flags=re.S)) is not None

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene, in pixels as a browser shows the drawing."""
        from svgelements import Path as Outline
        from svgelements import Shape

        svg = _parsed(path)
        drawing = Drawing(path)
        found = []
        for element, inherited in _leaves(svg):
            if isinstance(element, Shape):
                found.append((element, inherited, list(_outlines(abs(Outline(element))))))
            else:
                drawing.leave_out(type(element).__name__)
        height = _height(svg, [p for _, _, outlines in found for points, _ in outlines for p in points])
        for shape, inherited, outlines in found:
            own = _labels(shape) or inherited
            filled = shape.fill is not None and shape.fill.value is not None
            rings = [[(x, height - y) for x, y in points] for points, closed in outlines if closed or filled]
            if not rings:
                drawing.leave_out("line that is neither closed nor filled")
            name = str(shape.id or "")
            for polygon in nested(rings):
                drawing.add(polygon, own or labels([_NUMBER.sub("", name)]), name)
        return drawing.scene(path.stem, "px")


def _parsed(path: Path) -> Any:
    from xml.etree import ElementTree

    from svgelements import SVG

    data = loaded(path)
    try:
        root = ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        line, column = error.position
        raise unreadable(path, f"the file is not XML: {error.msg}", line, column + 1) from None
    except (LookupError, ValueError) as error:
        raise unreadable(path, f"the file is not XML: {error}") from None
    if expanded(root) > ELEMENT_LIMIT:
        raise unreadable(path, f"the drawing has more than {ELEMENT_LIMIT:,} elements, those of use included")
    for element in root.iter():
        if element.tag.endswith("path") and "d" not in element.attrib:
            element.set("d", "")  # svgelements fails without one
    try:
        found = SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=True)
    except Exception as error:  # svgelements lets errors of all kinds through
        raise unreadable(path, f"the drawing cannot be read: {error}") from None
    if not isinstance(found, SVG):
        raise unreadable(path, "the root of the file is no <svg>")
    return found


def _leaves(svg: Any) -> Iterator[tuple[Any, tuple[str, ...]]]:
    """Yield what is drawn, with the labels of the innermost group that has some."""
    from svgelements import SVG, Group, Use

    pending: list[tuple[Any, tuple[str, ...]]] = [(svg, ())]
    while pending:
        element, inherited = pending.pop()
        if isinstance(element, (Group, Use)):
            own = () if isinstance(element, SVG) else _labels(element)
            pending += ((child, own or inherited) for child in reversed(element))
        else:
            yield element, inherited


def _labels(element: Any) -> tuple[str, ...]:
    """Return the labels that an element says itself, in `data-labels` or in `class`."""
    values = element.values.get("attributes") or {}
    return labels((values.get("data-labels") or values.get("class") or "").replace(",", " ").split())


def _outlines(outline: Any) -> Iterator[tuple[list[Point], bool]]:
    """Yield the points of each run of a path, and whether it is closed."""
    from svgelements import Close, Move

    points: list[Point] = []
    for segment in outline:
        if isinstance(segment, Move):
            if len(points) > 1:
                yield points, points[0] == points[-1]
            points = [_point(segment.end)]
        elif isinstance(segment, Close):
            if len(points) > 1:
                yield points, True
            points = points[:1]
        else:
            points += _flattened(segment)
    if len(points) > 1:
        yield points, points[0] == points[-1]


def _flattened(segment: Any) -> list[Point]:
    """Return the points of a segment behind its first."""
    from svgelements import Line

    if isinstance(segment, Line):
        return [_point(segment.end)]
    count = 1
    while count < _MOST:
        count *= 2
        line = [_point(segment.start), *(_point(segment.point(k / count)) for k in range(1, count))]
        line.append(_point(segment.end))
        ends = [_point(segment.point(share)) for share in (_NEAR / count, 1 - _NEAR / count)]
        if count >= _FEWEST and _sharpest([line[0], ends[0], *line[1:-1], ends[1], line[-1]]) <= _TURN:
            break
    return line[1:]


def _sharpest(line: Sequence[Point]) -> float:
    """Return by how many degrees a line turns at most."""
    steps = [(bx - ax, by - ay) for (ax, ay), (bx, by) in pairwise(line) if (ax, ay) != (bx, by)]
    angles = [math.atan2(dy, dx) for dx, dy in steps]
    return max((abs(math.degrees(math.remainder(b - a, math.tau))) for a, b in pairwise(angles)), default=0.0)


def _point(point: Any) -> Point:
    return float(point.x), float(point.y)


def _height(svg: Any, points: Sequence[Point]) -> float:
    """Return where y is turned about: the height of the page; of a drawing without one, its lowest point."""
    sized = svg.values.get("attributes", {}).keys() & {"height", "viewBox"}
    if sized and isinstance(svg.height, (int, float)) and math.isfinite(svg.height):
        return float(svg.height)
    return max((y for _, y in points if math.isfinite(y)), default=0.0)
