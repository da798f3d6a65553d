"""Regions in a fixed ratio of height to width: a constraint for layoutkit."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from layoutkit.hooks import hookimpl

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint

#: The version of the plugin interface that this package is written for.
LAYOUTKIT_API = 1


@hookimpl
def layoutkit_constraints() -> Iterable[type[Constraint]]:
    """Return the kinds of this package; they are imported when layoutkit first asks for them."""
    from golden_windows.ratio import Ratio

    return (Ratio,)
