"""The work of ``replay``: operations made again on one tile of a scene, wherever a worker is."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from layoutkit.cli.remote import RemoteSession
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.model import World

if TYPE_CHECKING:
    from layoutkit.batch import Finished, Shared, Task
    from layoutkit.batch.task import Status
    from layoutkit.operations import Operations

#: So many diagnostics that are alike are told.
_TOLD = 2


def replay_tile(task: Task, shared: Shared) -> Finished:
    """Replay operations on a tile, and return its models and views.

    The arguments are ``scene``, the document of the tile, and ``sites``, the names of those that are built in
    it; ``seed``; and ``stem``, what its files are called.
    """
    from layoutkit.batch import Finished
    from layoutkit.documents import Source, read_scene

    given, operations = task.arguments, _operations(shared)
    session = RemoteSession.of_options(shared.options["session"], {})
    scene = read_scene(Source(f"{task.key}.xml", given["scene"].encode())).scene
    asked = {"operations": operations, "seed": given["seed"], "sites": tuple(given["sites"])}
    outcome = next(session.run("replay", scene, **asked))
    world = outcome.document
    told = _folded((*session.diagnostics, *outcome.diagnostics))
    if not isinstance(world, World):
        return Finished(task.key, "failed", diagnostics=told)
    # Sites that failed are left out, and told; the others are there all the same.
    status: Status = "failed" if any(d.severity is Severity.ERROR for d in told) else "done"
    files = tuple(_files(world, given["stem"], shared.options))
    return Finished(task.key, status, files, _summary(world), told)


@lru_cache(maxsize=2)
def _operations(shared: Shared) -> Operations:
    """Return the operations, read once in each process."""
    from layoutkit.documents.operations import read_operations_files

    host = RemoteSession.of_options(shared.options["session"], {}).host
    return read_operations_files(
        shared.files, shared.options["operations"], host.operations, host.constraints
    ).operations


def _files(world: World, stem: str, options: Mapping[str, Any]) -> Iterator[tuple[str, bytes]]:
    for name in options["formats"]:
        yield from WRITERS[name](world, stem)
    for side in options["views"]:
        from layoutkit.pictures import png_bytes
        from layoutkit.pictures.worlds.views import render_view

        size = (options["width"], round(options["width"] * 0.65))
        image = render_view(world, side_of(side), size, elevation=options["elevation"])
        yield f"{stem}-{side}.png", png_bytes(image, level=6)


def _glb(world: World, stem: str) -> Iterator[tuple[str, bytes]]:
    from layoutkit.pictures.worlds.glb import render_world_glb

    yield f"{stem}.glb", render_world_glb(world)


def _obj(world: World, stem: str) -> Iterator[tuple[str, bytes]]:
    from layoutkit.pictures.worlds.obj import render_world_obj

    folder, _, name = stem.rpartition("/")
    for file, data in render_world_obj(world, name).items():
        yield f"{folder}/{file}" if folder else file, data


def _cityjson(world: World, stem: str) -> Iterator[tuple[str, bytes]]:
    from layoutkit.documents.cityjson import cityjson_bytes

    yield f"{stem}.city.json", cityjson_bytes(world)


#: What models can be written as.
WRITERS: Mapping[str, Callable[[World, str], Iterator[tuple[str, bytes]]]] = {
    "glb": _glb,
    "obj": _obj,
    "cityjson": _cityjson,
}


def _folded(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Return diagnostics, of each code and place the first few, and how many more there are.

    What cannot be done on one site often cannot be done on hundreds.
    """
    alike: defaultdict[tuple[str, Severity, Place | None], list[Diagnostic]] = defaultdict(list)
    for diagnostic in dict.fromkeys(diagnostics):
        alike[diagnostic.code, diagnostic.severity, diagnostic.place].append(diagnostic)
    found: list[Diagnostic] = []
    for own in alike.values():
        found += own[:_TOLD]
        if more := own[_TOLD:]:
            message = f"and {len(more)} more of this kind, such as: {more[0].message}"
            found.append(replace(more[0], message=message, count=len(more)))
    return tuple(found)


def _summary(world: World) -> dict[str, Any]:
    return {
        "solids": len(world.bodies),
        "openings": sum(len(body.openings) for body in world.bodies),
        "triangles": sum(len(body.triangles) for body in world.bodies),
    }


def side_of(text: str) -> str | float:
    """Return a side to look from: a name, or degrees from north over east."""
    try:
        return float(text)
    except ValueError:
        return text
