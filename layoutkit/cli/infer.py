"""``layoutkit infer``: constraints read off a segmentation."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.options import FacadeFile, FacadeOutput, Json
from layoutkit.cli.relocation import moved
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.model import Facade

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint

EXAMPLES = """
Examples:

- `layoutkit infer house.xml -o house-constrained.xml`

- `layoutkit infer house.xml -o house-free.xml --freedom loose`
"""


class Freedom(enum.StrEnum):
    """How far variations may go from the input."""

    strict = enum.auto()
    medium = enum.auto()
    loose = enum.auto()


def infer(
    context: typer.Context,
    facade_file: FacadeFile,
    output: FacadeOutput,
    freedom: Annotated[
        Freedom,
        typer.Option(
            metavar="LEVEL",
            help="How far variations may go: strict keeps to the input, medium, loose leaves most open.",
        ),
    ] = Freedom.medium,
    as_json: Json = False,
) -> int:
    """Add constraints that the facade's own regularity suggests.

    They are written out as elements of the document, each with a comment that says why, so that they can be
    edited. What is in the document already stays as it is.
    """
    from layoutkit import documents

    session = Session.of(context)
    document, facade = session.read_facade(facade_file, "infer")
    added = inferred(session, facade, freedom)
    source = documents.with_constraints(document.source, added)
    session.write(output, moved(source, facade_file.parent, output.parent))
    session.report()
    if as_json:
        console.emit(
            {
                "document": str(output),
                "constraints": [str(constraint) for constraint in added],
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
    else:
        console.say(f"{output}: {len(added)} constraints added")
    return 0


def inferred(session: Session, facade: Facade, freedom: Freedom) -> tuple[Constraint, ...]:
    """Return the constraints that the stage ``infer`` adds to a facade.

    Raises
    ------
    Faulty
        If the stage finds none, and says so by errors.
    """
    added: list[Constraint] = []
    for outcome in session.run("infer", facade, freedom=str(freedom)):
        session.report(outcome.diagnostics)
        if any(d.severity is Severity.ERROR for d in outcome.diagnostics):
            raise Faulty(outcome.diagnostics)
        if isinstance(outcome.document, Facade):
            added += [c for c in outcome.document.constraints if c not in (*facade.constraints, *added)]
    return tuple(added)
