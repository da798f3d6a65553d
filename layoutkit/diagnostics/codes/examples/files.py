"""Examples of faults in files (LK0)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import COMMAND, DOCUMENT, DRAWN

EXAMPLES = {
    "LK001": Example(COMMAND, "layoutkit validate hous.xml", "layoutkit validate house.xml"),
    "LK002": Example(
        DOCUMENT,
        """\
<facade xmlns="urn:layoutkit:1" name="Bricks & Sons" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
        """\
<facade xmlns="urn:layoutkit:1" name="Bricks &amp; Sons" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
    ),
    "LK003": Example(
        DOCUMENT,
        """\
<?xml version="1.0" encoding="utf-9"?>
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
        """\
<?xml version="1.0" encoding="utf-8"?>
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
    ),
    "LK004": Example(
        DOCUMENT,
        """\
<!DOCTYPE facade SYSTEM "facade.dtd">
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
        """\
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="House" width="6" height="6"/>
</facade>""",
    ),
    "LK008": Example(
        COMMAND,
        "layoutkit schema -o house.xml/schema.xsd",
        "layoutkit schema -o schemas/schema.xsd",
    ),
    "LK010": Example(
        DRAWN,
        """\
<picture file="foto.png" left="0" top="0" right="100" bottom="100"/>
<region symbol="House" width="6" height="6"/>
<constraints><size of="House" max="7"/></constraints>""",
        """\
<picture file="photo.png" left="0" top="0" right="100" bottom="100"/>
<region symbol="House" width="6" height="6"/>
<constraints><size of="House" max="7"/></constraints>""",
    ),
}
