"""Examples of faults of structure (LK1)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import DOCUMENT, FACADE, HOUSE

EXAMPLES = {
    "LK101": Example(
        DOCUMENT,
        """\
<facade name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
        """\
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
    ),
    "LK102": Example(HOUSE, '<siz of="House/Floor" min="2"/>', '<size of="House/Floor" min="2"/>'),
    "LK103": Example(HOUSE, '<size of="House/Floor" minimum="2"/>', '<size of="House/Floor" min="2"/>'),
    "LK104": Example(HOUSE, '<size min="2"/>', '<size of="House/Floor" min="2"/>'),
    "LK105": Example(
        HOUSE,
        '<alignment first="@Window" second="@Door" lines="lefft"/>',
        '<alignment first="@Window" second="@Door" lines="left"/>',
    ),
    "LK106": Example(
        FACADE,
        '<region symbol="House" width="6 m" height="6"/>',
        '<region symbol="House" width="6" height="6"/>',
    ),
    "LK107": Example(
        FACADE,
        "<constraints/>",
        '<region symbol="House" width="6" height="6"/>\n<constraints/>',
    ),
    "LK108": Example(
        FACADE,
        '<constraints/>\n<region symbol="House" width="6" height="6"/>',
        '<region symbol="House" width="6" height="6"/>\n<constraints/>',
    ),
    "LK109": Example(
        FACADE,
        'my house: <region symbol="House" width="6" height="6"/>',
        '<!-- my house --> <region symbol="House" width="6" height="6"/>',
    ),
    "LK110": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6">
  <region symbol="Bay" width="6"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="6"/>
</region>""",
    ),
    "LK111": Example(
        FACADE,
        '<region symbol="House" width="6" height="6" split="columns"/>',
        '<region symbol="House" width="6" height="6"/>',
    ),
    "LK112": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="6" height="6"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Bay" width="6"/>
</region>""",
    ),
    "LK113": Example(
        HOUSE,
        '<acme:slender xmlns:acme="urn:acme:1" of="@Window"/>',
        '<size of="@Window" max="5"/>',
    ),
}
