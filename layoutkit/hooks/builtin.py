"""What the core itself adds, through the same hooks as any plugin."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from layoutkit.hooks.specs import hookimpl

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.sizing.qp import Backend


@hookimpl
def layoutkit_constraints() -> Iterable[type[Constraint]]:
    """Return the built-in constraint kinds."""
    from layoutkit.constraints import BUILT_IN

    return BUILT_IN


@hookimpl
def layoutkit_qp_backends() -> tuple[Backend, ...]:
    """Return the built-in solvers of quadratic programs."""
    from layoutkit.sizing.backends import BACKENDS

    return BACKENDS
