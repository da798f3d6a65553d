"""Scenes as GeoJSON, for other programs; what GeoJSON has no word for stands in properties."""

from __future__ import annotations

import json
from typing import Any

from layoutkit.model.face import Point
from layoutkit.model.scene import OwnLabels, Placement, Polygon, Scene

#: The member of a feature collection that holds what is said of the whole scene.
SCENE = "scene"


def geojson_bytes(scene: Scene) -> bytes:
    """Return a scene as a GeoJSON feature collection, one feature a line.

    Coordinates are in document units, in a plane: they are no degrees, whatever RFC 7946 says of them.
    Rings run counter-clockwise, as it asks for. The format ``geojson`` reads an equal scene of it.
    """
    features = [*map(_polygon, scene.polygons), *map(_placement, scene.placements)]
    lines = ",\n".join(json.dumps(_unsigned(feature), ensure_ascii=False) for feature in features)
    head = json.dumps(_head(scene), ensure_ascii=False)
    return f'{{"type": "FeatureCollection", "{SCENE}": {head}, "features": [\n{lines}\n]}}\n'.encode()


def _unsigned(value: Any) -> Any:
    """Return JSON-ready data whose zeros have no sign: reading does not keep it."""
    if isinstance(value, dict):
        return {name: _unsigned(own) for name, own in value.items()}
    if isinstance(value, (list, tuple)):
        return [_unsigned(own) for own in value]
    return value + 0.0 if isinstance(value, float) else value


def _head(scene: Scene) -> dict[str, Any]:
    picture = scene.picture
    shown = {} if picture is None else {"picture": {"file": picture.file, "box": list(picture.box)}}
    return {"name": scene.name, "units": scene.units, **shown}


def _polygon(polygon: Polygon) -> dict[str, Any]:
    properties: dict[str, Any] = {"kind": "polygon", "name": polygon.name, "labels": list(polygon.labels)}
    if polygon.angle is not None:
        properties["angle"] = polygon.angle
    for key, own in (("edges", polygon.edges), ("corners", polygon.corners)):
        if own:
            properties[key] = _own(own)
    return _feature(polygon.points, properties)


def _own(labels: OwnLabels) -> list[dict[str, Any]]:
    return [{"at": index + 1, "labels": list(own)} for index, own in labels]


def _placement(placement: Placement) -> dict[str, Any]:
    properties: dict[str, Any] = {"kind": "placement", "label": placement.label}
    for key in ("x", "y", "width", "height", "angle"):
        properties[key] = getattr(placement, key)
    if placement.score is not None:
        properties["score"] = placement.score
    if placement.mirrored:
        properties["mirrored"] = True
    if placement.target != 1:
        properties["target"] = placement.target
    return _feature(placement.points, properties)


def _feature(points: tuple[Point, ...], properties: dict[str, Any]) -> dict[str, Any]:
    ring = [list(point) for point in (*points, points[0])]
    geometry = {"type": "Polygon", "coordinates": [ring]}
    return {"type": "Feature", "properties": properties, "geometry": geometry}
