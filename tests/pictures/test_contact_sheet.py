"""Contact sheets: every picture there, all at one scale."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from layoutkit.pictures import Exhibit, contact_sheet
from layoutkit.pictures.sheet import HIGHEST, WIDEST


def exhibit(colour: tuple[int, int, int], width: float, height: float, scale: float = 14) -> Exhibit:
    image = Image.new("RGB", (round(width * scale), round(height * scale)), colour)
    return Exhibit(image, f"test-{colour[0]}", width, height, "m")


def extents(sheet: Image.Image, colour: tuple[int, int, int]) -> tuple[int, int, int, int]:
    """Return left, top, right, bottom of the pixels of one colour."""
    rows, columns = np.nonzero((np.asarray(sheet) == colour).all(axis=2))
    assert len(rows), f"{colour} is not on the sheet"
    assert len(rows) == (np.ptp(rows) + 1) * (np.ptp(columns) + 1)  # a whole rectangle, nothing over it
    return int(columns.min()), int(rows.min()), int(columns.max()) + 1, int(rows.max()) + 1


@pytest.mark.parametrize("count", [0, 1, 2, 7, 12, 40])
def test_every_picture_is_there_at_one_scale(count: int) -> None:
    original = exhibit((10, 120, 30), 8, 6)
    variations = [exhibit((10 + 5 * (i + 1), 40, 200), 8 + i % 3, 6 + i % 2) for i in range(count)]
    sheet = contact_sheet(original, variations)
    assert sheet.width <= WIDEST
    assert sheet.height <= HIGHEST
    boxes = [extents(sheet, e.image.getpixel((0, 0))) for e in (original, *variations)]
    scale = (boxes[0][2] - boxes[0][0]) / 8
    for box, shown in zip(boxes, (original, *variations), strict=True):
        assert box[2] - box[0] == pytest.approx(shown.width * scale, abs=1.5)
        assert box[3] - box[1] == pytest.approx(shown.height * scale, abs=1.5)
    assert boxes[0] == min(boxes, key=lambda b: (b[3], b[0]))  # the input comes first


def test_hundreds_of_pictures_make_a_higher_sheet() -> None:
    small = exhibit((1, 2, 3), 8, 6, 10)
    sheet = contact_sheet(small, [small] * 1500)
    assert sheet.width <= WIDEST
    assert sheet.height > HIGHEST


def test_pictures_of_a_row_stand_on_one_line() -> None:
    sheet = contact_sheet(exhibit((1, 2, 3), 4, 3), [exhibit((4, 5, 6), 4, 5), exhibit((7, 8, 9), 4, 4)])
    assert len({extents(sheet, colour)[3] for colour in ((1, 2, 3), (4, 5, 6), (7, 8, 9))}) == 1


def test_no_picture_is_enlarged() -> None:
    sheet = contact_sheet(exhibit((1, 2, 3), 2, 1, 50), [exhibit((4, 5, 6), 2, 1, 30)])
    left, _, right, _ = extents(sheet, (4, 5, 6))
    assert right - left == 60


def test_captions_tell_name_and_size() -> None:
    shown = exhibit((1, 2, 3), 8.12345, 6.0)
    assert shown.size_text == "8.123 × 6 m"
    one = contact_sheet(shown, [])
    other = contact_sheet(Exhibit(shown.image, "another", 8.12345, 6.0, "m"), [])
    assert one.tobytes() != other.tobytes()


def test_a_remark_stands_before_the_size() -> None:
    shown = exhibit((1, 2, 3), 8.0, 6.0)
    assert (
        Exhibit(shown.image, "test", 8.0, 6.0, "m", "distortion 2.5%").size_text == "distortion 2.5%, 8 × 6 m"
    )


def test_long_names_do_not_run_into_the_neighbour() -> None:
    plain = exhibit((1, 2, 3), 4, 6, 40)
    endless = Exhibit(exhibit((4, 5, 6), 4, 6, 40).image, "x" * 500, 4, 6, "m")
    last = exhibit((7, 8, 9), 4, 6, 40)
    calm = contact_sheet(plain, [Exhibit(endless.image, "", 4, 6, "m"), last])
    busy = contact_sheet(plain, [endless, last])
    _, columns = np.nonzero((np.asarray(calm) != np.asarray(busy)).any(axis=2))
    left = extents(busy, (4, 5, 6))[0]
    assert left - 1 <= columns.min()  # a letter may reach a pixel over
    assert columns.max() < extents(busy, (7, 8, 9))[0]
