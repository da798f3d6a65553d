"""Pictures with grids marked: what is where, and in which colour."""

from __future__ import annotations

import numpy as np
from pictured import composite, facade, floor, leaf
from PIL import Image

from layoutkit.model import Box, Facade, Grid, place
from layoutkit.pictures import png_bytes, render_png
from layoutkit.pictures.grid import PixelGrid
from layoutkit.pictures.gridded import COLOURS, NEW, grid_marks, legend_of, with_grids
from layoutkit.pictures.legend import MARGIN, Entry, with_legend
from layoutkit.pictures.palette import PALETTE

GREY = (128, 128, 128)
WINDOWS = Grid(
    "windows", elements=tuple(f"Facade/Floor{f}/Bay{b}/Window" for f in ("", ".2") for b in ("", ".2"))
)
PIERS = Grid("piers", elements=("Facade/Floor/Pier", "Facade/Floor/Pier.3", "Facade/Floor.2/Pier.2"))


def grey(source: Facade, scale: int = 30) -> Image.Image:
    return Image.new("RGB", (round(source.root.width * scale), round(source.root.height * scale)), GREY)


def cells(source: Facade, image: Image.Image) -> dict[str, tuple[slice, slice]]:
    """Return the pixels of each region, by its path."""
    grid = PixelGrid(source.root.width, source.root.height, *image.size)
    found = {}
    for placed in place(source.root):
        left, top, right, bottom = grid.cell(placed.box)
        found[placed.path] = (slice(top, bottom), slice(left, right))
    return found


def of_colour(image: Image.Image, colour: tuple[int, int, int]) -> np.ndarray:
    return (np.asarray(image) == colour).all(axis=2)


def test_elements_are_outlined_and_nothing_else() -> None:
    source = facade()
    image = grey(source)
    marked = with_grids(image, source, grid_marks(source, [WINDOWS]))
    assert marked.size == image.size
    touched = (np.asarray(marked) != np.asarray(image)).any(axis=2)
    outlined = of_colour(marked, COLOURS[0])
    elsewhere = np.ones_like(touched)
    for path in WINDOWS.elements:
        rows, columns = cells(source, image)[path]
        assert outlined[rows, columns][1, 5:-5].all(), "along the upper edge"
        assert outlined[rows, columns][5:-5, -2].all(), "along the right edge"
        assert not touched[rows, columns][8:-8, 8:-8].any(), "the inside stays as it is"
        elsewhere[rows, columns] = False
    assert not touched[elsewhere].any()
    assert np.asarray(image).std() == 0, "the picture itself is not drawn on"


def test_phantoms_are_circles_where_row_and_column_cross() -> None:
    source = facade()
    image = grey(source)
    (mark,) = grid_marks(source, [PIERS])
    assert len(mark.elements) == 3
    # Columns of piers are at 1, 6 and 11; floors in the middle of 2 to 8 and of 8 to 14.
    assert np.allclose(sorted(mark.phantoms), [(1, 5), (6, 11), (11, 5)])
    marked = with_grids(image, source, [mark])
    for x, y in mark.phantoms:
        column, row = round(x * 30), round((14 - y) * 30)
        assert marked.getpixel((column, row)) == (255, 255, 255), "its middle"
        ring = of_colour(marked, COLOURS[0])[row - 9 : row + 10, column - 9 : column + 10]
        assert ring[9, :].sum() >= 4, "left and right of it"
    dashed = of_colour(marked, COLOURS[0])[90, 60:150]  # from the first pier to the phantom beside
    assert 0.2 < dashed.mean() < 0.8


def test_grids_without_phantoms_have_no_links() -> None:
    (mark,) = grid_marks(facade(), [WINDOWS])
    assert (mark.phantoms, mark.links) == ((), ())


def test_grids_that_share_elements_show_beside_each_other() -> None:
    source = facade()
    image = grey(source)
    marked = with_grids(image, source, grid_marks(source, [WINDOWS, Grid("all", elements=WINDOWS.elements)]))
    for path in WINDOWS.elements:
        rows, columns = cells(source, image)[path]
        for colour in COLOURS[:2]:
            assert of_colour(marked, colour)[rows, columns].sum() > 4 * 40


def test_new_elements_are_tinted_in_a_colour_of_their_own() -> None:
    source = facade()
    image = grey(source)
    new = [placed.box for placed in place(source.root) if placed.path == WINDOWS.elements[1]]
    marked = with_grids(image, source, grid_marks(source, [WINDOWS]), new)
    for path in WINDOWS.elements:
        rows, columns = cells(source, image)[path]
        inside = np.asarray(marked)[rows, columns][8:-8, 8:-8].reshape(-1, 3).astype(int)
        green = inside[:, 1] - inside[:, 0]
        assert (green > 20).all() == (path == WINDOWS.elements[1])
        assert (green > 20).any() == (path == WINDOWS.elements[1])


def test_thin_elements_are_marked_as_well() -> None:
    strip = leaf("Strip", 10, 0.02)
    source = Facade("f", "m", composite("F", "rows", leaf("A", 10, 5), strip, leaf("B", 10, 5)))
    marked = with_grids(grey(source, 20), source, grid_marks(source, [Grid("strips", elements=("F/Strip",))]))
    assert of_colour(marked, COLOURS[0])[95:105].any(axis=0).mean() > 0.9


def test_marks_stand_out_from_what_labels_look_like() -> None:
    def far(one: tuple[int, ...], other: tuple[int, ...]) -> int:
        return sum(abs(a - b) for a, b in zip(one, other, strict=True))

    marks = (*COLOURS, NEW)
    assert all(far(mark, colour) > 100 for mark in marks for colour in PALETTE.values())
    assert all(far(one, other) > 80 for number, one in enumerate(marks) for other in marks[:number])


def test_the_legend_tells_every_grid_and_what_is_new() -> None:
    source = facade()
    marks = grid_marks(source, [WINDOWS, PIERS])
    assert [entry.text for entry in legend_of(marks)] == [
        "windows: 2 rows × 2 columns",
        "piers: 2 rows × 3 columns, 3 phantoms",
    ]
    assert [entry.text for entry in legend_of(marks[:1], "added")][1:] == ["added"]
    page = with_legend(grey(source), [Entry("what it is"), *legend_of(marks, "added")])
    below = page.crop((0, 14 * 30 + MARGIN, page.width, page.height))
    for colour in (*COLOURS[:2], NEW):
        assert of_colour(below, colour).sum() > 30
    assert not of_colour(below, COLOURS[2]).any()


def test_more_grids_than_colours_begin_again() -> None:
    source = facade()
    marks = grid_marks(source, [Grid(f"g{n}", elements=("Facade/Base",)) for n in range(len(COLOURS) + 1)])
    assert marks[0].colour == marks[-1].colour


def test_the_same_marks_give_the_same_bytes() -> None:
    source = facade()
    marks, new = grid_marks(source, [WINDOWS, PIERS]), [Box(0, 0, 2, 2)]
    first, second = (png_bytes(with_grids(render_png(source), source, marks, new)) for _ in range(2))
    assert first == second


def test_boxes_of_sizes_that_differ_within_a_floor() -> None:
    """Rows follow from overlap: elements of unlike heights stand in one."""
    source = Facade("f", "m", composite("F", "columns", floor("A", "PBP"), floor("B", "PBP")))
    (mark,) = grid_marks(source, [Grid("g", elements=("F/A/Bay/Window", "F/B/Pier"))])
    assert mark.text == "g: 1 row × 2 columns"
