"""``layoutkit count``: how many arrangements a facade has at a size."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import EXITS
from layoutkit.cli.options import FacadeFile, Json
from layoutkit.cli.session import Session
from layoutkit.cli.vary import AS_IS, Mass, Size, building, constrained
from layoutkit.model import Count, Facade

if TYPE_CHECKING:
    from layoutkit.hooks import Status

EXAMPLES = """
Examples:

- `layoutkit count house.xml`

- `layoutkit count house.xml --width 150% --effort 200000 --json`
"""

#: Whole numbers beyond this are not told apart by programs that read them as floats.
_SAFE = 2**53
#: Digits up to which a number is printed in full.
_DIGITS = 30


def count(
    context: typer.Context,
    facade_file: FacadeFile,
    width: Size = AS_IS,
    height: Size = AS_IS,
    mass: Mass = None,
    effort: Annotated[
        int | None,
        typer.Option(
            min=1,
            show_default=False,
            help="Small programs that may be solved, about; what is then not decided is left as a bound.",
        ),
    ] = None,
    as_json: Json = False,
) -> int:
    """Count the arrangements that a facade has at a size.

    An arrangement is a choice of words for all regions; it counts once if there are sizes that keep all
    constraints, however many there are. Where not all can be decided, the number is marked as a bound.

    Exit code 0: the number is exact. 3: it is 0, so there is no layout. 4: it is a bound.
    """
    session = Session.of(context)
    facade, _ = constrained(session, facade_file, "count")
    subject = facade if mass is None else building(session, facade, facade_file, mass, (width, height))
    asked: dict[str, Any] = {"width": width, "height": height}
    if effort is not None:
        asked["effort"] = effort
    outcome = next(session.run("count", subject, **asked))
    session.report(outcome.diagnostics)
    assert outcome.count is not None  # an outcome of this stage has one
    if as_json:
        console.emit(_as_data(session, facade, outcome.status, outcome.count))
    else:
        at = f"{outcome.count.size[0]:g} × {outcome.count.size[1]:g} {facade.units}"
        console.say(f"{facade.name} has {_said(outcome.count)} at {at}")
    return EXITS[outcome.status]


def _said(count: Count) -> str:
    """Return the number in words."""
    if count.kind == "exact":
        return f"{_spelled(count.least)} arrangement{'s' * (count.least != 1)}"
    if count.kind == "between":
        return f"between {_spelled(count.least)} and {_spelled(count.most)} arrangements"
    return f"{count.kind} {_spelled(count.most or count.least)} arrangements"


def _spelled(number: int | None) -> str:
    """Return a number in full, or, where that is too long to read, by its power of ten."""
    digits = str(number or 0)
    return f"{number:,}" if len(digits) <= _DIGITS else f"{digits[0]}.{digits[1:3]}e{len(digits) - 1}"


def _as_data(session: Session, facade: Facade, status: Status, count: Count) -> dict[str, Any]:
    least, most = _safe(count.least), _safe(count.most)
    return {
        "status": status,
        "name": facade.name,
        "units": facade.units,
        "width": count.size[0],
        "height": count.size[1],
        "kind": count.kind,
        "value": {"exact": least, "at least": least, "at most": most, "between": None}[count.kind],
        "least": least,
        "most": most,
        "explanation": count.explanation,
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }


def _safe(number: int | None) -> int | str | None:
    """Return a number as other programs can read it: as a string where floats are too short for it."""
    return number if number is None or number <= _SAFE else str(number)
