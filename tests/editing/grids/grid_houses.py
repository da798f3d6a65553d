"""Houses in a few words, for tests of grids: windows in walls, storey by storey."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import pytest

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Facade, Region
from layoutkit_editing.original import Original
from layoutkit_formats.cmp import CmpFormat

ROOT = Path(__file__).parents[3]
CMP = ROOT.parent / "shared" / "data" / "cmp"
KINDS = {kind.kind: kind for kind in BUILT_IN}
DESIGNS = ("arcade", "block", "palace", "plain", "townhouse")


def terminal(label: str, width: float, height: float) -> Region:
    return Region(label, width, height, labels=(label,))


def opening(label: str, width: float, height: float, storey: float = 3.0, symbol: str = "") -> Region:
    """A door or window, wall above and below."""
    sill = 0.0 if label == "Door" else (storey - height) / 3
    parts = [terminal("Wall", width, storey - height - sill), terminal(label, width, height)]
    if sill:
        parts.append(terminal("Wall", width, sill))
    return Region(symbol or f"{label}Strip", width, storey, "rows", tuple(parts))


def storey(openings: Sequence[Region], width: float, symbol: str = "Floor") -> Region:
    """Openings at equal distances."""
    height = openings[0].height
    gap = (width - sum(own.width for own in openings)) / (len(openings) + 1)
    parts = [terminal("Wall", gap, height)]
    for own in openings:
        parts += [own, terminal("Wall", gap, height)]
    return Region(symbol, width, height, "columns", tuple(parts), labels=("Floor",))


def house(*storeys: Region) -> Facade:
    return Facade(
        "house", "m", Region("House", storeys[0].width, sum(s.height for s in storeys), "rows", storeys)
    )


def windows(count: int, width: float = 1.0, height: float = 1.5) -> list[Region]:
    return [opening("Window", width, height)] * count


@cache
def design(name: str) -> Facade:
    """One of our own designs."""
    found = read(ROOT / "facades" / name / "facade.xml", KINDS).model
    assert isinstance(found, Facade)
    return found


@cache
def real(name: str) -> Original:
    """A converted facade of the CMP database."""
    if not CMP.is_dir():
        pytest.skip("the CMP facades are not beside the project")
    return Original(CmpFormat().read(CMP / f"{name}.xml", CMP / f"{name}.jpg")[0])
