"""What this package adds: kinds of operations, and the stage `replay`."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Stage, hookimpl
from layoutkit.operations import Operation


@hookimpl
def layoutkit_operations() -> Iterable[type[Operation]]:
    """Return the kinds of operations."""
    from layoutkit_operations.kinds import BUILT_IN

    return BUILT_IN


@hookimpl
def layoutkit_stages() -> Iterable[Stage]:
    """Return the stages."""
    from layoutkit_operations.stage import ReplayOperations

    return (ReplayOperations(),)
