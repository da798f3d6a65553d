"""``layoutkit place``: shapes put into a scene, as examples show it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from layoutkit.cli.declared import declared_by, given
from layoutkit.cli.editing import misused
from layoutkit.cli.learn import ChosenExamples, ExampleParts, LearnedLabel, learned
from layoutkit.cli.options import Json, finite
from layoutkit.cli.placing import Afresh, ContributionsFile, HeatFile, Limit, PictureScale, Targets, finish
from layoutkit.cli.scene_files import Part, SceneOutputs
from layoutkit.cli.scenes import read_scene
from layoutkit.cli.session import Session
from layoutkit.model import LearningSettings, PlacementModel, Spacing

EXAMPLES = """
Examples:

- `layoutkit place front.xml house.xml -o placed.xml -o placed.png`

- `layoutkit place first.xml second.xml third.xml --label Balcony --limit 8 -o balconies.svg`

- `layoutkit place flower-boxes.xml house.xml --heat heat.png --contributions why.png -o placed.png`
"""


@declared_by(LearningSettings, "settings")
@declared_by(Spacing, "spacing")
def place(
    context: typer.Context,
    *,
    examples: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="EXAMPLES...",
            help="Scenes with examples, any kind of file; or a placement model that `layoutkit learn` made.",
            show_default=False,
        ),
    ] = None,
    scene_file: Annotated[
        Path, typer.Argument(metavar="SCENE", help="The scene to place shapes in; any kind of file.")
    ],
    output: SceneOutputs,
    label: LearnedLabel = None,
    chosen: ChosenExamples = None,
    limit: Limit = None,
    threshold: Annotated[
        float | None,
        typer.Option(
            min=0,
            show_default=False,
            help="Only placements with at least this score; an example has about 1.",
        ),
    ] = None,
    afresh: Afresh = False,
    part: Part = None,
    parts: ExampleParts = None,
    heat: HeatFile = None,
    contributions: ContributionsFile = None,
    scale: PictureScale = 1.0,
    spacing: Spacing = Spacing(),  # noqa: B008 - frozen
    settings: LearningSettings = LearningSettings(),  # noqa: B008 - frozen
    as_json: Json = False,
) -> int:
    """Place shapes in a scene as they are placed in examples, the best first.

    Examples are the placements and polygons of a label in one or more scenes; what else stands there is what
    they are related to. The scene is written with placements, each an oriented box with a score.
    """
    session = Session.of(context)
    targets = Targets(output, heat, contributions, scale)
    files = examples or []
    targets.check([*files, scene_file])
    if file := _model_among(files, scene_file):
        model = _read(session, context, file, parts, label, chosen)
    else:
        document = learned(session, files, parts, label, chosen, settings).document
        assert isinstance(document, PlacementModel)
        model = document
    scene = read_scene(session, scene_file, part)
    if afresh:
        from layoutkit.cli.clearing import cleared

        scene = cleared(scene, model.label)
    asked: dict[str, Any] = {"limit": limit, "evidence": targets.evidence}
    if spacing != Spacing():
        asked["spacing"] = spacing
    if threshold is not None:
        asked["threshold"] = finite(threshold)
    (outcome,) = session.run("place", scene, model=model, **asked)
    session.report(outcome.diagnostics)
    return finish(session, outcome, scene, scene_file, targets, as_json)


def _model_among(files: Sequence[Path], scene_file: Path) -> Path | None:
    """Return the model, None of examples; raise `Faulty` unless there are these, and a scene behind them."""
    from layoutkit.documents import is_placement_model

    models = [file for file in files if is_placement_model(file)]
    if is_placement_model(scene_file):
        told = f"{scene_file} is a placement model, and stands where the scene is to be"
        if not files:
            raise misused(told, f"name the scene behind it: `layoutkit place {scene_file} SCENE -o OUT.png`")
        if models:
            raise misused(told, "name one model, and behind it the scene")
        raise misused(told, f"name the model first: `layoutkit place {scene_file} {files[-1]} -o OUT.png`")
    if not files:
        hint = (
            f"name examples, or a model, before the scene: `layoutkit place EXAMPLES {scene_file} -o OUT.png`"
        )
        raise misused(f"only one file is named, {scene_file}: there is nothing to place shapes by", hint)
    if len(models) > 1:
        named = ", ".join(map(str, models))
        hint = f"name one alone: `layoutkit place {models[0]} {scene_file} -o OUT.png`"
        raise misused(
            f"{len(models)} placement models are named, and shapes are placed by one: {named}", hint
        )
    if models and len(files) > 1:
        hint = f"name it alone: `layoutkit place {models[0]} {scene_file} -o OUT.png`"
        raise misused(f"{models[0]} is a placement model, and others are named with it", hint)
    return models[0] if models else None


def _read(
    session: Session,
    context: typer.Context,
    file: Path,
    parts: Sequence[str] | None,
    label: str | None,
    chosen: str | None,
) -> PlacementModel:
    """Return a model that was learned before, or raise `Faulty` where options would learn it otherwise."""
    from layoutkit import documents

    options = [*(["--examples"] if chosen else []), *(["--example-part"] if parts else [])]
    options += given(context, LearningSettings)
    if options:
        message = f"{file} was learned already: {', '.join(options)} can change nothing"
        raise misused(message, "give `layoutkit learn` these options")
    read = documents.read_placement_model(file)
    session.report(read.diagnostics)
    if label not in (None, read.model.label):
        raise misused(f"{file} places {read.model.label}, and not {label}", "leave --label away")
    return read.model
