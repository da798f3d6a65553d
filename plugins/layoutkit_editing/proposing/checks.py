"""What is looked over before a proposal is shown."""

from __future__ import annotations

from collections.abc import Collection

from layoutkit.model import Box
from layoutkit.model.grid import OVERLAP_TOLERANCE
from layoutkit_editing.grids.lattices import as_arranged
from layoutkit_editing.sizing.solving import Sized
from layoutkit_editing.state import State


def torn(state: State, found: Sized, names: Collection[str]) -> str:
    """Say which of the edited grids is torn: its elements no longer stand in its rows and columns.

    Returns
    -------
    str
        The reason, in the user's words; empty if all is well.
    """
    for name in names:
        lattice = state.lattice(name)
        boxes = boxes_of(found, tuple(lattice.elements))
        if not as_arranged(lattice, boxes, OVERLAP_TOLERANCE * max(found.extents)):
            return f"elements of the grid {name!r} would no longer stand in its rows and columns"
    return ""


def boxes_of(found: Sized, nodes: tuple[int, ...]) -> dict[int, Box]:
    """Return where nodes stand, y up."""
    places = found.places[:, [found.flat.index[own] for own in nodes]]
    height = found.extents[1]
    columns = (places[0, :, 0], height - places[1, :, 1], places[0, :, 1], height - places[1, :, 0])
    return {own: Box(*box) for own, *box in zip(nodes, *(column.tolist() for column in columns), strict=True)}
