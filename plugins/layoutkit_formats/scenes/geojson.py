"""GeoJSON (RFC 7946): polygons and multipolygons, their labels in properties."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Picture, Placement, Scene
from layoutkit.model.facade import Units
from layoutkit.model.face import Point
from layoutkit.model.scene import OwnLabels
from layoutkit_formats.scenes import geography
from layoutkit_formats.scenes.drawing import Drawing, Ring, loaded, unreadable
from layoutkit_formats.scenes.labels import label, labels

_TYPES = "FeatureCollection|Feature|Polygon|MultiPolygon|GeometryCollection"
#: Properties that say what a feature is; the first that is there counts.
_LABELS = ("labels", "label", "class")
_DEGREES = re.compile(r"CRS84|EPSG:+4326|WGS\s*84$", re.IGNORECASE)
_SIZES = ("x", "y", "width", "height", "angle")


class GeoJsonFormat(SceneFormat):
    """Reads feature collections, features and geometries."""

    name = "geojson"
    summary = "GeoJSON: polygons, labelled by their properties labels, label or class, and named by name."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file is a JSON object whose type is one of GeoJSON's."""
        text = head.decode("utf-8-sig", "replace")
        if not text.lstrip().startswith("{"):
            return False
        named = path.suffix.lower() == ".geojson"
        return named or re.search(rf'"type"\s*:\s*"({_TYPES})"', text) is not None

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene; what is no polygon is left out, holes are taken for filled."""
        data = _parsed(path)
        drawing = Drawing(path)
        features = list(_features(data))
        standing = [(properties, given) for properties, given in features if not _is_placement(properties)]
        shapes = [(own, rings) for own, given in standing for rings in _polygons(given, drawing)]
        taken = _projection(data, [rings for _, rings in shapes], drawing)
        for properties, rings in shapes:
            drawing.add(
                [list(map(taken, ring)) for ring in rings],
                _labels(properties),
                _text(properties.get("name")) or _text(properties.get("id")),
                _number(properties.get("angle")),
                edges=_own(properties.get("edges"), len(rings[0]) - 1),
                corners=_own(properties.get("corners"), len(rings[0]) - 1),
            )
        drawing.placements += (placed for properties, _ in features for placed in _placement(properties))
        told = data.get("scene")
        head = told if isinstance(told, dict) else {}
        units: Units = "px" if head.get("units") == "px" else "m"
        name = _text(head.get("name")) or _text(data.get("name")) or path.stem
        return drawing.scene(name, units, _picture(head.get("picture"), path))


def _parsed(path: Path) -> dict[str, Any]:
    try:
        data = json.loads(loaded(path))
    except json.JSONDecodeError as error:
        raise unreadable(path, f"the file is not JSON: {error.msg}", error.lineno, error.colno) from None
    except (ValueError, RecursionError) as error:
        raise unreadable(path, f"the file is not JSON: {error}") from None
    if not isinstance(data, dict) or not isinstance(data.get("type"), str):
        raise unreadable(path, "the file is no GeoJSON: it has no type")
    return data


def _features(data: dict[str, Any]) -> Iterator[tuple[dict[str, Any], Any]]:
    """Yield the properties of each feature, and its geometry."""
    if data["type"] == "FeatureCollection":
        for feature in _list(data.get("features")):
            if isinstance(feature, dict):
                properties = feature.get("properties")
                own = properties if isinstance(properties, dict) else {}
                identity = {"id": feature["id"]} if "id" in feature else {}
                yield {**identity, **own}, feature.get("geometry")
    elif data["type"] == "Feature":
        yield from _features({"type": "FeatureCollection", "features": [data]})
    else:
        yield {}, data


def _polygons(geometry: Any, drawing: Drawing, depth: int = 0) -> Iterator[list[Ring]]:
    """Yield the rings of each polygon of a geometry; what else there is, is counted as left out."""
    kind = geometry.get("type") if isinstance(geometry, dict) else None
    if kind == "GeometryCollection" and depth < _DEEPEST:
        for inner in _list(geometry.get("geometries")):
            yield from _polygons(inner, drawing, depth + 1)
        return
    coordinates = geometry.get("coordinates") if isinstance(geometry, dict) else None
    given = [coordinates] if kind == "Polygon" else _list(coordinates) if kind == "MultiPolygon" else []
    if kind not in ("Polygon", "MultiPolygon"):
        drawing.leave_out(str(kind) if kind else "feature without geometry")
    for rings in given:
        read = [_ring(ring) for ring in _list(rings)]
        if read and all(ring is not None for ring in read):
            yield [ring for ring in read if ring is not None]
        else:
            drawing.leave_out(f"{kind} with coordinates that are no numbers")


#: So deep collections may be nested in each other.
_DEEPEST = 20


def _ring(given: Any) -> list[Point] | None:
    """Return the points of a ring; None if they are none."""
    found = []
    for point in _list(given):
        x, y = (_number(v) for v in (*_list(point)[:2], None, None)[:2])
        if x is None or y is None:
            return None
        found.append((x, y))
    return found or None


def _projection(data: dict[str, Any], shapes: Sequence[Sequence[Ring]], drawing: Drawing) -> Any:
    """Return what takes coordinates to the plane; degrees are told by the file, or by their looks."""
    points = [point for rings in shapes for ring in rings for point in ring]
    if not points:
        return _as_it_is
    xs, ys = zip(*points, strict=True)
    bounds = min(xs), min(ys), max(xs), max(ys)
    system = data.get("crs")
    if isinstance(system, dict):
        told = system.get("properties")
        degrees = isinstance(told, dict) and bool(_DEGREES.search(str(told.get("name"))))
    else:
        degrees = "scene" not in data and geography.looks_like_degrees(bounds)
    if not degrees:
        return _as_it_is
    hint = "a member crs with the name of a plane system keeps coordinates as they are"
    drawing.remark("LK860", geography.REMARK, hint, Severity.NOTE)
    return geography.metres(bounds)


def _as_it_is(point: Point) -> Point:
    return point


def _labels(properties: Mapping[str, Any]) -> tuple[str, ...]:
    key = next((key for key in _LABELS if properties.get(key)), None)
    value = properties.get(key) if key else None
    if isinstance(value, str):
        return labels(re.split(r"[\s,;]+", value)) if key == "labels" else labels([value])
    return labels(map(str, value)) if isinstance(value, list) else labels([_text(value)])


def _placement(properties: Mapping[str, Any]) -> Iterator[Placement]:
    """Yield the placement, if a feature is one."""
    values = {key: _number(properties.get(key)) for key in _SIZES}
    if not _is_placement(properties):
        return
    x, y, width, height, angle = (value or 0.0 for value in values.values())
    named = label(_text(properties.get("label")))
    score, mirrored = _number(properties.get("score")), properties.get("mirrored") is True
    target = _number(properties.get("target"))
    yield Placement(x, y, width, height, angle, named, score, mirrored, 1.0 if target is None else target)


def _is_placement(properties: Mapping[str, Any]) -> bool:
    sizes = [_number(properties.get(key)) for key in _SIZES]
    if properties.get("kind") != "placement" or any(value is None for value in sizes):
        return False
    return (sizes[2] or 0) > 0 and (sizes[3] or 0) > 0


def _own(given: Any, count: int) -> OwnLabels:
    """Return the labels of edges or corners, where they are written as we write them."""
    found = []
    for entry in _list(given):
        at = entry.get("at") if isinstance(entry, dict) else None
        if isinstance(at, int) and 1 <= at <= count:
            found.append((at - 1, labels(map(str, _list(entry.get("labels"))))))
    return tuple(found)


def _picture(given: Any, path: Path) -> Picture | None:
    """Return the picture of a scene that we wrote; its file is named from where the scene's lies."""
    if not isinstance(given, dict) or not _text(given.get("file")):
        return None
    box = [_number(side) for side in _list(given.get("box"))]
    left, top, right, bottom = box if len(box) == 4 else (None,) * 4
    if left is None or top is None or right is None or bottom is None:
        return None
    return Picture(str(path.parent / given["file"]), (left, top, right, bottom))


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _text(value: Any) -> str:
    return str(value) if isinstance(value, (str, int, float)) and not isinstance(value, bool) else ""


def _number(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None
