"""Types of attributes that operations have besides those of constraints, and what they hold as elements."""

from __future__ import annotations

import re
from dataclasses import field
from pathlib import PurePosixPath, PureWindowsPath
from typing import Any

from layoutkit.constraints.attributes import AttributeType
from layoutkit.operations.resources import Asset, Design, Steps

Colour = tuple[int, int, int]

#: The key of a field's metadata that names the element which it is read from.
HELD = "element"

_COLOUR = re.compile("#[0-9A-Fa-f]{6}")


def _colour(text: str) -> Colour:
    if _COLOUR.fullmatch(text.strip()) is None:
        raise ValueError(f"{text!r} is no colour such as #c8b090")
    digits = text.strip()[1:]
    red, green, blue = (int(digits[at : at + 2], 16) for at in (0, 2, 4))
    return red, green, blue


def _colour_text(colour: Colour) -> str:
    return "#" + "".join(f"{part:02x}" for part in colour)


def _file(text: str) -> str:
    if not text.strip():
        raise ValueError("a file is to be named")
    if PurePosixPath(text.strip()).is_absolute() or PureWindowsPath(text.strip()).is_absolute():
        raise ValueError(f"{text!r} is an absolute path: files are named from where the document lies")
    return text.strip()


#: A facade's document, which is read with the operations.
DESIGN = AttributeType("facade file", lambda text: Design(_file(text)), str)
#: A session's document, which is read with the operations.
STEPS = AttributeType("session file", lambda text: Steps(_file(text)), str)
#: A mesh that others modelled, which is read with the operations.
ASSET = AttributeType("mesh file", lambda text: Asset(_file(text)), str)
COLOUR = AttributeType("colour", _colour, _colour_text, pattern=r"\s*#[0-9A-Fa-f]{6}\s*")


def held(element: str, help: str) -> Any:
    """Declare what an operation holds as an element of its own, such as ``placement-model``; or None."""
    return field(default=None, metadata={HELD: element, "help": help})
