"""Examples of what there is to say of edits (LK65)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import EDITING, HEIGHTENED, REPLAYED

_TAKE = "layoutkit apply {} --grid piers --take 1 -o edited.xml --session edits.xml"
_PROPOSE = "layoutkit propose {} --grid windows_and_doors -o out"
_REMOVE = '<edit action="remove" axis="rows" grids="openings" source="{}"/>'

EXAMPLES = {
    "LK651": Example(
        EDITING,
        "layoutkit propose house.xml --grid peirs -o out",
        "layoutkit propose house.xml --grid piers -o out",
    ),
    "LK652": Example(EDITING, _TAKE.format("bare.xml"), _TAKE.format("house.xml")),
    "LK653": Example(
        EDITING,
        "layoutkit propose house.xml --grid openings --remove -o out",
        "layoutkit propose house.xml --grid openings --axis rows --remove -o out",
    ),
    "LK654": Example(REPLAYED, _REMOVE.format(3), _REMOVE.format(2)),
    "LK655": Example(
        HEIGHTENED,
        '<frequency of="@Door" within="House" max="1"/>',
        '<frequency of="@Door" within="House" max="2"/>',
    ),
    "LK656": Example(
        EDITING,
        "layoutkit propose house.xml --grid openings --axis rows -n 1 -o out",
        "layoutkit propose house.xml --grid openings --axis rows -o out",
    ),
    "LK657": Example(
        EDITING,
        _PROPOSE.format("bare.xml"),
        f"layoutkit grids bare.xml -o found.xml && {_PROPOSE.format('found.xml')}",
    ),
    "LK658": Example(
        EDITING,
        "layoutkit apply house.xml --size House/Flor=x3.5 -o edited.xml",
        "layoutkit apply house.xml --size House/Floor=x3.5 -o edited.xml",
    ),
    "LK659": Example(
        EDITING,
        "layoutkit apply house.xml --drag House/Floor/Pier:right=5.5 -o edited.xml",
        "layoutkit apply house.xml --drag House/Floor/Pier:right=1.5 -o edited.xml",
    ),
}
