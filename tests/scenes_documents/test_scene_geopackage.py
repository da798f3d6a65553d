"""GeoPackages, made here with SQLite alone."""

from __future__ import annotations

import sqlite3
import struct
from pathlib import Path
from typing import Any

import pytest
import shapely

from layoutkit.diagnostics import Faulty
from tests.scenes_documents.format_reading import FORMATS, read, recognised

SQUARE = shapely.box(0, 0, 4, 4)


def geometry(shape: Any, envelope: int = 0) -> bytes:
    header = struct.pack("<2sBBi", b"GP", 0, 1 | envelope << 1, 25833)
    sizes = {0: 0, 1: 4, 2: 6, 3: 6, 4: 8}
    return header + bytes(8 * sizes[envelope]) + bytes(shapely.to_wkb(shape, byte_order=1))


def package(path: Path, layers: dict[str, list[tuple[Any, str | None]]], system: str = "PROJCS[]") -> Path:
    database = sqlite3.connect(path)
    database.executescript(
        """
        pragma application_id = 0x47504B47;
        create table gpkg_contents (table_name text, data_type text);
        create table gpkg_geometry_columns (table_name text, column_name text, srs_id int);
        create table gpkg_spatial_ref_sys (srs_id int, definition text);
        """
    )
    database.execute("insert into gpkg_spatial_ref_sys values (1, ?)", (system,))
    for name, rows in layers.items():
        database.execute("insert into gpkg_contents values (?, 'features')", (name,))
        database.execute("insert into gpkg_geometry_columns values (?, 'the geom', 1)", (name,))
        quoted = name.replace('"', '""')
        database.execute(f'create table "{quoted}" (fid integer primary key, "the geom" blob, Class text)')
        for blob, label in rows:
            database.execute(f'insert into "{quoted}" ("the geom", Class) values (?, ?)', (blob, label))
    database.commit()
    database.close()
    return path


@pytest.mark.parametrize("envelope", range(5))
def test_a_layer(envelope: int, tmp_path: Path) -> None:
    rows = [(geometry(SQUARE, envelope), "House"), (geometry(shapely.box(5, 0, 6, 1), envelope), None)]
    path = package(tmp_path / "town.gpkg", {'the "houses"': rows})
    assert recognised(path) == ["geopackage"]
    found, codes = read(path)
    assert [p.labels for p in found.polygons] == [("House",), ("the_houses",)]
    assert set(found.polygons[0].points) == {(0, 0), (4, 0), (4, 4), (0, 4)}
    assert (found.units, codes) == ("m", [])


def test_layers_are_parts_and_can_be_joined(tmp_path: Path) -> None:
    layers = {name: [(geometry(SQUARE), None)] for name in ("houses", "plots")}
    path = package(tmp_path / "town.gpkg", layers)
    assert FORMATS["geopackage"].parts(path) == ("houses", "plots")
    assert read(path, "plots,houses")[0].labels == ("plots", "houses")
    with pytest.raises(Faulty, match="did you mean 'plots'"):
        read(path, "plot")


def test_what_is_no_polygon_is_left_out(tmp_path: Path) -> None:
    line = shapely.LineString([(0, 0), (1, 1)])
    ring = SQUARE.difference(shapely.box(1, 1, 2, 2))
    broken = [None, b"GP", "text", b"GP\0\1" + bytes(9)]
    rows = [geometry(line), geometry(ring), geometry(shapely.Polygon()), *broken]
    found, codes = read(package(tmp_path / "town.gpkg", {"a": [(row, None) for row in rows]}))
    assert len(found.polygons) == 1
    assert set(codes) == {"LK851", "LK854", "LK855"}
    with pytest.raises(Faulty, match="LineString"):
        read(package(tmp_path / "lines.gpkg", {"a": [(geometry(line), None)]}))


def test_degrees_become_metres(tmp_path: Path) -> None:
    rows = [(geometry(shapely.box(13.40, 52.52, 13.41, 52.53)), None)]
    found, codes = read(package(tmp_path / "town.gpkg", {"a": rows}, "GEOGCS[WGS 84]"))
    x0, y0, x1, y1 = found.bounds
    assert (round(x1 - x0), round(y1 - y0), codes) == (677, 1112, ["LK860"])


def test_what_is_no_sound_package(tmp_path: Path) -> None:
    path = tmp_path / "x.gpkg"
    path.write_bytes(b"SQLite format 3\x00" + b"x" * 500)
    for data in (path.read_bytes(), b"", b"nonsense"):
        path.write_bytes(data)
        with pytest.raises(Faulty, match="LK301"):
            FORMATS["geopackage"].parts(path)
    with pytest.raises(Faulty, match="no layer"):
        FORMATS["geopackage"].parts(package(tmp_path / "empty.gpkg", {}))
    with pytest.raises(Faulty, match="LK301"):
        FORMATS["geopackage"].parts(tmp_path / "missing.gpkg")
