from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from layoutkit.constraints import BUILT_IN, Constraint


@pytest.fixture(scope="session")
def kinds() -> dict[str, type[Constraint]]:
    return {kind.kind: kind for kind in BUILT_IN}


@pytest.fixture
def written(tmp_path: Path) -> Callable[..., Path]:
    """Return a function that writes a document and gives its path."""

    def write(source: str | bytes, name: str = "facade.xml") -> Path:
        path = tmp_path / name
        path.write_bytes(source.encode() if isinstance(source, str) else source)
        return path

    return write
