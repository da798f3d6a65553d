"""What documents are made of, declared once: the reader and the schema follow from it."""

from __future__ import annotations

import math
import re
import string
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from layoutkit.constraints.attributes import REGIONS, Attribute, AttributeType, choice
from layoutkit.constraints.namespace import CORE
from layoutkit.model.face import Point
from layoutkit.model.mass import CORNER
from layoutkit.model.measure import format_number
from layoutkit.model.selection import SYMBOL

NAMESPACE = CORE.uri
#: Points of one footprint: that they do not cross is found by comparing all of its sides.
POINT_LIMIT = 1000
#: Of the number of a column or row.
_DIGITS = 9

_SYMBOL = re.compile(SYMBOL)
_BLANKS = re.compile(r"[ \t\r\n]+")
#: No white space, no ASCII sign but the underscore, no digit first: as near as XSD comes, whose `\w` means
#: something else, and whose `\p{L}` libxml2 takes for less than all letters. (Nor does it take `\[-\^`.)
_SIGNS = r"\s!-/:-@\[\\\]\^`{-~"
_SYMBOL_PATTERN = f"[^{_SIGNS}0-9][^{_SIGNS}]*"
_LABELS_PATTERN = rf"\s*({_SYMBOL_PATTERN}(\s+{_SYMBOL_PATTERN})*)?\s*"
_EXPONENT = r"([eE][+\-]?[0-9]{1,3})?"
#: At least one digit is not 0, before the point or after it.
_POSITIVE_PATTERN = rf" *\+?(0*[1-9][0-9]*(\.[0-9]*)?|0*\.0*[1-9][0-9]*){_EXPONENT} *"
_NUMBER_PATTERN = rf"[+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+){_EXPONENT}"
_POINTS_PATTERN = rf"\s*{_NUMBER_PATTERN},{_NUMBER_PATTERN}(\s+{_NUMBER_PATTERN},{_NUMBER_PATTERN})*\s*"
_PIXEL_PATTERN = rf" *\+?([0-9]+(\.[0-9]*)?|\.[0-9]+){_EXPONENT} *"
_WHOLE_PATTERN = r"[0-9]{1,39}"
_POSITION_PATTERN = "[1-9][0-9]*"
_KEY_PATTERN = "[a-z][a-z0-9\\-]*"
_REPEAT = rf"(\.{_POSITION_PATTERN})?"
_STEP, _STEP_PATTERN = rf"{SYMBOL}{_REPEAT}", rf"{_SYMBOL_PATTERN}{_REPEAT}"
_PATH_PATTERN = rf"{_STEP_PATTERN}(/{_STEP_PATTERN})*"


def _some(pattern: str) -> str:
    """Return the pattern of at least one thing, and blanks between them."""
    return rf"\s*{pattern}(\s+{pattern})*\s*"


def _spelled(pattern: str) -> Callable[[str], bool]:
    compiled = re.compile(pattern)
    return lambda text: compiled.fullmatch(text) is not None


#: Documents repeat their values over and over: reading one a second time costs next to nothing.
_remembered = lru_cache(maxsize=1 << 14)

_is_positive, _is_pixel, _is_whole = map(_spelled, (_POSITIVE_PATTERN, _PIXEL_PATTERN, _WHOLE_PATTERN))
_is_number, _are_points = _spelled(f" *{_NUMBER_PATTERN} *"), _spelled(_POINTS_PATTERN)
_is_key = _spelled(_KEY_PATTERN)
_is_position, _is_path = _spelled(_POSITION_PATTERN), _spelled(f"{_STEP}(/{_STEP})*")


#: What units are written with.
_LETTERS = string.ascii_letters


@_remembered
def _size(text: str) -> float:
    value = float(text) if _is_positive(text) else math.nan
    if not 0 < value < math.inf:
        raise _no_number(text, "a finite number greater than 0")
    return value


def _amount(text: str) -> float:
    value = float(text) if _is_pixel(text) else math.nan
    if not math.isfinite(value):
        raise _no_number(text, "a finite number of at least 0")
    return value


def _number(text: str) -> float:
    value = float(text) if _is_number(text) else math.nan
    if not math.isfinite(value):
        raise _no_number(text, "a finite number")
    return value


def _no_number(text: str, wanted: str) -> ValueError:
    """Say what a number should be; where all that is wrong is a unit, that."""
    alone = text.strip().rstrip(_LETTERS).strip()
    if alone != text.strip() and _is_number(alone):
        return ValueError(f"{text!r} has a unit: write {alone} in the units of the document")
    return ValueError(f"{text!r} is not {wanted}")


