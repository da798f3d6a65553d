"""How a constraint's attributes are declared once: the rest (parsing, schema, help) follows from it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, field, fields, replace
from typing import Any

from layoutkit.model import Extent, Measure, RegionSet, Word
from layoutkit.model.measure import format_number
from layoutkit.model.selection import SYMBOL


@dataclass(frozen=True, slots=True)
class AttributeType:
    """A kind of value that an attribute may hold.

    Attributes
    ----------
    name
        What the reference calls it.
    parse
        Text to value; raises ValueError with a message for the user.
    text
        Value to text, so that parsing it gives the same value.
    pattern
        XSD pattern, or empty.
    choices
        The words allowed, where they are few.
    many
        Whether several of the choices may stand together, separated by spaces.
    counts
        Whether a measure is a number of regions, and no size.
    """

    name: str
    parse: Callable[[str], Any]
    text: Callable[[Any], str] = str
    pattern: str = ""
    choices: tuple[str, ...] = ()
    many: bool = False
    counts: bool = False


def choice(name: str, *words: str) -> AttributeType:
    """Return a type whose values are one of `words`."""

    def parse(text: str) -> str:
        if text.strip() not in words:
            raise ValueError(f"{text!r} is none of {', '.join(words)}")
        return text.strip()

    return AttributeType(name, parse, choices=words)


def choices(name: str, *words: str) -> AttributeType:
    """Return a type whose values are some of `words`, at least one, each once."""

    def parse(text: str) -> tuple[str, ...]:
        found = tuple(text.split())
        if unknown := [word for word in found if word not in words]:
            raise ValueError(f"{unknown[0]!r} is none of {', '.join(words)}")
        if not found or len(set(found)) < len(found):
            raise ValueError(f"{text!r} should name some of {', '.join(words)}, each once")
        return found

    return AttributeType(name, parse, " ".join, choices=words, many=True)


def _count(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        raise ValueError(f"{text!r} is not a whole number") from None
    if value < 0:
        raise ValueError(f"{text!r} is below 0")
    return value


def _paths(text: str) -> tuple[str, ...]:
    found = tuple(text.split())
    if not found:
        raise ValueError("at least one path is needed")
    for path in found:
        RegionSet.parse(path)
    return found


def _path(text: str) -> str:
    found = _paths(text)
    if len(found) > 1:
        raise ValueError(f"one path is expected, not {len(found)}, in {text!r}")
    return found[0]


def _weight(text: str) -> float:
    value = _finite(text)
    if value <= 0:
        raise ValueError(f"{text!r} is not above 0")
    return value


def _bias(text: str) -> float:
    value = _finite(text)
    if not -1 <= value <= 1:
        raise ValueError(f"{text!r} is not between -1 and 1")
    return value


def _finite(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{text!r} is not a finite number")
    return value


def _pairs(text: str) -> tuple[tuple[str, str], ...]:
    found = []
    for part in text.split():
        pair = re.fullmatch(rf"({SYMBOL}):({SYMBOL})", part)
        if pair is None:
            raise ValueError(f"{part!r} is not a pair of symbols such as E:K")
        found.append((pair[1], pair[2]))
    return tuple(found)


def _paired(pairs: tuple[tuple[str, str], ...]) -> str:
    return " ".join(f"{one}:{other}" for one, other in pairs)


MEASURE = AttributeType("measure", Measure.parse, pattern=r"\s*[0-9.]+([eE][+\-]?[0-9]+)?\s*%?\s*")
#: A measure that is a number of regions, absolute or as a share of the input's.
NUMBER = replace(MEASURE, counts=True)
COUNT = AttributeType("count", _count, pattern=r"[0-9]+")
REGIONS = AttributeType("regions", RegionSet.parse)
#: A set in the context of the attribute `within`, whose direct subregions its single symbols mean.
MEMBERS = AttributeType("members", RegionSet.parse)
EXTENT = AttributeType("extent", Extent.parse)
WORD = AttributeType("word", Word.parse)
CONTEXT = AttributeType("context", Word.context)
PAIRS = AttributeType("pairs", _pairs, _paired)
WEIGHT = AttributeType("weight", _weight, format_number, r"\s*\+?[0-9.]+([eE][+\-]?[0-9]+)?\s*")
BIAS = AttributeType("bias", _bias, format_number, r"\s*[+\-]?[0-9.]+([eE][+\-]?[0-9]+)?\s*")
PATH = AttributeType("path", _path)
#: A path that only says where a constraint holds: its regions on several faces may count as one.
ENCLOSING = AttributeType("enclosing path", _path)
PATHS = AttributeType("paths", _paths, " ".join)


def attribute(kind: AttributeType, help: str, default: Any = MISSING, *, demands: bool = True) -> Any:
    """Declare a constraint's attribute: a dataclass field that knows its type and what to say of it.

    Parameters
    ----------
    demands
        Whether it says what layouts must keep, and not only how variations begin.
    """
    metadata = {"type": kind, "help": help, "demands": demands}
    if default is MISSING:
        return field(metadata=metadata)
    return field(default=default, metadata=metadata)


@dataclass(frozen=True, slots=True)
class Attribute:
    """A declared attribute: its name in documents, and its field."""

    name: str
    field_name: str
    type: AttributeType
    help: str
    required: bool
    default: Any
    demands: bool = True


def attributes_of(kind: type[Any]) -> tuple[Attribute, ...]:
    """Return the attributes that a constraint class declares, in order."""
    return tuple(_attribute(f) for f in fields(kind) if "type" in f.metadata)


def _attribute(declared: Field[Any]) -> Attribute:
    required = declared.default is MISSING
    return Attribute(
        declared.name.strip("_").replace("_", "-"),
        declared.name,
        declared.metadata["type"],
        declared.metadata["help"],
        required,
        None if required else declared.default,
        declared.metadata["demands"],
    )
