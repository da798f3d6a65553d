"""GeoPackages (OGC 12-128): layers of features in SQLite, geometries as well-known binary behind a header."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Scene
from layoutkit_formats.scenes import geography
from layoutkit_formats.scenes.drawing import Drawing, no_such_part, unreadable
from layoutkit_formats.scenes.labels import labels

#: Columns that say what a feature is; the first that a layer has counts.
_LABELS = ("labels", "label", "class", "type")
#: Bytes of the header behind the flags and system, by the code of its envelope.
_ENVELOPES = {0: 0, 1: 32, 2: 48, 3: 48, 4: 64}
_LAYERS = """
select c.table_name, g.column_name, coalesce(s.definition, '')
from gpkg_contents c join gpkg_geometry_columns g on g.table_name = c.table_name
left join gpkg_spatial_ref_sys s on s.srs_id = g.srs_id
where c.data_type = 'features' order by c.table_name
"""

_Layer = tuple[str, str]


class GeoPackageFormat(SceneFormat):
    """Reads the layers of polygons of a GeoPackage, without GDAL."""

    name = "geopackage"
    summary = "GeoPackage: each layer a scene, several with commas between them; labelled by layer or column."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file is an SQLite database whose application is GeoPackage."""
        marked = head[68:72] in (b"GPKG", b"GP10", b"GP11")
        return head.startswith(b"SQLite format 3\x00") and (marked or path.suffix.lower() == ".gpkg")

    def parts(self, path: Path) -> Sequence[str]:
        """Return the names of the layers of features."""
        with _opened(path) as database:
            return tuple(_layers(database, path))

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene of a layer, or of several whose names have commas between them, in metres."""
        drawing = Drawing(path)
        with _opened(path) as database:
            layers = _layers(database, path)
            wanted = [part] if part in layers else part.split(",")
            for name in wanted:
                if name not in layers:
                    raise no_such_part(path, name, list(layers))
            found = {name: list(_features(database, name, layers[name][0])) for name in wanted}
        degrees = any(layers[name][1].lstrip().upper().startswith("GEOG") for name in wanted)
        shapes = [(name, own, _geometry(blob, drawing)) for name in wanted for blob, own in found[name]]
        _draw([(name, own, shape) for name, own, shape in shapes if shape is not None], degrees, drawing)
        return drawing.scene(f"{path.stem}-{'-'.join(wanted)}", "m")


@contextlib.contextmanager
def _opened(path: Path) -> Iterator[sqlite3.Connection]:
    """Open a database for reading alone; what is wrong with it is the file's fault."""
    try:
        database = sqlite3.connect(f"file:{quote(str(path))}?mode=ro&immutable=1", uri=True)
    except sqlite3.Error as error:
        raise unreadable(path, f"the file cannot be read: {error}") from None
    try:
        yield database
    except sqlite3.Error as error:
        raise unreadable(path, f"the file is no sound GeoPackage: {error}") from None
    finally:
        database.close()


def _layers(database: sqlite3.Connection, path: Path) -> dict[str, _Layer]:
    """Return the column of geometries of each layer, and the definition of its system, by its name."""
    found = {name: (column, system) for name, column, system in database.execute(_LAYERS)}
    if not found:
        raise unreadable(path, "the file has no layer of features")
    return found


def _features(database: sqlite3.Connection, layer: str, column: str) -> Iterator[tuple[Any, tuple[str, ...]]]:
    """Yield the geometry of each feature, and its labels."""
    columns = [row[1] for row in database.execute(f"pragma table_info({_name(layer)})")]
    known = {name.lower(): name for name in columns}
    own = next((known[name] for name in _LABELS if name in known), None)
    chosen = f"{_name(column)}, {_name(own) if own else 'null'}"
    for blob, text in database.execute(f"select {chosen} from {_name(layer)}"):
        yield blob, labels([str(text)] if text not in (None, "") else [layer])


def _name(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


def _geometry(blob: Any, drawing: Drawing) -> Any:
    """Return the shapely geometry of a feature; None where it has none, or none that can be read."""
    import shapely

    if blob is None:
        drawing.leave_out("feature without geometry")
        return None
    if not isinstance(blob, bytes) or blob[:2] != b"GP" or len(blob) < 8:
        drawing.leave_out("geometry that cannot be read")
        return None
    header = 8 + _ENVELOPES.get(blob[3] >> 1 & 7, 0)
    try:
        shape = shapely.from_wkb(blob[header:])
    except shapely.errors.ShapelyError:
        drawing.leave_out("geometry that cannot be read")
        return None
    return shape


def _draw(shapes: Sequence[tuple[str, tuple[str, ...], Any]], degrees: bool, drawing: Drawing) -> None:
    """Draw all polygons, in metres."""
    import shapely

    from layoutkit_formats.scenes.wkt import add

    if degrees and shapes:
        x0, y0, x1, y1 = (float(v) for v in shapely.total_bounds([shape for _, _, shape in shapes]))
        laid_out = geography.metres((x0, y0, x1, y1))
        shapes = [(name, own, _moved(shape, laid_out)) for name, own, shape in shapes]
        drawing.remark("LK860", geography.REMARK, severity=Severity.NOTE)
    for _, own, shape in shapes:
        add(shape, own, drawing)


def _moved(shape: Any, laid_out: Any) -> Any:
    import shapely

    return shapely.transform(shape, lambda points: [laid_out((x, y)) for x, y in points])
