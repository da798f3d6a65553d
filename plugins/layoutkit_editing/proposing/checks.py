"""What is looked over before a proposal is shown."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from layoutkit.model import Box
from layoutkit.model.grid import OVERLAP_TOLERANCE, arranged
from layoutkit_editing.grids.lattices import as_arranged
from layoutkit_editing.sizing.solving import Sized
from layoutkit_editing.state import Lattice, State


def torn(state: State, told: State, names: Collection[str]) -> str:
    """Say which of the edited grids is torn: its elements no longer stand in its rows and columns.

    Parameters
    ----------
    told
        The state with the rows and columns in which elements stand.

    Returns
    -------
    str
        The reason, in the user's words; empty if all is well.
    """
    for name in names:
        if told.lattice(name) is not state.lattice(name):
            return f"elements of the grid {name!r} would no longer stand in its rows and columns"
    return ""


def rearranged(state: State, found: Sized) -> State:
    """Return a sized state with the rows and columns in which elements stand; itself, if it has them."""
    tolerance = OVERLAP_TOLERANCE * max(found.extents)
    lattices, new = list[Lattice](), False
    for lattice in state.lattices:
        elements = tuple(lattice.elements)
        boxes = boxes_of(found, elements)
        if not as_arranged(lattice, boxes, tolerance):
            cells = arranged([boxes[own] for own in elements], tolerance)
            rows = tuple(tuple(None if index is None else elements[index] for index in row) for row in cells)
            lattice, new = replace(lattice, cells=rows), True
        lattices.append(lattice)
    return replace(state, lattices=tuple(lattices)) if new else state


def boxes_of(found: Sized, nodes: tuple[int, ...]) -> dict[int, Box]:
    """Return where nodes stand, y up."""
    places = found.places[:, [found.flat.index[own] for own in nodes]]
    height = found.extents[1]
    columns = (places[0, :, 0], height - places[1, :, 1], places[0, :, 1], height - places[1, :, 0])
    return {own: Box(*box) for own, *box in zip(nodes, *(column.tolist() for column in columns), strict=True)}
