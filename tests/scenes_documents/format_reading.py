"""How tests read a scene with a built-in format."""

from __future__ import annotations

from pathlib import Path

from layoutkit.hooks import SceneFormat
from layoutkit.model import Scene
from layoutkit_formats.plugin import layoutkit_scene_formats

FORMATS: dict[str, SceneFormat] = {own.name: own for own in layoutkit_scene_formats()}


def recognised(path: Path) -> list[str]:
    """Return the names of the formats that recognise a file."""
    head = path.read_bytes()[:4096]
    return [own.name for own in FORMATS.values() if own.recognises(path, head)]


def read(path: Path, part: str | None = None) -> tuple[Scene, list[str]]:
    """Read a scene by the one format that recognises it; return it and the codes of what is said."""
    (name,) = recognised(path)
    own = FORMATS[name]
    scene, remarks = own.read(path, own.parts(path)[0] if part is None else part)
    return scene, [d.code for d in remarks]
