"""Whether an edited facade keeps the constraints of its document.

While a facade is edited, its constraints are asked as they are written, of the original: every region of the
edited facade is looked at under the name that it had there, and what the constraints call the input is the
original. So, whatever was copied, moved or taken away in between:

- A size in percent is a share of the size of what the region is a copy of.
- A frequency counts copies, and a percentage is of the original's count: a column more may be one too many.
- Sequences, and the words of generators, are those of the original. A region of which they speak may only
  take an arrangement that they admit; what is copied into it from elsewhere goes by its symbol there. One of
  which no sequence speaks is free: that it keep the input's arrangement by default is not asked here, nor are
  default sizes, nor that regions of one symbol are replicas.
- Where `instances` say how many different ones there are, copies of a region are its occurrences.
- What a lock keeps in its place occurs as often as before: no copy of it is made, and none taken away.
- Regions of the same arrangement, and such as are symmetric, are so in the symbols of the original. What was
  inserted into one floor alone makes it another arrangement.
- Of a region that is gone, or that was dissolved into others, nothing is asked any more.

Soft constraints refuse nothing: what is not kept of them is told (`unkept`).
"""

from __future__ import annotations

from collections.abc import Sequence

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import violations_of
from layoutkit.constraints.expansion import expanded
from layoutkit.model import Violation
from layoutkit_editing.constraints.reasons import told
from layoutkit_editing.constraints.view import EditedView
from layoutkit_editing.state import State
from layoutkit_editing.topology.site import Spans


def broken(state: State, spans: Spans) -> str:
    """Say which hard constraint a sized state breaks first: what, where and by how much.

    Parameters
    ----------
    spans
        Where the state's nodes stand.

    Returns
    -------
    str
        The reason, in the user's words; empty if all are kept.

    Raises
    ------
    Misbehaviour
        If a plugin's kind answers what makes no sense.
    """
    hard = [constraint for constraint in _explicit(state) if not constraint.soft]
    if not hard:
        return ""
    view = EditedView(state, spans)
    found = (violation for constraint in hard for violation in violations_of(constraint, view))
    first = next(found, None)
    return "" if first is None else _told(first)


def unkept(state: State, spans: Spans) -> tuple[Constraint, ...]:
    """Return the soft constraints that a sized state does not keep."""
    soft = [constraint for constraint in _explicit(state) if constraint.soft]
    if not soft:
        return ()
    view = EditedView(state, spans)
    return tuple(constraint for constraint in soft if any(True for _ in violations_of(constraint, view)))


def _explicit(state: State) -> Sequence[Constraint]:
    """Return what the document says, generators as sequences; nothing that holds by default."""
    return expanded(state.original.facade)


def _told(violation: Violation) -> str:
    constraint = violation.constraint
    assert constraint is not None  # only the rules of all layouts have none
    return told(constraint, f"{violation.path.rstrip('/')} {violation.message}")
