"""Sizing within the constraints of the facade's document."""

from __future__ import annotations

from collections.abc import Sequence

from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit_editing.constraints.arrangements import forbidden
from layoutkit_editing.constraints.rules import asked
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import State

#: So often sizes are looked over for regions that overlap out of line; a check tells of those that still do.
_ROUNDS = 12


def sized_within(state: State, backends: Sequence[Backend] = BACKENDS) -> Sized | Unsizable:
    """Size a state as its document's hard constraints ask, as far as rows can say it.

    Where that is not possible since they do not admit the arrangements, this is the reason told.

    What regions overlap hangs on the sizes: after each sizing those that do so out of line are looked for,
    and kept in line, or apart, in the next. Whether everything is kept is for `checks.broken` to tell.

    Raises
    ------
    Misbehaviour
        If a plugin's kind answers what makes no sense.
    """
    found = _sized(state, backends)
    if isinstance(found, Unsizable) and state.original.facade.constraints:
        return Unsizable(forbidden(state) or found.reason, found.axis)
    return found


def _sized(state: State, backends: Sequence[Backend]) -> Sized | Unsizable:
    own = asked(state)
    rules, found = own.rules, sized(state, backends, own.rules)
    for _ in range(_ROUNDS if own.aligned else 0):
        if isinstance(found, Unsizable):
            return found
        further = own.out_of_line(found.span, found.extents)
        if not further:
            return found
        rules = (*rules, *further)
        found = sized(state, backends, rules)
    return found
