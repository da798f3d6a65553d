"""Pictures with marks: where they are, and that the legend has room."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from layoutkit.model import Box, Facade, Region
from layoutkit.pictures import png_bytes
from layoutkit.pictures.legend import MARGIN, NARROWEST
from layoutkit.pictures.marks import AMBER, RED, Mark, marked

GREY = (90, 90, 90)


def facade(width: float, height: float) -> Facade:
    return Facade("f", "px", Region("R", width, height))


def picture(width: int, height: int) -> Image.Image:
    return Image.new("RGB", (width, height), GREY)


def shown(page: Image.Image, width: int, height: int) -> np.ndarray:
    """Return the pixels of the part that shows the document."""
    return np.asarray(page)[MARGIN : MARGIN + height, MARGIN : MARGIN + width].astype(int)


def coloured(pixels: np.ndarray, colour: tuple[int, int, int]) -> np.ndarray:
    return np.abs(pixels - np.array(colour)).sum(axis=2) < 12


def test_what_is_broken_is_hatched_and_nothing_else() -> None:
    mark = Mark((Box(300.0, 100.0, 500.0, 300.0),), "too wide", True)
    pixels = shown(marked(picture(700, 400), facade(700.0, 400.0), [mark], "f"), 700, 400)
    red = coloured(pixels, RED)
    inside = np.zeros_like(red)
    inside[100:300, 300:500] = True  # y up: from 100 below the top
    assert red[inside].mean() > 0.03
    assert not red[~inside].any()
    # A hatching reaches every part of it.
    tinted = pixels[:, :, 0] - pixels[:, :, 2] > 40
    for rows in (slice(103, 200), slice(200, 297)):
        for columns in (slice(303, 400), slice(400, 497)):
            assert 0.1 < tinted[rows, columns].mean() < 0.7


def test_what_takes_part_is_outlined() -> None:
    mark = Mark((Box(0.0, 0.0, 350.0, 400.0),), "size of R/a: at most 3 m", False)
    pixels = shown(marked(picture(700, 400), facade(700.0, 400.0), [mark], "f"), 700, 400)
    amber = coloured(pixels, AMBER)
    assert amber[:, :350].any()
    assert not amber[:, 350:].any()
    assert not amber[20:-20, 20:330].any(), "the inside stays as it is"


def test_the_picture_is_paler() -> None:
    pixels = shown(marked(picture(700, 400), facade(700.0, 400.0), [], "f"), 700, 400)
    assert pixels.min() > GREY[0] + 30
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) == 1


@pytest.mark.parametrize("size", [(700, 400), (60, 900), (40, 30), (3, 1000)])
def test_all_of_the_legend_is_on_the_page(size: tuple[int, int]) -> None:
    """A longer legend makes a larger page, below the picture or beside it, and leaves a margin."""
    long = " ".join(["size of Facade/Floor/Bay and Facade/Floor/Axis at least 1.26 m"] * 5)
    box = Box(0.0, 0.0, float(size[0]), float(size[1]))
    marks = [Mark((box,), long, True), Mark((), "arrangement of R: as in the input: ⊢ × …", False)]
    few, many = (
        marked(picture(*size), facade(*map(float, size)), some, "f") for some in (marks[1:], marks * 3)
    )
    assert many.height > few.height or size[1] > 800
    assert many.width >= NARROWEST
    for page in (few, many):
        pixels = np.asarray(page)
        assert (pixels[-MARGIN // 2 :] == 255).all()
        assert (pixels[:, -MARGIN // 4 :] == 255).all()


def test_a_region_that_nearly_vanished_shows_as_well() -> None:
    mark = Mark((Box(200.0, 0.0, 200.01, 400.0),), "too narrow", True)
    pixels = shown(marked(picture(700, 400), facade(700.0, 400.0), [mark], "f"), 700, 400)
    assert coloured(pixels, RED)[:, 198:206].any(axis=1).mean() > 0.9


def test_numbers_go_from_one_and_the_same_marks_give_the_same_bytes() -> None:
    marks = [Mark((Box(0.0, 0.0, 90.0, 90.0),), f"line {n}", True) for n in range(12)]
    first, second = (png_bytes(marked(picture(700, 400), facade(700.0, 400.0), marks, "f")) for _ in range(2))
    assert first == second
