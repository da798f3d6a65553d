"""Scenes as commands read them: from documents of scenes, facades and layouts, and what formats know."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layoutkit.cli.recognising import scene_formats as scene_formats  # commands find it here
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, blame
from layoutkit.model import Scene

if TYPE_CHECKING:
    from layoutkit.hooks import SceneFormat

#: As many parts of a file are told by name.
_SHOWN = 12


def read_scene(
    session: Session, path: Path, part: str | None = None, format_name: str | None = None
) -> Scene:
    """Return the scene of a file of any kind, and report what is to be said of it.

    Parameters
    ----------
    part
        Which scene of a file that holds several: a layer, a room, a flat.
    format_name
        How to read the file; None: as what it looks like.

    Returns
    -------
    Scene
        Its picture is named from where the file lies.

    Raises
    ------
    Faulty
        If nothing can be made of the file, or it holds several scenes and none of them is named.
    """
    from layoutkit import documents

    if format_name is None and documents.is_scene(path):
        _no_part(path, part)
        read = documents.read_scene(path)
        session.report(read.diagnostics)
        return read.scene
    if format_name is None and documents.is_placement_model(path):
        raise Faulty([_no_scene(path, "placement-model", f"place {path} SCENE -o OUT.png", "places by it")])
    if format_name is None and documents.is_operations(path):
        raise Faulty([_no_scene(path, "operations", f"replay {path} SCENE -o OUT", "makes them in it")])
    if format_name is None and is_tree(path):
        from layoutkit.scenes.regions import scene_of

        _no_part(path, part)
        return scene_of(session.read(path).model)
    chosen = scene_format(session, path, format_name)
    return read_part(session, chosen, path, _chosen_part(chosen, path, part))


def read_part(session: Session, chosen: SceneFormat, path: Path, part: str) -> Scene:
    """Return one of the scenes of a file as a format reads it; its picture is named from where the file lies.

    Raises
    ------
    Faulty
        If nothing can be made of the file, or it has no such part.
    Misbehaviour
        If the format returns something else.
    """
    found: Any = chosen.read(path, part)
    whole = isinstance(found, tuple) and len(found) == 2 and isinstance(found[0], Scene)
    if not whole or not all(isinstance(remark, Diagnostic) for remark in found[1]):
        raise blame.Misbehaviour(chosen, f"reads {found!r}, and no Scene with its remarks")
    scene: Scene = found[0]
    session.report(found[1])
    if scene.picture is None:
        return scene
    file = Path(os.path.relpath(scene.picture.file, path.parent)).as_posix()
    return replace(scene, picture=replace(scene.picture, file=file))


def parts_of(chosen: SceneFormat, path: Path) -> tuple[str, ...]:
    """Return the names of the scenes of a file.

    Raises
    ------
    Faulty
        If nothing can be made of the file.
    Misbehaviour
        If the format returns something else.
    """
    found: Any = chosen.parts(path)
    if isinstance(found, str) or not all(isinstance(part, str) for part in found):
        raise blame.Misbehaviour(chosen, f"gives {found!r}, and no names of scenes")
    return tuple(found)


def scene_format(session: Session, path: Path, name: str | None = None) -> SceneFormat:
    """Return the format of scenes of that name, or else the one that recognises the file.

    Raises
    ------
    Faulty
        If there is none, several recognise the file, or it cannot be read.
    """
    from layoutkit.documents import load

    if name is not None:
        load(path)  # whether it can be read is said first
        return session.host.scene_formats.find(name)
    fitting = scene_formats(session, path)
    if len(fitting) == 1:
        return fitting[0]
    raise Faulty([_undecided(path, fitting or list(session.host.scene_formats.values()), bool(fitting))])


def nothing_in(path: Path) -> Diagnostic | None:
    """Return the diagnostic of a file that is empty; None where there is something in it.

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    from layoutkit.documents import load

    if load(path).strip():
        return None
    return Diagnostic(
        "LK703",
        "nothing can be made of this file: it is empty",
        Place(str(path)),
        "write it once more, or name another file",
        topic="usage",
    )


def is_tree(path: Path) -> bool:
    """Tell whether a file is a facade or layout, or another document of ours that their reader tells of."""
    from layoutkit.cli.gathering import root_name
    from layoutkit.documents import NAMESPACE, Source
    from layoutkit.documents.grammar import FACADE, LAYOUT
    from layoutkit.documents.spelling import near_namespace

    namespace, _, name = (root_name(Source.of(path)) or "").rpartition(" ")
    ours = namespace == NAMESPACE or near_namespace(namespace)
    return ours or (not namespace and name in (FACADE.name, LAYOUT.name))


def is_drawn(session: Session, path: Path) -> bool:
    """Tell whether a file is a drawing, or nothing that could be a document; formats say what it is."""
    from layoutkit.documents import load
    from layoutkit.documents.foreign import foreign

    return not is_tree(path) and (bool(scene_formats(session, path)) or bool(foreign(load(path))))


def this_file(path: Path) -> str:
    """Return what a file that nothing recognises is called."""
    from layoutkit.documents import load
    from layoutkit.documents.foreign import foreign

    return f"this {foreign(load(path))} file".replace("  ", " ")


def _no_part(path: Path, part: str | None) -> None:
    if part:
        hint = "leave --part away"
        raise Faulty(
            [
                Diagnostic(
                    "LK701", "the document is one scene, without parts", Place(str(path)), hint, topic="usage"
                )
            ]
        )


def _chosen_part(chosen: SceneFormat, path: Path, part: str | None) -> str:
    """Return the part that is meant; one that is named is the format's to find."""
    if part is not None:
        return part
    parts = parts_of(chosen, path)
    if len(parts) == 1:
        return parts[0]
    if not parts:
        raise Faulty([Diagnostic("LK303", "the file holds no scene", Place(str(path)), topic="conversion")])
    more = ", …" if len(parts) > _SHOWN else ""
    shown = ", ".join(parts[:_SHOWN]) + more
    raise Faulty(
        [
            Diagnostic(
                "LK857",
                f"the file holds {len(parts)} scenes, and none is named",
                Place(str(path)),
                f"name one with --part, such as --part {_quoted(parts[0])}",
                topic="usage",
                details=(f"there are {shown}",),
            )
        ]
    )


def _quoted(part: str) -> str:
    import shlex

    return shlex.quote(part)


def _no_scene(path: Path, root: str, command: str, does: str) -> Diagnostic:
    """Say that a document is of another kind, and which command takes it."""
    hint = f"name a scene; `layoutkit {command}` {does}"
    return Diagnostic("LK101", f"<{root}> is no scene", Place(str(path)), hint, topic="schema")


def _undecided(path: Path, choice: Sequence[SceneFormat], fitting: bool) -> Diagnostic:
    if empty := nothing_in(path):
        return empty
    return Diagnostic(
        "LK703",
        "several formats of scenes recognise this file"
        if fitting
        else f"no format of scenes recognises {this_file(path)}",
        Place(str(path)),
        f"`layoutkit convert {path} --format NAME -o OUT.xml` reads it as one of these"
        if choice
        else "no format is loaded: see `layoutkit plugins`",
        Severity.ERROR,
        "usage",
        tuple(f"{candidate.name}: {candidate.summary}" for candidate in choice),
    )
