"""What edited facades are, and what their pictures show."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from PIL import Image

from layoutkit.documents import read
from layoutkit.model import Facade, place
from layoutkit.pictures.grid import PixelGrid

#: A facade in which no grid is found.
SINGLE = """\
<facade xmlns="urn:layoutkit:1" name="s" units="m">
  <region symbol="S" width="1" height="1"/>
</facade>
"""


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in sorted(folder.iterdir())}


def facade_of(document: Path) -> Facade:
    model = read(document, {}).model
    assert isinstance(model, Facade)
    return model


def shape(document: Path, name: str = "openings") -> tuple[int, int]:
    """Return rows and columns of a grid."""
    facade = facade_of(document)
    (grid,) = (grid for grid in facade.grids if grid.name == name)
    cells = grid.cells(facade)
    return len(cells), len(cells[0])


def colours(document: Path) -> Mapping[str, tuple[int, ...]]:
    """Return the colour in the middle of each terminal, by its path, from the document's own picture."""
    facade = facade_of(document)
    assert facade.picture is not None
    with Image.open(document.parent / facade.picture.file) as picture:
        shown = picture.convert("RGB").crop(tuple(map(int, facade.picture.box)))
    grid = PixelGrid(facade.root.width, facade.root.height, *shown.size)
    found = {}
    for placed in place(facade.root):
        if placed.region.terminal:
            left, top, right, bottom = grid.cell(placed.box)
            found[placed.path] = shown.getpixel(((left + right) // 2, (top + bottom) // 2))
    return found
