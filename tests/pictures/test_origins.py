"""Pictures of edited facades: every region shows what it was copied from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pictured import composite, facade, flat_photo, floor, leaf, noise_photo
from PIL import Image

from layoutkit.diagnostics import Faulty
from layoutkit.model import Box, Facade, Piece, Region, place
from layoutkit.pictures import Photo, render_png
from layoutkit.pictures.grid import PixelGrid


def terminals(root: Region) -> list[str]:
    return [placed.path for placed in place(root) if placed.region.terminal]


def whole(source: Facade, paths: Mapping[str, str]) -> dict[str, tuple[Piece, ...]]:
    """Return the origins that show one terminal of a facade in each."""
    boxes = {placed.path: placed.box for placed in place(source.root)}
    return {path: (Piece.whole(boxes[origin]),) for path, origin in paths.items()}


def shown(root: Region, image: Image.Image) -> dict[str, tuple[int, ...]]:
    """Return the colours of each terminal, which has to have a single one."""
    grid, pixels = PixelGrid(root.width, root.height, *image.size), np.asarray(image)
    found = {}
    for placed in place(root):
        if placed.region.terminal:
            left, top, right, bottom = grid.cell(placed.box)
            (colour,) = np.unique(pixels[top:bottom, left:right].reshape(-1, 3), axis=0)
            found[placed.path] = tuple(map(int, colour))
    return found


def test_terminals_show_what_they_were_copied_from() -> None:
    """The second bay of the first floor once more, before the first; the windows of both change places."""
    source = facade()
    photo, colour = flat_photo(source)
    root = composite("Facade", "rows", floor("Floor", "PBPBPBP"), leaf("Base", 17, 2, "repeat"))
    origins = {
        "Facade/Floor/Pier": "Facade/Floor/Pier",
        "Facade/Floor/Bay/Window": "Facade/Floor/Bay.2/Window",
        "Facade/Floor/Bay/Sill": "Facade/Floor/Bay.2/Sill",
        "Facade/Floor/Pier.2": "Facade/Floor/Pier.3",
        "Facade/Floor/Bay.2/Window": "Facade/Floor/Bay.2/Window",
        "Facade/Floor/Bay.2/Sill": "Facade/Floor/Bay/Sill",
        "Facade/Floor/Pier.3": "Facade/Floor/Pier.2",
        "Facade/Floor/Bay.3/Window": "Facade/Floor/Bay/Window",
        "Facade/Floor/Bay.3/Sill": "Facade/Floor/Bay.2/Sill",
        "Facade/Floor/Pier.4": "Facade/Floor.2/Pier",
        "Facade/Base": "Facade/Base",
    }
    image = render_png(replace(source, root=root), photo, origins=whole(source, origins))
    assert image.size == (170, 80)
    assert shown(root, image) == {path: colour[origin] for path, origin in origins.items()}


def test_names_that_editing_made_up_show_their_source() -> None:
    """Symbols of an edited facade need not occur in the original, nor need their kind of region."""
    source = facade()
    photo, colour = flat_photo(source)
    root = composite("Facade", "columns", leaf("Pier_2", 3, 14), leaf("Group", 5, 14))
    origins = {"Facade/Pier_2": "Facade/Base", "Facade/Group": "Facade/Floor.2/Pier"}
    image = render_png(replace(source, root=root), photo, origins=whole(source, origins))
    assert shown(root, image) == {path: colour[origin] for path, origin in origins.items()}


@given(st.integers(0, 1000))
def test_a_facade_that_nothing_was_done_to_shows_its_photo(seed: int) -> None:
    source = facade()
    photo, pixels = noise_photo(source, seed)
    origins = {path: path for path in terminals(source.root)}
    assert np.array_equal(np.asarray(render_png(source, photo, origins=whole(source, origins))), pixels)


@pytest.mark.parametrize(
    ("fill", "levels"),
    [("stretch", [0, 0, 80, 80, 160, 160, 240, 240]), ("repeat", [0, 80, 160, 240, 240, 160, 80, 0])],
)
def test_what_grew_is_stretched_or_repeated(fill: str, levels: list[int]) -> None:
    """Against the size of its source, whatever size regions of its symbol had."""
    source = Facade("f", "m", composite("F", "columns", leaf("A", 8, 2, fill), leaf("B", 4, 2)))
    pixels = np.zeros((20, 120, 3), np.uint8)
    pixels[:, :80] = np.repeat([0, 80, 160, 240], 20)[None, :, None]
    root = composite("F", "columns", leaf("B", 4, 2), leaf("A", 16, 2, fill))
    image = render_png(
        replace(source, root=root),
        Photo(source, Image.fromarray(pixels)),
        origins=whole(source, {"F/B": "F/B", "F/A": "F/A"}),
    )
    row = np.asarray(image)[10, 40:, 0]
    assert [int(row[10 + 20 * part]) for part in range(8)] == levels


def test_one_source_at_two_sizes() -> None:
    """Textures that are made once are told apart by size."""
    source = facade()
    photo, colour = flat_photo(source)
    root = composite("Facade", "columns", leaf("A", 2, 3), leaf("B", 3, 3), leaf("C", 2, 3))
    origins = {f"Facade/{symbol}": "Facade/Floor/Pier" for symbol in "ABC"}
    image = render_png(replace(source, root=root), photo, origins=whole(source, origins))
    assert set(shown(root, image).values()) == {colour["Facade/Floor/Pier"]}


@pytest.mark.parametrize("fill", ["stretch", "repeat"])
def test_a_terminal_is_put_together_from_pieces(fill: str) -> None:
    """Each stretched to its share, the same part of the photo as often as pieces name it."""
    source = Facade("f", "m", leaf("F", 8, 4))
    pixels = np.zeros((40, 80, 3), np.uint8)
    pixels[:, :40, 0], pixels[:20, :, 1] = 200, 100
    left, right = Box(0, 0, 4, 2), Box(4, 2, 8, 4)
    pieces = tuple(
        Piece(Box(*share), of)
        for share, of in (
            ((0.0, 0.0, 0.25, 1.0), left),
            ((0.25, 0.5, 1.0, 1.0), right),
            ((0.25, 0.0, 1.0, 0.5), left),
        )
    )
    edited = replace(source, root=leaf("F", 16, 4, fill))
    image = np.asarray(render_png(edited, Photo(source, Image.fromarray(pixels)), origins={"F": pieces}))
    assert image.shape == (40, 160, 3)
    assert (image[:, :40] == (200, 0, 0)).all()
    assert (image[:20, 40:] == (0, 100, 0)).all()
    assert (image[20:, 40:] == (200, 0, 0)).all()


@pytest.mark.parametrize(
    "origins",
    [
        {},
        {"Facade/Pier": ()},
        {"Facade/Pier": (Piece.whole(Box(0, 0, 2, 15)),)},
        {"Facade/Pier": (Piece.whole(Box(2, 0, 2, 3)),)},
        {"Facade/Pier": (Piece.whole(Box(0, 0, 2, 3)), Piece.whole(Box(-1, 0, 2, 3)))},
    ],
)
def test_a_terminal_without_a_picture_is_named(origins: dict[str, tuple[Piece, ...]]) -> None:
    source = facade()
    photo, _ = noise_photo(source)
    root = composite("Facade", "columns", leaf("Pier", 2, 3))
    with pytest.raises(Faulty, match="Facade/Pier has no picture") as caught:
        render_png(replace(source, root=root), photo, origins=origins)
    assert caught.value.diagnostics[0].code == "LK501"


def test_without_a_photo_origins_do_not_matter() -> None:
    source = facade()
    plain, told = (render_png(source, origins=origins) for origins in (None, {"Facade/Base": ()}))
    assert plain.tobytes() == told.tobytes()
