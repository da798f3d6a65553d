"""Examples of faults of references, and of what constraints need (LK201 to LK223)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import FACADE, HOUSE, VARIED

EXAMPLES = {
    "LK201": Example(HOUSE, '<size of="House/Flor" min="2"/>', '<size of="House/Floor" min="2"/>'),
    "LK202": Example(
        HOUSE, '<size of="House/Floor" min="4" max="2"/>', '<size of="House/Floor" min="2" max="4"/>'
    ),
    "LK203": Example(
        VARIED,
        '<size of="House/Floor" max="2"/>\n<size of="House/Ground" max="3"/>',
        '<size of="House/Floor" max="3"/>\n<size of="House/Ground" max="3"/>',
    ),
    "LK205": Example(
        HOUSE,
        '<sequence within="House/Floor/Bay" word="|- Bay -|"/>',
        '<sequence within="House/Floor" word="|- Pier Bay Pier -|"/>',
    ),
    "LK206": Example(
        HOUSE,
        '<alignment first="@Window" second="@Door" lines="left top"/>',
        '<alignment first="@Window" second="@Door" lines="left right"/>',
    ),
    "LK207": Example(
        HOUSE,
        '<same-size first="House: Floor Ground" dimension="width"/>',
        '<same-size first="House: Floor Ground" dimension="height"/>',
    ),
    "LK208": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="rows">
  <region symbol="Floor" height="3" split="columns"><region symbol="Bay" width="6"/></region>
  <region symbol="Ground" height="3" split="columns"><region symbol="Door" width="6"/></region>
</region>
<constraints>
  <same-arrangement of="House/Floor House/Ground"/>
</constraints>""",
        """\
<region symbol="House" width="6" height="6" split="rows">
  <region symbol="Floor" height="3" split="columns"><region symbol="Bay" width="6"/></region>
  <region symbol="Ground" height="3" split="columns"><region symbol="Bay" width="6"/></region>
</region>
<constraints>
  <same-arrangement of="House/Floor House/Ground"/>
</constraints>""",
    ),
    "LK210": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2"/>
  <region symbol="Bay" width="4"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2"/>
  <region symbol="WideBay" width="4"/>
</region>""",
    ),
    "LK211": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="columns">
  <again symbol="Bay"/>
  <region symbol="Bay" width="3"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="3"/>
  <again symbol="Bay"/>
</region>""",
    ),
    "LK212": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2"/>
  <region symbol="Pier" width="3"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="2"/>
  <region symbol="Pier" width="4"/>
</region>""",
    ),
    "LK213": Example(
        FACADE,
        """\
<picture file="photo.png" left="0" top="100" right="100" bottom="0"/>
<region symbol="House" width="6" height="6"/>""",
        """\
<picture file="photo.png" left="0" top="0" right="100" bottom="100"/>
<region symbol="House" width="6" height="6"/>""",
    ),
    "LK214": Example(
        HOUSE,
        '<size of="House/Floor" max="4" distribution="uniform"/>',
        '<size of="House/Floor" min="2" max="4" distribution="uniform"/>',
    ),
    "LK215": Example(
        HOUSE,
        '<alignment first="@Wall" second="@Wall" lines="left" first-before="-|"/>',
        '<alignment first="@Wall" second="@Wall" lines="left" first-after="-|"/>',
    ),
    "LK216": Example(HOUSE, '<instances of="House"/>', '<instances of="House/Floor/Pier"/>'),
    "LK217": Example(
        HOUSE, '<symmetry of="House/Floor" pairs="Pier:Bay Pier:Pier"/>', '<symmetry of="House/Floor"/>'
    ),
    "LK218": Example(
        HOUSE,
        '<lock of="House/Floor/Bay" keep="place" anchor="left right"/>',
        '<lock of="House/Floor/Bay" keep="place size" anchor="left"/>',
    ),
    "LK220": Example(
        HOUSE,
        '<repetition within="House/Floor" pattern="Pier+ Bay Pier+"/>',
        '<repetition within="House/Floor" pattern="Pier (Bay Pier)+"/>',
    ),
    "LK221": Example(
        HOUSE,
        '<reversal within="House/Floor"/>',
        '<replication within="House/Floor"/>\n<reversal within="House/Floor"/>',
    ),
    "LK222": Example(
        HOUSE,
        '<replication within="House"/>\n<reuse within="House/Floor" like="House"/>',
        '<replication within="House/Floor"/>\n<reuse within="House/Ground" like="House/Floor"/>',
    ),
    "LK223": Example(
        HOUSE,
        '<replication within="House/Floor" of="|- Bay Pier -|"/>',
        '<replication within="House/Floor" of="|- Pier Bay Pier -|"/>',
    ),
}
