"""What this package adds: relationship functions, and the stages `propagate`, `learn` and `place`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from layoutkit.hooks.specs import Stage, hookimpl

if TYPE_CHECKING:
    from layoutkit.scenes.relationship import Relationship


@hookimpl
def layoutkit_relationships() -> Iterable[Relationship]:
    """Return the relationship functions of both papers."""
    from layoutkit_placement.functions import BUILT_IN

    return BUILT_IN


@hookimpl
def layoutkit_stages() -> Iterable[Stage]:
    """Return the stages."""
    from layoutkit_placement.stages.learn import Learn
    from layoutkit_placement.stages.place import Place
    from layoutkit_placement.stages.propagate import Propagate

    return (Propagate(), Learn(), Place())
