"""Facades of the CMP Facade Database as scenes: boxes that overlap as they were drawn."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Picture, Scene
from layoutkit_formats.boxes import hull
from layoutkit_formats.cmp import CmpFormat, boxes_of
from layoutkit_formats.pictures import beside, picture_size
from layoutkit_formats.remarks import conversion
from layoutkit_formats.scenes.drawing import Drawing


class CmpScenes(SceneFormat):
    """Reads the boxes of the CMP Facade Database as upright polygons, with the photo beside them."""

    name = "cmp"
    summary = CmpFormat.summary

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file begins with an `<object>`."""
        return CmpFormat().recognises(path, head)

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene in the pixels of the picture beside it, y up from its lower edge."""
        photo = beside(path)
        if photo is None:
            hint = "put the photo beside the file, under the same name"
            raise Faulty([conversion("LK302", "the picture's size is not known", Place(str(path)), hint)])
        width, height = picture_size(photo)
        drawing = Drawing(path)
        boxes = tuple(boxes_of(path, width, height, drawing.remarks))
        for label, x0, top, x1, bottom in boxes:
            y0, y1 = height - bottom, height - top
            drawing.add([((x0, y0), (x1, y0), (x1, y1), (x0, y1))], (label,), angle=0.0)
        picture = None
        if boxes:
            _, left, upper, right, lower = hull(boxes)
            picture = Picture(str(photo), (left, upper, right, lower))
        return drawing.scene(path.stem, "px", picture)