def _outline(text: str) -> tuple[Point, ...]:
    if not _are_points(text):
        raise ValueError("points are written x,y x,y: two numbers with a comma each, and blanks between them")
    numbers = tuple(map(float, text.replace(",", " ").split()))
    if not all(map(math.isfinite, numbers)):
        raise ValueError("a number is too large to be finite")
    return tuple(zip(numbers[::2], numbers[1::2], strict=True))


def _points(text: str) -> tuple[Point, ...]:
    found = _outline(text)
    if len(found) > POINT_LIMIT:
        raise ValueError(f"{len(found)} points are more than {POINT_LIMIT}")
    return found


def _points_text(points: tuple[Point, ...]) -> str:
    return " ".join(f"{format_number(x)},{format_number(y)}" for x, y in points)


def _whole(text: str) -> int:
    if not _is_whole(text):
        raise ValueError(f"{text!r} is not a whole number of at least 0")
    return int(text)


@_remembered
def _symbol(text: str) -> str:
    if _SYMBOL.fullmatch(text) is None:
        raise ValueError(f"{text!r} is not a letter or underscore, then letters, digits and underscores")
    return text


@_remembered
def _labels(text: str) -> tuple[str, ...]:
    if "," in text:
        raise ValueError(f"{text!r} has commas: labels are separated by blanks")
    return tuple(_symbol(part) for part in _BLANKS.split(text) if part)


def _parts(text: str) -> tuple[str, ...]:
    found = tuple(part for part in _BLANKS.split(text) if part)
    if not found:
        raise ValueError("at least one is needed")
    return found


def _unique_path(text: str) -> str:
    if not _is_path(text):
        raise ValueError(f"{text!r} is no path such as House/Floor.2/Window")
    return text


def _unique_paths(text: str) -> tuple[str, ...]:
    return tuple(_unique_path(part) for part in _parts(text))


def _names(text: str) -> tuple[str, ...]:
    found = tuple(_symbol(part) for part in _parts(text))
    if len(set(found)) < len(found):
        raise ValueError(f"{text!r} should name each once")
    return found


def _keys(text: str) -> tuple[str, ...]:
    found = tuple(part for part in _BLANKS.split(text) if part)
    if wrong := next((part for part in found if not _is_key(part)), None):
        raise ValueError(f"{wrong!r} is not a name of small letters, digits and hyphens")
    return found


def _answer(text: str) -> bool:
    if text.strip() not in ("yes", "no"):
        raise ValueError(f"{text!r} is neither yes nor no")
    return text.strip() == "yes"


def _answered(value: bool) -> str:
    return "yes" if value else "no"


def _positions(text: str) -> tuple[int, ...]:
    found = _parts(text)
    for part in found:
        if not _is_position(part) or len(part) > _DIGITS:
            raise ValueError(f"{part!r} is not a whole number of at least 1")
    return tuple(map(int, found))


def _spaced(values: tuple[object, ...]) -> str:
    return " ".join(map(str, values))


SIZE = AttributeType("size", _size, pattern=_POSITIVE_PATTERN)
AMOUNT = AttributeType("amount", _amount, format_number, pattern=_PIXEL_PATTERN)
NUMBER = AttributeType("number", _number, format_number, pattern=f" *{_NUMBER_PATTERN} *")
_POINTS = AttributeType("points", _points, _points_text, pattern=_POINTS_PATTERN)
#: Points of any number.
OUTLINE = AttributeType("outline", _outline, _points_text, pattern=_POINTS_PATTERN)
WHOLE = AttributeType("whole", _whole, pattern=_WHOLE_PATTERN)
NAME = AttributeType("symbol", _symbol, pattern=_SYMBOL_PATTERN)
LABELS = AttributeType("labels", _labels, " ".join, pattern=_LABELS_PATTERN)
_PATH = AttributeType("unique path", _unique_path, pattern=_PATH_PATTERN)
_PATHS = AttributeType("unique paths", _unique_paths, _spaced, pattern=_some(_PATH_PATTERN))
NAMES = AttributeType("names", _names, _spaced, pattern=_some(_SYMBOL_PATTERN))
POSITIONS = AttributeType("positions", _positions, _spaced, pattern=_some(_POSITION_PATTERN))
#: Names of what plugins add.
KEYS = AttributeType("keys", _keys, _spaced, pattern=rf"\s*({_KEY_PATTERN}(\s+{_KEY_PATTERN})*)?\s*")
ANSWER = AttributeType("answer", _answer, _answered, choices=("yes", "no"))
TEXT = AttributeType("text", str)
_UNITS = choice("units", "m", "px")
_SPLIT = choice("split", "columns", "rows")
_ROOT_SPLIT = choice("split", "columns", "rows", "faces")
_CLOSED = choice("closed", "yes", "no")
_FILL = choice("fill", "stretch", "repeat")
_ACTION = choice("action", "add", "remove", "move")
_AXIS = choice("axis", "columns", "rows")
_GAP = choice("gap", "before", "after")
_SIDE = choice("side", "left", "right", "top", "bottom")


