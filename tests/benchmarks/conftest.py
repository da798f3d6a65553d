"""The designs, built once for all tests."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from benchmarks.designs import DESIGNS
from layoutkit.model import Facade


@pytest.fixture(scope="session")
def designs() -> Mapping[str, Facade]:
    return {name: design() for name, design in DESIGNS.items()}
