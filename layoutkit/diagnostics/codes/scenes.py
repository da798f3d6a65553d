"""Scenes, and the files that they are made of (LK85)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK851",
        "polygon without area",
        "A polygon needs three different points at least, finite ones, that do not lie on a line. In a scene "
        "document that is an error; of a file in another format, such polygons are left out, with a warning.",
        "A click instead of an outline; a line saved as a polygon.",
        "Draw an outline that encloses something, or delete it.",
    ),
    Code(
        "LK852",
        "polygon that crosses itself",
        "An outline may neither cross nor touch itself: it would not be clear what is inside. In a scene "
        "document that is an error; of a file in another format, such polygons are left out, with a warning.",
        "Points in the wrong order; a hole drawn as a part of the outline.",
        "Put the points in order; draw what stands in a hole as a polygon of its own.",
    ),
    Code(
        "LK853",
        "points given twice",
        "Points that stand twice in a row are taken once; so is a first point that is repeated at the end.",
        "The habit of other formats to close a ring by its first point.",
        "Nothing is needed; an outline closes by itself.",
        Severity.NOTE,
    ),
    Code(
        "LK854",
        "holes left away",
        "Polygons of scenes have no holes; one that has some is taken for filled.",
        "Courtyards of buildings; walls drawn as a ring.",
        "Nothing is needed where what is inside counts; else cut the polygon in two without holes.",
        Severity.WARNING,
    ),
    Code(
        "LK855",
        "no polygon",
        "A scene is made of polygons: points, lines, texts and pictures of a drawing are left out.",
        "A file that holds more than outlines.",
        "Nothing is needed; close or buffer lines that were meant as outlines.",
        Severity.WARNING,
    ),
    Code(
        "LK856",
        "polygons named alike",
        "Each polygon of a scene goes by a name of its own.",
        "A polygon that was copied.",
        "Give it another name, or none: it is then called by its label and a number.",
    ),
    Code(
        "LK857",
        "several scenes in a file",
        "The file holds several scenes, such as layers, rooms or flats, and one is wanted.",
        "A data set in one file.",
        "Name one with --part; `layoutkit convert --every-part` writes all of them.",
    ),
    Code(
        "LK858",
        "scene that a file lacks",
        "The file holds no scene of the name.",
        "A misspelt layer, or a number beyond the last.",
        "Follow the hint.",
    ),
    Code(
        "LK859",
        "geometry that cannot be read",
        "A line or entry of the file is no geometry; it is left out.",
        "A bracket that is missing, or text of another kind.",
        "Write it as the hint says.",
        Severity.WARNING,
    ),
    Code(
        "LK860",
        "degrees laid out in metres",
        "Coordinates are longitudes and latitudes, as the file says or as they look; scenes are plane.",
        "GeoJSON by its standard; a GeoPackage in WGS 84.",
        "Nothing is needed; to have a plane of your own, transform the data before.",
        Severity.NOTE,
    ),
    Code(
        "LK861",
        "objects of unknown size",
        "The houses of ProcTHOR name their objects; how large these are stands in a database of assets.",
        "The database does not lie beside the houses, or is of another version.",
        "Put `asset-database.json`, or the packed one, beside the file.",
        Severity.WARNING,
    ),
)
