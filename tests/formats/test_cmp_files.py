"""CMP files: what is read, and which defects are survived, each with a remark."""

from __future__ import annotations

from pathlib import Path

import pytest
from annotated import WHOLE, agreement, check_exact, converted, grid, remarks, write
from PIL import Image

from layoutkit.diagnostics import Faulty, Severity
from layoutkit_formats.cmp import CmpFormat

WINDOW = ("window", 0.2, 0.3, 0.4, 0.5)


def test_axes_are_swapped_back(tmp_path: Path) -> None:
    facade = converted(tmp_path, [WHOLE, WINDOW])
    window = next(p[0] for p in facade.places.values() if "Window" in p[0].region.labels)
    assert window.box == pytest.approx((0.2 * 600, 0.5 * 800, 0.4 * 600, 0.7 * 800), abs=1e-6)


def test_the_picture_beside_the_file_is_taken(tmp_path: Path) -> None:
    facade = converted(tmp_path, [WHOLE, WINDOW])
    assert facade.name == "house"
    assert facade.units == "px"
    assert facade.picture is not None
    assert facade.picture.file == str(tmp_path / "house.jpg")
    assert facade.picture.box == (0.0, 0.0, 600.0, 800.0)


def test_the_picture_is_cropped_to_the_facade(tmp_path: Path) -> None:
    boxes = [("facade", 0.25, 0.1, 0.75, 0.9), ("window", 0.4, 0.3, 0.6, 0.5)]
    facade = converted(tmp_path, boxes)
    assert facade.picture is not None
    assert facade.picture.box == pytest.approx((150.0, 80.0, 450.0, 720.0))
    assert agreement(facade, boxes) == 1.0


def test_neighbours_beside_the_facade_are_kept(tmp_path: Path) -> None:
    boxes = [("facade", 0.4, 0.0, 1.0, 1.0), ("window", 0.6, 0.3, 0.8, 0.5), ("window", 0.1, 0.3, 0.3, 0.6)]
    facade = converted(tmp_path, boxes)
    assert agreement(facade, boxes) > 0.99
    assert facade.root.word == ("Building", "Building2")


@pytest.mark.parametrize(
    ("defect", "code"),
    [
        (("window", 0.5, 0.5, 0.5, 0.5), "LK305"),
        (("window", float("nan"), 0.5, 0.6, 0.7), "LK305"),
        (("windows", 0.5, 0.5, 0.6, 0.6), "LK304"),
        (("", 0.5, 0.5, 0.6, 0.6), "LK304"),
        (("window", 0.8, 0.5, 1.3, 0.6), "LK306"),
        (WINDOW, "LK307"),
        (("facade", 0.0, 0.0, 0.5, 1.0), "LK308"),
    ],
)
def test_defects_are_survived(
    tmp_path: Path, defect: tuple[str, float, float, float, float], code: str
) -> None:
    boxes = [WHOLE, WINDOW, defect]
    found = remarks(tmp_path, boxes)
    assert [d.code for d in found] == [code]
    assert found[0].severity < Severity.ERROR
    assert found[0].place is not None
    if code not in ("LK308",):
        assert found[0].place.line > 1
    check_exact(converted(tmp_path, boxes))


def test_an_unknown_class_is_answered_with_the_nearest(tmp_path: Path) -> None:
    (found,) = remarks(tmp_path, [WHOLE, WINDOW, ("widnow", 0.5, 0.5, 0.6, 0.6)])
    assert "window" in found.hint


def test_without_a_facade_the_elements_make_it(tmp_path: Path) -> None:
    boxes = [WINDOW, ("window", 0.6, 0.3, 0.8, 0.5)]
    assert [d.code for d in remarks(tmp_path, boxes)] == ["LK309"]
    assert converted(tmp_path, boxes).root.width == pytest.approx(0.6 * 600)


@pytest.mark.parametrize(
    ("text", "code"),
    [("<object><points>", "LK301"), ("", "LK303"), ("<object></object>", "LK303"), ("\x00", "LK301")],
)
def test_broken_files_are_faults(tmp_path: Path, text: str, code: str) -> None:
    file = write(tmp_path, [WHOLE])
    file.write_text(text)
    with pytest.raises(Faulty) as caught:
        CmpFormat().read(file, None)
    assert caught.value.diagnostics[-1].code == code


def test_a_missing_picture_is_a_fault_with_a_hint(tmp_path: Path) -> None:
    file = write(tmp_path, [WHOLE])
    (tmp_path / "house.jpg").unlink()
    with pytest.raises(Faulty) as caught:
        CmpFormat().read(file, None)
    (found,) = caught.value.diagnostics
    assert found.code == "LK302"
    assert "--image" in found.hint


@pytest.mark.parametrize("content", [b"", b"no picture", b"\x89PNG\r\n\x1a\n"])
def test_an_unreadable_picture_is_a_fault(tmp_path: Path, content: bytes) -> None:
    file = write(tmp_path, [WHOLE])
    (tmp_path / "other.png").write_bytes(content)
    for picture in (tmp_path / "other.png", tmp_path / "absent.png", tmp_path):
        with pytest.raises(Faulty, match="LK302"):
            CmpFormat().read(file, picture)


def test_files_are_recognised_by_their_beginning(tmp_path: Path) -> None:
    file = write(tmp_path, grid(2, 2))
    recognises = CmpFormat().recognises
    assert recognises(file, file.read_bytes()[:100])
    assert recognises(file, b"\xef\xbb\xbf<?xml version='1.0'?>\n<object>")
    assert not recognises(file, b"<facade/>")
    assert not recognises(file, b"<objects>")


def test_the_picture_may_lie_elsewhere(tmp_path: Path) -> None:
    file = write(tmp_path, [WHOLE, WINDOW])
    Image.new("RGB", (300, 200)).save(tmp_path / "photo.png")
    facade, _ = CmpFormat().read(file, tmp_path / "photo.png")
    assert (facade.root.width, facade.root.height) == (300, 200)
