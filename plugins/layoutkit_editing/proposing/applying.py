"""Edits applied to states: topology only, sizes follow."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from layoutkit_editing.naming import free_name
from layoutkit_editing.state import COLUMNS, ROWS, Lattice, Matrix, State
from layoutkit_editing.topology.followers import followed, outermost, trimmed
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
    axis, counts = (
        AXES[edit.axis],
        {name: len(state.lattice(name).lines(AXES[edit.axis])) for name in numbered},
    )
    for step, name in enumerate(_innermost_first(state, numbered)):
        if all(
            lattice.name != name or len(lattice.lines(axis)) != counts[name] for lattice in state.lattices
        ):
            continue  # it followed another one of them already, as sills follow their windows
        if step:
            spans = size(state)
        site = Site(state, state.lattice(name), axis, spans)
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
    for own, shift in moved.shifts.items():
        known = shifts.pop(own, (0.0, 0.0))
        total = known[0] + shift[0], known[1] + shift[1]
        if max(map(abs, total)) > site.state.original.tolerance:
            shifts[own] = total
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
    shifts, rests = (_inherited(known, jump) for known in (state.shifts, state.rests))
    return replace(state, tree=tree, lattices=lattices, shifts=shifts, rests=rests)


def _inherited(known: Mapping[int, tuple[float, float]], jump: Jump) -> Mapping[int, tuple[float, float]]:
    """Return what is known of nodes that are still there, and of copies what is known of their originals."""
    nodes = jump.tree.nodes
    found = {own: what for own, what in known.items() if own in nodes}
    found.update((own, known[of]) for own, of in jump.origin.items() if of in known and own in nodes)
    return found


def _lattices(site: Site, jump: Jump, lines: Matrix) -> Iterator[Lattice]:
    """Yield all grids after a jump, copies of subgrids last, under free names."""
    taken = {lattice.name for lattice in site.state.lattices}
    copies = list[Lattice]()
    for lattice in site.state.lattices:
        if lattice.name == site.lattice.name:
            yield trimmed(lattice.with_lines(site.axis, lines))
            continue
        own, *further = followed(lattice, jump.tree, jump.origin, site.axis)
        if own.cells:
            yield own
        copies += further
    for copy in copies:
        name = free_name(re.sub(r"_\d+$", "", copy.name), taken)
        taken.add(name)
        yield replace(copy, name=name)
