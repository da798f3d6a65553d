"""Examples of layouts that do not fit their facades (LK5)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import LAYOUT, WHOLE_LAYOUT

_LAYOUT = """\
<layout xmlns="urn:layoutkit:1" name="house-1" units="{}" facade="{}">
  <region symbol="House" width="6" height="3"/>
</layout>"""

EXAMPLES = {
    "LK501": Example(
        LAYOUT, '<region symbol="Hut" width="6" height="3"/>', '<region symbol="House" width="6" height="3"/>'
    ),
    "LK502": Example(
        LAYOUT,
        '<region symbol="House" width="9" height="3"/>',
        '<region symbol="House" width="7" height="3"/>',
    ),
    "LK503": Example(WHOLE_LAYOUT, _LAYOUT.format("px", "house.xml"), _LAYOUT.format("m", "house.xml")),
    "LK504": Example(WHOLE_LAYOUT, _LAYOUT.format("m", "hous.xml"), _LAYOUT.format("m", "house.xml")),
    "LK505": Example(WHOLE_LAYOUT, _LAYOUT.format("m", "layout.xml"), _LAYOUT.format("m", "house.xml")),
    "LK506": Example(
        LAYOUT,
        '<region symbol="House" width="4" height="3"/>',
        '<region symbol="House" width="6" height="3"/>',
    ),
}
