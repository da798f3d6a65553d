"""Arguments and options that several commands have."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from layoutkit.model import Measure

Json = Annotated[bool, typer.Option("--json", help="Print the result as JSON, for other programs.")]
FacadeFile = Annotated[Path, typer.Argument(metavar="FACADE", help="A facade document (XML).")]
FacadeOutput = Annotated[
    Path, typer.Option("-o", "--output", metavar="OUT.xml", help="The facade document to write.")
]


def read_size(text: str | Measure) -> Measure:
    """Read a size; typer also hands defaults in."""
    try:
        measure = Measure.parse(str(text))
    except ValueError:
        measure = Measure(0.0)
    if measure.value <= 0:
        raise typer.BadParameter(
            f"{text or 'nothing'} is no size above 0 (such as 24) and no percentage (such as 120%)"
        )
    return measure


def finite(value: float) -> float:
    """Return a number, unless it is none: ranges let NaN through."""
    if not math.isfinite(value):
        raise typer.BadParameter(f"{value} is no number")
    return value