def required(name: str, kind: AttributeType, help: str) -> Attribute:
    """Declare an attribute that its element needs."""
    return Attribute(name, name, kind, help, True, None)


def optional(name: str, kind: AttributeType, help: str, default: Any = None) -> Attribute:
    """Declare an attribute that may be left out."""
    return Attribute(name, name, kind, help, False, default)


@dataclass(frozen=True, slots=True)
class ElementType:
    """What the reader and the schema know of an element.

    Attributes
    ----------
    help
        What it is, for the schema.
    attributes
        By name, in the order in which they are written.
    required
        The names of those that it needs.
    """

    name: str
    help: str
    attributes: Mapping[str, Attribute]
    required: tuple[str, ...]


def element_type(name: str, help: str, *attributes: Attribute) -> ElementType:
    """Return an element's type."""
    needed = tuple(a.name for a in attributes if a.required)
    return ElementType(name, help, {a.name: a for a in attributes}, needed)


DOCUMENT_NAME = required("name", TEXT, "What the document is called; pictures and reports show it.")
DOCUMENT_UNITS = required("units", _UNITS, "What sizes are counted in: metres (m) or pixels (px).")

FACADE = element_type(
    "facade",
    "A segmented facade: its picture, its region tree, and the constraints that every variation keeps.",
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
)
LAYOUT = element_type(
    "layout",
    "A facade laid out anew: the tree of placed regions, every size known.",
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
    optional("facade", TEXT, "The facade's document, relative to this one."),
    optional("seed", WHOLE, "The seed that the layout was made from."),
    optional("index", WHOLE, "Its number among the variations of that seed, from 0."),
)
PICTURE = element_type(
    "picture",
    "A picture, and the part of it that the document covers, in its pixels: x to the right, y down.",
    required("file", TEXT, "The picture's file, relative to this document."),
    required("left", AMOUNT, "Left edge of the part."),
    required("top", AMOUNT, "Upper edge of the part."),
    required("right", AMOUNT, "Right edge of the part, greater than left."),
    required("bottom", AMOUNT, "Lower edge of the part, greater than top."),
)
_SYMBOL_HELP = "The region's type within its parent: the same symbol means an identical region."
_SPLIT_HELP = "How it is divided: columns from left to right, rows from the top down. A terminal has none."
_ROOT_SPLIT_HELP = f"{_SPLIT_HELP} A building's layout: its faces side by side."
_FILL_HELP = "How a terminal's picture fills another size: stretched, or repeated."
_REGION_ATTRIBUTES = (
    optional("labels", LABELS, "Semantic classes, separated by spaces; constraints name them with @."),
    optional("fill", _FILL, _FILL_HELP, "stretch"),
    optional("depth", NUMBER, "How far it stands out of what is around it; below 0: stands back.", 0.0),
    optional("material", TEXT, "What it and its inside are made of; left out, as what is around it.", ""),
)
REGION = element_type(
    "region",
    "A rectangle of the hierarchy. It has only its size along the parent's split; its children add up to it.",
    required("symbol", NAME, _SYMBOL_HELP),
    optional("width", SIZE, "The width, where the parent is split into columns."),
    optional("height", SIZE, "The height, where the parent is split into rows."),
    optional("base", NUMBER, "Elevation of a face's lower edge, where the parent is split into faces.", 0.0),
    optional("split", _SPLIT, _SPLIT_HELP),
    *_REGION_ATTRIBUTES,
)
ROOT_REGION = element_type(
    "region",
    "The whole facade: the root of the hierarchy. Its symbol begins every path.",
    required("symbol", NAME, _SYMBOL_HELP),
    required("width", SIZE, "The width of the whole."),
    required("height", SIZE, "The height of the whole."),
    optional("split", _ROOT_SPLIT, _ROOT_SPLIT_HELP),
    *_REGION_ATTRIBUTES,
)
AGAIN = element_type(
    "again",
    "A replica of the nearest earlier sibling of the same symbol.",
    required("symbol", NAME, "The symbol of the sibling to repeat."),
)
CONSTRAINTS = element_type(
    "constraints",
    "What every variation keeps. A comment directly above a constraint says why it is there.",
)
GRIDS = element_type("grids", "Regions that are edited together, as grids of rows and columns.")
GRID = element_type(
    "grid",
    "A grid: which of its elements stand in one row or column follows from where they are. No two overlap.",
    required("name", NAME, "What edits call it; each grid of a facade has another name."),
    optional("of", REGIONS, "A set of regions, such as @Window: all its places are elements."),
    optional(
        "elements",
        _PATHS,
        "Further elements, by the unique paths that layoutkit inspect prints, separated by blanks.",
    ),
)
_MASS_HELP = (
    "A building's mass, of boxes and footprints: x to the east, y to the north, elevations above the ground."
)
#: A document of its own.
MASS = element_type("mass", _MASS_HELP, DOCUMENT_NAME, DOCUMENT_UNITS)
#: What a layout's faces stand on.
LAYOUT_MASS = element_type("mass", _MASS_HELP)
_PART_NAME = optional("name", NAME, "Begins the names of its faces (Tower_South); an only one goes by it.")
_PART_BASE = optional("base", NUMBER, "Elevation of its foot.", 0.0)
BOX = element_type(
    "box",
    "A box along the axes. Its faces are South, East, North and West.",
    _PART_NAME,
    optional("x", NUMBER, "Its west side.", 0.0),
    optional("y", NUMBER, "Its south side.", 0.0),
    required("width", SIZE, "Its extent along x."),
    required("depth", SIZE, "Its extent along y."),
    required("height", SIZE, "Its extent upwards."),
    _PART_BASE,
)
FOOTPRINT = element_type(
    "footprint",
    "A prism over an outline. Its faces are Face1, Face2 and so on, from the outline's first corner.",
    _PART_NAME,
    required("points", _POINTS, "The outline's points, x,y each. A curve is written as many short sides."),
    required("height", SIZE, "Its extent upwards."),
    _PART_BASE,
    optional("closed", _CLOSED, "yes, or no for a wall by itself, whose outside is on the right.", "yes"),
    optional("corner", SIZE, "Degrees from which on two segments meet in a corner between faces.", CORNER),
)

