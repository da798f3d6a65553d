"""Facades of the CMP database as scenes of one scale."""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from layoutkit.diagnostics import Diagnostic
from layoutkit.model.scene import Polygon, Scene
from layoutkit_formats.boxes import LabelBox
from layoutkit_formats.cmp import boxes_of
from layoutkit_formats.pictures import picture_size

#: A pixel of a photo has no size of its own. Each facade is scaled so that its median window, by the geometric
#: mean of its sides, measures this many metres: of what was tried (height of the facade, width, height or area
#: of windows, diagonal of the picture), this makes the elements of all facades most alike in size.
WINDOW = 1.5


def facades(folder: Path) -> tuple[Scene, ...]:
    """Return all facades of a folder in the order of their names.

    Boxes without area and copies are left out; boxes keep what else is amiss with them: they overlap, miss
    elements, and end some pixels off.
    """
    return tuple(facade(path) for path in sorted(folder.glob("*.xml")))


def facade(path: Path) -> Scene:
    """Return one facade, y up, in metres by its windows; the picture is beside the file."""
    width, height = picture_size(path.with_suffix(".jpg"))
    faults: list[Diagnostic] = []
    boxes = list(boxes_of(path, width, height, faults))
    metres = WINDOW / statistics.median((b.width * b.height) ** 0.5 for b in boxes if b.label == "Window")
    return Scene(path.stem, "m", tuple(_polygons(boxes, height, metres)))


def _polygons(boxes: Sequence[LabelBox], height: int, metres: float) -> list[Polygon]:
    counts: Counter[str] = Counter()
    found = []
    for label, x0, y0, x1, y1 in boxes:
        counts[label] += 1
        corners = (x0 * metres, (height - y1) * metres, x1 * metres, (height - y0) * metres)
        found.append(Polygon.rectangle(f"{label}_{counts[label]}", *corners, labels=(label,)))
    return found
