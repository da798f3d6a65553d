"""Pictures in pixels: where the photo's parts come out."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pictured import (
    composite,
    facade,
    flat_photo,
    floor,
    layout,
    leaf,
    noise_photo,
)
from PIL import Image

from layoutkit.diagnostics import Faulty
from layoutkit.model import Box, Facade, Picture, Region, place
from layoutkit.pictures import Photo, png_bytes, render_png
from layoutkit.pictures.grid import PixelGrid
from layoutkit.pictures.palette import colour_of


def test_the_input_shows_the_photo() -> None:
    source = facade()
    photo, pixels = noise_photo(source)
    assert np.array_equal(np.asarray(render_png(source, photo)), pixels)


def test_a_layout_of_the_same_words_and_sizes_shows_the_photo() -> None:
    source = facade()
    photo, pixels = noise_photo(source)
    assert np.array_equal(np.asarray(render_png(layout(source.root, source), photo)), pixels)


@given(st.floats(0.31, 400.0), st.floats(0.31, 400.0), st.integers(0, 9), st.integers(1, 300))
def test_the_input_shows_the_photo_whatever_its_units(
    width: float, height: float, left: int, columns: int
) -> None:
    kinds = [leaf("A", width / 7, height), leaf("B", width * 6 / 7, height)]
    picture = Picture("p.png", (left + 0.4, 3.0, float(left + columns), 93.2))
    source = Facade("f", "m", composite("Facade", "columns", *kinds), picture)
    photo, pixels = noise_photo(source)
    assert np.array_equal(np.asarray(render_png(source, photo)), pixels)


def test_every_region_shows_its_source() -> None:
    """One floor more, one bay more, other sizes: bays and floors come whole from one of the input."""
    source = facade()
    photo, colour = flat_photo(source)
    story = floor("Floor", "PBPBPBP", pier=1.7, width=3.1, height=5)
    root = composite("Facade", "rows", story, story, story, leaf("Base", story.width, 2, "repeat"))
    image = render_png(layout(root, source), photo)

    def expected(path: str) -> str:
        parts = path.replace("Floor.3", "Floor").split("/")
        return "/".join(parts).replace("Bay.3", "Bay").replace("Pier.4", "Pier")

    shown = shown_colours(root, image)
    assert len(shown) == 3 * (4 + 3 * 2) + 1
    assert shown == {path: colour[expected(path)] for path in shown}


def shown_colours(root: Region, image: Image.Image) -> dict[str, tuple[int, ...]]:
    """Return the colour of each terminal's middle pixel."""
    grid = PixelGrid(root.width, root.height, *image.size)
    found = {}
    for placed in place(root):
        if placed.region.terminal:
            left, top, right, bottom = grid.cell(placed.box)
            found[placed.path] = image.getpixel(((left + right) // 2, (top + bottom) // 2))
    return found


def test_edges_are_shared_and_sharp() -> None:
    """Flat colours stay flat up to the last pixel: no gap, nothing painted twice, nothing bled over."""
    source = facade()
    photo, colour = flat_photo(source)
    story = floor("Floor", "PBPBP", pier=1.23, width=2.77, height=4.56)
    root = composite("Facade", "rows", story, leaf("Base", story.width, 1.11, "repeat"))
    image = render_png(layout(root, source), photo)
    grid = PixelGrid(root.width, root.height, *image.size)
    pixels, painted = np.asarray(image), np.zeros(image.size[::-1], int)
    for placed in place(root):
        if placed.region.terminal:
            left, top, right, bottom = grid.cell(placed.box)
            painted[top:bottom, left:right] += 1
            assert (pixels[top:bottom, left:right] == colour[placed.path]).all()
    assert (painted == 1).all()


@given(st.lists(st.floats(0.001, 50.0), min_size=1, max_size=40), st.floats(0.1, 90.0))
def test_cells_tile_the_grid(widths: list[float], scale: float) -> None:
    root = composite("F", "columns", *(leaf(f"C{i}", width, 1.0) for i, width in enumerate(widths)))
    grid = PixelGrid.at(root.width, root.height, (scale, scale))
    cells = [grid.cell(p.box) for p in place(root) if p.region.terminal]
    assert cells[0][0] == 0
    assert cells[-1][2] == grid.columns
    assert all(one[2] == other[0] for one, other in pairwise(cells))


def test_edges_that_differ_by_rounding_noise_share_a_pixel() -> None:
    grid = PixelGrid(10.0, 10.0, 10, 10)
    noisy, exact = Box(0, 0, 2.5 - 1e-13, 1), Box(2.5, 0, 10, 1)
    assert grid.cell(noisy)[2] == grid.cell(exact)[0] == 3


def striped(width: int, height: int) -> Image.Image:
    """Return upright stripes, one a quarter of the width, of grey levels 0, 80, 160, 240."""
    levels = np.repeat(np.array([0, 80, 160, 240], np.uint8), width // 4)
    return Image.fromarray(np.repeat(levels[None, :], height, axis=0)).convert("RGB")


@pytest.mark.parametrize(
    ("width", "copies"), [(8.0, 1), (11.9, 1), (12.1, 2), (16.0, 2), (26.0, 3), (5.0, 1)]
)
def test_repeating_terminals_show_whole_copies(width: float, copies: int) -> None:
    source = Facade("f", "m", Region("Facade", 8, 2, "rows", (leaf("Strip", 8, 2, "repeat"),)))
    photo = Photo(source, striped(320, 80))
    root = Region("Facade", width, 2, "rows", (leaf("Strip", width, 2, "repeat"),))
    row = np.asarray(render_png(layout(root, source), photo))[40, :, 0].astype(int)
    middles = [
        round((copy + (stripe + 0.5) / 4) * len(row) / copies)
        for copy in range(copies)
        for stripe in range(4)
    ]
    there_and_back = [0, 80, 160, 240, 240, 160, 80, 0] * copies  # every second copy is mirrored
    assert [int(row[m]) for m in middles] == there_and_back[: 4 * copies]


def test_copies_downwards_are_not_mirrored() -> None:
    source = Facade("f", "m", Region("Facade", 2, 8, "columns", (leaf("Strip", 2, 8, "repeat"),)))
    photo = Photo(source, striped(320, 80).rotate(-90, expand=True))
    root = Region("Facade", 2, 16, "columns", (leaf("Strip", 2, 16, "repeat"),))
    column = np.asarray(render_png(layout(root, source), photo))[:, 40, 0]
    assert [int(column[40 + 80 * stripe]) for stripe in range(8)] == [0, 80, 160, 240] * 2


def test_stretching_terminals_show_one_copy() -> None:
    source = Facade("f", "m", Region("Facade", 8, 2, "rows", (leaf("Strip", 8, 2),)))
    root = Region("Facade", 24, 2, "rows", (leaf("Strip", 24, 2),))
    row = np.asarray(render_png(layout(root, source), Photo(source, striped(320, 80))))[40, :, 0]
    assert [int(row[m]) for m in (120, 360, 600, 840)] == [0, 80, 160, 240]


def test_thin_regions_of_the_input_keep_a_colour() -> None:
    """A source under half a pixel still gives its larger target something to show."""
    source = Facade(
        "f",
        "m",
        composite("Facade", "columns", leaf("A", 9.999, 5), leaf("B", 0.001, 5)),
        Picture("p", (0, 0, 100, 50)),
    )
    photo, _ = noise_photo(source)
    root = composite("Facade", "columns", leaf("A", 5, 5), leaf("B", 5, 5))
    assert render_png(layout(root, source), photo).size == (100, 50)


@pytest.mark.parametrize(
    ("scale", "longest", "size"),
    [(1.0, 4096, (120, 140)), (0.5, 4096, (60, 70)), (2.0, 4096, (240, 280)), (1.0, 70, (60, 70))],
)
def test_scale_and_limit(scale: float, longest: int, size: tuple[int, int]) -> None:
    source = facade()
    photo, _ = noise_photo(source)
    assert render_png(source, photo, scale=scale, longest=longest).size == size


def test_regions_that_the_facade_lacks_are_named() -> None:
    source = facade()
    photo, _ = noise_photo(source)
    root = composite("Facade", "rows", floor("Flor", "PBP"), leaf("Base", 7, 2))
    with pytest.raises(Faulty) as caught:
        render_png(layout(root, source), photo)
    assert caught.value.diagnostics[0].code == "LK501"
    assert "Facade/Floor" in caught.value.diagnostics[0].hint


def test_another_root_is_a_fault() -> None:
    source = facade()
    photo, _ = noise_photo(source)
    with pytest.raises(Faulty, match="LK501"):
        render_png(layout(leaf("House", 3, 3), source), photo)


def test_without_a_photo_labels_give_the_colours() -> None:
    root = composite("Facade", "columns", leaf("A", 2, 3, labels="Window"), leaf("B", 4, 3, labels="Own"))
    image = render_png(Facade("f", "m", root))
    assert image.size == (300, 150)
    assert image.getpixel((50, 75)) == colour_of(root.children[0])
    assert image.getpixel((200, 75)) == colour_of(root.children[1])
    assert image.getpixel((0, 0)) != colour_of(root.children[0])  # the outline


def test_the_same_pixels_give_the_same_bytes() -> None:
    source = facade()
    photo, _ = noise_photo(source)
    first, second = (png_bytes(render_png(source, photo, scale=1.3)) for _ in range(2))
    assert first == second
    assert b"tIME" not in first


def test_photos_that_cannot_be_used(tmp_path: Path) -> None:
    Image.new("RGB", (50, 50)).save(tmp_path / "photo.png")
    (tmp_path / "text.png").write_text("no picture")
    damaged = png_bytes(Image.effect_noise((64, 64), 50).convert("RGB"))
    (tmp_path / "damaged.png").write_bytes(damaged[: len(damaged) // 2])
    root = facade().root
    for file, reason in (
        ("missing.png", "is not there"),
        ("text.png", "no picture of a known format"),
        ("damaged.png", "cannot be read"),
        ("photo.png", "not inside the picture"),
        (".", "cannot be read"),
    ):
        with pytest.raises(Faulty, match=reason) as caught:
            Photo.open(Facade("f", "m", root, Picture(file, (0, 0, 51, 50))), tmp_path)
        assert caught.value.diagnostics[0].code == "LK010"
    with pytest.raises(Faulty, match="names no picture"):
        Photo.open(Facade("f", "m", root), tmp_path)


def test_a_photo_is_read_from_beside_the_document(tmp_path: Path) -> None:
    Image.new("P", (140, 150), 3).save(tmp_path / "photo.png")
    photo = Photo.open(facade(), tmp_path)
    assert photo.image.size == (120, 140)
    assert photo.image.mode == "RGB"
