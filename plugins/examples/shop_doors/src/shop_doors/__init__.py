"""Shop doors apart, and no three of a kind in a row: constraints for layoutkit."""

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
    from shop_doors.constraints import Apart, Mixed

    return (Apart, Mixed)
