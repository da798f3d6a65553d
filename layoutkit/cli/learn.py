"""``layoutkit learn``: where shapes are placed, learned from examples, as a document."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.declared import declared_by
from layoutkit.cli.editing import keep, misused
from layoutkit.cli.exits import EXITS
from layoutkit.cli.options import Json
from layoutkit.cli.scene_files import unknown_suffix
from layoutkit.cli.scenes import read_scene
from layoutkit.cli.session import Session
from layoutkit.hooks import Outcome
from layoutkit.model import LearningSettings, PlacementModel

EXAMPLES = """
Examples:

- `layoutkit learn front.xml -o flower-boxes.xml`

- `layoutkit learn first.xml second.xml --label Balcony --tolerance 2 -o balconies.xml`
"""

ExampleFiles = Annotated[
    list[Path],
    typer.Argument(metavar="EXAMPLES...", help="Scenes with examples: files of any kind that scenes are in."),
]
LearnedLabel = Annotated[
    str | None,
    typer.Option(
        metavar="LABEL",
        show_default=False,
        help="What is placed; may be left out where the examples' placements have one label.",
    ),
]
ChosenExamples = Annotated[
    str | None,
    typer.Option(
        "--examples",
        metavar="NUMBERS",
        show_default=False,
        help="Which examples count, such as 1,3: counted from 1 through all files, in each placements first, "
        "then polygons; left out, all.",
    ),
]
ExampleParts = Annotated[
    list[str] | None,
    typer.Option(
        "--example-part",
        metavar="NAME",
        show_default=False,
        help="Which scene of examples' files that hold several; may be given several times.",
    ),
]


@declared_by(LearningSettings, "settings")
def learn(
    context: typer.Context,
    files: ExampleFiles,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="OUT.xml", help="The placement model to write.")
    ],
    label: LearnedLabel = None,
    chosen: ChosenExamples = None,
    parts: ExampleParts = None,
    settings: LearningSettings = LearningSettings(),  # noqa: B008 - frozen
    as_json: Json = False,
) -> int:
    """Learn where shapes are placed from examples in scenes.

    Examples are the placements and polygons of a label. All else in their scenes is what they are related to.
    Writes a placement model, which `layoutkit place` takes instead of examples.
    """
    session = Session.of(context)
    if output.suffix.lower() != ".xml":
        raise unknown_suffix(output, (".xml",))
    keep(output, files)
    outcome = learned(session, files, parts, label, chosen, settings)
    model = outcome.document
    if isinstance(model, PlacementModel):
        from layoutkit.documents import placement_model_bytes

        session.write(output, placement_model_bytes(model))
    if as_json:
        console.emit(_as_data(session, outcome, output))
    elif isinstance(model, PlacementModel):
        console.say(f"{output}: {model.label}, learned from {counted(len(model.examples), 'example')}")
    return EXITS[outcome.status]


def learned(
    session: Session,
    files: Sequence[Path],
    parts: Sequence[str] | None,
    label: str | None,
    chosen: str | None,
    settings: LearningSettings,
) -> Outcome:
    """Return what the stage `learn` makes of the examples in some files, and report what it says.

    Raises
    ------
    Faulty
        If a file cannot be read, or nothing can be learned from what is in it.
    """
    named: Sequence[str | None] = parts or [None]
    first, *more = [read_scene(session, file, part) for file in files for part in named]
    asked: dict[str, Any] = {"label": label or "", "more": tuple(more), "settings": settings}
    if chosen is not None:
        asked["chosen"] = _numbers(chosen)
    (outcome,) = session.run("learn", first, **asked)
    session.report(outcome.diagnostics)
    return outcome


def counted(count: int, what: str) -> str:
    """Return a number with what it is of."""
    return f"{count} {what}{'s' * (count != 1)}"


def _numbers(text: str) -> tuple[int, ...]:
    """Read ``1,3``."""
    numbers = text.replace(",", " ").split()
    if not numbers or not all(number.isdecimal() and int(number) > 0 for number in numbers):
        raise misused(f"--examples {text}: these are no numbers of examples", "write such as 1,3")
    return tuple(dict.fromkeys(map(int, numbers)))


def _as_data(session: Session, outcome: Outcome, output: Path) -> dict[str, Any]:
    model = outcome.document
    found: dict[str, Any] = {"status": outcome.status, "model": None, "label": None, "examples": 0}
    if isinstance(model, PlacementModel):
        found |= {"model": str(output), "label": model.label, "examples": len(model.examples)}
    return {
        **found,
        "seconds": round(outcome.seconds, 6),
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }
