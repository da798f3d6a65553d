"""The documents and commands in which examples stand."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import GAP, Frame

_HOUSE = """\
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6" split="rows">
    <region symbol="Floor" height="3" split="columns">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Bay" width="4" labels="Window"/>
      <again symbol="Pier"/>
    </region>
    <region symbol="Ground" height="3" split="columns">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Door" width="4" labels="Door"/>
      <again symbol="Pier"/>
    </region>
  </region>
  <constraints>
    …
  </constraints>
</facade>
"""
_CONSTRAINTS = f"<constraints>\n    {GAP}\n  </constraints>"
_GRIDS = f"<grids>\n    {GAP}\n  </grids>"
_GRIDDED = _HOUSE.replace(_CONSTRAINTS, _GRIDS)
_SESSION = '<session xmlns="urn:layoutkit:1" name="house" facade="house.xml">\n  …\n</session>\n'
_HEAD = '<facade xmlns="urn:layoutkit:1" name="house" units="m">\n  …\n</facade>\n'
_LAYOUT = '<layout xmlns="urn:layoutkit:1" name="house-1" units="m" facade="house.xml">\n  …\n</layout>\n'
_MASS = '<mass xmlns="urn:layoutkit:1" name="block" units="m">\n  …\n</mass>\n'
_BLOCK = '<box name="Block" x="0" y="0" width="6" depth="6" height="6"/>'
_KEPT = '<size of="House/Floor" min="2.5" max="3.5"/>'
_ROW = '<region symbol="House" width="6" height="3"/>'

_BOXES = """\
<object><points><x>0</x><x>1</x><y>0</y><y>1</y></points><labelname>facade</labelname></object>
"""
_PLUGIN = """\
from layoutkit.hooks import hookimpl

@hookimpl
def layoutkit_formats():
    return []
"""
_KIND = """\
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import PATH, AttributeType, attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.references import unknown_path
from layoutkit.hooks import hookimpl

@dataclass(frozen=True, kw_only=True)
class Plain(Constraint):
    kind = "plain"
    namespace = Namespace("acme", "urn:acme:1")
    summary = "The region is as it is."
    …

    def faults(self, facade):
        return unknown_path(self, self.of, facade)

    def violations(self, view):
        return iter(())

@hookimpl
def layoutkit_constraints():
    return [Plain]
