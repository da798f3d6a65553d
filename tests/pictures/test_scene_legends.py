"""Legends of scenes: which colour is which label, and what is placed, outside of the drawing."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from layoutkit.documents import read_scene
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.pictures.legend import KEY, LINE, MARGIN
from layoutkit.pictures.palette import colour_of_labels
from layoutkit.pictures.scenes.frame import Frame
from layoutkit.pictures.scenes.marks import PLACED
from layoutkit.pictures.scenes.meanings import Meaning, meanings
from layoutkit.pictures.scenes.painting import drawing, render_scene
from layoutkit.pictures.scenes.svg import render_scene_svg
from layoutkit.samples import list_scenes

SVG = "{http://www.w3.org/2000/svg}"
ROOM = Polygon.rectangle("room", 0, 0, 8, 6, ("Room",))
BED = Polygon("bed", ((1, 1), (3, 1), (3, 4), (1, 4)), ("Bed", "Old"), edges=((1, ("Head",)),))
CHAIR = Placement(6, 3, 1, 0.5, 90, "Chair", 0.75)
SHOWN = Scene("room", "m", (ROOM, BED), (CHAIR,))


def svg_legend(scene: Scene) -> list[str]:
    root = ElementTree.fromstring(render_scene_svg(scene))
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def tall(count: int) -> Scene:
    """Return a tower of storeys of as many labels."""
    return Scene(
        "tower", "m", tuple(Polygon.rectangle(f"s{n}", 0, n, 1, n + 1, (f"Kind{n}",)) for n in range(count))
    )


def test_a_legend_names_every_label_and_what_is_placed() -> None:
    assert meanings(SHOWN) == [
        Meaning("Bed", "area", colour_of_labels(("Bed",))),
        Meaning("Room", "area", colour_of_labels(("Room",))),
        Meaning("Head (edges)", "edge", colour_of_labels(("Head",))),
        Meaning("placed: Chair", "placed", PLACED),
    ]
    assert svg_legend(SHOWN) == ["Bed", "Room", "Head (edges)", "placed: Chair"]


def test_labels_of_one_colour_share_a_line() -> None:
    walls = [Polygon.rectangle(label, 0, 0, 1, 1, (label,)) for label in ("Wall", "Facade", "wall")]
    assert [meaning.text for meaning in meanings(Scene("walls", "m", tuple(walls)))] == ["Facade, Wall, wall"]


def test_shapes_without_labels_are_told_as_well() -> None:
    bare = Scene("bare", "m", (Polygon("a", ROOM.points),), (Placement(1, 1, 1, 1),))
    assert [meaning.text for meaning in meanings(bare)] == ["without a label", "placed"]


def test_the_legend_does_not_cover_the_drawing() -> None:
    plain, page = drawing(SHOWN), render_scene(SHOWN)
    corner = (MARGIN, MARGIN, MARGIN + plain.width, MARGIN + plain.height)
    assert page.crop(corner).tobytes() == plain.tobytes()
    first = MARGIN + plain.height + MARGIN + LINE // 2
    assert page.getpixel((MARGIN + 14, first)) == colour_of_labels(("Bed",))
    assert page.getpixel((MARGIN + 14, first + LINE)) == colour_of_labels(("Room",))
    letters = np.asarray(page)[first - LINE // 2 :, MARGIN + KEY :]
    assert (letters < 100).all(axis=-1).any()


@pytest.mark.parametrize("count", [4, 60])
def test_beside_what_is_high_every_label_has_its_line(count: int) -> None:
    shown = tall(count)
    page, plain = render_scene(shown), drawing(shown)
    assert page.width > plain.width + 600
    assert page.height >= LINE * count
    assert svg_legend(shown) == sorted(f"Kind{n}" for n in range(count))


def test_a_drawing_has_room_for_its_legend() -> None:
    for shown in (SHOWN, tall(40)):
        root = ElementTree.fromstring(render_scene_svg(shown))
        frame = Frame.around(shown, 1000)
        width, height = float(root.get("width", 0)), float(root.get("height", 0))
        box = [float(v) for v in (root.get("viewBox") or "").split()]
        assert box[2] / width == pytest.approx(1 / frame.zoom), "the drawing keeps its size"
        assert box[3] / height == pytest.approx(1 / frame.zoom)
        for text in root.iter(f"{SVG}text"):
            x, y = float(text.get("x", 0)), float(text.get("y", 0))
            assert 0 < x < width
            assert 0 < y < height
            assert x > frame.columns or y > frame.rows, "outside of what is drawn"


def test_a_scene_without_shapes_has_no_legend() -> None:
    empty = Scene("none", "m", ())
    assert render_scene(empty).size == drawing(empty).size
    assert svg_legend(empty) == []


def test_a_drawing_read_as_a_scene_has_no_shapes_of_the_legend(tmp_path: Path, layoutkit: Any) -> None:
    (sample,) = (scene.examples for scene in list_scenes() if scene.name == "bedside")
    drawn, back = tmp_path / "room.svg", tmp_path / "room.xml"
    assert layoutkit("render", sample, "-o", drawn).code == 0
    assert layoutkit("convert", drawn, "-o", back).code == 0
    before, after = read_scene(sample).scene, read_scene(back).scene
    assert set(after.labels) <= set(before.labels)
    assert len(after.polygons) == len(before.polygons) + len(before.placements)
