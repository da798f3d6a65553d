"""A wrong and a mended example of each code, smallest where possible; tests run all of them.

One file a group, as the codes have. `EXAMPLES` has them by code; `UNSHOWN` says why the others have none.
"""

from __future__ import annotations

from collections.abc import Mapping

from layoutkit.diagnostics.codes.examples import (
    batch,
    buildings,
    conversion,
    editing,
    files,
    grids,
    layouts,
    operations,
    placement,
    plugins,
    references,
    scenes,
    search,
    semantics,
    structure,
    usage,
)
from layoutkit.diagnostics.codes.examples.example import GAP, Example, Frame

__all__ = ["EXAMPLES", "GAP", "UNSHOWN", "Example", "Frame"]

_GROUPS = (
    files,
    structure,
    references,
    semantics,
    grids,
    conversion,
    plugins,
    layouts,
    search,
    editing,
    usage,
    buildings,
    scenes,
    placement,
    operations,
    batch,
)

#: Every example, by code.
EXAMPLES: Mapping[str, Example] = {code: own for group in _GROUPS for code, own in group.EXAMPLES.items()}

#: Codes without one, and why.
UNSHOWN: Mapping[str, str] = {
    "LK005": "a document that is nested so deeply does not fit a page",
    "LK006": "a document of so many elements does not fit a page",
    "LK007": "a file of that size does not fit a page",
    "LK009": "no page can show a character that XML cannot hold",
    "LK605": "a facade whose arrangements cannot be counted does not fit a page",
    "LK876": "it takes an area that is very large for its shapes, and some time",
    "LK889": "it is told to programs that record operations, and not by a command",
    "LK891": "it takes two commands at the same time",
    "LK892": "it takes a process that is killed",
    "LK894": "it takes a second machine",
    "LK895": "it takes a system that starts no processes",
    "LK896": "it takes a file that is changed while a command reads it",
    "LK901": "it is a fault of layoutkit: if an example were known, it would be mended",
    "LK902": "it is a fault of layoutkit: if an example were known, it would be mended",
    "LK903": "it is a fault of layoutkit: if an example were known, it would be mended",
}
