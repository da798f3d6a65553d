"""``layoutkit vary``: variations of a facade, as documents, pictures and a contact sheet."""

from __future__ import annotations

import enum
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import EXITS, exit_of
from layoutkit.cli.infer import Freedom, inferred
from layoutkit.cli.options import FacadeFile, Json, finite, read_size
from layoutkit.cli.render import photo_of
from layoutkit.cli.results import FACADE_FILE, ResultFolder, Variation
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, blame, worst
from layoutkit.model import Facade, Layout, Measure

if TYPE_CHECKING:
    from layoutkit.hooks import Outcome, Status


class Sampling(enum.StrEnum):
    """Which arrangements variations have."""

    weighted = enum.auto()
    uniform = enum.auto()
    diverse = enum.auto()


EXAMPLES = """
Examples:

- `layoutkit vary house.xml -n 8 -o out`

- `layoutkit vary house.xml -n 20 --width 150% --height 21.5 --seed 7 -o wide`

- `layoutkit vary house.xml -n 4 --mass block.xml -o block`

- `layoutkit vary house.xml -n 6 --sampling diverse -o far-apart`
"""


Size = Annotated[
    Measure,
    typer.Option(
        parser=read_size,
        metavar="SIZE",
        show_default="100%",
        help="A number in the document's units, or a percentage of the input's size, such as 120%.",
    ),
]
AS_IS = Measure(1.0, relative=True)
Mass = Annotated[
    Path | None,
    typer.Option(
        metavar="MASS",
        show_default=False,
        help="A mass document (XML): the facade is put on all its faces, which set the sizes.",
    ),
]


def vary(
    context: typer.Context,
    facade_file: FacadeFile,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The folder for results.")],
    count: Annotated[int, typer.Option("-n", "--count", min=1, help="How many variations.")] = 8,
    width: Size = AS_IS,
    height: Size = AS_IS,
    mass: Mass = None,
    seed: Annotated[
        int, typer.Option(min=0, help="Start of all random choices: the same seed gives the same bytes.")
    ] = 0,
    sampling: Annotated[
        Sampling,
        typer.Option(
            metavar="WAY",
            help="Which arrangements: weighted, likely ones; uniform, each that exists equally often; "
            "diverse, such as are far from each other.",
        ),
    ] = Sampling.weighted,
    node_limit: Annotated[
        int | None,
        typer.Option(min=1, show_default=False, help="Words tried for one variation before giving up."),
    ] = None,
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of the pictures, as a multiple of the photo's own."
        ),
    ] = 1.0,
    as_json: Json = False,
) -> int:
    """Make variations of a facade that keep its constraints.

    Writes into DIR: a layout document and a picture of each, the contact sheet sheet.png, and a copy of the
    facade. A facade without constraints gets those that its own regularity suggests. The faces of a building
    stand side by side in pictures; `layoutkit render` puts them in place.

    Exit code 3: proved that there are no (more) variations. 4: the search gave up at a limit.
    """
    session = Session.of(context)
    refuse_own_input(facade_file, output)
    facade, source = constrained(session, facade_file, "vary")
    subject = facade if mass is None else building(session, facade, facade_file, mass, (width, height))
    photo = photo_of(facade, facade_file.parent)
    picture = facade_file.parent / facade.picture.file if facade.picture is not None else None
    folder = ResultFolder(session, output, facade, photo, scale, max(2, len(str(count))))
    folder.write_facade(source, picture)
    asked: dict[str, Any] = {"count": count, "width": width, "height": height, "seed": seed}
    if sampling is not Sampling.weighted:  # by default no stage needs to know of it
        asked["sampling"] = str(sampling)
    if node_limit is not None:
        asked["node_limit"] = node_limit
    results = list(_results(folder, subject, count, asked))
    if written := [r.variation for r in results if r.variation is not None]:
        sheet = folder.write_sheet(written)
    session.report(folder.left_over(written))
    status = _status(results, count)
    if as_json:
        console.emit(_as_data(session, status, seed, results))
    elif written:
        console.say(f"{len(written)} of {count} variations of {facade.name}; {sheet} shows them all")
    return exit_of(d for d in session.diagnostics if d.code.startswith("LK9")) or EXITS[status]


