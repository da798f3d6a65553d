"""From an edit to a sized facade: every way to make it, until one keeps all that has to be kept."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit_editing.natural import naturally_sized
from layoutkit_editing.proposing.applying import applied
from layoutkit_editing.proposing.checks import rearranged, torn
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import State
from layoutkit_editing.topology.insertion import EMBEDDINGS
from layoutkit_editing.topology.site import Refused, Spans

if TYPE_CHECKING:
    from layoutkit.model.session import Edit


def nothing(state: State) -> str:
    """Forbid no arrangement."""
    return ""


def kept(state: State, found: Sized) -> str:
    """Find nothing broken."""
    return ""


#: So often the rows and columns of other grids are told anew, and sizes found for them.
_ROUNDS = 5


@dataclass(frozen=True)
class Judge:
    """What sizes states, and looks over what comes of it.

    Attributes
    ----------
    size
        Gives a state sizes of least distortion that keep constraints.
    forbidden
        Says why no sizes of a state can be shown, in the user's words; empty if some can.
    broken
        Says which constraint a sized state breaks; empty if none.
    """

    size: Callable[[State], Sized | Unsizable]
    forbidden: Callable[[State], str] = nothing
    broken: Callable[[State, Sized], str] = kept

    def between(self, state: State) -> Spans:
        """Return where the nodes of a state stand that more is to be done to: it need not keep constraints.

        Raises
        ------
        Refused
            If it cannot be sized.
        """
        found = naturally_sized(state, sized)
        if isinstance(found, Unsizable):
            raise Refused(found.reason)
        return found.span

    def settled(self, state: State, names: Sequence[str]) -> tuple[State, Sized]:
        """Return a state after some of its grids were edited, and its sizes.

        Of other grids, rows and columns are told anew where elements came to overlap otherwise.

        Raises
        ------
        Refused
            If it cannot be sized, or must not be shown.
        """
        if reason := self.forbidden(state):
            raise Refused(reason)
        for _ in range(_ROUNDS):
            found = naturally_sized(state, self.size)
            if isinstance(found, Unsizable):
                raise Refused(found.reason)
            told = rearranged(state, found)
            if reason := torn(state, told, names) or self.broken(state, found):
                raise Refused(reason)
            if told is state:
                return state, found
            state = told
        raise Refused("elements of other grids find no rows and columns to stand in")


def ways(
    state: State, spans: Spans, edit: Edit, groups: Sequence[Sequence[str]], judge: Judge, element: int | None
) -> Iterator[State | Refused]:
    """Yield what an edit may lead to, the likeliest first, or why it does not.

    What is inserted brings what it stands in; where that does not fit, it is embedded as the elements beside
    it are.
    """
    for embedding in EMBEDDINGS if edit.action == "add" else EMBEDDINGS[:1]:
        try:
            yield applied(state, spans, edit, groups, judge.between, element, embedding)
        except Refused as refused:
            yield refused


def made(
    state: State, spans: Spans, edit: Edit, groups: Sequence[Sequence[str]], judge: Judge, element: int | None
) -> tuple[State, Sized]:
    """Return the state that an edit leads to, and its sizes.

    Raises
    ------
    Refused
        If none of the ways to make it leads anywhere; the reason is that of the first.
    """
    reasons = list[Refused]()
    for after in ways(state, spans, edit, groups, judge, element):
        try:
            if isinstance(after, Refused):
                raise after
            return judge.settled(after, edit.grids)
        except Refused as refused:
            reasons.append(refused)
    raise reasons[0]
