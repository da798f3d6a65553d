"""``layoutkit replay``: a recorded session of modelling, made again on other scenes."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli.batch import names_of
from layoutkit.cli.batching import (
    FIRST_SEED,
    Afresh,
    Scheduler,
    SeedList,
    Seeds,
    Workers,
    carried_out,
    plugins_of,
    runner_of,
)
from layoutkit.cli.editing import misused
from layoutkit.cli.options import Json, finite
from layoutkit.cli.remote import options_of
from layoutkit.cli.replayed import replay_tile, side_of
from layoutkit.cli.scene_files import Part
from layoutkit.cli.scenes import read_scene
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Scene

if TYPE_CHECKING:
    from layoutkit.batch import Plan, Task
    from layoutkit.documents.operations import OperationsDocument
    from layoutkit.operations import Operations

EXAMPLES = """
Examples:

- `layoutkit replay houses/operations.xml houses/scene.xml -o out`

- `layoutkit replay houses/operations.xml city.gpkg --part plots --workers 2 -o out`

- `layoutkit replay flat/operations.xml flat/scene.xml --seeds 0-9 --elevation 60 --format obj -o out`
"""

#: What is drawn of each model, unless something else is asked for.
_SIDES = ("south-west", "north-east")


class Format(enum.StrEnum):
    """What models are written as."""

    glb = "glb"
    obj = "obj"
    cityjson = "cityjson"


def replay(
    context: typer.Context,
    operations_file: Annotated[
        Path, typer.Argument(metavar="OPERATIONS", help="The operations document (XML).")
    ],
    scene_files: Annotated[
        list[Path],
        typer.Argument(metavar="SCENE...", help="The scenes to model in; any kind of file."),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The folder for results.")],
    part: Part = None,
    seeds: SeedList = FIRST_SEED,
    formats: Annotated[
        list[Format] | None,
        typer.Option(
            "--format",
            show_default="glb",
            help="What models are written as; may be given several times.",
        ),
    ] = None,
    views: Annotated[
        list[str] | None,
        typer.Option(
            "--view",
            metavar="SIDE",
            show_default=", ".join(_SIDES),
            help="Where a picture is seen from: south-west, east, or degrees from north over east, such as "
            "75; may be given several times.",
        ),
    ] = None,
    undrawn: Annotated[bool, typer.Option("--no-views", help="Draw no pictures.")] = False,
    elevation: Annotated[
        float,
        typer.Option(
            min=1,
            max=90,
            callback=finite,
            help="How steeply pictures are seen from above, in degrees: 90 is straight down.",
        ),
    ] = 33.0,
    width: Annotated[int, typer.Option(min=64, max=3000, help="Width of pictures, in pixels.")] = 1200,
    tile: Annotated[
        int, typer.Option(min=1, help="How many sites go into one model, and one piece of work, at most.")
    ] = 50,
    workers: Workers = None,
    scheduler: Scheduler = None,
    afresh: Afresh = False,
    as_json: Json = False,
) -> int:
    """Make the operations of a recorded session again on other scenes, in three dimensions.

    Every scene becomes a model, and pictures of it from two sides, for every seed; of several scenes, each
    has a folder of its own. Where the operations say which polygons are sites of their own, large scenes are
    divided into tiles of near sites, each with a model of its own. DIR/manifest.json lists all. The bytes are
    the same whoever does the work: this process, several, or a cluster.

    The same command goes on where it was interrupted. A tile that fails is listed, and does not stop others.
    """
    session = Session.of(context)
    runner = runner_of(session, workers, scheduler)
    options = {
        "formats": [str(name) for name in dict.fromkeys(formats or [Format("glb")])],
        "views": _sides(views, undrawn=undrawn),
        "elevation": elevation,
        "width": width,
        "tile": tile,
        "session": options_of(session),
        "operations": operations_file.name,
    }
    document = _read(session, operations_file)
    files = list(dict.fromkeys(scene_files))
    scenes = {
        name: read_scene(session, file, part) for name, file in zip(names_of(files), files, strict=True)
    }
    plan = _plan(document, scenes, seeds, options, session)
    inputs = {operations_file, *files, *(operations_file.parent / own for own in document.files)}
    _refuse_own_inputs(plan.tasks, inputs, output)
    called = {name: str(operations_file.parent / name) for name in document.files}
    return carried_out(
        session, plan, output, runner, afresh=afresh, as_json=as_json, what="models", files=called
    )


def _read(session: Session, file: Path) -> OperationsDocument:
    """Read the operations, and load what they will need, so that what fails is told once, and here."""
    from layoutkit.documents.operations import read_operations

    session.host.stages.find("replay")
    document = read_operations(file, session.host.operations, session.host.constraints)
    session.report(document.diagnostics)
    _check_pictures(document.operations, operations_file=file)
    return document


def _check_pictures(operations: Operations, operations_file: Path) -> None:
    """Raise `Faulty` if pictures of facades cannot be decoded: tasks would all fail of it."""
    from layoutkit.operations import Design
    from layoutkit.pictures import Photo

    held = (value for node in operations.nodes for value in vars(node.operation).values())
    designs = {value.file: value for value in held if isinstance(value, Design)}
    faults: list[Diagnostic] = []
    for file, design in designs.items():
        if design.facade is not None and design.facade.picture is not None:
            picture = operations_file.parent / Path(file).parent / design.facade.picture.file
            try:
                Photo.decoded(design.facade, design.picture, picture)
            except Faulty as faulty:
                faults += faulty.diagnostics
    if faults:
        raise Faulty(faults)


def _sides(views: Sequence[str] | None, *, undrawn: bool) -> list[str]:
    """Return the sides to draw; raise `Faulty` where one is none, or some are asked for and none wanted."""
    from layoutkit.pictures.worlds.camera import bearing_of

    if undrawn:
        if views:
            raise misused("--view asks for a picture, and --no-views for none", "leave one of them away")
        return []
    sides = list(dict.fromkeys(views or _SIDES))
    for side in sides:
        if isinstance(bearing := side_of(side), float) and not 0 <= bearing < 360:
            hint = "write 0 to 359 degrees from north over east, or a side such as south-west"
            raise Faulty([Diagnostic("LK701", f"{side} is no side to look from", hint=hint, topic="usage")])
        bearing_of(bearing)
    return sides


def _plan(
    document: OperationsDocument,
    scenes: Mapping[str, Scene],
    seeds: Seeds,
    options: Mapping[str, Any],
    session: Session,
) -> Plan:
    from layoutkit.batch import Plan

    tasks = [
        task
        for name, scene in scenes.items()
        for task in _tasks(document, name, f"{name}/" if len(scenes) > 1 else "", scene, seeds, options)
    ]
    seen = {"scenes": list(scenes), "seeds": list(seeds.numbers)}
    told = {**seen, **options, "plugins": plugins_of(session)}
    return Plan("replay", tasks, told)


def _tasks(
    document: OperationsDocument,
    name: str,
    folder: str,
    scene: Scene,
    seeds: Seeds,
    options: Mapping[str, Any],
) -> Iterator[Task]:
    """Yield the tasks of a scene: one for each seed and tile."""
    from layoutkit.batch import Shared, Task
    from layoutkit.cli.tiles import tiles_of
    from layoutkit.documents import scene_bytes
    from layoutkit.operations.sites import sites_of

    plain = Scene(scene.name, scene.units, scene.settled().polygons)
    sites = sites_of(plain, document.operations.sites)
    parts = [(scene_bytes(tile).decode(), names) for tile, names in tiles_of(plain, sites, options["tile"])]
    shared = Shared(document.files, options)
    for seed in seeds.numbers:
        for number, (text, names) in enumerate(parts, 1):
            stem = name if len(seeds.numbers) == 1 else f"{name}-s{seed}"
            stem += f"-{number:0{len(str(len(parts)))}d}" if len(parts) > 1 else ""
            given = {"scene": text, "sites": list(names), "seed": seed, "stem": f"{folder}{stem}"}
            yield Task(f"{folder}{stem}", replay_tile, given, shared)


def _refuse_own_inputs(tasks: Sequence[Task], inputs: Iterable[Path], output: Path) -> None:
    """Raise `Faulty` if results might be written over what is read."""
    stems = {(output / task.key).resolve() for task in tasks}
    for file in sorted(inputs):
        own = file.resolve()
        if any(own.parent == stem.parent and own.name.startswith(stem.name) for stem in stems):
            message, place = f"results could overwrite the input {file}", Place(str(output))
            hint = f"name another folder with -o, such as {output / 'replayed'}"
            raise Faulty([Diagnostic("LK704", message, place, hint, topic="usage")])
