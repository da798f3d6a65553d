"""Pictures of facades and layouts in pixels: from the input's photo, or by label colours."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from layoutkit.model import Facade, Layout, Piece, PlacedRegion, place
from layoutkit.pictures.grid import Cell, PixelGrid
from layoutkit.pictures.palette import colour_of, darker
from layoutkit.pictures.photo import Photo
from layoutkit.pictures.sources import Pieces, known_sources, sources

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: Pixels a document unit where no photo gives them.
DEFAULT_SCALE = {"m": 50.0, "px": 1.0}

#: What shows around the faces of a building, which need not be equally high.
BACKGROUND = "#ffffff"

#: The longest side of a picture, in pixels, unless asked otherwise.
LONGEST = 4096


def render_png(
    document: Facade | Layout,
    photo: Photo | None = None,
    *,
    origins: Mapping[str, Pieces] | None = None,
    scale: float = 1.0,
    longest: int = LONGEST,
) -> Image:
    """Return a picture of a facade or layout.

    With a photo, each terminal shows the photo's parts that `origins` name or else `sources` chooses for it,
    a single part stretched or repeated as its `fill` says; without one, terminals are coloured by label and
    outlined.

    Parameters
    ----------
    photo
        The photo of the facade that a layout varies, or that an edited facade began with.
    origins
        Of an edited facade: for each terminal, by its unique path, the pieces that its picture is made of.
    scale
        Pixels a document unit, as a multiple of the photo's own (without one: 50 a metre, 1 a pixel).
    longest
        Greatest width or height in pixels; a larger picture is made smaller as a whole.

    Raises
    ------
    Faulty
        If a layout has a region that the photo's facade lacks, or an edited facade a terminal without pieces
        of it.
    """
    grid = _grid(document, photo, scale, longest)
    if photo is None:
        return _by_labels(document, grid)
    root, facade = document.root, photo.facade
    if origins is None:
        return _by_photo(((own, (Piece.whole(of.box),)) for own, of in sources(root, facade)), photo, grid)
    return _by_photo(known_sources(root, facade, origins), photo, grid)


def png_bytes(image: Image, level: int = 1) -> bytes:
    """Return the image as a PNG file: the same bytes for the same pixels.

    Parameters
    ----------
    level
        How hard to compress, 0 to 9. Photos at 1 take a quarter of the time of 6, and a tenth more room.
    """
    buffer = io.BytesIO()
    image.save(buffer, "PNG", compress_level=level)
    return buffer.getvalue()


def _grid(document: Facade | Layout, photo: Photo | None, scale: float, longest: int) -> PixelGrid:
    root = document.root
    natural = photo.grid.scale if photo else (DEFAULT_SCALE[document.units],) * 2
    wanted = max(root.width * natural[0], root.height * natural[1]) * scale
    factor = scale * min(1.0, longest / wanted)
    return PixelGrid.at(root.width, root.height, (natural[0] * factor, natural[1] * factor))


def _by_photo(pairs: Iterable[tuple[PlacedRegion, Pieces]], photo: Photo, grid: PixelGrid) -> Image:
    """Return a picture of placed terminals, each with its pieces of the photo's facade."""
    from PIL import Image

    canvas = Image.new("RGB", (grid.columns, grid.rows), BACKGROUND)
    made: dict[tuple[Pieces, tuple[int, int]], Image.Image] = {}
    for placed, pieces in pairs:
        left, top, right, bottom = grid.cell(placed.box)
        size = (right - left, bottom - top)
        if min(size) == 0:
            continue
        # Replicas of one source differ by a pixel at most: most textures are made once.
        if (key := (pieces, size)) not in made:
            made[key] = photo.texture(pieces, placed.region, size)
        canvas.paste(made[key], (left, top))
    return canvas


def _by_labels(document: Facade | Layout, grid: PixelGrid) -> Image:
    from PIL import Image, ImageDraw

    canvas = Image.new("RGB", (grid.columns, grid.rows), BACKGROUND)
    draw = ImageDraw.Draw(canvas)
    for placed in place(document.root):
        if placed.region.terminal:
            _fill(draw, placed, grid.cell(placed.box))
    return canvas


def _fill(draw: ImageDraw, placed: PlacedRegion, cell: Cell) -> None:
    left, top, right, bottom = cell
    if left < right and top < bottom:
        colour = colour_of(placed.region)
        draw.rectangle((left, top, right - 1, bottom - 1), colour, darker(colour), 1)
