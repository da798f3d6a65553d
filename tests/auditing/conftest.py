"""Makes the random models of the tests of relayout, and their brute force, importable here."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "relayout"))
