"""Examples of constraints that mean what cannot be (LK224 to LK231)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import FACADE, HOUSE

EXAMPLES = {
    "LK224": Example(
        HOUSE,
        '<size of="House" max="5"/>\n<size of="House/Floor | House/Ground" min="3"/>',
        '<size of="House" max="7"/>\n<size of="House/Floor | House/Ground" min="3"/>',
    ),
    "LK225": Example(
        HOUSE,
        '<sequence within="House/Floor" word="Pier Bay Pier -|"/>',
        '<sequence within="House/Floor" word="|- Pier Bay Pier -|"/>',
    ),
    "LK226": Example(
        HOUSE,
        '<size of="House/Floor" min="3.5"/>\n<size of="House/Floor | House/Ground" max="3"/>',
        '<size of="House/Floor" min="2.5"/>\n<size of="House/Floor | House/Ground" max="3"/>',
    ),
    "LK227": Example(
        HOUSE,
        '<size of="House/Floor" max="2"/>\n<size of="House/Ground" max="3"/>',
        '<size of="House/Floor" max="3"/>\n<size of="House/Ground" max="3"/>',
    ),
    "LK228": Example(
        HOUSE,
        """\
<sequence within="House/Floor" word="|- Pier"/>
<sequence within="House/Floor" word="Pier Pier"/>
<sequence within="House/Floor" word="Pier -|"/>""",
        """\
<sequence within="House/Floor" word="|- Pier"/>
<sequence within="House/Floor" word="Pier Bay Pier"/>
<sequence within="House/Floor" word="Pier -|"/>""",
    ),
    "LK229": Example(
        HOUSE,
        '<alignment first="House/Floor/Pier" second="House/Floor/Bay" lines="left"/>',
        '<alignment first="House/Ground/Door" second="House/Floor/Bay" lines="left"/>',
    ),
    "LK230": Example(
        HOUSE,
        '<alignment first="@Window" second="@Door" lines="left" first-before="Bay"/>',
        '<alignment first="@Window" second="@Door" lines="left" first-before="Pier"/>',
    ),
    "LK231": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2" labels="Window"/>
  <region symbol="Shop" width="4" labels="window"/>
</region>
<constraints>
  <size of="@Window" min="1" max="5"/>
</constraints>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2" labels="Window"/>
  <region symbol="Shop" width="4" labels="Window"/>
</region>
<constraints>
  <size of="@Window" min="1" max="5"/>
</constraints>""",
    ),
}
