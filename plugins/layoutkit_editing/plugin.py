"""What this package adds to layoutkit: the stages `grids`, `propose` and `edit`."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Stage, hookimpl


@hookimpl
def layoutkit_stages() -> Iterable[Stage]:
    """Return the stages."""
    from layoutkit_editing.stages.edit import MakeEdits
    from layoutkit_editing.stages.grids import FindGrids
    from layoutkit_editing.stages.propose import Propose

    return (FindGrids(), Propose(), MakeEdits())
