"""Arguments and options that several commands have."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

Json = Annotated[bool, typer.Option("--json", help="Print the result as JSON, for other programs.")]
FacadeFile = Annotated[Path, typer.Argument(metavar="FACADE", help="A facade document (XML).")]
DocumentFile = Annotated[Path, typer.Argument(metavar="DOC", help="A facade or layout document (XML).")]
FacadeOutput = Annotated[
    Path, typer.Option("-o", "--output", metavar="OUT.xml", help="The facade document to write.")
]


def finite(value: float) -> float:
    """Return a number, unless it is none: ranges let NaN through."""
    if not math.isfinite(value):
        raise typer.BadParameter(f"{value} is no number")
    return value
