"""Continuous edits as options tell them: sides that are dragged, regions that are given sizes."""

from __future__ import annotations

import re
from typing import Annotated

import typer

from layoutkit.cli.options import finite
from layoutkit.model import Drag, RegionSize

_DRAG = re.compile(r"(?P<region>[^:=]+):(?P<side>left|right|top|bottom)=(?P<to>[^=]+)")
_SIZE = re.compile(r"(?P<region>[^=]+)=(?P<width>[^x×]*)[x×](?P<height>[^x×]*)")


def _drag(text: str | Drag) -> Drag:
    """Read ``Facade/Bay:left=1.5``."""
    if (parts := _DRAG.fullmatch(str(text))) is None:
        raise typer.BadParameter(f"{text} is not of the form REGION:SIDE=TO, such as Facade/Bay:left=1.5")
    return Drag(parts["region"], parts["side"], _number(parts["to"]))  # type: ignore[arg-type]  # one of them


def _region_size(text: str | RegionSize) -> RegionSize:
    """Read ``Facade/Bay=2x1.5``, ``Facade/Bay=2x`` or ``Facade/Bay=x1.5``."""
    parts = _SIZE.fullmatch(str(text))
    if parts is None or not (parts["width"] or parts["height"]):
        example = "Facade/Bay=2x1.5, or Facade/Bay=2x for the width alone"
        raise typer.BadParameter(f"{text} is not of the form REGION=WIDTHxHEIGHT, such as {example}")
    width, height = (_number(parts[side]) if parts[side] else None for side in ("width", "height"))
    if any(size is not None and size <= 0 for size in (width, height)):
        raise typer.BadParameter(f"{text}: sizes are above 0")
    return RegionSize(parts["region"], width, height)


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is no number") from None
    return finite(value)


Dragged = Annotated[
    Drag | None,
    typer.Option(
        "--drag",
        parser=_drag,
        metavar="REGION:SIDE=TO",
        show_default=False,
        help="Put a side of a region elsewhere: left or right to an x, top or bottom to a y, from below.",
    ),
]
RegionSized = Annotated[
    RegionSize | None,
    typer.Option(
        "--size",
        parser=_region_size,
        metavar="REGION=WxH",
        show_default=False,
        help="Give a region another size: 2x1.5; 2x, the width alone; x1.5, the height alone.",
    ),
]
