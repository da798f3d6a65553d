"""Edits applied to states: topology only, sizes follow."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from layoutkit_editing.naming import free_name
from layoutkit_editing.state import COLUMNS, ROWS, Lattice, Matrix, State
from layoutkit_editing.topology.followers import followed, outermost
from layoutkit_editing.topology.insertion import Embedding, Jump, insertion
from layoutkit_editing.topology.moving import move
from layoutkit_editing.topology.removal import removal
from layoutkit_editing.topology.site import Refused, Site, Spans, common

if TYPE_CHECKING:
    from layoutkit.model.session import Edit

#: Sizes a state: where its nodes then stand.
Sizing = Callable[[State], Spans]

AXES: Mapping[str, int] = {"columns": COLUMNS, "rows": ROWS}


def applied(
    state: State,
    spans: Spans,
    edit: Edit,
    families: Sequence[Sequence[str]],
    size: Sizing,
    element: int | None = None,
    embedding: Embedding = "own",
) -> State:
    """Return the state that an edit leads to.

    Grids inside elements of others come first: what is inserted afterwards is a copy of what they became.

    Parameters
    ----------
    spans
        Where the state's nodes stand.
    families
        Names of the grids to edit; one number of the edit is for each family.
    size
        Sizes states in between, where several grids are edited.
    element
        The node that the edit moves, if it moves one.
    embedding
        What is copied together with elements that are added.

    Raises
    ------
    Refused
        If the edit is not possible.
    """
    numbered = {name: number for number, family in enumerate(families) for name in family}
    for step, name in enumerate(_innermost_first(state, numbered)):
        if step:
            spans = size(state)
        site = Site(state, state.lattice(name), AXES[edit.axis], spans)
        state = _edited(site, edit, numbered[name], element, embedding)
    return state


def _innermost_first(state: State, names: Mapping[str, int]) -> list[str]:
    """Return names of grids, those whose elements have the deepest common ancestor first."""
    if len(names) == 1:
        return list(names)

    def depth(name: str) -> int:
        return len(state.tree.ancestors(common(state.tree, state.lattice(name).elements)))

    return sorted(names, key=lambda name: -depth(name))


def _edited(site: Site, edit: Edit, family: int, element: int | None, embedding: Embedding) -> State:
    """Apply an edit to one grid."""
    count = len(site.lines)
    at = _index(edit.source[family], count, site) if edit.source else 0
    if edit.action == "remove":
        jump = removal(site, at, edit.gap)
        return _jumped(site, jump, (*site.lines[:at], *site.lines[at + 1 :]))
    if edit.action == "add":
        to = _index(edit.at[family], count + 1, site)
        jump = insertion(site, at, to, embedding)
        return _jumped(site, jump, (*site.lines[:to], jump.line, *site.lines[to:]))
    rows = None
    if element is not None:
        at, row = _where(site, element)
        rows = (row,)
    moved = move(site, at, _index(edit.to[family], count, site), rows)
    lattice = site.lattice.with_lines(site.axis, moved.lines)
    shifts = dict(site.state.shifts)
    for own, along in moved.shifts.items():
        known = shifts.get(own, (0.0, 0.0))
        shifts[own] = (along, known[1]) if site.axis == COLUMNS else (known[0], along)
    others = (outermost(own, moved.tree) for own in site.state.lattices)
    lattices = tuple(lattice if own.name == lattice.name else own for own in others)
    return replace(site.state, tree=moved.tree, lattices=lattices, shifts=shifts)


def _index(number: int, count: int, site: Site) -> int:
    """Return the index of a line that is counted from 1."""
    if not 1 <= number <= count:
        which = "column" if site.axis == COLUMNS else "row"
        raise Refused(
            f"the grid {site.lattice.name!r} has no place {number} for a {which}: the last is {count}"
        )
    return number - 1


def _where(site: Site, element: int) -> tuple[int, int]:
    """Return line and row of an element."""
    for number, line in enumerate(site.lines):
        if element in line:
            return number, line.index(element)
    raise Refused(f"{site.called(element)} is no element of the grid {site.lattice.name!r}")


def _jumped(site: Site, jump: Jump, lines: Matrix) -> State:
    """Return the state after a jump: other grids follow, and so does what was known of originals."""
    state, tree = site.state, jump.tree
    lattices = tuple(_lattices(site, jump, lines))
    shifts = {own: shift for own, shift in state.shifts.items() if own in tree.nodes}
    for own, origin in jump.origin.items():
        if origin in state.shifts and own in tree.nodes:
            shifts[own] = state.shifts[origin]
    return replace(
        state, tree=tree, lattices=lattices, shifts=shifts, targets=state.targets.among(tree.nodes)
    )


def _lattices(site: Site, jump: Jump, lines: Matrix) -> Iterator[Lattice]:
    """Yield all grids after a jump, copies of subgrids last, under free names."""
    taken = {lattice.name for lattice in site.state.lattices}
    copies = list[Lattice]()
    for lattice in site.state.lattices:
        if lattice.name == site.lattice.name:
            yield lattice.with_lines(site.axis, lines)
            continue
        own, *further = followed(lattice, jump.tree, jump.origin, site.axis)
        if own.cells:
            yield own
        copies += further
    for copy in copies:
        name = free_name(re.sub(r"_\d+$", "", copy.name), taken)
        taken.add(name)
        yield replace(copy, name=name)
