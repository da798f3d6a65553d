"""ProcTHOR: rooms seen from above, everything where Unity puts it."""

from __future__ import annotations

import gzip
import json
from pathlib import Path
from typing import Any

import pytest

from layoutkit.diagnostics import Faulty
from layoutkit.model import Scene
from tests.scenes_documents.format_reading import FORMATS, read, recognised

ASSETS = {"Chair": [{"assetId": "Chair_1", "boundingBox": {"x": 1.0, "y": 1.2, "z": 0.5}}]}


def corner(x: float, z: float) -> dict[str, float]:
    return {"x": x, "y": 0, "z": z}


def room(number: int, x: float) -> dict[str, Any]:
    corners = [corner(x, 0), corner(x, 3), corner(x + 4, 3), corner(x + 4, 0)]
    return {"id": f"room|{number}", "roomType": "Kitchen", "floorPolygon": corners}


def chair(x: float, z: float, turned: float, **more: Any) -> dict[str, Any]:
    position, rotation = {"x": x, "y": 0.6, "z": z}, {"x": 0, "y": turned, "z": 0}
    return {"assetId": "Chair_1", "position": position, "rotation": rotation, **more}


def house(*rooms: dict[str, Any], **parts: Any) -> dict[str, Any]:
    return {"rooms": list(rooms), "doors": [], "windows": [], "objects": [], "walls": [], **parts}


def written(tmp_path: Path, *houses: dict[str, Any], assets: Any = ASSETS) -> Path:
    path = tmp_path / "houses.jsonl.gz"
    path.write_bytes(gzip.compress("\n".join(map(json.dumps, houses)).encode()))
    if assets is not None:
        (tmp_path / "asset-database.json.gz").write_bytes(gzip.compress(json.dumps(assets).encode()))
    return path


def one(scene: Scene, label: str) -> Any:
    (found,) = (polygon for polygon in scene.polygons if polygon.labels == (label,))
    return found


@pytest.mark.parametrize(
    ("turned", "front"),
    # An object faces along z if it is not turned, and along x if it is turned by 90 degrees.
    [(0, (0, 0.25)), (90, (0.25, 0)), (180, (0, -0.25)), (270, (-0.25, 0))],
)
def test_objects_face_where_unity_turns_them(
    turned: float, front: tuple[float, float], tmp_path: Path
) -> None:
    path = written(tmp_path, house(room(1, 0), objects=[chair(1, 2, turned)]))
    assert recognised(path) == ["procthor"]
    found, codes = read(path)
    (x0, y0), (x1, y1) = one(found, "Chair").points[2:]
    assert ((x0 + x1) / 2 - 1, (y0 + y1) / 2 - 2) == pytest.approx(front)
    assert (found.units, found.polygons[0].labels, codes) == ("m", ("Kitchen",), [])


def test_openings_are_measured_along_their_wall(tmp_path: Path) -> None:
    wall = {
        "id": "w",
        "roomId": "room|1",
        "polygon": [corner(4, 0), corner(0, 0), corner(4, 0), corner(0, 0)],
    }
    outside = {**wall, "id": "v", "roomId": "exterior"}
    door = {"wall0": "v", "wall1": "w", "holePolygon": [corner(0.5, 0), corner(1.5, 0)]}
    found, _ = read(written(tmp_path, house(room(1, 0), walls=[wall, outside], doors=[door])))
    placed = one(found, "Door")
    xs, ys = zip(*placed.points, strict=True)
    assert (min(xs), max(xs)) == pytest.approx((2.5, 3.5))
    assert (min(ys), max(ys)) == pytest.approx((-0.05, 0.05))
    assert placed.points[3][1] > placed.points[0][1], "its own y axis points into the room"


def test_rooms_of_a_house_are_scenes_of_their_own(tmp_path: Path) -> None:
    things = [chair(1, 1, 0, children=[chair(1, 1, 45)]), chair(6, 1, 0)]
    path = written(tmp_path, house(room(1, 0), room(2, 5), objects=things), house(room(1, 0)))
    assert FORMATS["procthor"].parts(path) == ("1/room|1", "1/room|2", "2")
    assert [len(read(path, part)[0].polygons) for part in FORMATS["procthor"].parts(path)] == [3, 2, 1]
    with pytest.raises(Faulty, match="LK858"):
        read(path, "3")


def test_sizes_that_are_not_known(tmp_path: Path) -> None:
    path = written(tmp_path, house(room(1, 0), objects=[chair(1, 1, 0)]), assets=None)
    found, codes = read(path)
    assert (len(found.polygons), codes) == (1, ["LK861"])
    other = {"Chair": [{**ASSETS["Chair"][0], "assetId": "Chair_2"}]}
    (tmp_path / "asset-database.json").write_text(json.dumps(other))
    assert read(path)[1] == ["LK861"]
    (tmp_path / "asset-database.json").write_text("[]")
    with pytest.raises(Faulty, match="LK301"):
        read(path)


def test_what_is_no_house(tmp_path: Path) -> None:
    path = written(tmp_path, house(room(1, 0)), {"rooms": 3})
    with pytest.raises(Faulty, match=":2: error LK301"):
        FORMATS["procthor"].parts(path)
    path = written(tmp_path, house(room(1, 0), objects=[{"assetId": "Chair_1"}]))
    with pytest.raises(Faulty, match="not of the form"):
        read(path)
    path.write_bytes(path.read_bytes()[:-9])
    with pytest.raises(Faulty, match="unpacked"):
        FORMATS["procthor"].parts(path)
