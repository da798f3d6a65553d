"""Examples of commands that are at fault (LK7)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import COMMAND, WITH_PLUGIN

EXAMPLES = {
    "LK701": Example(
        COMMAND,
        "layoutkit vary house.xml -n 1 --widht 8 -o out",
        "layoutkit vary house.xml -n 1 --width 8 -o out",
    ),
    "LK702": Example(
        COMMAND, "layoutkit vary layout.xml -n 1 -o out", "layoutkit vary house.xml -n 1 -o out"
    ),
    "LK703": Example(
        COMMAND, "layoutkit render house.xml -o house.bmp", "layoutkit render house.xml -o house.png"
    ),
    "LK704": Example(
        COMMAND, "layoutkit vary facade.xml -n 1 -o .", "layoutkit vary facade.xml -n 1 -o variations"
    ),
    "LK705": Example(
        COMMAND,
        "layoutkit vary house.xml -n 2 -o out && layoutkit vary house.xml -n 1 -o out",
        "layoutkit vary house.xml -n 2 -o out && layoutkit vary house.xml -n 1 -o other",
    ),
    "LK706": Example(
        COMMAND,
        "layoutkit vary house.xml --mass mass.xml --width 8 -n 1 -o out",
        "layoutkit vary house.xml --mass mass.xml -n 1 -o out",
    ),
    "LK707": Example(
        WITH_PLUGIN,
        "LAYOUTKIT_PLUGIN_PATIENCE=10s layoutkit plugins",
        "LAYOUTKIT_PLUGIN_PATIENCE=10 layoutkit plugins",
    ),
    "LK710": Example(COMMAND, "layoutkit samples palais -o samples", "layoutkit samples palace -o samples"),
    "LK711": Example(COMMAND, "layoutkit validate toys", "layoutkit validate house.xml"),
    "LK712": Example(COMMAND, "layoutkit validate .", "layoutkit validate house.xml"),
}
