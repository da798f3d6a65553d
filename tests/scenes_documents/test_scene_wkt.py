"""Well-known text, alone and in ResPlan's flats."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from layoutkit.diagnostics import Faulty
from tests.scenes_documents.format_reading import FORMATS, read, recognised

SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"


@pytest.mark.parametrize(
    ("line", "labels"),
    [
        (SQUARE, ()),
        (f"House {SQUARE}", ("House",)),
        (f"House, Big: {SQUARE}", ("House", "Big")),
        (f"House\t{SQUARE.lower()}", ("House",)),
        (f"SRID=25833;{SQUARE}", ()),
        (f"House SRID=25833;{SQUARE}", ("House",)),
        ("POLYGON Z ((0 0 7, 4 0 7, 4 4 7, 0 4 7, 0 0 7))", ()),
        ("MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)))", ()),
    ],
)
def test_lines(line: str, labels: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    path.write_text(f"# a drawing\n\n{line}\n")
    found, codes = read(path)
    assert [(p.labels, p.points) for p in found.polygons] == [(labels, ((0, 0), (4, 0), (4, 4), (0, 4)))]
    assert codes == []


def test_remarks_have_their_line(tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    hole = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))"
    lines = [SQUARE, "POLYGON ((0 0", "hello", hole, "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))", "POINT (1 1)"]
    path.write_text("\n".join([*lines, "POLYGON EMPTY"]))
    _, remarks = FORMATS["wkt"].read(path, "")
    told = {(d.code, d.place.line) for d in remarks if d.place}
    assert told == {("LK859", 2), ("LK859", 3), ("LK854", 4), ("LK852", 5), ("LK855", 0), ("LK851", 7)}


@pytest.mark.parametrize(
    "data", [b"", b"hello", b"\xff\xfe", b"POINT (1 1)", b"# POLYGON ((0 0, 1 0, 1 1, 0 0))"]
)
def test_what_holds_no_polygon(data: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    path.write_bytes(data)
    with pytest.raises(Faulty, match=r"LK30[13]"):
        FORMATS["wkt"].read(path, "")


def test_flats(tmp_path: Path) -> None:
    path = tmp_path / "flats.json"
    flats = [{"id": k, "geometries": {"living room": [SQUARE], "wall": ["POLYGON", 3]}} for k in (4, 4)]
    path.write_text(json.dumps(flats))
    assert recognised(path) == ["resplan"]
    assert FORMATS["resplan"].parts(path) == ("4", "4#1")
    found, codes = read(path, "4")
    assert (found.name, found.labels, codes) == ("flats-4", ("living_room",), ["LK859", "LK859"])
    with pytest.raises(Faulty, match="LK858"):
        read(path, "5")
    for wrong in ("[", "[3]", '[{"geometries": 3}]', "[]"):
        path.write_text(wrong)
        with pytest.raises(Faulty, match=r"LK301|LK858"):
            FORMATS["resplan"].read(path, "0")


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("number", ["nan", "1e400", "-1e400"])
def test_numbers_that_are_not_finite_are_refused(tmp_path: Path, number: str) -> None:
    path = tmp_path / "a.wkt"
    path.write_text(f"A POLYGON ((0 0, 4 0, {number} 4, 0 4, 0 0))\nB {SQUARE}\n", encoding="utf-8")
    scene, remarks = FORMATS["wkt"].read(path, "")
    assert [polygon.labels for polygon in scene.polygons] == [("B",)]
    (remark,) = remarks
    assert (remark.code, remark.place.line) == ("LK859", 1)
    assert "no finite number" in remark.message
