"""The CMP Facade Database's annotations: a run of labelled boxes in XML.

The files have no root element and bare CR line ends; `<x>` gives rows, down the picture, and `<y>` columns,
both as shares of its size (Tyleček and Šára: Spatial Pattern Templates for Recognition of Objects with
Regular Structure, GCPR 2013).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, did_you_mean
from layoutkit.hooks.specs import Format
from layoutkit.model import Facade
from layoutkit_formats.boxes import LabelBox, hull
from layoutkit_formats.facade import Annotation, facade
from layoutkit_formats.pictures import beside, picture_size
from layoutkit_formats.remarks import conversion

if TYPE_CHECKING:
    from lxml.etree import _Element

#: The classes of the database, and the labels that facades give them.
CLASSES = {
    "background": "Background",
    "facade": "Wall",
    "wall": "Wall",
    "window": "Window",
    "door": "Door",
    "cornice": "Cornice",
    "sill": "Sill",
    "balcony": "Balcony",
    "blind": "Blind",
    "deco": "Deco",
    "molding": "Molding",
    "pillar": "Pillar",
    "shop": "Shop",
}


class CmpFormat(Format):
    """Reads the boxes of the CMP Facade Database."""

    name = "cmp"
    summary = "Labelled boxes of the CMP Facade Database: XML without a root element."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file begins with an `<object>`."""
        return re.match(rb"(\xef\xbb\xbf)?\s*(<\?xml[^>]*\?>)?\s*<object\b", head) is not None

    def read(self, path: Path, picture: Path | None) -> tuple[Facade, Sequence[Diagnostic]]:
        """Return the facade; the picture beside the file, of the same name, is taken if none is given."""
        given = picture or beside(path)
        if given is None:
            hint = "name the picture with --image, or put it beside the file"
            raise Faulty([conversion("LK302", "the picture's size is not known", Place(str(path)), hint)])
        width, height = picture_size(given)
        remarks: list[Diagnostic] = []
        boxes = list(boxes_of(path, width, height, remarks))
        place = Place(str(path))
        if not boxes:
            raise Faulty([*remarks, conversion("LK303", "no usable box is in the file", place)])
        facades = sum(box.label == "Wall" for box in boxes)
        if facades > 1:
            message = f"{facades} facades are marked; those side by side become buildings"
            remarks.append(conversion("LK308", message, place, severity=Severity.NOTE))
        if not facades:
            hint = "the box around all others is taken for it"
            remarks.append(_warning("LK309", "no facade box is in the file", place, hint))
            boxes.append(hull(boxes))
        return facade(Annotation(path.stem, width, height, tuple(boxes), str(given))), remarks


def boxes_of(path: Path, width: int, height: int, remarks: list[Diagnostic]) -> Iterator[LabelBox]:
    """Yield the usable boxes in pixels; note what is wrong with the others."""
    seen: set[LabelBox] = set()
    for item in _objects(path):
        place = Place(str(path), line if isinstance(line := item.sourceline, int) else 0)
        found = _box(item, place, remarks)
        if found is None:
            continue
        box = LabelBox(found.label, found.x0 * width, found.y0 * height, found.x1 * width, found.y1 * height)
        if box in seen:
            message = f"the {box.label} box is there twice"
            remarks.append(_warning("LK307", message, place, "the copy is left out"))
            continue
        seen.add(box)
        yield box


def _objects(path: Path) -> list[_Element]:
    """Return the `<object>` elements; lines are counted by the file's own ends."""
    from lxml import etree

    try:
        data = path.read_bytes()
    except OSError as error:
        message = f"the file cannot be read: {error.strerror}"
        raise Faulty([conversion("LK301", message, Place(str(path)))]) from None
    text = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    text = re.sub(rb"^(\xef\xbb\xbf)?\s*(<\?xml[^>]*\?>)?", b"", text)
    parser = etree.XMLParser(resolve_entities=False, no_network=True)
    try:
        root = etree.fromstring(b"<annotation>" + text + b"</annotation>", parser)
    except etree.XMLSyntaxError as error:
        line, column = error.position
        message = f"the file is not XML: {error.msg}"
        raise Faulty([conversion("LK301", message, Place(str(path), line, column))]) from None
    return list(root.iter("object"))


def _box(item: _Element, place: Place, remarks: list[Diagnostic]) -> LabelBox | None:
    """Return one object's box in shares of the picture, or None where it has to be left out."""
    name = (item.findtext("labelname") or "").strip().lower()
    if name not in CLASSES:
        shown = repr(name) if name else "no class"
        remarks.append(
            _warning(
                "LK304", f"{shown} is not one of the database's classes", place, did_you_mean(name, CLASSES)
            )
        )
        return None
    try:
        down, across = ([float(e.text or "") for e in item.iterfind(f"points/{axis}")] for axis in "xy")
    except ValueError:
        down, across = [], []
    if min(len(down), len(across)) < 2 or not all(map(math.isfinite, down + across)):
        remarks.append(
            _warning(
                "LK305",
                f"the {name} box lacks two finite numbers for each axis",
                place,
                "the box is left out",
            )
        )
        return None
    inside = [[min(1.0, max(0.0, v)) for v in (min(values), max(values))] for values in (across, down)]
    if min(down + across) < -0.01 or max(down + across) > 1.01:
        remarks.append(
            _warning(
                "LK306", f"the {name} box reaches beyond the picture", place, "only the part inside is kept"
            )
        )
    (x0, x1), (y0, y1) = inside
    if x1 <= x0 or y1 <= y0:
        remarks.append(_warning("LK305", f"the {name} box has no area", place, "the box is left out"))
        return None
    return LabelBox(CLASSES[name], x0, y0, x1, y1)


def _warning(code: str, message: str, place: Place, hint: str) -> Diagnostic:
    return conversion(code, message, place, hint, Severity.WARNING)
