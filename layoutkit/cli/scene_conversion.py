"""``layoutkit convert`` of scenes: one, or all that a file holds."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layoutkit.cli import console
from layoutkit.cli.exits import exit_of
from layoutkit.cli.recognising import recognising, scene_formats
from layoutkit.cli.scene_files import check_targets, write_scene
from layoutkit.cli.scenes import parts_of, read_part, read_scene, scene_format
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.model import Scene

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

#: What file names cannot hold everywhere.
_NO_NAME = re.compile(r"[^\w.\-]+")


def is_scene_file(session: Session, path: Path, format_name: str | None) -> bool:
    """Tell whether a file can be read as a scene, and not as an annotation of a facade.

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    from layoutkit.documents import is_scene

    if format_name is not None:
        return format_name in session.host.scene_formats and format_name not in session.host.formats
    if recognising(session, path):
        return False
    return is_scene(path) or bool(scene_formats(session, path))


def convert_scene(
    session: Session,
    path: Path,
    outputs: Sequence[Path],
    part: str | None,
    format_name: str | None,
    as_json: bool,
) -> int:
    """Write the scene of a file to some files, and tell what it holds."""
    check_targets(outputs, [], [path])
    scene = read_scene(session, path, part, format_name)
    write_scene(session, scene, path.parent, outputs)
    _tell(session, [(output, scene) for output in outputs], as_json)
    return 0


def convert_all(session: Session, path: Path, folder: Path, format_name: str | None, as_json: bool) -> int:
    """Write every scene of a file into a folder; those of which nothing can be made are told."""
    chosen = scene_format(session, path, format_name)
    parts = parts_of(chosen, path)
    faults: list[Diagnostic] = []
    written: list[tuple[Path, Scene]] = []
    for part, target in zip(parts, _targets(parts, folder), strict=True):
        try:
            scene = read_part(session, chosen, path, part)
        except Faulty as faulty:
            faults += faulty.diagnostics
            continue
        write_scene(session, scene, path.parent, [target])
        written.append((target, scene))
    session.report(faults)
    _tell(session, written, as_json)
    return exit_of(faults)


def counts(scene: Scene) -> str:
    """Return how much stands in a scene, in words."""
    polygons, placements = len(scene.polygons), len(scene.placements)
    shown = f"{polygons} polygon{'s' * (polygons != 1)}"
    return f"{shown}, {placements} placement{'s' * (placements != 1)}" if placements else shown


def _targets(parts: Iterable[str], folder: Path) -> Iterator[Path]:
    """Yield a file for each part, none twice, also where capitals do not count."""
    taken: set[str] = set()
    for number, part in enumerate(parts, 1):
        name = _NO_NAME.sub("-", part).strip("-.") or "scene"
        if name.casefold() in taken:
            name = f"{name}-{number}"
        taken.add(name.casefold())
        yield folder / f"{name}.xml"


def _tell(session: Session, written: list[tuple[Path, Scene]], as_json: bool) -> None:
    session.report()
    if as_json:
        scenes: list[dict[str, Any]] = [
            {"document": str(file), "polygons": len(scene.polygons), "placements": len(scene.placements)}
            for file, scene in written
        ]
        console.emit({"scenes": scenes, "diagnostics": [d.as_dict() for d in session.diagnostics]})
        return
    for file, scene in written:
        console.say(f"{file}: {counts(scene)}")