@dataclass(frozen=True)
class _Result:
    """What came of one variation; `variation` is None where nothing was written."""

    outcome: Outcome
    variation: Variation | None


def refuse_own_input(facade_file: Path, output: Path, results: str = "variations") -> None:
    """Raise `Faulty` if the copy of the facade in a folder of results would overwrite the facade itself.

    Parameters
    ----------
    results
        What to call another folder.
    """
    own = output / FACADE_FILE
    if own.exists() and facade_file.exists() and own.samefile(facade_file):
        raise Faulty(
            [
                Diagnostic(
                    "LK704",
                    f"the results' copy of the facade would overwrite the input {facade_file}",
                    Place(str(output)),
                    f"name another folder with -o, such as {output / results}",
                    topic="usage",
                )
            ]
        )


def constrained(session: Session, facade_file: Path, command: str) -> tuple[Facade, bytes]:
    """Return the facade and its document's text; with inferred constraints where it had none."""
    from layoutkit import documents

    document, facade = session.read_facade(facade_file, command)
    if facade.constraints:
        return facade, document.source
    added = inferred(session, facade, Freedom.medium)
    session.report(
        [
            Diagnostic(
                "LK602",
                f"the document has no constraints: {len(added)} were inferred from the facade's regularity",
                Place(str(facade_file)),
                "`layoutkit infer` writes them into a document, where they can be edited",
                Severity.NOTE,
                "search",
            )
        ]
    )
    constrained = replace(facade, constraints=added)
    return constrained, documents.with_constraints(document.source, added)


def building(
    session: Session, facade: Facade, facade_file: Path, mass_file: Path, size: tuple[Measure, Measure]
) -> Facade:
    """Return the facade of a building: the design on all faces of a mass.

    Raises
    ------
    Faulty
        If the mass has errors or other units, if a constraint cannot be carried over, or if a size is asked.
    """
    from layoutkit import documents
    from layoutkit.constraints.dressing import dressed, dressing_faults

    if size != (AS_IS, AS_IS):
        message = f"a building has the size of its mass {mass_file}, and no other"
        hint = "leave --width and --height away, or change the mass"
        raise Faulty([Diagnostic("LK706", message, Place(str(mass_file)), hint, topic="usage")])
    document = documents.read_mass(mass_file)
    session.report(document.diagnostics)
    if document.units != facade.units:
        message = f"the mass is in {document.units}, the facade {facade_file} in {facade.units}"
        hint = "write both in the same units"
        raise Faulty([Diagnostic("LK503", message, Place(str(mass_file)), hint, topic="mass")])
    found = tuple(dressing_faults(facade, document.mass))
    if worst(found) is Severity.ERROR:
        raise Faulty(found)
    session.report(found)
    return dressed(facade, document.mass)


def _results(folder: ResultFolder, subject: Facade, count: int, options: dict[str, Any]) -> Iterator[_Result]:
    """Yield what comes of each variation; where the stage fails, those before it are all there is."""
    session = folder.session
    outcomes = iter(console.progress(session.run("relayout", subject, **options), "variations", count))
    for position in range(count):
        try:
            outcome = next(outcomes, None)
        except Faulty:
            raise
        except blame.ANYTHING as error:
            session.report([blame.unforeseen(error)])
            return
        if outcome is None:
            return
        session.report(outcome.diagnostics)
        yield _Result(outcome, _written(folder, position, outcome))


def _written(folder: ResultFolder, position: int, outcome: Outcome) -> Variation | None:
    layout = outcome.document
    if outcome.status != "found" or not isinstance(layout, Layout):
        return None
    number = position if layout.index is None else layout.index
    return folder.write_variation(number + 1, layout)


def _status(results: list[_Result], count: int) -> Status:
    if sum(result.variation is not None for result in results) >= count:
        return "found"
    return "infeasible" if any(r.outcome.status == "infeasible" for r in results) else "limit"


def _as_data(session: Session, status: Status, seed: int, results: list[_Result]) -> dict[str, Any]:
    return {
        "status": status,
        "seed": seed,
        "variations": [
            {
                "index": position,
                "status": result.outcome.status,
                "layout": str(result.variation.layout) if result.variation else None,
                "picture": str(result.variation.picture) if result.variation else None,
                "seconds": round(result.outcome.seconds, 6),
            }
            for position, result in enumerate(results)
        ],
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }
