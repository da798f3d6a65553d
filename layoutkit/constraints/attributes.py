"""How a constraint's attributes are declared once: the rest (parsing, schema, help) follows from it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import Any

from layoutkit.model import Extent, Measure, RegionSet, Word


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
    """

    name: str
    parse: Callable[[str], Any]
    text: Callable[[Any], str] = str
    pattern: str = ""
    choices: tuple[str, ...] = ()
    many: bool = False


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


MEASURE = AttributeType("measure", Measure.parse, pattern=r"\s*[0-9.]+([eE][+\-]?[0-9]+)?\s*%?\s*")
COUNT = AttributeType("count", _count, pattern=r"[0-9]+")
REGIONS = AttributeType("regions", RegionSet.parse)
EXTENT = AttributeType("extent", Extent.parse)
WORD = AttributeType("word", Word.parse)
PATH = AttributeType("path", lambda text: _paths(text)[0])
PATHS = AttributeType("paths", _paths, " ".join)


def attribute(kind: AttributeType, help: str, default: Any = MISSING) -> Any:
    """Declare a constraint's attribute: a dataclass field that knows its type and what to say of it."""
    metadata = {"type": kind, "help": help}
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
    )
