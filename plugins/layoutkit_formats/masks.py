"""Label masks: pictures whose pixels are classes, indexed (CMP) or coloured (ECP).

Each connected patch of a class becomes a box, or several where it is no rectangle; parts that a later class
hides count as filled.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity
from layoutkit.hooks.specs import Format
from layoutkit.model import Facade
from layoutkit_formats.boxes import BACKGROUND, CODES, PAINTING, LabelBox
from layoutkit_formats.facade import Annotation, facade
from layoutkit_formats.pictures import beside, loaded, picture_size
from layoutkit_formats.remarks import conversion

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layoutkit_formats.boxes import Mask

#: The colours of the facades of the Ecole Centrale Paris.
COLOURS: Mapping[tuple[int, int, int], str] = {
    (255, 0, 0): "Window",
    (255, 255, 0): "Wall",
    (128, 0, 255): "Balcony",
    (255, 128, 0): "Door",
    (0, 0, 255): "Roof",
    (128, 255, 255): "Sky",
    (0, 255, 0): "Shop",
    (128, 128, 128): "Chimney",
    (0, 0, 0): "Background",
}

#: The numbers of the CMP Facade Database (label_names.txt).
NUMBERS: Mapping[int, str] = {
    0: "Background",
    1: "Background",
    2: "Wall",
    3: "Window",
    4: "Door",
    5: "Cornice",
    6: "Sill",
    7: "Balcony",
    8: "Blind",
    9: "Deco",
    10: "Molding",
    11: "Pillar",
    12: "Shop",
}

#: A patch is one box if this share of the box is the patch, or hidden.
FILLED = 0.88

#: Patches of fewer pixels than this share of the mask are noise.
SPECK = 0.0001

#: At most this share of a mask's pixels may be of no known class.
UNKNOWN = 0.1


class MaskFormat(Format):
    """Reads label masks."""

    name = "mask"
    summary = "Label masks in PNG: class numbers (CMP) or colours (ECP: red windows, yellow walls, …)."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file is a PNG picture."""
        return head.startswith(b"\x89PNG\r\n\x1a\n")

    def read(self, path: Path, picture: Path | None) -> tuple[Facade, Sequence[Diagnostic]]:
        """Return the facade; its picture is the photograph given or beside the mask, else the mask itself."""
        mask, remarks = _codes(path)
        shown = picture or beside(path) or path
        height, width = mask.shape
        if picture_size(shown) != (width, height):
            message = f"the picture's size is not the mask's, {width} × {height}"
            hint = "name the picture that was labelled"
            raise Faulty([conversion("LK302", message, Place(str(shown)), hint)])
        boxes = tuple(patches(mask))
        if not boxes:
            raise Faulty([*remarks, conversion("LK303", "the mask shows no class", Place(str(path)))])
        return facade(Annotation(path.stem, width, height, boxes, str(shown), mask)), remarks


def _codes(path: Path) -> tuple[Mask, list[Diagnostic]]:
    """Return the mask in our codes, unknown classes as background."""
    import numpy as np

    mode, pixels = loaded(path)
    mask = np.full(pixels.shape[:2], BACKGROUND, np.uint8)
    known = np.zeros(mask.shape, bool)
    if mode in ("P", "L"):
        for number, label in NUMBERS.items():
            known |= (own := pixels == number)
            mask[own] = CODES[label]
    else:
        for colour, label in COLOURS.items():
            known |= (own := (pixels == colour).all(2))
            mask[own] = CODES[label]
    share = 1.0 - float(known.mean())
    if not share:
        return mask, []
    message = f"{share:.2%} of the mask's pixels are of no known class"
    hint = "the classes are the numbers 1 to 12 of CMP, or the colours of ECP"
    if share > UNKNOWN:
        raise Faulty([conversion("LK304", message, Place(str(path)), hint)])
    return mask, [conversion("LK304", message, Place(str(path)), hint, Severity.WARNING)]


def patches(mask: Mask) -> Iterator[LabelBox]:
    """Yield the boxes of a mask's connected patches, class by class; walls are one box."""
    from scipy import ndimage

    for code, label in enumerate(PAINTING):
        if code == BACKGROUND or not (own := mask == code).any():
            continue
        behind = mask >= code
        if label in ("Wall", "Sky"):
            yield _box(label, own, 0, 0)
            continue
        numbered, _ = ndimage.label(own)
        for number, place in enumerate(ndimage.find_objects(numbered), 1):
            patch = numbered[place] == number
            if patch.sum() >= SPECK * mask.size:
                yield from _boxes(label, patch, patch | (behind[place] & (mask[place] != code)), place)


def _boxes(
    label: str, patch: NDArray[np.bool_], filled: NDArray[np.bool_], place: tuple[slice, ...], depth: int = 4
) -> Iterator[LabelBox]:
    """Yield boxes that cover a patch, cut where its outline jumps."""
    if not patch.any():
        return
    box = _box(label, patch, place[1].start, place[0].start)
    y0, y1 = round(box.y0) - place[0].start, round(box.y1) - place[0].start
    x0, x1 = round(box.x0) - place[1].start, round(box.x1) - place[1].start
    patch, filled = patch[y0:y1, x0:x1], filled[y0:y1, x0:x1]
    top, left = round(box.y0), round(box.x0)
    if depth == 0 or filled.mean() >= FILLED or min(patch.shape) < 6:
        yield box
        return
    axis, at = _jump(filled)
    for part in (slice(0, at), slice(at, patch.shape[axis])):
        rows, columns = (part, slice(None)) if axis == 0 else (slice(None), part)
        corner = (
            slice(top + (part.start if axis == 0 else 0), None),
            slice(left + (part.start if axis == 1 else 0), None),
        )
        yield from _boxes(label, patch[rows, columns], filled[rows, columns], corner, depth - 1)


def _jump(filled: NDArray[np.bool_]) -> tuple[int, int]:
    """Return the axis and the index at which the filled share changes most from line to line."""
    import numpy as np

    found = []
    for axis in (0, 1):
        profile = filled.mean(1 - axis)
        steps = np.abs(np.diff(profile))
        at = int(steps.argmax())
        found.append((float(steps[at]), -axis, at + 1))
    _, axis, at = max(found)
    return -axis, at


def _box(label: str, patch: NDArray[np.bool_], left: int, top: int) -> LabelBox:
    import numpy as np

    ys, xs = np.flatnonzero(patch.any(1)), np.flatnonzero(patch.any(0))
    return LabelBox(
        label,
        float(left + xs[0]),
        float(top + ys[0]),
        float(left + xs[-1] + 1),
        float(top + ys[-1] + 1),
    )
