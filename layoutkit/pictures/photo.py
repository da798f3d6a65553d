"""A facade's photo: decoded once, then cut up for any number of pictures."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Box, Facade, Picture, Piece, Region
from layoutkit.pictures.grid import Cell, PixelGrid

if TYPE_CHECKING:
    from PIL.Image import Image


class Photo:
    """The part of a picture that a facade covers, in memory.

    Parameters
    ----------
    facade
        What the picture shows; without a `Facade.picture` it is taken to show the facade and nothing else.
    image
        The whole picture.

    Attributes
    ----------
    image
        The facade's part, as RGB.
    grid
        The facade's pixels in it.

    Raises
    ------
    Faulty
        If the facade's box is not inside the picture (LK010).
    """

    def __init__(self, facade: Facade, image: Image) -> None:
        self.facade = facade
        self.image = image.convert("RGB").crop(_part(facade.picture, image))
        self.grid = PixelGrid(facade.root.width, facade.root.height, *self.image.size)

    @classmethod
    def open(cls, facade: Facade, folder: Path) -> Photo:
        """Read the picture that the facade names.

        Parameters
        ----------
        folder
            Where the facade's document lies.

        Raises
        ------
        Faulty
            If the facade names no picture, or the file cannot be read (LK010).
        """
        if facade.picture is None:
            raise _faulty(f"the facade {facade.name!r} names no picture", "add a picture element", None)
        return cls(facade, _opened(folder / facade.picture.file))

    @classmethod
    def decoded(cls, facade: Facade, data: bytes | None, file: Path) -> Photo:
        """Read the picture that the facade names where its bytes are at hand, and its file is elsewhere.

        Parameters
        ----------
        data
            None where it is not there.
        file
            What diagnostics name.

        Raises
        ------
        Faulty
            If it cannot be read (LK010).
        """
        if data is None:
            raise _missing(file)
        return cls(facade, _opened(file, io.BytesIO(data)))

    def texture(self, pieces: tuple[Piece, ...], region: Region, size: tuple[int, int]) -> Image:
        """Return the picture of a terminal.

        Parameters
        ----------
        pieces
            The parts of the facade that it is made of. If there are several, each stretches.
        region
            The terminal in its layout: its size, and whether a single piece stretches or repeats.
        size
            Width and height in pixels.
        """
        from PIL import Image

        if len(pieces) == 1:
            return _brought_to(size, _repeated(self._cut(pieces[0].source), copies(region, pieces[0].source)))
        whole, grid = Image.new("RGB", size), PixelGrid(1.0, 1.0, *size)
        for piece in pieces:
            left, top, right, bottom = grid.cell(piece.share)
            if left < right and top < bottom:
                whole.paste(_brought_to((right - left, bottom - top), self._cut(piece.source)), (left, top))
        return whole

    def _cut(self, source: Box) -> Image:
        return self.image.crop(_at_least_one_pixel(self.grid.cell(source), self.image.size))

    def window(self, source: Box) -> Box:
        """Return where a part of the facade is in the image, as shares of that, y up.

        Its edges run through the middle of pixels: whoever blends neighbours blends none from outside.
        """
        left, top, right, bottom = _at_least_one_pixel(self.grid.cell(source), self.image.size)
        width, height = self.image.size
        return Box(
            (left + 0.5) / width, 1 - (bottom - 0.5) / height, (right - 0.5) / width, 1 - (top + 0.5) / height
        )


def copies(region: Region, source: Box) -> tuple[int, int]:
    """Return how often a terminal shows its picture side by side, and one upon the other."""
    if region.fill != "repeat":
        return 1, 1
    return _copies(region.width, source.width), _copies(region.height, source.height)


def part_shown(picture: Picture, folder: Path) -> Image:
    """Return the part of a picture that a document covers, as RGB.

    Parameters
    ----------
    folder
        Where the document lies.

    Raises
    ------
    Faulty
        If the file cannot be read, or the part is not inside it (LK010).
    """
    image = _opened(folder / picture.file)
    return image.convert("RGB").crop(_part(picture, image))


def _opened(file: Path, data: io.BytesIO | None = None) -> Image:
    """Read a picture; from its bytes, if these are at hand."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(data or file) as image:
            image.load()
            return image
    except FileNotFoundError:
        raise _missing(file) from None
    except UnidentifiedImageError:
        raise _faulty("this is no picture of a known format", "use PNG or JPEG", file) from None
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        # Pillow's decoders raise SyntaxError and ValueError for damaged files.
        message = f"the picture cannot be read: {error}"
        raise _faulty(message, "save it anew as PNG or JPEG", file) from None


def _part(picture: Picture | None, image: Image) -> Cell:
    if picture is None:
        return 0, 0, image.width, image.height
    left, top, right, bottom = (round(edge) for edge in picture.box)
    if not (0 <= left < right <= image.width and 0 <= top < bottom <= image.height):
        raise _faulty(
            f"the part {left} {top} {right} {bottom} is not inside the picture of "
            f"{image.width} × {image.height} pixels",
            "correct left, top, right and bottom of the picture element: pixels, y down",
            Path(picture.file),
        )
    return left, top, right, bottom


def _at_least_one_pixel(cell: Cell, size: tuple[int, int]) -> Cell:
    """Widen a cell that rounding left empty: a thin region still has a colour."""
    left, top = min(cell[0], size[0] - 1), min(cell[1], size[1] - 1)
    return left, top, max(cell[2], left + 1), max(cell[3], top + 1)


def _copies(target: float, source: float) -> int:
    return max(1, round(target / source))


def _brought_to(size: tuple[int, int], texture: Image) -> Image:
    from PIL.Image import Resampling

    return texture if texture.size == size else texture.resize(size, Resampling.LANCZOS)


def _repeated(texture: Image, copies: tuple[int, int]) -> Image:
    """Return copies side by side, every second one across mirrored.

    In photos, light and perspective drift along a wall or cornice: a mirrored copy goes on where the one
    before ends, a plain one shows a seam. Downwards nothing is mirrored: a moulding upside down looks worse
    than a seam.
    """
    if copies == (1, 1):
        return texture
    from PIL import Image, ImageOps

    width, height = texture.size
    whole = Image.new("RGB", (width * copies[0], height * copies[1]))
    turned = ImageOps.mirror(texture)
    for column in range(copies[0]):
        for row in range(copies[1]):
            whole.paste(turned if column % 2 else texture, (column * width, row * height))
    return whole


def _missing(file: Path) -> Faulty:
    hint = "put the picture there, or correct the file attribute of the picture element"
    return _faulty("the picture is not there", hint, file)


def _faulty(message: str, hint: str, file: Path | None) -> Faulty:
    place = Place(str(file)) if file is not None else None
    return Faulty([Diagnostic("LK010", message, place, hint, topic="picture")])