SESSION = element_type(
    "session",
    "The edits of a facade, one after the other: they can be made again, taken back, and gone on with.",
    DOCUMENT_NAME,
    required("facade", TEXT, "The document of the facade that they begin with, relative to this one."),
    optional("done", WHOLE, "How many of them are in force; the rest were taken back. Left out: all."),
)
EDIT = element_type(
    "edit",
    "A column or row of grids that was added, removed or moved, or an element that was moved.",
    required("action", _ACTION, "What was done."),
    required("axis", _AXIS, "Whether columns or rows; an element moves across columns or across rows."),
    required("grids", NAMES, "The grids that were edited, separated by blanks."),
    optional(
        "source",
        POSITIONS,
        "Which column or row was copied, removed or moved, counted from 1 before the edit. Of grids with "
        "different numbers of them, one for each number, in the order in which the grids are named.",
    ),
    optional(
        "at", POSITIONS, "Added: which column or row the new one is afterwards, as many numbers as source."
    ),
    optional("to", POSITIONS, "Moved: which column or row it is afterwards, as many numbers as source."),
    optional("gap", _GAP, "Removed: which of the gaps beside it went with it.", "after"),
    optional("element", _PATH, "Instead of source: the unique path of the one element that was moved."),
    optional("width", SIZE, "The width that the facade was to have afterwards; left out, what follows."),
    optional("height", SIZE, "The height that the facade was to have afterwards; left out, what follows."),
)
RESIZE = element_type(
    "resize",
    "The facade was given another size, and everything in it followed.",
    optional("width", SIZE, "The new width; left out, it was not asked for."),
    optional("height", SIZE, "The new height; left out, it was not asked for."),
)
DRAG = element_type(
    "drag",
    "A side of a region was dragged to another place.",
    required("region", _PATH, "The unique path of the region."),
    required("side", _SIDE, "Which of its sides."),
    required("to", NUMBER, "Where the side was to be: x of left and right, y of top and bottom, upwards."),
)
REGION_SIZE = element_type(
    "size",
    "A region was given another size.",
    required("region", _PATH, "The unique path of the region."),
    optional("width", SIZE, "The new width; left out, it was not asked for."),
    optional("height", SIZE, "The new height; left out, it was not asked for."),
)
