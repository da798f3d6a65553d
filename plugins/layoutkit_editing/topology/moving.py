"""Elements moved to other places of their row or column, without detour over a copy and a removal.

The paper replicates an element at its target and deletes the original, and notes that moving it directly
might be more intuitive (Dang et al. 2014, section 6).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from layoutkit_editing.state import Matrix
from layoutkit_editing.topology.site import Refused, Site
from layoutkit_editing.tree import Node, Tree


@dataclass(frozen=True)
class Moved:
    """A tree in which elements have changed places.

    Attributes
    ----------
    lines
        The grid's lines, as they now are.
    shifts
        For each element that moved, how far it is from where it stood to the place that it took over, along x
        and down: across the axis only if it left behind what it stood in.
    """

    tree: Tree
    lines: Matrix
    shifts: Mapping[int, tuple[float, float]] = field(default_factory=dict)


def move(site: Site, at: int, to: int, rows: Sequence[int] | None = None) -> Moved:
    """Move a line to another place; those between make room.

    Where whole children of a common parent can change places, they do; else the elements themselves change
    places, and what is around them stays.

    Parameters
    ----------
    at, to
        Index of the line now, and afterwards.
    rows
        Which of its elements move; None for all that are no phantoms. Phantoms on the way stay.

    Raises
    ------
    Refused
        If nothing would move.
    """
    chosen = [row for row, own in enumerate(site.lines[at]) if own is not None and row in (rows or [row])]
    lines = [list(line) for line in site.lines]
    taken: dict[int, int] = {}
    for row in chosen:
        slots = _slots(site, row, at, to)
        order = [*slots[1:], slots[0]]
        for slot, source in zip(slots, order, strict=True):
            element, place = site.lines[source][row], site.lines[slot][row]
            lines[slot][row] = element
            if element is not None and place is not None and element != place:
                taken[place] = element
    if not taken:
        raise Refused("nothing would move")
    carriers = _carriers(site, taken)
    axes = (site.axis,) if carriers else (0, 1)
    shifts = {own: _shift(site, own, place, axes) for place, own in taken.items()}
    return Moved(_exchanged(site, carriers or taken), tuple(map(tuple, lines)), shifts)


def _slots(site: Site, row: int, at: int, to: int) -> list[int]:
    """Return the places between which a row's elements are passed on, the first element going to the last."""
    step = 1 if to > at else -1
    return [slot for slot in range(at, to + step, step) if site.lines[slot][row] is not None]


def _shift(site: Site, own: int, place: int, axes: Collection[int]) -> tuple[float, float]:
    """Return how far the centre of one element is from that of another, in the original as it was shifted."""
    nodes, spans, known = site.tree.nodes, site.state.original.spans, site.state.shifts
    found = [0.0, 0.0]
    for axis in axes:
        there, here = (
            float(spans[axis, nodes[each].source].mean()) + known.get(each, (0.0, 0.0))[axis]
            for each in (place, own)
        )
        found[axis] = there - here
    return found[0], found[1]


def _exchanged(site: Site, instead: Mapping[int, int]) -> Tree:
    """Return the tree with nodes in the places of others."""
    changes: dict[int, Node] = {}
    for place in instead:
        above = site.tree.parents[place]
        node = site.tree.nodes[above]
        changes[above] = node._replace(children=tuple(instead.get(own, own) for own in node.children))
    return site.tree.changed(changes)


def _carriers(site: Site, taken: Mapping[int, int]) -> Mapping[int, int] | None:
    """Return which children of common parents change places with the elements; None if they cannot."""
    found: dict[int, int] = {}
    for place, own in taken.items():
        parent = site.tree.common_ancestor(place, own)
        if site.tree.nodes[parent].split != site.split:
            return None
        there, here = site.tree.holding(parent, place), site.tree.holding(parent, own)
        if found.setdefault(there, here) != here:
            return None
    moving = set(taken)
    alone = all(site.inside(own) <= moving for own in found)
    return found if alone and set(found) == set(found.values()) else None
