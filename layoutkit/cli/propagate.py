"""``layoutkit propagate``: shapes put where places are like those that they stand in."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from layoutkit.cli.declared import declared_by_stage
from layoutkit.cli.editing import misused
from layoutkit.cli.options import Json
from layoutkit.cli.placing import Afresh, ContributionsFile, HeatFile, PictureScale, Targets, finish
from layoutkit.cli.scene_files import Part, SceneOutputs
from layoutkit.cli.scenes import read_scene
from layoutkit.cli.session import Session
from layoutkit.cli.shapes import PoseOption, named_shape
from layoutkit.model import Placement, Pose, Scene

EXAMPLES = """
Examples:

- `layoutkit propagate flat.xml --from room.xml --shape NightTable_1 -o placed.png`

- `layoutkit propagate room.xml --shape Chair_1 --space poses --mirrored -o chairs.xml --heat heat.png`

- `layoutkit propagate yard.xml --pose 2.5,1,90 --width 0.6 --height 0.4 --label Bench -o benches.svg`
"""

ShapeSize = Annotated[
    float | None,
    typer.Option(min=0, show_default=False, help="Of what stands at --pose, along its own axis."),
]


@declared_by_stage("propagate", "settings")
def propagate(
    context: typer.Context,
    scene_file: Annotated[
        Path, typer.Argument(metavar="SCENE", help="The scene to place shapes in; any kind of file.")
    ],
    output: SceneOutputs,
    shape: Annotated[
        list[str] | None,
        typer.Option(
            "--shape",
            metavar="NAME",
            show_default=False,
            help="A polygon's name, or a placement's label and number, such as Chair_1; may be given several "
            "times.",
        ),
    ] = None,
    pose: PoseOption = None,
    width: ShapeSize = None,
    height: ShapeSize = None,
    label: Annotated[
        str | None, typer.Option(metavar="LABEL", show_default=False, help="What stands at --pose.")
    ] = None,
    source_file: Annotated[
        Path | None,
        typer.Option(
            "--from",
            metavar="SOURCE",
            show_default=False,
            help="The scene that the shape stands in, where it is another one; any kind of file.",
        ),
    ] = None,
    part: Part = None,
    source_part: Annotated[
        str | None,
        typer.Option(
            "--from-part",
            metavar="NAME",
            show_default=False,
            help="Which scene of SOURCE, if it holds several.",
        ),
    ] = None,
    afresh: Afresh = False,
    seed: Annotated[int, typer.Option(min=0, help="Start of all random choices.")] = 0,
    heat: HeatFile = None,
    contributions: ContributionsFile = None,
    scale: PictureScale = 1.0,
    settings: Any = None,
    as_json: Json = False,
) -> int:
    """Place a shape in a scene wherever its surroundings are like those that it stands in.

    One example is enough. Each new placement has a score: the share of the shape's relationships to its
    surroundings that it keeps. With --array, two shapes are named: the first and the last of a row.
    """
    session = Session.of(context)
    targets = Targets(output, heat, contributions, scale)
    targets.check([scene_file, *([source_file] if source_file else [])])
    if source_part is not None and source_file is None:
        raise misused("--from-part is given without --from", "name the file with --from")
    scene = read_scene(session, scene_file, part)
    source = scene if source_file is None else read_scene(session, source_file, source_part)
    shapes = _shapes(source, shape or [], pose, width, height, label)
    if afresh:
        from layoutkit.cli.clearing import cleared

        for own in dict.fromkeys(each.label for each in shapes):
            scene = cleared(scene, own)
    asked = {"shapes": shapes, "source": source, "settings": settings, "seed": seed}
    (outcome,) = session.run("propagate", scene, **asked)
    session.report(outcome.diagnostics)
    return finish(session, outcome, scene, scene_file, targets, as_json)


def _shapes(
    source: Scene,
    names: Sequence[str],
    pose: Pose | None,
    width: float | None,
    height: float | None,
    label: str | None,
) -> tuple[Placement, ...]:
    """Return the shapes that are propagated.

    Raises
    ------
    Faulty
        If none or both ways of naming them are used, or one of them is incomplete.
    """
    if bool(names) == (pose is not None):
        raise misused("a shape is named by --shape, or else by --pose", "give one of the two")
    if pose is None:
        if (width, height, label) != (None, None, None):
            raise misused("--width, --height and --label go with --pose", "leave them away")
        return tuple(named_shape(source, name) for name in names)
    if not width or not height or not label:
        raise misused("--pose takes --width, --height and --label", "say how large it is, and what")
    return (Placement(pose.x, pose.y, width, height, pose.angle, label),)
