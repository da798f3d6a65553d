"""GeoJSON: scenes that we wrote are read back; what others wrote is read as far as it goes."""

from __future__ import annotations

import json
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given

from layoutkit.diagnostics import Faulty
from layoutkit.documents.geojson import geojson_bytes
from layoutkit.model import Picture, Scene
from tests.scenes_documents.drawn_scenes import scenes
from tests.scenes_documents.format_reading import FORMATS, read

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
HOLE = [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]


def feature(coordinates: Any, kind: str = "Polygon", **properties: Any) -> dict[str, Any]:
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def written(tmp_path: Path, *features: Any, **members: Any) -> Path:
    path = tmp_path / "town.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", **members, "features": features}))
    return path


@given(scenes().filter(lambda scene: bool(scene.polygons or scene.placements) and bool(scene.name)))
def test_what_we_write_we_read(scene: Scene) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene.geojson")
        path.write_bytes(geojson_bytes(scene))
        found, remarks = FORMATS["geojson"].read(path, "")
        picture = scene.picture and Picture(str(path.parent / scene.picture.file), scene.picture.box)
        assert found == replace(scene, picture=picture)
        assert remarks == ()
        again = replace(found, picture=scene.picture)
        assert geojson_bytes(again) == path.read_bytes()


def test_other_programs_can_read_it(tmp_path: Path) -> None:
    import shapely

    path = written(tmp_path, feature([SQUARE], label="House"))
    data = json.loads(geojson_bytes(read(path)[0]))
    shape = shapely.geometry.shape(data["features"][0]["geometry"])
    assert shape.equals(shapely.box(0, 0, 4, 4))
    assert data["features"][0]["properties"]["labels"] == ["House"]


@pytest.mark.parametrize(
    ("properties", "labels"),
    [
        ({"label": "House"}, ("House",)),
        ({"labels": ["House", "Big"]}, ("House", "Big")),
        ({"labels": "House Big, Old"}, ("House", "Big", "Old")),
        ({"class": "single family-home"}, ("single_family_home",)),
        ({"class": 7}, ("_7",)),
        ({"name": "Town hall"}, ()),
        ({"label": None, "class": "Shed"}, ("Shed",)),
    ],
)
def test_labels(properties: dict[str, Any], labels: tuple[str, ...], tmp_path: Path) -> None:
    found, codes = read(written(tmp_path, feature([SQUARE], **properties)))
    assert (found.polygons[0].labels, codes) == (labels, [])
    assert found.polygons[0].name == properties.get("name", f"{labels[0] if labels else 'Polygon'}_1")


def test_a_multipolygon_is_split_and_its_holes_are_dropped(tmp_path: Path) -> None:
    far = [[x + 9, y] for x, y in SQUARE]
    found, codes = read(written(tmp_path, feature([[SQUARE, HOLE], [far]], "MultiPolygon", label="House")))
    assert [p.name for p in found.polygons] == ["House_1", "House_2"]
    assert found.polygons[0].points == ((0, 0), (4, 0), (4, 4), (0, 4))
    assert codes == ["LK854"]


def test_what_is_no_polygon_is_left_out(tmp_path: Path) -> None:
    others = [
        feature([0, 0], "Point"),
        feature(SQUARE, "LineString"),
        feature([[[0, "a"], [1, 0], [1, 1]]]),
        feature([[[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]]),
        feature([[[0, 0], [1, 0], [0, 0]]]),
        feature(None),
        feature([[]]),
        {"type": "Feature", "properties": None, "geometry": None},
        7,
    ]
    found, codes = read(written(tmp_path, feature([SQUARE]), *others))
    assert len(found.polygons) == 1
    assert sorted(set(codes)) == ["LK851", "LK852", "LK855"]


@pytest.mark.parametrize(
    "text",
    [
        "{",
        '{"type": "FeatureCollection"}',
        '{"type": "Polygon", "coordinates": 3}',
        '{"type": "Feature"}',
        "{}",
    ],
)
def test_what_has_nothing_in_it(text: str, tmp_path: Path) -> None:
    path = tmp_path / "x.geojson"
    path.write_text(text)
    with pytest.raises(Faulty, match=r"LK30[13]"):
        read(path)


def test_ten_thousand_crossing_polygons_are_told_in_a_few_lines(tmp_path: Path) -> None:
    crossing = feature([[[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]])
    _, remarks = FORMATS["geojson"].read(written(tmp_path, feature([SQUARE]), *[crossing] * 10_000), "")
    assert len(remarks) == 6
    assert sum(d.count for d in remarks) == 10_000


def test_degrees_become_metres(tmp_path: Path) -> None:
    berlin = [[13.40, 52.52], [13.41, 52.52], [13.41, 52.53], [13.40, 52.53], [13.40, 52.52]]
    found, codes = read(written(tmp_path, feature([berlin])))
    x0, y0, x1, y1 = found.bounds
    assert (round(x1 - x0), round(y1 - y0)) == (677, 1112)
    assert codes == ["LK860"]
    plane = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25833"}}
    assert read(written(tmp_path, feature([berlin]), crs=plane))[1] == []
    world = {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}
    assert read(written(tmp_path, feature([SQUARE]), crs=world))[1] == ["LK860"]
