"""What commands do with a scene in which shapes were placed: files, pictures, and what is said of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import EXITS
from layoutkit.cli.options import finite
from layoutkit.cli.scene_files import check_targets, write_evidence, write_scene
from layoutkit.cli.session import Session
from layoutkit.hooks import Outcome
from layoutkit.model import Evidence, Placement, Scene

HeatFile = Annotated[
    Path | None,
    typer.Option("--heat", metavar="FILE.png", show_default=False, help="Heat maps to write as a picture."),
]
ContributionsFile = Annotated[
    Path | None,
    typer.Option(
        "--contributions",
        metavar="FILE.png",
        show_default=False,
        help="A picture to write of what each relationship function adds to each score.",
    ),
]
Afresh = Annotated[
    bool, typer.Option("--afresh", help="Take what has the label out of the scene before anything is placed.")
]
Limit = Annotated[
    int | None, typer.Option(min=1, show_default=False, help="How many are placed at most; the best ones.")
]
PictureScale = Annotated[
    float,
    typer.Option(
        min=0.01,
        max=100,
        callback=finite,
        help="Size of a PNG, as a multiple of the photo's own, or of 1200 pixels.",
    ),
]


@dataclass(frozen=True)
class Targets:
    """The files to write.

    Attributes
    ----------
    scenes
        For the scene, by suffix.
    heat, contributions
        For pictures of the evidence.
    scale
        Size of PNGs of the scene.
    """

    scenes: Sequence[Path]
    heat: Path | None
    contributions: Path | None
    scale: float

    @property
    def evidence(self) -> bool:
        """Whether pictures of the evidence are asked for."""
        return (self.heat or self.contributions) is not None

    @property
    def files(self) -> tuple[Path, ...]:
        """All of them."""
        return (*self.scenes, *(file for file in (self.heat, self.contributions) if file is not None))

    def check(self, read: Sequence[Path]) -> None:
        """Raise `Faulty` where a file cannot be written, or is one of those that are read."""
        check_targets(self.scenes, (self.heat, self.contributions), read)


def finish(
    session: Session, outcome: Outcome, before: Scene, source: Path, targets: Targets, as_json: bool
) -> int:
    """Write what came of a stage, say so, and return the exit code.

    Parameters
    ----------
    before
        The scene that shapes were placed in.
    source
        Its file.
    """
    scene = outcome.document
    placed: tuple[Placement, ...] = ()
    if isinstance(scene, Scene):
        placed = added(before, scene)
        write_scene(session, scene, source.parent, targets.scenes, targets.scale)
        if targets.evidence:
            evidence = outcome.evidence or Evidence()
            shown = replace(before.settled(), placements=evidence.placements or placed)
            write_evidence(session, shown, evidence, targets.heat, targets.contributions)
    files = targets.files if isinstance(scene, Scene) else ()
    if as_json:
        console.emit(_as_data(session, outcome, placed, files))
    else:
        for line in _lines(before, placed, files):
            console.say(line)
    return EXITS[outcome.status]


def added(before: Scene, after: Scene) -> tuple[Placement, ...]:
    """Return the placements of a scene that it did not have before."""
    old = list(before.placements)
    new = []
    for placement in after.placements:
        if placement in old:
            old.remove(placement)
        else:
            new.append(placement)
    return tuple(new)


def placement_data(placement: Placement) -> dict[str, Any]:
    """Return a placement as JSON-ready data."""
    names = ("label", "x", "y", "width", "height", "angle", "mirrored", "score")
    return {name: getattr(placement, name) for name in names}


def _lines(before: Scene, placed: Sequence[Placement], files: Sequence[Path]) -> Iterator[str]:
    scores = [placement.score for placement in placed if placement.score is not None]
    told = f", scores from {max(scores):.3g} to {min(scores):.3g}" if scores else ""
    yield f"{before.name}: {len(placed)} placed{told}"
    yield from map(str, files)


def _as_data(
    session: Session, outcome: Outcome, placed: Sequence[Placement], files: Sequence[Path]
) -> dict[str, Any]:
    return {
        "status": outcome.status,
        "placements": [placement_data(placement) for placement in placed],
        "files": [str(file) for file in files],
        "seconds": round(outcome.seconds, 6),
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }
