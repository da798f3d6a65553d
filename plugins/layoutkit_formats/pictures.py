"""The pictures that annotations were made of: where they are, and how large."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Faulty, Place
from layoutkit_formats.remarks import conversion

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from PIL.Image import Image

#: What a picture beside an annotation may end in.
ENDINGS = (".jpg", ".jpeg", ".JPG", ".png")


def beside(path: Path) -> Path | None:
    """Return the picture of the same name in the annotation's folder, if there is one."""
    candidates = (path.with_suffix(ending) for ending in ENDINGS)
    return next((p for p in candidates if p != path and p.is_file()), None)


def picture_size(path: Path) -> tuple[int, int]:
    """Return a picture's width and height in pixels.

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    with _opened(path) as picture:
        return picture.size


def loaded(path: Path) -> tuple[str, NDArray[np.uint8]]:
    """Return a picture's mode (P, L or RGB) and its pixels: shape (height, width), or (height, width, 3).

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    import numpy as np

    with _opened(path) as picture:
        try:
            shown = picture if picture.mode in ("P", "L") else picture.convert("RGB")
            return shown.mode, np.asarray(shown, np.uint8)
        except (OSError, SyntaxError, ValueError) as error:
            raise _unreadable(path, error) from None


def _opened(path: Path) -> Image:
    from PIL import Image

    try:
        return Image.open(path)
    except (OSError, ValueError) as error:  # an unidentified picture is an OSError too
        raise _unreadable(path, error) from None


def _unreadable(path: Path, error: Exception) -> Faulty:
    return Faulty([conversion("LK302", f"the picture cannot be read: {error}", Place(str(path)))])
