"""The picture of a document, and the part of it that the document covers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from layoutkit.documents.grammar import PICTURE
from layoutkit.documents.reading import Reading
from layoutkit.documents.tree import Element
from layoutkit.model import Picture
from layoutkit.model.measure import format_number


def picture_of(element: Element, reading: Reading) -> Picture | None:
    """Return what a picture element says; None if that cannot be read. Faults are recorded."""
    values: dict[str, Any] = reading.values(element, PICTURE)
    reading.no_children(element)
    left, top, right, bottom = (values.get(side) for side in ("left", "top", "right", "bottom"))
    if left is None or top is None or right is None or bottom is None:
        return None
    for less, more, names in ((left, right, ("left", "right")), (top, bottom, ("top", "bottom"))):
        if less >= more:
            message = f"the picture's part is empty: {names[0]} {less:g} is not below {names[1]} {more:g}"
            hint = "x counts to the right and y down, in pixels"
            reading.fault("LK213", message, element, hint, topic="reference")
    return Picture(values.get("file") or "", (left, top, right, bottom))


def picture_fields(picture: Picture) -> Iterator[tuple[str, str]]:
    """Yield the attributes of a picture's element, as they are written."""
    yield "file", picture.file
    yield from zip(("left", "top", "right", "bottom"), map(format_number, picture.box), strict=True)
