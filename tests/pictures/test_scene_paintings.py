"""Pictures of scenes: colours where polygons are, inner ones upon outer ones, the photo where it belongs."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

from layoutkit.diagnostics import Faulty
from layoutkit.model import Picture, Placement, Polygon, Scene
from layoutkit.pictures.palette import PALETTE, colour_of_labels
from layoutkit.pictures.photo import part_shown
from layoutkit.pictures.scenes.marks import PLACED
from layoutkit.pictures.scenes.painting import NATURAL, drawing, frame_of, render_scene
from layoutkit.pictures.scenes.svg import render_scene_svg

SVG = "{http://www.w3.org/2000/svg}"
ROOM = Polygon.rectangle("room", 0, 0, 8, 6, ("Room",))
BED = Polygon.rectangle("bed", 1, 1, 3, 4, ("Bed",))
CHAIR = Placement(6, 3, 1, 0.5, 90, "Chair", 0.75)


def scene(*polygons: Polygon, placements: tuple[Placement, ...] = ()) -> Scene:
    return Scene("room", "m", polygons, placements)


def pixel(image: Image.Image, shown: Scene, x: float, y: float, photo: Image.Image | None = None) -> object:
    column, row = frame_of(shown, photo).pixel((x, y))
    return image.getpixel((round(column), round(row)))


@pytest.mark.parametrize("polygons", [(ROOM, BED), (BED, ROOM)])
def test_inner_polygons_are_seen_in_any_order(polygons: tuple[Polygon, ...]) -> None:
    shown = scene(*polygons)
    image = drawing(shown)
    assert max(image.size) == NATURAL
    assert pixel(image, shown, 2, 2) == colour_of_labels(("Bed",))
    assert pixel(image, shown, 7, 5) == PALETTE["room"]


def test_placements_are_outlined_not_filled() -> None:
    shown = scene(ROOM, placements=(CHAIR,))
    image = drawing(shown)
    assert pixel(image, shown, 6.25, 3) == PLACED, "its lower side, as it is turned"
    assert pixel(image, shown, 6, 3.25) == PLACED, "the arrow, upwards"
    assert pixel(image, shown, 6.12, 2.75) == PALETTE["room"]


def test_edges_and_corners_have_colours_of_their_own() -> None:
    labelled = Polygon("plot", ROOM.points, ("Plot",), edges=((1, ("Front",)),), corners=((3, ("Gate",)),))
    shown = scene(Polygon.rectangle("all", -2, -2, 10, 8), labelled)
    image = drawing(shown)
    assert pixel(image, shown, 8, 3) == colour_of_labels(("Front",))
    assert pixel(image, shown, 0, 6) == colour_of_labels(("Gate",))
    assert pixel(image, shown, 4, 0) != colour_of_labels(("Front",))


def test_the_photo_stands_where_the_polygons_do(tmp_path: Path) -> None:
    whole = Image.new("RGB", (100, 80), (255, 105, 180))
    whole.paste((0, 0, 200), (10, 10, 90, 70))
    whole.paste((200, 0, 0), (10, 10, 50, 40))  # the upper left of what it shows
    whole.save(tmp_path / "photo.png")
    photo = part_shown(Picture("photo.png", (10, 10, 90, 70)), tmp_path)
    assert photo.size == (80, 60)
    beyond = Placement(9, 3, 1, 1)
    shown = scene(Polygon("hull", ROOM.points), placements=(beyond,))
    image = np.asarray(drawing(shown, photo, scale=4), float)
    frame = frame_of(shown, photo, 4)
    assert frame.zoom == pytest.approx(40, rel=0.01), "ten pixels a unit in the photo"

    def at(x: float, y: float) -> np.ndarray:
        column, row = frame.pixel((x, y))
        return image[round(row), round(column)]

    red, blue = at(2, 5), at(6, 1)
    assert red[0] > red[2] + 50
    assert blue[2] > blue[0] + 50
    assert np.all(at(8.2, 5.8) == 255), "nothing is beside it"


def test_pictures_that_are_missing_are_told(tmp_path: Path) -> None:
    with pytest.raises(Faulty) as caught:
        part_shown(Picture("none.png", (0, 0, 1, 1)), tmp_path)
    assert caught.value.diagnostics[0].code == "LK010"


def test_pictures_get_no_larger_than_allowed() -> None:
    assert max(drawing(scene(ROOM), scale=100, longest=300).size) == 300


def test_an_empty_scene_is_an_empty_picture() -> None:
    image = np.asarray(render_scene(scene()))
    assert np.all(image == 255)


def test_a_drawing_has_every_shape_where_it_is() -> None:
    odd = Polygon("a<b", ((1, 1), (3, 1), (2, 4)), ("Bed", "Old"), edges=((2, ("Head",)),))
    drawn = render_scene_svg(scene(ROOM, odd, placements=(CHAIR,)))
    root = ElementTree.fromstring(drawn)
    polygons = {p.get("data-name"): p for p in root.iter(f"{SVG}polygon") if p.get("data-name")}
    assert list(polygons) == ["room", "a<b"]
    assert polygons["a<b"].get("points") == "1,-1 3,-1 2,-4"
    assert polygons["a<b"].get("data-labels") == "Bed Old"
    assert next(p.get("points") for p in root.iter(f"{SVG}polyline")) == "2,-4 1,-1"
    (group,) = (g for g in root.iter(f"{SVG}g") if g.get("data-score"))
    assert group.get("data-score") == "0.75"
    title = group.findtext(f"{SVG}title") or ""
    assert title.split("\n") == ["1 Chair", "1 × 0.5 m, 90°", "score 0.75"]
    corners = {tuple(map(float, p.split(","))) for p in group[0].get("points", "").split()}
    assert corners == {(6.25, -2.5), (6.25, -3.5), (5.75, -3.5), (5.75, -2.5)}
    left, top, width, height = map(float, (root.get("viewBox") or "").split())
    assert left < 0 < 8 < left + width
    assert top < -6 < 0 < top + height


def test_coordinates_of_maps_keep_their_digits() -> None:
    far = Polygon.rectangle("far", 456789.25, 5543210.5, 456799.75, 5543220.5)
    assert b"456789.25,-5543210.5" in render_scene_svg(scene(far))


def test_a_drawing_holds_its_photo() -> None:
    photo = Image.new("RGB", (80, 60), (9, 90, 200))
    drawn = render_scene_svg(scene(ROOM, placements=(CHAIR,)), photo)
    root = ElementTree.fromstring(drawn)
    (image,) = root.iter(f"{SVG}image")
    assert [image.get(n) for n in ("x", "y", "width", "height")] == ["0", "-6", "8", "6"]
    assert re.match("data:image/jpeg;base64,", image.get("href") or "")
    assert render_scene_svg(scene(ROOM, placements=(CHAIR,)), photo) == drawn
