"""Examples of batches that cannot go on (LK89)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import COMMAND

EXAMPLES = {
    "LK890": Example(
        COMMAND,
        "layoutkit batch house.xml -n 1 -o out && layoutkit batch house.xml -n 1 --width 8 -o out",
        "layoutkit batch house.xml -n 1 -o out && layoutkit batch house.xml -n 1 --width 8 -o wide",
    ),
    "LK893": Example(
        COMMAND,
        "layoutkit batch house.xml -n 1 --scheduler tcp://127.0.0.1:1 -o out",
        "layoutkit batch house.xml -n 1 -o out",
    ),
}
