"""The registry of diagnostic codes: what each means, how it comes about, and what to do.

One file a group: LK0 files and safety, LK1 structure, LK2 references and constraints, LK24 grids, LK3
conversion, LK4 plugins, LK5 layouts against facades, LK6 search, LK65 editing, LK7 usage, LK8 masses and
buildings, LK85 to LK87 scenes and placement, LK88 operations, LK89 batches, LK9 our own faults. A code keeps
its meaning for good; retired ones are not given out again. Examples stand in `examples`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from layoutkit.diagnostics.codes import (
    batch,
    buildings,
    conversion,
    editing,
    files,
    grids,
    layouts,
    operations,
    ours,
    placement,
    plugins,
    references,
    scenes,
    search,
    structure,
    usage,
)
from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.codes.examples import EXAMPLES

__all__ = ["CODES", "Code"]

_GROUPS = (
    files,
    structure,
    references,
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
    ours,
)

#: Every code, in order, with its example where there is one.
CODES: Mapping[str, Code] = {
    entry.code: replace(entry, example=EXAMPLES.get(entry.code)) for group in _GROUPS for entry in group.CODES
}
