"""Shapes of a scene as options name them: placements, polygons as the boxes about them, and poses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

import typer

from layoutkit.cli.editing import misused
from layoutkit.cli.options import finite
from layoutkit.diagnostics import did_you_mean
from layoutkit.model import Placement, Polygon, Pose, Scene


def _pose(text: str | Pose) -> Pose:
    """Read ``2.5,1,90``."""
    if isinstance(text, Pose):
        return text
    try:
        x, y, angle = (finite(float(part)) for part in text.split(","))
    except ValueError:
        raise typer.BadParameter(f"{text} is not of the form X,Y,ANGLE, such as 2.5,1,90") from None
    return Pose(x, y, angle)


PoseOption = Annotated[
    Pose | None,
    typer.Option(
        "--pose",
        parser=_pose,
        metavar="X,Y,ANGLE",
        show_default=False,
        help="Instead of --shape: a centre and a direction in degrees; with --width, --height and --label.",
    ),
]


def named_shape(scene: Scene, name: str) -> Placement:
    """Return a placement of a scene, called by its label and number, or the box about a polygon.

    Raises
    ------
    Faulty
        If nothing has the name, or what has it has no label.
    """
    known: Mapping[str, Polygon] = {polygon.name: polygon for polygon in scene.settled().polygons}
    if name not in known:
        raise misused(f"{scene.name} has no shape {name!r}", did_you_mean(name, known))
    placed = [polygon.name for polygon in scene.settled().polygons[len(scene.polygons) :]]
    if name in placed:
        return scene.placements[placed.index(name)]
    if not known[name].labels:
        raise misused(f"{name} has no label, by which others of its kind are known", "give it one")
    from layoutkit.scenes.boxes import box_about

    return box_about(known[name], known[name].labels[0])
