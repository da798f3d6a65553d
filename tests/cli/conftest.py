"""A small house to work on, with its photo, and stages that do as they are told."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

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
