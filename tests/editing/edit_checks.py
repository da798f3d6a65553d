"""What every edit of every facade keeps, as code that shares nothing with what makes edits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from layoutkit.model import Region, place
from layoutkit.model.grid import OVERLAP_TOLERANCE, arranged
from layoutkit.model.session import Axis, Edit, Gap
from layoutkit_editing.naming import named
from layoutkit_editing.natural import naturally_sized
from layoutkit_editing.proposing.applying import AXES, applied
from layoutkit_editing.proposing.proposals import Proposal
from layoutkit_editing.proposing.settling import Judge, made
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import Lattice, State
from layoutkit_editing.topology.site import Refused, Spans

GAPS: tuple[Gap, Gap] = ("after", "before")


def sized_naturally(state: State) -> Sized | Unsizable:
    """Return the sizes of a state whose facade is as large as it likes."""
    return naturally_sized(state, sized)


def spans_of(state: State) -> Spans:
    """Return where the nodes of a state stand that can be sized."""
    found = sized_naturally(state)
    assert isinstance(found, Sized), found
    return found.span


@dataclass
class Tally:
    """What became of edits."""

    proposed: int = 0
    dropped: int = 0
    restored: int = 0
    added: int = 0

    def __iadd__(self, other: Tally) -> Tally:
        for name in ("proposed", "dropped", "restored", "added"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        return self


def check_edits(state: State, random: np.random.Generator, most: int = 2, deep: int = 1) -> Tally:
    """Check edits of every grid along both axes, of each kind some; and edits of what comes of one of them.

    Parameters
    ----------
    deep
        How many steps to go on for.
    """
    tally, taken = Tally(), list[Proposal]()
    spans = spans_of(state)
    for lattice in state.lattices:
        for axis in ("columns", "rows"):
            for edit in random_edits(lattice, axis, random, most):
                try:
                    after, found = made(state, spans, edit, [[lattice.name]], Judge(sized), None)
                except Refused as refused:
                    tally.dropped += bool(str(refused))
                    continue
                taken.append(Proposal(edit, after, found, state.tree))
                tally.proposed += 1
                check_proposal(state, taken[-1])
                if edit.action == "add":
                    tally.added += 1
                    tally.restored += restored(state, taken[-1])
    if deep and taken:
        tally += check_edits(taken[int(random.integers(len(taken)))].state, random, 1, deep - 1)
    return tally


def random_edits(lattice: Lattice, axis: Axis, random: np.random.Generator, most: int) -> Iterator[Edit]:
    """Yield edits of a grid, of each kind some."""
    count = len(lattice.lines(AXES[axis]))
    for _ in range(most):
        source, at, to = random.integers(1, (count + 1, count + 2, count + 1)).tolist()
        edit = Edit("add", axis, (lattice.name,), (source,), at=(at,))
        yield edit
        yield replace(edit, action="remove", at=(), gap=GAPS[int(random.integers(2))])
        if source != to:
            yield replace(edit, action="move", at=(), to=(to,))


def check_proposal(before: State, proposal: Proposal) -> None:
    """Check that a proposal tiles, has a line more or fewer, and keeps alignments."""
    after, found = proposal.state, proposal.sized
    assert after.elements <= after.tree.nodes.keys(), "grids are of what is there"
    names = named(after.original, after.tree, found.span)
    check_tiling(names.root)
    own = {placed.path: placed.box for placed in place(names.root)}
    boxes = {node: own[path] for node, path in names.paths.items()}
    (name,), axis = proposal.edit.grids, AXES[proposal.edit.axis]
    change = {"add": 1, "remove": -1, "move": 0}[proposal.edit.action]
    lines = len(before.lattice(name).lines(axis))
    edited = after.lattice(name)
    assert len(edited.lines(axis)) == lines + change
    elements = list(edited.elements)
    tolerance = OVERLAP_TOLERANCE * max(found.extents)
    cells = arranged([boxes[element] for element in elements], tolerance)
    derived = tuple(tuple(None if c is None else elements[c] for c in row) for row in cells)
    assert derived == edited.cells, "rows and columns by overlap are those that were kept"
    for lattice in after.lattices:
        check_alignments(after, lattice, found)


def check_tiling(region: Region) -> None:
    """Check that the children of every region tile it."""
    if not region.children:
        assert region.split is None
        return
    along = [child.extent(region.split or "columns") for child in region.children]
    across = [child.height if region.split == "columns" else child.width for child in region.children]
    size = region.extent(region.split or "columns")
    other = region.height if region.split == "columns" else region.width
    assert min(along) > 0
    assert math.isclose(math.fsum(along), size, rel_tol=1e-9)
    assert all(math.isclose(each, other, rel_tol=1e-9) for each in across)
    for child in region.children:
        check_tiling(child)


def check_alignments(state: State, lattice: Lattice, found: Sized) -> None:
    """Check that neighbours in a column, or row, have some anchor as far from each other's as they had."""
    sources = state.original.spans
    tolerance = 1e-6 * max(found.extents)
    for axis in (0, 1):
        for line in lattice.lines(axis):
            inner = [own for own in line if own is not None]
            for one, other in pairwise(inner):
                was = [
                    sources[axis, state.tree.nodes[own].source] + state.shifts.get(own, (0.0, 0.0))[axis]
                    for own in (one, other)
                ]
                if min(was[0][1], was[1][1]) - max(was[0][0], was[1][0]) <= tolerance:
                    continue
                now = [found.span(own, axis) for own in (one, other)]
                misses = [
                    abs(
                        anchor(now[1], share)
                        - anchor(now[0], share)
                        - anchor(was[1], share)
                        + anchor(was[0], share)
                    )
                    for share in (0.0, 0.5, 1.0)
                ]
                assert min(misses) <= tolerance, (lattice.name, one, other, misses)


def anchor(span: tuple[float, float], share: float) -> float:
    """Return a point of an interval."""
    return (1 - share) * span[0] + share * span[1]


def restored(state: State, proposal: Proposal) -> bool:
    """Tell whether removing the line that was added gives the state again: every terminal where it was."""
    edit = proposal.edit
    wanted = outline(state, spans_of(state))
    return any(outline(*undone) == wanted for undone in _undone(proposal, edit.grids[0]))


def _undone(proposal: Proposal, name: str) -> Iterator[tuple[State, Spans]]:
    for gap in ("after", "before"):
        back = replace(proposal.edit, action="remove", source=proposal.edit.at, at=(), gap=gap)
        try:
            after = applied(proposal.state, proposal.sized.span, back, [[name]], spans_of)
        except Refused:
            continue
        found = sized_naturally(after)
        if isinstance(found, Sized):
            yield after, found.span


def outline(state: State, spans: Spans) -> list[tuple[int, ...]]:
    """Return where each terminal stands, in millionths of the facade, and what it is a copy of by its box."""
    unit = 1e-6 * max(state.original.facade.root.width, state.original.facade.root.height)
    kinds = state.original.places
    found = []
    for own in state.tree.inside(state.tree.root):
        node = state.tree.nodes[own]
        if node.split is None:
            place_ = tuple(round(end / unit / 10) for axis in (0, 1) for end in spans(own, axis))
            found.append((*place_, hash(kinds[node.source].region)))
    return sorted(found)
