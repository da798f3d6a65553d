"""Scenes of data that others made: each read, sound, and written and read back."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
import shapely

from layoutkit.diagnostics import Faulty
from layoutkit.documents import Source, read_scene, scene_bytes
from layoutkit.model import Scene
from layoutkit.scenes.shapes import shapes
from tests.scenes_documents.format_reading import FORMATS, recognised

DATA = Path(__file__).parents[2] / ".." / "shared" / "data"
ABSENT = pytest.mark.skipif(not DATA.is_dir(), reason="the data is not here")


#: What stands on the floor and is wide.
STANDING = {"DiningTable", "Sofa", "Bed", "Dresser", "Desk", "Fridge", "CounterTop"}


def kept(scene: Scene) -> Scene:
    """Check that a scene is sound, and the same once it was written."""
    assert shapely.is_valid(shapes(scene.polygons)).all()
    found = read_scene(Source("scene.xml", scene_bytes(scene)))
    assert (found.scene, found.diagnostics) == (scene, ())
    return scene


@ABSENT
def test_facades_of_the_cmp_database() -> None:
    files = sorted((DATA / "cmp").glob("*.xml"))
    codes: Counter[str] = Counter()
    for path in files:
        assert recognised(path) == ["cmp"]
        scene, remarks = FORMATS["cmp"].read(path, "")
        kept(scene)
        codes.update(d.code for d in remarks)
        assert scene.picture is not None
        left, top, right, bottom = scene.picture.box
        x0, y0, x1, y1 = scene.bounds
        assert (x0, x1, y1 - y0) == pytest.approx((left, right, bottom - top))
        assert "Wall" in scene.labels
        assert all(polygon.angle == 0 for polygon in scene.polygons)
    assert len(files) == 60
    assert set(codes) <= {"LK305", "LK306", "LK307"}


@ABSENT
def test_rooms_of_procthor() -> None:
    path = DATA / "floorplans" / "train.jsonl.gz"
    assert recognised(path) == ["procthor"]
    parts = FORMATS["procthor"].parts(path)
    labels: Counter[str] = Counter()
    for part in parts:
        scene, remarks = FORMATS["procthor"].read(path, part)
        kept(scene)
        assert not remarks
        labels.update(label for polygon in scene.polygons for label in polygon.labels)
        floor, *others = shapes(scene.polygons)
        around = shapely.buffer(floor, 0.06)
        assert all(around.covers(shape) for shape in others), part
    assert len(parts) == 500
    assert (labels["Door"], labels["Window"]) == (500, 642)


@ABSENT
def test_doors_of_procthor_are_free() -> None:
    path = DATA / "floorplans" / "train.jsonl.gz"
    blocked = 0.0
    for part in FORMATS["procthor"].parts(path):
        scene, _ = FORMATS["procthor"].read(path, part)
        made = shapes(scene.polygons)
        labels = [polygon.labels[0] for polygon in scene.polygons]
        doors = shapely.union_all([made[k] for k, label in enumerate(labels) if label == "Door"])
        things = shapely.union_all([made[k] for k, label in enumerate(labels) if label in STANDING])
        blocked += shapely.buffer(doors, 0.3).intersection(things).area
    # Measured from the other end of their walls, they are blocked by more than ten square metres.
    assert blocked < 1


@ABSENT
def test_layers_of_a_city() -> None:
    path = DATA / "city" / "bubenec.gpkg"
    assert FORMATS["geopackage"].parts(path) == ("buildings", "plots", "streets", "tessellation")
    found = {}
    for part in ("buildings", "plots", "tessellation"):
        scene, _ = FORMATS["geopackage"].read(path, part)
        found[part] = len(kept(scene).polygons)
    assert found == {"buildings": 144, "plots": 407, "tessellation": 144}
    with pytest.raises(Faulty, match="35 × LineString"):
        FORMATS["geopackage"].read(path, "streets")


@ABSENT
def test_flats_of_resplan() -> None:
    path = DATA / "floorplans" / "resplan_0_10.json"
    assert recognised(path) == ["resplan"]
    for part in FORMATS["resplan"].parts(path):
        scene = kept(FORMATS["resplan"].read(path, part)[0])
        assert {"living", "kitchen", "door", "window"} <= set(scene.labels)
