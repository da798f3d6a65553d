"""Examples of faults of grids, and of sessions that name them (LK24)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import GRIDDED, SESSION

_PIERS = '<grid name="piers" elements="House/Floor/Pier House/Floor/{}"/>'

EXAMPLES = {
    "LK241": Example(GRIDDED, _PIERS.format("Pier.3"), _PIERS.format("Pier.2")),
    "LK242": Example(GRIDDED, _PIERS.format("Pier"), _PIERS.format("Pier.2")),
    "LK243": Example(
        GRIDDED,
        '<grid name="floors" of="House/Floor | @Window"/>',
        '<grid name="floors" of="House/Floor"/>\n<grid name="windows" of="@Window"/>',
    ),
    "LK244": Example(
        GRIDDED,
        '<grid name="openings" of="@Window - House/Floor/*"/>',
        '<grid name="openings" of="@Window | @Door"/>',
    ),
    "LK245": Example(
        GRIDDED,
        '<grid name="walls" of="House/Floor/Pier"/>\n<grid name="walls" of="House/Ground/Pier"/>',
        '<grid name="upper" of="House/Floor/Pier"/>\n<grid name="lower" of="House/Ground/Pier"/>',
    ),
    "LK246": Example(
        SESSION,
        '<edit action="add" axis="columns" grids="peirs" source="1" at="2"/>',
        '<edit action="add" axis="columns" grids="piers" source="1" at="2"/>',
    ),
}
