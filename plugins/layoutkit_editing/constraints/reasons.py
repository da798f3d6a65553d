"""How it is told that an edit would break a constraint."""

from __future__ import annotations

from layoutkit.constraints import Constraint


def told(constraint: Constraint, what: str) -> str:
    """Return a reason: the constraint as documents write it, with its line, and what is wrong."""
    line = f" (line {constraint.place.line})" if constraint.place else ""
    return f"it would break {constraint}{line}: {what}"
