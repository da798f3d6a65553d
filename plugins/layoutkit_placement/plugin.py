"""What this package adds to layoutkit: relationship functions, and the stages `propagate` and `place`."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Stage, hookimpl
from layoutkit.scenes.relationship import Relationship


@hookimpl
def layoutkit_relationships() -> Iterable[Relationship]:
    """Return the relationship functions of both papers."""
    from layoutkit_placement.functions import BUILT_IN

    return BUILT_IN


@hookimpl
def layoutkit_stages() -> Iterable[Stage]:
    """Return the stages."""
    return ()
