"""Examples of faults of scenes, and of files that they are made of (LK85)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import GEOJSON, SCENE, SCENE_FILES, WKT

_ROOM = '<polygon points="0,0 4,0 4,3 0,3" labels="Room"/>'
_HOUSE = "Building POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0){})"

EXAMPLES = {
    "LK851": Example(SCENE, '<polygon points="0,0 4,0 2,0" labels="Room"/>', _ROOM),
    "LK852": Example(SCENE, '<polygon points="0,0 4,0 0,3 4,3" labels="Room"/>', _ROOM),
    "LK853": Example(SCENE, '<polygon points="0,0 4,0 4,3 0,3 0,0" labels="Room"/>', _ROOM),
    "LK854": Example(WKT, _HOUSE.format(", (3 3, 6 3, 6 6, 3 6, 3 3)"), _HOUSE.format("")),
    "LK855": Example(WKT, f"Road LINESTRING (-2 0, -2 9)\n{_HOUSE.format('')}", _HOUSE.format("")),
    "LK856": Example(
        SCENE,
        '<polygon name="bed" points="0,0 2,0 2,1 0,1"/>\n<polygon name="bed" points="0,2 2,2 2,3 0,3"/>',
        '<polygon name="bed" points="0,0 2,0 2,1 0,1"/>\n<polygon name="cot" points="0,2 2,2 2,3 0,3"/>',
    ),
    "LK857": Example(
        SCENE_FILES,
        "layoutkit convert flats.json -o scene.xml",
        "layoutkit convert flats.json --part 7 -o scene.xml",
    ),
    "LK858": Example(
        SCENE_FILES,
        "layoutkit convert flats.json --part 6 -o scene.xml",
        "layoutkit convert flats.json --part 7 -o scene.xml",
    ),
    "LK859": Example(WKT, f"{_HOUSE.format('')}\n{_HOUSE.format('')[:-2]}", _HOUSE.format("")),
    "LK860": Example(
        GEOJSON,
        "[[[13.40, 52.52], [13.41, 52.52], [13.41, 52.53], [13.40, 52.52]]]",
        "[[[0, 0], [678, 0], [678, 1112], [0, 0]]]",
    ),
    "LK861": Example(
        SCENE_FILES,
        "layoutkit convert bare/house.jsonl -o scene.xml",
        "layoutkit convert furnished/house.jsonl -o scene.xml",
    ),
}
