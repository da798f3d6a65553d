"""Examples of shapes that go nowhere (LK86, LK87)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import GAP, Example, Frame

_SCENE = '<scene xmlns="urn:layoutkit:1" name="{}" units="m">\n{}</scene>\n'
_ROOM = '  <polygon name="room" points="0,0 5,0 5,4 0,4" labels="{}"/>\n'
_TABLE = '  <polygon name="table" points="2,1 3,1 3,3 2,3" labels="Table"/>\n'
_CHAIRS = (
    '  <placement x="1.7" y="1.5" width="0.4" height="0.4" label="Chair"/>\n'
    '  <placement x="1.7" y="2.5" width="0.4" height="0.4" label="Chair"/>\n'
    '  <placement x="4.7" y="3.7" width="0.4" height="0.4" label="Chair"/>\n'
)
_STRAY = '  <placement x="90" y="90" width="0.4" height="0.4" label="Chair"/>\n'

#: Commands, in a folder with scenes.
ROOMS = Frame(
    "a folder of scenes",
    GAP,
    "",
    GAP,
    {
        "room.xml": _SCENE.format("room", _ROOM.format("Room") + _TABLE + _CHAIRS),
        "other.xml": _SCENE.format("other", _ROOM.format("Room") + _TABLE),
        "hall.xml": _SCENE.format("hall", _ROOM.format("Hall") + _TABLE + _CHAIRS),
        "yard.xml": _SCENE.format("yard", _TABLE + _CHAIRS),
        "chairs.xml": _SCENE.format("chairs", _CHAIRS),
        "stray.xml": _SCENE.format("stray", _ROOM.format("Room") + _TABLE + _CHAIRS + _STRAY),
        "plan.xml": _SCENE.format("plan", _ROOM.format("Room") + _TABLE).replace('"m"', '"px"'),
    },
)
_RUN = "layoutkit propagate other.xml --from {} -o placed.xml"
_CHAIR = " --shape Chair_1"
_PLACE = "layoutkit place {} {} -o placed.xml"
_PLACED = _PLACE.format("room.xml", "other.xml")

EXAMPLES = {
    "LK864": Example(
        ROOMS,
        _RUN.format("room.xml") + _CHAIR + " --threshold 1.5",
        _RUN.format("room.xml") + _CHAIR + " --threshold 0.9",
    ),
    "LK865": Example(
        ROOMS,
        _RUN.format("room.xml") + _CHAIR + " --relationships corner-rato",
        _RUN.format("room.xml") + _CHAIR + " --relationships corner-ratio",
    ),
    "LK866": Example(ROOMS, _RUN.format("chairs.xml") + _CHAIR, _RUN.format("room.xml") + _CHAIR),
    "LK867": Example(ROOMS, _RUN.format("hall.xml") + _CHAIR, _RUN.format("room.xml") + _CHAIR),
    "LK868": Example(
        ROOMS,
        _RUN.format("room.xml") + _CHAIR + " --shape Chair_3 --array 0.5",
        _RUN.format("room.xml") + _CHAIR + " --shape Chair_2 --array 0.5",
    ),
    "LK869": Example(
        ROOMS,
        _RUN.format("yard.xml").replace("other", "yard") + _CHAIR + " --carry boundary",
        _RUN.format("room.xml") + _CHAIR + " --carry boundary",
    ),
    "LK871": Example(ROOMS, f"{_PLACED} --label Chiar", f"{_PLACED} --label Chair"),
    "LK872": Example(
        ROOMS,
        f"{_PLACED} --relationships bounding-box",
        f"{_PLACED} --relationships bounding-box-coordinates",
    ),
    "LK873": Example(ROOMS, _PLACE.format("stray.xml", "other.xml"), _PLACED),
    "LK874": Example(ROOMS, _PLACE.format("room.xml", "plan.xml"), _PLACED),
    "LK877": Example(ROOMS, f"{_PLACED} --each-width 90", _PLACED),
    "LK875": Example(ROOMS, _PLACE.format("hall.xml", "other.xml"), _PLACED),
}
