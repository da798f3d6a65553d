"""Well-known text: one geometry a line, labels before it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Scene
from layoutkit_formats.scenes.drawing import Drawing, loaded, unreadable
from layoutkit_formats.scenes.labels import labels

_KINDS = "POINT|LINESTRING|LINEARRING|POLYGON|MULTIPOINT|MULTILINESTRING|MULTIPOLYGON|GEOMETRYCOLLECTION"
_GEOMETRY = re.compile(rf"(?:SRID=\d+;)?\b(?P<wkt>(?:{_KINDS})\s*(?:Z|M|ZM)?\s*(?:\(|EMPTY).*)", re.I)
_LABELLED = re.compile(r"[^\s,;:]+")


class WktFormat(SceneFormat):
    """Reads lines such as ``Window POLYGON ((0 0, 1 0, 1 2, 0 2, 0 0))``."""

    name = "wkt"
    summary = "Well-known text: one geometry a line, its labels before it; # begins a comment."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the first line that is no comment holds a geometry."""
        lines = (line.strip() for line in head.decode("utf-8-sig", "replace").splitlines())
        first = next((line for line in lines if line and not line.startswith("#")), "")
        found = _GEOMETRY.search(first)
        return found is not None and not set(first[: found.start()]) & set("{}<>\"'")

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene; a line that cannot be read is left out."""
        drawing = Drawing(path)
        try:
            text = loaded(path).decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise unreadable(path, f"the file is not UTF-8: {error.reason}") from None
        for number, line in enumerate(text.splitlines(), 1):
            if line.strip() and not line.lstrip().startswith("#"):
                _read_line(line, Place(str(path), number, 1), drawing)
        return drawing.scene(path.stem, "m")


def _read_line(line: str, place: Place, drawing: Drawing) -> None:
    found = _GEOMETRY.search(line)
    geometry = None if found is None else _geometry(found["wkt"])
    if geometry is not None and not _finite(geometry):
        hint, message = (
            "write numbers that are finite",
            "a coordinate is no finite number; the line is left out",
        )
        drawing.remarks.append(Diagnostic("LK859", message, place, hint, Severity.WARNING, "scene"))
        return
    if found is None or geometry is None:
        hint = "write POLYGON ((x y, x y, x y, x y)), its labels before it"
        message = "the line holds no geometry; it is left out"
        drawing.remarks.append(Diagnostic("LK859", message, place, hint, Severity.WARNING, "scene"))
        return
    add(geometry, labels(_LABELLED.findall(line[: found.start()])), drawing, place)


def parsed(text: str) -> Any:
    """Return a shapely geometry; None if the text is none, or a coordinate is no finite number."""
    geometry = _geometry(text)
    return geometry if geometry is not None and _finite(geometry) else None


def _geometry(text: str) -> Any:
    """Return a shapely geometry, maybe with coordinates that are not finite; None if the text is none."""
    import numpy as np
    import shapely

    try:
        with np.errstate(invalid="ignore", over="ignore"):  # such coordinates are refused afterwards
            return shapely.from_wkt(text)
    except shapely.errors.ShapelyError:
        return None


def _finite(geometry: Any) -> bool:
    import numpy as np
    import shapely

    return bool(np.isfinite(shapely.get_coordinates(geometry)).all())


def add(
    geometry: Any, labels: tuple[str, ...], drawing: Drawing, place: Place | None = None, name: str = ""
) -> None:
    """Add a shapely geometry to a drawing: each of its polygons; others are left out."""
    kind = geometry.geom_type
    if kind in ("MultiPolygon", "GeometryCollection"):
        for part in geometry.geoms:
            add(part, labels, drawing, place, name)
    elif kind != "Polygon":
        drawing.leave_out(kind)
    else:
        rings = (geometry.exterior, *geometry.interiors)
        points = [[(x, y) for x, y, *_ in ring.coords] for ring in rings]
        drawing.add(points, labels, name, place=place)
