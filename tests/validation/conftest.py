"""Documents to check and to mend."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from layoutkit.constraints import BUILT_IN
from layoutkit.documents.kinds import Kinds

HOUSE = """<?xml version="1.0" encoding="UTF-8"?>
<facade xmlns="urn:layoutkit:1" name="house" units="m">
  <region symbol="Facade" width="6" height="4" split="columns">
    <region symbol="Pier" width="1.5" labels="Wall"/>
    <region symbol="Bay" width="3" split="rows">
      <region symbol="Top" height="1" labels="Wall"/>
      <region symbol="Opening" height="3" labels="Window"/>
    </region>
    <again symbol="Pier"/>
  </region>
  <constraints>
    <size of="Facade/Pier" min="0.5" max="3"/>
    <size of="Facade/Bay" min="80%"/>
  </constraints>
</facade>
"""

#: A sum that is wrong, which is left; and a name that is misspelt, which is mended.
BROKEN = HOUSE.replace('height="3"', 'height="2"')
MISSPELT = HOUSE.replace('width="6"', 'widht="6"')

#: A layout of the house, whose file goes into the braces.
LAYOUT = """<layout xmlns="urn:layoutkit:1" name="out" units="m" facade="{}">
  <region symbol="Facade" width="6" height="4" split="columns">
    <region symbol="Pier" width="1.5" labels="Wall"/>
    <region symbol="Bay" width="3" split="rows">
      <region symbol="Top" height="1" labels="Wall"/>
      <region symbol="Opening" height="3" labels="Window"/>
    </region>
    <again symbol="Pier"/>
  </region>
</layout>
"""

Written = Callable[..., Path]


@pytest.fixture(scope="session")
def kinds() -> Kinds:
    """Return the built-in constraint kinds."""
    return {kind.kind: kind for kind in BUILT_IN}


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Written:
    """Write a document into the current folder, which is empty otherwise."""
    monkeypatch.chdir(tmp_path)

    def _written(name: str, text: str | bytes = HOUSE, encoding: str = "utf-8") -> Path:
        path = Path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode(encoding))
        return path

    return _written
