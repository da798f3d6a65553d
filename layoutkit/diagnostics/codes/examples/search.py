"""Examples of what there is to say of a search (LK6)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import COMMAND, DRAWN, VARIED

_HOUSE = '<region symbol="House" width="6" height="6"/>'

EXAMPLES = {
    "LK601": Example(
        COMMAND,
        "layoutkit vary free.xml -n 1 --node-limit 1 -o out",
        "layoutkit vary free.xml -n 1 --node-limit 100 -o out",
    ),
    "LK602": Example(DRAWN, _HOUSE, f'{_HOUSE}\n<constraints><size of="House" max="7"/></constraints>'),
    "LK603": Example(
        VARIED,
        '<size of="House/Floor" min="2.5"/>\n<size of="House/Floor" max="2" weight="1"/>',
        '<size of="House/Floor" min="2.5"/>\n<size of="House/Floor" max="3" weight="1"/>',
    ),
    "LK604": Example(
        COMMAND,
        "layoutkit count tied.xml --effort 1",
        "layoutkit count tied.xml",
    ),
}
