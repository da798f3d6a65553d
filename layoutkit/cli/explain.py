"""``layoutkit explain``: which constraints leave no layout at a size, by how much, and what would help."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import EXITS
from layoutkit.cli.options import FacadeFile, Json
from layoutkit.cli.render import photo_of
from layoutkit.cli.results import FACADE_FILE, ResultFolder
from layoutkit.cli.session import Session
from layoutkit.cli.vary import AS_IS, Mass, Size, building, constrained, refuse_own_input
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Facade, Layout, Picture

if TYPE_CHECKING:
    from layoutkit.hooks import Outcome
    from layoutkit.pictures import Photo

EXAMPLES = """
Examples:

- `layoutkit explain house.xml --width 60%`

- `layoutkit explain house.xml --width 1.9 -o why.png`

- `layoutkit explain house.xml --width 1.9 --json -o why`
"""

#: What is surely meant as a picture, and not as a folder.
_OTHER_PICTURES = frozenset((".svg", ".jpg", ".jpeg", ".gif", ".pdf", ".glb"))
#: Files in the folder of results, beside the copy of the facade.
LAYOUT_FILE, PICTURE_FILE, DATA_FILE = "layout.xml", "layout.png", "explanation.json"

#: The longer side of a picture, in pixels, at least.
_LEAST_PIXELS = 900


def explain(
    context: typer.Context,
    facade_file: FacadeFile,
    width: Size = AS_IS,
    height: Size = AS_IS,
    mass: Mass = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            show_default=False,
            help="A folder for the layout, its picture and the explanation; or a .png for the picture alone.",
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Start of the random choices in the layout.")] = 0,
    node_limit: Annotated[
        int | None,
        typer.Option(min=1, show_default=False, help="Words tried to tell whether there is a layout."),
    ] = None,
    as_json: Json = False,
) -> int:
    """Tell why a facade has no layout at a size, or show one.

    For each conflict: the fewest constraints that cannot hold together, with their lines, by how much they
    miss, and changes that help; each of these was tried. The picture shows the layout that comes nearest:
    what it breaks is hatched in red, what else takes part in the conflict outlined in amber.

    Exit code 0: there is a layout. 3: there is none. 4: that could not be told within the limit.
    """
    session = Session.of(context)
    if output is not None and output.suffix.lower() in _OTHER_PICTURES:
        raise Faulty([_only_png(output)])
    if output is not None and not _is_picture(output):
        refuse_own_input(facade_file, output)
    facade, source = constrained(session, facade_file, "explain")
    subject = facade if mass is None else building(session, facade, facade_file, mass, (width, height))
    asked: dict[str, Any] = {"width": width, "height": height, "seed": seed}
    if node_limit is not None:
        asked["node_limit"] = node_limit
    outcome = next(session.run("explain", subject, **asked))
    session.report(outcome.diagnostics)
    answer = _Answer(session, facade, outcome)
    if output is not None:
        photo = photo_of(facade, facade_file.parent)
        _write(answer, output, source, photo, facade_file.parent)
    if as_json:
        console.emit(answer.data())
    else:
        for line in answer.lines(output):
            console.say(line)
    return EXITS[outcome.status]


@dataclass(frozen=True)
class _Answer:
    """What came of it: the outcome of the stage, and what there is to show."""

    session: Session
    facade: Facade
    outcome: Outcome

    @property
    def size(self) -> tuple[float, float]:
        """Width and height that were asked for."""
        if isinstance(self.outcome.document, Layout):
            return self.outcome.document.root.width, self.outcome.document.root.height
        assert self.outcome.explanation is not None  # an outcome of this stage has either
        return self.outcome.explanation.size

    @property
    def layout(self) -> Layout | None:
        """The layout that was found, or else the best effort."""
        if isinstance(self.outcome.document, Layout):
            return self.outcome.document
        explanation = self.outcome.explanation
        return explanation.best_effort if explanation is not None else None

    def data(self) -> dict[str, Any]:
        """Return all of it as JSON-ready data."""
        from layoutkit.cli.explanation import conflict_data, violation_data

        explanation, effort = self.outcome.explanation, self.layout
        return {
            "status": self.outcome.status,
            "name": self.facade.name,
            "units": self.facade.units,
            "width": self.size[0],
            "height": self.size[1],
            "conflicts": [] if explanation is None else [conflict_data(c) for c in explanation.conflicts],
            "complete": True if explanation is None else explanation.complete,
            "violations": [] if effort is None else [violation_data(v) for v in effort.violations()],
            "diagnostics": [d.as_dict() for d in self.session.diagnostics],
        }

    def lines(self, output: Path | None) -> list[str]:
        """Return all of it in a few lines; what the conflicts are is told by diagnostics."""
        at = f"{self.size[0]:g} × {self.size[1]:g} {self.facade.units}"
        where = "" if output is None or self.layout is None else f"; {_picture(output)} shows "
        if self.outcome.status == "found":
            return [f"{self.facade.name} can be laid out at {at}" + (where and f"{where}how")]
        broken = () if self.layout is None else self.layout.violations()
        count = len({id(violation.constraint) for violation in broken})
        effort = f"the best effort breaks {count} constraint{'s' * (count != 1)}"
        none = f"{self.facade.name} has no layout at {at}"
        if self.outcome.status == "limit":
            none = f"{self.facade.name} may have no layout at {at}"
        return [none if self.layout is None else f"{none}; {effort}" + (where and f"{where}it")]


def _only_png(output: Path) -> Diagnostic:
    return Diagnostic(
        "LK703",
        f"an explanation is not drawn as {output.suffix!r}",
        Place(str(output)),
        "end the file's name in .png, or name a folder",
        topic="usage",
    )


def _is_picture(output: Path) -> bool:
    return output.suffix.lower() == ".png"


def _picture(output: Path) -> Path:
    return output if _is_picture(output) else output / PICTURE_FILE


def _write(answer: _Answer, output: Path, source: bytes, photo: Photo | None, folder: Path) -> None:
    """Write the picture, and, into a folder, the documents that go with it."""
    from layoutkit.documents import layout_bytes

    session, layout = answer.session, answer.layout
    size = (0, 0)
    if layout is not None:
        picture, size = _drawn(answer, layout, photo)
        session.write(_picture(output), picture)
    if _is_picture(output):
        return
    own = folder / answer.facade.picture.file if answer.facade.picture is not None else None
    ResultFolder(session, output, answer.facade, photo, 1.0, 2).write_facade(source, own)
    session.write(output / DATA_FILE, f"{json.dumps(answer.data(), indent=2)}\n".encode())
    if layout is not None:
        shown = Picture(PICTURE_FILE, (0.0, 0.0, float(size[0]), float(size[1])))
        written = replace(layout, facade_file=FACADE_FILE, picture=shown)
        session.write(output / LAYOUT_FILE, layout_bytes(written))


def _drawn(answer: _Answer, layout: Layout, photo: Photo | None) -> tuple[bytes, tuple[int, int]]:
    """Return a picture of the layout as a file, and the size of the part that shows it."""
    from layoutkit.cli.explanation import marks_of
    from layoutkit.pictures import png_bytes, render_png
    from layoutkit.pictures.marks import marked

    image = render_png(layout, photo, scale=_scale(layout, photo))
    explanation = answer.outcome.explanation
    if explanation is None:
        return png_bytes(image), image.size
    title = f"{answer.facade.name}: best effort at {answer.size[0]:g} × {answer.size[1]:g} {layout.units}"
    return png_bytes(marked(image, layout, marks_of(explanation, layout), title)), image.size


def _scale(layout: Layout, photo: Photo | None) -> float:
    """Return how much larger than usual a picture has to be for marks to have room."""
    from layoutkit.pictures.png import DEFAULT_SCALE

    natural = max(photo.grid.scale) if photo is not None else DEFAULT_SCALE[layout.units]
    return min(4.0, max(1.0, _LEAST_PIXELS / (natural * max(layout.root.width, layout.root.height))))