"""
_ROW_CONSTRAINTS = """<constraints>
    <size of="House" max="8"/>
    <size of="House" min="5" weight="1"/>
  </constraints>"""
#: Floors with a choice of words each.
_FREE = """\
<sequence within="House/Floor House/Ground" word="|- Pier"/>
    <sequence within="House/Floor" word="Pier Bay Pier"/>
    <sequence within="House/Ground" word="Pier Door Pier"/>
    <sequence within="House/Floor House/Ground" word="Pier -|"/>"""
#: The same, and windows and doors in line.
_TIED = f'{_FREE}\n    <alignment first="@Window" second="@Door" lines="left"/>'

#: A whole document.
DOCUMENT = Frame("a document", GAP, "house.xml", "layoutkit validate house.xml")
#: The parts of a facade.
FACADE = Frame("a facade", _HEAD, "house.xml", "layoutkit validate house.xml")
#: Constraints on a house of two floors.
HOUSE = Frame("the house", _HOUSE, "house.xml", "layoutkit validate house.xml")
#: Grids of the same house.
GRIDDED = Frame("the house with grids", _GRIDDED, "house.xml", "layoutkit validate house.xml")
#: Edits of a grid of the house's piers.
SESSION = Frame(
    "a session",
    _SESSION,
    "session.xml",
    "layoutkit validate session.xml",
    {"house.xml": _GRIDDED.replace(GAP, '<grid name="piers" of="House/Floor/Pier | House/Ground/Pier"/>')},
)
_EDITABLE = """\
<grid name="piers" of="House/Floor/Pier | House/Ground/Pier"/>
    <grid name="openings" of="@Window | @Door"/>"""
#: Commands that edit the house, with grids and without.
EDITING = Frame(
    "a house to edit",
    GAP,
    "",
    GAP,
    {
        "house.xml": _GRIDDED.replace(GAP, _EDITABLE),
        "bare.xml": _GRIDDED.replace(f"  {_GRIDS}\n", ""),
    },
)
#: Edits that are made again.
REPLAYED = Frame(
    "a session, made again",
    _SESSION,
    "session.xml",
    "layoutkit apply session.xml -o edited.xml",
    {"house.xml": EDITING.beside["house.xml"]},
)
#: Constraints on the house, a floor of which is to be added.
HEIGHTENED = Frame(
    "the house, to be heightened",
    _HOUSE.replace("</facade>", f"  {_GRIDS}\n</facade>".replace(GAP, _EDITABLE)),
    "house.xml",
    "layoutkit propose house.xml --grid openings --axis rows -o out",
)
#: The house, when it is varied, counted, or drawn.
VARIED = Frame("the house, varied", _HOUSE, "house.xml", "layoutkit vary house.xml -n 1 -o out")
DRAWN = Frame(
    "a facade, drawn", _HEAD, "house.xml", "layoutkit vary house.xml -n 1 -o out", pictures=("photo.png",)
)
_BESIDE = {"house.xml": _HEAD.replace(GAP, f"{_ROW}\n  {_ROW_CONSTRAINTS}")}
#: The parts of a layout of a one-piece facade: at most 8 m wide, and better at least 5 m.
LAYOUT = Frame("a layout", _LAYOUT, "layout.xml", "layoutkit validate layout.xml", _BESIDE)
#: A whole layout of the same.
WHOLE_LAYOUT = Frame("a layout document", GAP, "layout.xml", "layoutkit validate layout.xml", _BESIDE)
#: The parts of a mass.
MASS = Frame("a mass", _MASS, "mass.xml", "layoutkit validate mass.xml")
#: Constraints on the house, which is put on a block.
DRESSED = Frame(
    "the house on a block",
    _HOUSE,
    "house.xml",
    "layoutkit vary house.xml --mass mass.xml -n 1 -o out",
    {"mass.xml": _MASS.replace(GAP, _BLOCK)},
)
#: The same, where a plugin is installed.
DRESSED_WITH_PLUGIN = Frame(
    "the house on a block, with a plugin",
    _HOUSE,
    "house.xml",
    DRESSED.command,
    {**DRESSED.beside, "acme.py": _KIND.replace(GAP, 'of: str = attribute(PATH, "The region.")')},
)
#: How a plugin's kind, used in the house, declares what it speaks of.
KIND = Frame(
    "a plugin's constraint",
    _KIND,
    "acme.py",
    DRESSED.command,
    {
        **DRESSED.beside,
        "house.xml": _HOUSE.replace(GAP, '<acme:plain xmlns:acme="urn:acme:1" of="House/Floor"/>'),
    },
)
#: An annotation, in a format that `convert` reads.
ANNOTATION = Frame(
    "an annotation",
    GAP,
    "boxes.xml",
    "layoutkit convert boxes.xml --format cmp --image photo.png -o house.xml",
    pictures=("photo.png",),
)
#: The module of a plugin that is installed under the name `acme`.
PLUGIN = Frame("a plugin", GAP, "acme.py", "layoutkit plugins")
#: Commands, where a plugin is installed.
WITH_PLUGIN = Frame("a folder where a plugin is installed", GAP, "", GAP, {"acme.py": _PLUGIN})
#: The same, and a file that its format is asked about.
CONVERTING_PLUGIN = Frame(
    "a plugin at work",
    GAP,
    "acme.py",
    "layoutkit convert boxes.xml --image photo.png -o converted.xml",
    {"boxes.xml": _BOXES},
    ("photo.png",),
)
#: Commands, in a folder with documents.
COMMAND = Frame(
    "a folder of documents",
    GAP,
    "",
    GAP,
    {
        "house.xml": _HOUSE.replace(GAP, _KEPT),
        "mass.xml": _MASS.replace(GAP, _BLOCK),
        "layout.xml": _LAYOUT.replace(' facade="house.xml"', "").replace(GAP, _ROW),
        "boxes.xml": _BOXES,
        "toys/toy.txt": "no document\n",
        "facade.xml": _HOUSE.replace(GAP, _KEPT),
        "free.xml": _HOUSE.replace(GAP, _FREE),
        "tied.xml": _HOUSE.replace(GAP, _TIED),
    },
    pictures=("photo.png",),
)
#: The parts of a scene.
SCENE = Frame(
    "a scene",
    '<scene xmlns="urn:layoutkit:1" name="room" units="m">\n  …\n</scene>\n',
    "scene.xml",
    "layoutkit validate scene.xml",
)
#: Geometries as well-known text.
WKT = Frame("a drawing in WKT", GAP, "drawing.wkt", "layoutkit convert drawing.wkt -o scene.xml")
#: Coordinates of a polygon in GeoJSON.
GEOJSON = Frame(
    "a drawing in GeoJSON",
    '{"type": "Polygon", "coordinates":\n  …\n}\n',
    "drawing.geojson",
    "layoutkit convert drawing.geojson -o scene.xml",
)
_FLATS = """\
[{"id": 7, "geometries": {"kitchen": ["POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))"]}},
 {"id": 8, "geometries": {"living": ["POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0))"]}}]
"""
_CORNERS = ", ".join(f'{{"x": {x}, "y": 0, "z": {z}}}' for x, z in ((0, 0), (0, 3), (4, 3), (4, 0)))
_FLOOR = f'"roomType": "Kitchen", "floorPolygon": [{_CORNERS}]'
_CHAIR = '"assetId": "Chair_1", "position": {"x": 1, "y": 0.5, "z": 2}, "rotation": {"x": 0, "y": 90, "z": 0}'
_FURNISHED = f'{{"rooms": [{{"id": "room|1", {_FLOOR}}}], "objects": [{{{_CHAIR}}}]}}\n'
#: Commands, in a folder with files that hold scenes.
SCENE_FILES = Frame(
    "a folder of drawings",
    GAP,
    "",
    GAP,
    {
        "flats.json": _FLATS,
        "bare/house.jsonl": _FURNISHED,
        "furnished/house.jsonl": _FURNISHED,
        "furnished/asset-database.json": (
            '{"Chair": [{"assetId": "Chair_1", "boundingBox": {"x": 0.5, "y": 1, "z": 0.5}}]}\n'
        ),
    },
)
