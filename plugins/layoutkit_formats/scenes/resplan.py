"""ResPlan: whole flats, their rooms, walls and openings as well-known text in JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Scene
from layoutkit_formats.scenes.drawing import Drawing, loaded, no_such_part, unreadable
from layoutkit_formats.scenes.labels import labels
from layoutkit_formats.scenes.wkt import add, parsed


class ResPlanFormat(SceneFormat):
    """Reads the flats of ResPlan."""

    name = "resplan"
    summary = "ResPlan: flats in JSON, each a scene, their geometries as well-known text."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the file is JSON that begins with a flat."""
        start = head.lstrip(b"\xef\xbb\xbf \t\r\n")
        return start[:1] in (b"[", b"{") and b'"geometries"' in head and b"POLYGON" in head

    def parts(self, path: Path) -> Sequence[str]:
        """Return the numbers of the flats."""
        return tuple(_flats(path))

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene of a flat; its polygons are labelled by their kind."""
        flats = _flats(path)
        if part not in flats:
            raise no_such_part(path, part, list(flats))
        drawing = Drawing(path)
        for kind, texts in flats[part].items():
            for text in texts if isinstance(texts, list) else [texts]:
                geometry = parsed(text) if isinstance(text, str) else None
                if geometry is None:
                    drawing.remark("LK859", f"a geometry of {kind} cannot be read; it is left out")
                else:
                    add(geometry, labels([kind]), drawing)
        return drawing.scene(f"{path.stem}-{part}" if len(flats) > 1 else path.stem, "px")


def _flats(path: Path) -> dict[str, dict[str, Any]]:
    """Return the geometries of each flat, by its number."""
    try:
        data = json.loads(loaded(path))
    except (ValueError, RecursionError) as error:
        raise unreadable(path, f"the file is not JSON: {error}") from None
    found: dict[str, dict[str, Any]] = {}
    for number, flat in enumerate(data if isinstance(data, list) else [data]):
        geometries = flat.get("geometries") if isinstance(flat, dict) else None
        if not isinstance(geometries, dict):
            raise unreadable(path, f"flat {number} has no geometries")
        name = str(flat.get("id", number))
        found[name if name not in found else f"{name}#{number}"] = geometries
    return found
