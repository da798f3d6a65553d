"""What is wrong with a CityJSON document, by the rules of the specification (2.0, sections 1 to 4)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

FIRST_LEVEL = {
    "Bridge", "Building", "CityFurniture", "CityObjectGroup", "GenericCityObject", "LandUse",
    "OtherConstruction", "PlantCover", "SolitaryVegetationObject", "TINRelief", "TransportSquare", "Railway",
    "Road", "Tunnel", "WaterBody", "Waterway",
}  # fmt: skip
SECOND_LEVEL = {"BuildingPart": {"Building"}, "BuildingInstallation": {"Building", "BuildingPart"}}
OF_BUILDINGS = {
    "RoofSurface", "GroundSurface", "WallSurface", "ClosureSurface", "OuterCeilingSurface",
    "OuterFloorSurface", "Window", "Door",
}  # fmt: skip
DEPTHS = {"MultiSurface": 0, "Solid": 1}


def faults(document: Any) -> list[str]:
    """Everything that the specification forbids."""
    return [*_head(document), *_family(document), *_geometries(document), *_vertices(document)]


def _head(document: Any) -> Iterator[str]:
    if (document["type"], document["version"]) != ("CityJSON", "2.0"):
        yield "neither CityJSON nor 2.0"
    if {"transform", "CityObjects", "vertices"} - set(document):
        yield "a member is missing"
    if set(document["transform"]) != {"scale", "translate"} or min(document["transform"]["scale"]) <= 0:
        yield "the transform is incomplete"
    if len(document["metadata"].get("geographicalExtent", [0] * 6)) != 6:
        yield "the extent is no box"


def _family(document: Any) -> Iterator[str]:
    objects = document["CityObjects"]
    for name, own in objects.items():
        if own["type"] not in FIRST_LEVEL | set(SECOND_LEVEL):
            yield f"{name}: {own['type']} is no type"
        if (own["type"] in SECOND_LEVEL) != bool(own.get("parents")):
            yield f"{name}: a {own['type']} with parents {own.get('parents')}"
        for parent in own.get("parents", ()):
            if name not in objects.get(parent, {}).get("children", ()):
                yield f"{name}: {parent} does not know it"
            elif objects[parent]["type"] not in SECOND_LEVEL[own["type"]]:
                yield f"{name}: {parent} is a {objects[parent]['type']}"
        for child in own.get("children", ()):
            if objects.get(child, {}).get("parents") != [name]:
                yield f"{name}: {child} does not know it"


def _geometries(document: Any) -> Iterator[str]:
    for name, own in document["CityObjects"].items():
        for geometry in own["geometry"]:
            yield from (f"{name}: {fault}" for fault in _geometry(document, own["type"], geometry))


def _geometry(document: Any, kind: str, geometry: Any) -> Iterator[str]:
    if not isinstance(geometry["lod"], str) or geometry["lod"] not in ("1", "2", "3"):
        yield f"level of detail {geometry['lod']!r}"
    shells = geometry["boundaries"] if geometry["type"] == "Solid" else [geometry["boundaries"]]
    shape = [len(shell) for shell in shells]
    for face in (face for shell in shells for face in shell):
        for ring in face:
            if len(ring) < 3 or len(set(ring)) < len(ring):
                yield f"ring {ring}"
            if not all(isinstance(v, int) and 0 <= v < len(document["vertices"]) for v in ring):
                yield f"ring {ring} has no vertices"
        if np.linalg.norm(area(document, face[0])) == 0:
            yield f"face {face} has no area"
    if geometry["type"] == "Solid":
        for shell in shells:
            yield from _closed(shell)
    looks = document["appearance"]["materials"] if "material" in geometry else []
    for theme in geometry.get("material", {}).values():
        yield from _valued("material", theme["values"], geometry, shape, len(looks))
    if "semantics" in geometry:
        surfaces = geometry["semantics"]["surfaces"]
        yield from _valued("semantics", geometry["semantics"]["values"], geometry, shape, len(surfaces))
        yield from _surfaces(kind, surfaces)


def _valued(what: str, values: Any, geometry: Any, shape: list[int], count: int) -> Iterator[str]:
    rows = values if geometry["type"] == "Solid" else [values]
    if [len(row) for row in rows] != shape:
        yield f"{what} of another shape than the boundaries"
    if not all(isinstance(v, int) and 0 <= v < count for row in rows for v in row):
        yield f"{what} that are not there"


def _surfaces(kind: str, surfaces: Any) -> Iterator[str]:
    if not kind.startswith("Building"):
        yield f"a {kind} has surfaces of a building"
    for number, own in enumerate(surfaces):
        if own["type"] not in OF_BUILDINGS:
            yield f"surface {number}: {own['type']}"
        if (own["type"] in ("Window", "Door")) != ("parent" in own):
            yield f"surface {number}: a {own['type']} with parent {own.get('parent')}"
        if "parent" in own and number not in surfaces[own["parent"]].get("children", ()):
            yield f"surface {number}: its parent does not know it"
        if any(surfaces[child].get("parent") != number for child in own.get("children", ())):
            yield f"surface {number}: a child does not know it"


def _closed(shell: Any) -> Iterator[str]:
    edges = Counter(edge for face in shell for ring in face for edge in pairwise((*ring, ring[0])))
    if any(count > 1 for count in edges.values()):
        yield "an edge is there twice"
    if any((b, a) not in edges for a, b in edges):
        yield "the shell is open"


def _vertices(document: Any) -> Iterator[str]:
    vertices = document["vertices"]
    if not all(isinstance(v, int) for vertex in vertices for v in vertex):
        yield "vertices are no integers"
    if len({tuple(vertex) for vertex in vertices}) < len(vertices):
        yield "a vertex is there twice"
    if set(_numbers([own["geometry"] for own in document["CityObjects"].values()])) != set(
        range(len(vertices))
    ):
        yield "a vertex is not used"


def _numbers(value: Any) -> Iterator[int]:
    if isinstance(value, int):
        yield value
    elif isinstance(value, list):
        for own in value:
            yield from _numbers(own)
    elif isinstance(value, dict):
        yield from _numbers(value["boundaries"])


def places(document: Any) -> np.ndarray:
    """Vertices where they are in the world."""
    transform = document["transform"]
    return np.array(document["vertices"]) * transform["scale"] + transform["translate"]


def area(document: Any, ring: list[int]) -> np.ndarray:
    """The area of a ring, as a vector to where it looks, in the world's units."""
    corners = (np.array(document["vertices"])[ring] - document["vertices"][ring[0]]).astype(float)
    corners *= document["transform"]["scale"]
    return np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0) / 2


def volume(document: Any, name: str) -> float:
    """What a solid encloses: a third of each face's area times its height over the first vertex."""
    (geometry,) = document["CityObjects"][name]["geometry"]
    points = places(document)
    points = points - points[geometry["boundaries"][0][0][0][0]]
    found = 0.0
    for face in geometry["boundaries"][0]:
        found += sum(float(area(document, ring) @ points[face[0][0]]) for ring in face) / 3
    return found
