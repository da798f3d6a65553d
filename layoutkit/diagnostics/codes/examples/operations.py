"""Examples of operations that cannot be made (LK88)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import GAP, Example, Frame

_OPERATIONS = """\
<operations xmlns="urn:layoutkit:1" name="build" units="m">
  <select labels="Plot">
    …
  </select>
</operations>
"""
_WALL = """\
<facade xmlns="urn:layoutkit:1" name="wall" units="m">
  <region symbol="Wall" width="4" height="3" split="columns">
    <region symbol="Pier" width="1"/>
    <region symbol="Bay" width="2" labels="Window"/>
    <again symbol="Pier"/>
  </region>
  <constraints>
    <size of="Wall" max="{}"/>
  </constraints>
  <grids>
    <grid name="openings" of="@Window"/>
  </grids>
</facade>
"""
_LAID = """\
<layout xmlns="urn:layoutkit:1" name="wall" units="m">
  <region symbol="Wall" width="4" height="3"/>
</layout>
"""
_EDITS = """\
<session xmlns="urn:layoutkit:1" name="wider" facade="wall.xml">
  <edit action="add" axis="columns" grids="openings" source="1" at="1"/>
</session>
"""
_YARD = """\
<scene xmlns="urn:layoutkit:1" name="yard" units="{}">
  <polygon name="plot" points="0,0 8,0 8,6 0,6" labels="Plot"/>
</scene>
"""
_EXTRUDE = '<extrude height="{}"/>'
_SIDES = """\
<extrude height="3">
  <select labels="Side">{}</select>
</extrude>"""
_DRESSED = _SIDES.format('<vary facade="{}"/>')

#: Operations on plots.
BUILD = Frame(
    "operations",
    _OPERATIONS,
    "build.xml",
    "layoutkit validate build.xml",
    {"wall.xml": _WALL.format(9), "layout.xml": _LAID},
)
#: The same, made again in a scene.
REPLAYED = Frame(
    "operations, made again",
    _OPERATIONS,
    "build.xml",
    "layoutkit replay build.xml yard.xml --no-views -o out",
    {
        "yard.xml": _YARD.format("m"),
        "wall.xml": _WALL.format(9),
        "short.xml": _WALL.format(5),
        "edits.xml": _EDITS,
    },
)
#: Commands that make operations again.
YARDS = Frame(
    "operations and scenes",
    GAP,
    "",
    GAP,
    {
        "build.xml": _OPERATIONS.replace(GAP, _EXTRUDE.format(3)),
        "yard.xml": _YARD.format("m"),
        "traced.xml": _YARD.format("px"),
    },
)
_REPLAY = "layoutkit replay build.xml {} --no-views -o out"

EXAMPLES = {
    "LK880": Example(BUILD, _DRESSED.format("wal.xml"), _DRESSED.format("wall.xml")),
    "LK881": Example(YARDS, _REPLAY.format("traced.xml"), _REPLAY.format("yard.xml")),
    "LK882": Example(BUILD, _EXTRUDE.format(0), _EXTRUDE.format(3)),
    "LK883": Example(REPLAYED, '<extrude height="3"><extrude height="1"/></extrude>', _EXTRUDE.format(4)),
    "LK884": Example(
        REPLAYED,
        '<boolean action="union" with="intersecting"/>',
        '<extrude height="3"><boolean action="union" with="intersecting"/></extrude>',
    ),
    "LK885": Example(REPLAYED, _DRESSED.format("short.xml"), _DRESSED.format("wall.xml")),
    "LK886": Example(
        REPLAYED,
        _SIDES.format('<edit session="edits.xml"/>'),
        _SIDES.format('<vary facade="wall.xml"><edit session="edits.xml"/></vary>'),
    ),
    "LK888": Example(
        REPLAYED,
        '<extrude height="3"><select labels="Tpo"/></extrude>',
        '<extrude height="3"><select labels="Top"/></extrude>',
    ),
    "LK887": Example(BUILD, _DRESSED.format("layout.xml"), _DRESSED.format("wall.xml")),
}
