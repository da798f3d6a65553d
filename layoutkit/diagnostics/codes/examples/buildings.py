"""Examples of faults of masses, and of facades on them (LK8)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import DRESSED_WITH_PLUGIN, FACADE, KIND, LAYOUT, MASS

_FACES = """\
<mass><box name="Block" width="6" depth="6" height="3"/></mass>
<region symbol="Building" width="24" height="3" split="faces">
  <region symbol="Block_South" width="{}" height="3"/>
  <region symbol="Block_East" width="6" height="3"/>
  <region symbol="Block_North" width="{}" height="3"/>
  <region symbol="Block_West" width="6" height="3"/>
</region>"""

EXAMPLES = {
    "LK801": Example(
        MASS,
        '<footprint name="Corner" height="4" points="0,0 6,0 0,6 6,6"/>',
        '<footprint name="Corner" height="4" points="0,0 6,0 6,6 0,6"/>',
    ),
    "LK802": Example(
        MASS,
        """\
<box name="Podium" x="0" y="0" width="9" depth="9" height="4"/>
<box name="Tower" x="3" y="3" width="3" depth="3" height="12"/>""",
        """\
<box name="Podium" x="0" y="0" width="9" depth="9" height="4"/>
<box name="Tower" x="3" y="3" width="3" depth="3" height="8" base="4"/>""",
    ),
    "LK803": Example(
        MASS,
        """\
<box x="0" y="0" width="6" depth="6" height="4"/>
<box x="9" y="0" width="6" depth="6" height="4"/>""",
        """\
<box name="House" x="0" y="0" width="6" depth="6" height="4"/>
<box name="Barn" x="9" y="0" width="6" depth="6" height="4"/>""",
    ),
    "LK804": Example(
        DRESSED_WITH_PLUGIN,
        '<acme:plain xmlns:acme="urn:acme:1" of="House/Floor" scope="building"/>',
        '<acme:plain xmlns:acme="urn:acme:1" of="House/Floor"/>',
    ),
    "LK805": Example(
        KIND,
        'of: str = attribute(AttributeType("name", str), "The region.")',
        'of: str = attribute(PATH, "The region.")',
    ),
    "LK806": Example(LAYOUT, _FACES.format(5, 7), _FACES.format(6, 6)),
    "LK807": Example(
        FACADE,
        """\
<region symbol="House" width="6" height="6" split="faces">
  <region symbol="Front" width="6" height="6"/>
</region>""",
        """\
<region symbol="House" width="6" height="6" split="columns">
  <region symbol="Front" width="6"/>
</region>""",
    ),
}
