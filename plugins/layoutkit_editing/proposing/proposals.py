"""All proposals of an edit: every source at every place, sized, duplicates folded, best first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import TYPE_CHECKING

from layoutkit.model.session import Edit
from layoutkit_editing.proposing.applying import AXES
from layoutkit_editing.proposing.settling import Judge, ways
from layoutkit_editing.proposing.signatures import Signatures
from layoutkit_editing.sizing.solving import Sized
from layoutkit_editing.state import Lattice, Matrix, State
from layoutkit_editing.topology.site import Refused, Spans
from layoutkit_editing.tree import Tree

if TYPE_CHECKING:
    from layoutkit.model.session import Action, Axis

#: So many combinations of sources and places are gone through.
MOST = 400
#: A place in one grid: which line, and where to; 0 where there is no such number.
Choice = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Proposal:
    """What an edit can come to.

    Attributes
    ----------
    edit
        What was done.
    state
        The facade after it.
    sized
        Its sizes.
    before
        The facade's tree before it: a proposal can be taken there alone.
    """

    edit: Edit
    state: State
    sized: Sized
    before: Tree


@dataclass(frozen=True, slots=True)
class Dropped:
    """An edit that comes to nothing.

    Attributes
    ----------
    reason
        Why, in the user's words.
    """

    edit: Edit
    reason: str


@dataclass(frozen=True, slots=True)
class Wish:
    """What the user wants proposals for.

    Attributes
    ----------
    grids
        Names of the active grids. Those with equally many columns, or rows, are edited alike; else every
        place in one goes with every place in the others.
    element
        The one element to move, if it is no whole line: its node, and its path.
    width, height
        What the facade is to measure afterwards.
    """

    action: Action
    axis: Axis
    grids: tuple[str, ...]
    element: tuple[int, str] | None = None
    width: float | None = None
    height: float | None = None


def proposals(
    state: State, spans: Spans, wish: Wish, types: Sequence[int], judge: Judge
) -> Iterator[Proposal | Dropped]:
    """Yield every proposal in a stable order, and every edit that was dropped.

    Order is that of sources, then of places. Of proposals that look alike, the first is kept.

    Parameters
    ----------
    spans
        Where the state's nodes stand.
    types
        The loose type of each source.
    judge
        Sizes states, and says which must not be shown.
    """
    signatures = Signatures(types, state.tree)
    groups = lockstep(state, wish.grids, AXES[wish.axis])
    known = {signatures[state.tree.root]}
    element = wish.element[0] if wish.element else None
    for edit in _edits(state, wish, groups, signatures):
        reasons = list[str]()
        for after in ways(state, spans, edit, groups, judge, element):
            if isinstance(after, Refused):
                reasons.append(str(after))
                continue
            own = signatures.of(after.tree)
            if own in known:
                if reasons:
                    yield Dropped(edit, reasons[0])
                break
            known.add(own)
            try:
                yield Proposal(edit, *judge.settled(after, wish.grids), state.tree)
                break
            except Refused as refused:
                reasons.append(str(refused))
        else:
            yield Dropped(edit, reasons[0])


def lockstep(state: State, names: Sequence[str], axis: int) -> tuple[tuple[str, ...], ...]:
    """Return the names of grids that are edited alike, together: those with as many columns, or rows."""
    groups: dict[int, list[str]] = {}
    for name in names:
        groups.setdefault(len(state.lattice(name).lines(axis)), []).append(name)
    return tuple(map(tuple, groups.values()))


def _edits(
    state: State, wish: Wish, groups: Sequence[Sequence[str]], signatures: Signatures
) -> Iterator[Edit]:
    """Yield every edit that a wish may mean."""
    choices = [tuple(_choices([state.lattice(name) for name in group], wish, signatures)) for group in groups]
    if (count := math.prod(map(len, choices))) > MOST:
        raise Refused(
            f"the grids have different numbers of {wish.axis}, which makes {count} combinations: "
            f"edit them one after the other (together, {MOST} at most are gone through)"
        )
    names = tuple(name for group in groups for name in group)
    for picked in product(*choices):
        source, to = tuple(p[0] for p in picked), tuple(p[1] for p in picked)
        edit = Edit(wish.action, wish.axis, names, source, width=wish.width, height=wish.height)
        if wish.action == "add":
            yield replace(edit, at=to)
        elif wish.action == "remove":
            yield edit
            yield replace(edit, gap="before")
        elif wish.element is None:
            yield replace(edit, to=to)
        else:
            yield replace(edit, source=(), to=to, element=wish.element[1])


def _choices(lattices: Sequence[Lattice], wish: Wish, signatures: Signatures) -> Sequence[Choice]:
    """Return which lines of like grids, and which places for them, there are: both counted from 1."""
    by_grid = [lattice.lines(AXES[wish.axis]) for lattice in lattices]
    count = len(by_grid[0])
    numbers = range(1, count + 1)
    if wish.element is not None:
        own = next((n for n, line in enumerate(by_grid[0], 1) if wish.element[0] in line), 0)
        return [(0, number) for number in numbers if number != own]
    if wish.action == "add":
        return list(product(_unique(by_grid, signatures), range(1, count + 2)))
    if wish.action == "remove":
        return [(number, 0) for number in numbers]
    return [(one, other) for one in numbers for other in numbers if one != other]


def _unique(by_grid: Sequence[Matrix], signatures: Signatures) -> list[int]:
    """Return the numbers of the source lines: of lines that look alike in all grids, the first."""
    first: dict[tuple[tuple[int | None, ...], ...], int] = {}
    for number, lines in enumerate(zip(*by_grid, strict=True), 1):
        looks = tuple(tuple(None if own is None else signatures[own] for own in line) for line in lines)
        first.setdefault(looks, number)
    return list(first.values())
