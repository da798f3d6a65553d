"""Label masks: patches become boxes, classes are known by number or colour, and faults are said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from annotated import DATA, check_exact, shown
from PIL import Image

from layoutkit.diagnostics import Faulty, Severity
from layoutkit_formats.boxes import CODES
from layoutkit_formats.masks import COLOURS, MaskFormat, patches

COLOUR = {label: colour for colour, label in COLOURS.items()}


def coloured(file: Path) -> Path:
    """Sky over a wall with two windows, a balcony below both, and a door."""
    pixels = np.empty((200, 150, 3), np.uint8)
    for label, y0, y1, x0, x1 in (
        ("Sky", 0, 200, 0, 150),
        ("Wall", 30, 200, 0, 150),
        ("Window", 60, 100, 20, 50),
        ("Window", 60, 100, 90, 120),
        ("Balcony", 95, 110, 10, 130),
        ("Window", 60, 97, 20, 50),
        ("Door", 150, 200, 60, 90),
    ):
        pixels[y0:y1, x0:x1] = COLOUR[label]
    Image.fromarray(pixels).save(file)
    return file


def test_colours_become_regions(tmp_path: Path) -> None:
    facade, remarks = MaskFormat().read(coloured(tmp_path / "house.png"), None)
    assert not remarks
    assert {"Sky", "Wall", "Window", "Balcony", "Door"} <= facade.labels
    check_exact(facade)
    truth = np.asarray(Image.open(tmp_path / "house.png"))
    mask = np.zeros(truth.shape[:2], np.uint8)
    for colour, label in COLOURS.items():
        mask[(truth == colour).all(2)] = CODES[label]
    assert (shown(facade, mask.shape) == mask).mean() > 0.97


def test_numbers_become_regions(tmp_path: Path) -> None:
    pixels = np.full((100, 80), 2, np.uint8)
    pixels[20:50, 20:40] = 3
    Image.fromarray(pixels).save(tmp_path / "house.png")
    facade, _ = MaskFormat().read(tmp_path / "house.png", None)
    window = next(p[0] for p in facade.places.values() if "Window" in p[0].region.labels)
    assert window.box == pytest.approx((20, 50, 40, 80))


def test_the_photograph_beside_the_mask_is_its_picture(tmp_path: Path) -> None:
    file = coloured(tmp_path / "house.png")
    Image.new("RGB", (150, 200)).save(tmp_path / "house.jpg")
    facade, _ = MaskFormat().read(file, None)
    assert facade.picture is not None
    assert facade.picture.file == str(tmp_path / "house.jpg")


def test_a_patch_that_is_no_rectangle_is_cut() -> None:
    mask = np.full((60, 60), CODES["Wall"], np.uint8)
    mask[10:50, 10:20] = CODES["Balcony"]
    mask[40:50, 10:50] = CODES["Balcony"]
    found = [box for box in patches(mask) if box.label == "Balcony"]
    assert len(found) == 2
    assert sum(box.width * box.height for box in found) == (mask == CODES["Balcony"]).sum()


def test_hidden_parts_of_a_patch_count_as_filled() -> None:
    mask = np.full((60, 60), CODES["Wall"], np.uint8)
    mask[40:50, 5:55] = CODES["Balcony"]
    mask[20:48, 20:40] = CODES["Window"]
    assert sorted(box.label for box in patches(mask)) == ["Balcony", "Wall", "Window"]


def test_few_unknown_colours_are_survived(tmp_path: Path) -> None:
    file = coloured(tmp_path / "house.png")
    pixels = np.array(Image.open(file))
    pixels[0, :5] = (1, 2, 3)
    Image.fromarray(pixels).save(file)
    _, remarks = MaskFormat().read(file, None)
    assert [(d.code, d.severity) for d in remarks] == [("LK304", Severity.WARNING)]


@pytest.mark.parametrize("colour", [(1, 2, 3), (0, 0, 0)])
def test_pictures_that_are_no_masks_are_faults(tmp_path: Path, colour: tuple[int, int, int]) -> None:
    Image.new("RGB", (20, 20), colour).save(tmp_path / "house.png")
    with pytest.raises(Faulty, match=r"LK30[34]"):
        MaskFormat().read(tmp_path / "house.png", None)


def test_a_picture_of_another_size_is_a_fault(tmp_path: Path) -> None:
    file = coloured(tmp_path / "house.png")
    Image.new("RGB", (15, 20)).save(tmp_path / "other.jpg")
    with pytest.raises(Faulty, match="LK302"):
        MaskFormat().read(file, tmp_path / "other.jpg")


def test_masks_are_recognised(tmp_path: Path) -> None:
    file = coloured(tmp_path / "house.png")
    assert MaskFormat().recognises(file, file.read_bytes()[:16])
    assert not MaskFormat().recognises(file, b"<object>")


@pytest.mark.skipif(not (DATA / "ecp").is_dir(), reason="the ECP facades are not beside the project")
def test_real_masks_agree() -> None:
    found = []
    for file in sorted((DATA / "ecp" / "labels").glob("*.png"))[::4]:
        facade, _ = MaskFormat().read(file, None)
        check_exact(facade)
        pixels = np.asarray(Image.open(file).convert("RGB"))
        mask = np.full(pixels.shape[:2], CODES["Background"], np.uint8)
        for colour, label in COLOURS.items():
            mask[(pixels == colour).all(2)] = CODES[label]
        found.append(float((shown(facade, mask.shape) == mask).mean()))
    assert np.mean(found) > 0.93
