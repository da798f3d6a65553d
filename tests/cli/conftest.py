"""A small house and a gate to work on, with their photos, and stages that do as they are told."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

from layoutkit.documents import read
from layoutkit.model import place

HOUSE = """<?xml version="1.0" encoding="UTF-8"?>
<!-- drawn by hand -->
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <picture file="photo.png" left="0" top="0" right="60" bottom="40"/>
  <region symbol="Facade" width="6" height="4" split="columns">
    <region symbol="Pier" width="1" labels="Wall" fill="repeat"/>
    <region symbol="Bay" width="1.5" split="rows">
      <region symbol="Top" height="1" labels="Wall"/>
      <region symbol="Opening" height="2" labels="Window Glass"/>
      <region symbol="Bottom" height="1" labels="Wall"/>
    </region>
    <again symbol="Pier"/>
    <again symbol="Bay"/>
    <again symbol="Pier"/>
  </region>
  <constraints>
    <!-- one pane of glass -->
    <size of="Facade/Bay" min="80%" max="125%"/>
    <size of="Facade/Pier" min="0.5" max="3"/>
    <sequence within="Facade" word="⊢ Pier Bay"/>
    <sequence within="Facade" word="Bay Pier Bay"/>
    <sequence within="Facade" word="Bay Pier ⊣"/>
  </constraints>
</facade>
"""


@pytest.fixture
def house(tmp_path: Path) -> Path:
    """Return a facade document with constraints, its photo beside it."""
    folder = tmp_path / "house"
    folder.mkdir()
    Image.effect_noise((60, 40), 80).convert("RGB").save(folder / "photo.png")
    document = folder / "house.xml"
    document.write_text(HOUSE, encoding="utf-8")
    return document


@pytest.fixture
def bare_house(house: Path) -> Path:
    """Return the same without constraints."""
    text = house.read_text(encoding="utf-8")
    start, end = text.index("  <constraints>"), text.index("</constraints>\n") + len("</constraints>\n")
    bare = house.with_name("bare.xml")
    bare.write_text(text[:start] + text[end:], encoding="utf-8")
    return bare


GATE = """<?xml version="1.0" encoding="UTF-8"?>
<facade xmlns="urn:layoutkit:1" name="gate" units="m">
  <picture file="photo.png" left="10" top="5" right="150" bottom="125"/>
  <!-- two floors, one door -->
  <region symbol="Gate" width="7" height="6" split="rows">
    <region symbol="Floor" height="3" split="columns">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Bay" width="1" split="rows">
        <region symbol="Over" height="1" labels="Wall"/>
        <region symbol="Window" height="1.5" labels="Window"/>
        <region symbol="Under" height="0.5" labels="Wall"/>
      </region>
      <again symbol="Pier"/>
      <again symbol="Bay"/>
      <again symbol="Pier"/>
      <again symbol="Bay"/>
      <again symbol="Pier"/>
    </region>
    <region symbol="Ground" height="3" split="columns">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Bay" width="1" split="rows">
        <region symbol="Over" height="1" labels="Wall"/>
        <region symbol="Window" height="1.5" labels="Window"/>
        <region symbol="Under" height="0.5" labels="Wall"/>
      </region>
      <again symbol="Pier"/>
      <region symbol="Axis" width="1" split="rows">
        <region symbol="Over" height="1" labels="Wall"/>
        <region symbol="Door" height="2" labels="Door"/>
      </region>
      <again symbol="Pier"/>
      <again symbol="Bay"/>
      <again symbol="Pier"/>
    </region>
  </region>
  <grids>
    <grid name="openings" of="@Window | @Door"/>
    <grid name="upper" of="Gate/Floor/Bay/Window"/>
  </grids>
</facade>
"""


@pytest.fixture
def gate(tmp_path: Path) -> Path:
    """Return a facade document with grids; in its photo, each terminal has a colour of its own."""
    folder = tmp_path / "gate"
    folder.mkdir()
    document = folder / "gate.xml"
    document.write_text(GATE, encoding="utf-8")
    photo = Image.new("RGB", (160, 130), (255, 105, 180))
    facade = read(document, {}).model
    terminals = [placed for placed in place(facade.root) if placed.region.terminal]
    for number, placed in enumerate(terminals):
        x0, y0, x1, y1 = (round(20 * edge) for edge in placed.box)
        photo.paste((7 * number, 250 - 7 * number, 40 * number % 250), (10 + x0, 125 - y1, 10 + x1, 125 - y0))
    photo.save(folder / "photo.png")
    return document


@pytest.fixture
def bare_gate(gate: Path) -> Path:
    """Return the same without grids."""
    text = gate.read_text(encoding="utf-8")
    start, end = text.index("  <grids>"), text.index("</grids>\n") + len("</grids>\n")
    bare = gate.with_name("bare.xml")
    bare.write_text(text[:start] + text[end:], encoding="utf-8")
    return bare
