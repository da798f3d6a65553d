"""Equalities between cut lines: line = other line + constant + sizes of classes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.classes import Classes
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.lattices import CENTRE, END, Alignments
from layoutkit_editing.state import State

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: What asks for a relation.
ALIGNED, LIKE, SIZE_ASKED, START_ASKED, END_ASKED, EXTENT_ASKED = range(6)


@dataclass(frozen=True, eq=False)
class Relations:
    """Equalities after = before + distance + share · (size of `plus` − size of `minus`).

    Attributes
    ----------
    before, after
        Lines.
    distances
        In document units.
    shares
        What factor the sizes have.
    plus, minus
        Numbers of classes; -1 for none.
    why
        What asks for each: `ALIGNED`, `LIKE`, or what the user asked.
    nodes
        The nodes that it is about, twice the same if it is one (m × 2).
    """

    before: Ints
    after: Ints
    distances: Floats
    shares: Floats
    plus: Ints
    minus: Ints
    why: Ints
    nodes: Ints

    def __len__(self) -> int:
        return len(self.before)

    @classmethod
    def joined(cls, parts: Sequence[Relations]) -> Relations:
        """Return relations one after the other."""
        names = [field.name for field in fields(cls)]
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))

    def telling(self, tolerance: float) -> Relations:
        """Return the relations that do not hold by themselves; distances up to a tolerance are none.

        Elements of one composite that is divided across the axis have the same lines, so are in line.
        """
        same = (self.before == self.after) & (self.plus == self.minus) & (np.abs(self.distances) <= tolerance)
        kept = np.flatnonzero(~same)
        return Relations(*(getattr(self, field.name)[kept] for field in fields(self)))

    def renumbered(self, numbers: Ints) -> Relations:
        """Return the same with other numbers of lines."""
        return replace(self, before=numbers[self.before], after=numbers[self.after])


def of_targets(state: State, flat: Flat, lines: tuple[Ints, Ints], axis: int) -> Relations:
    """Return what the user asks sizes and places to be."""
    index, (starts, ends), asked = flat.index, lines, state.targets
    rows: list[tuple[int, int, float, int, int]] = []
    extent = asked.extents[axis]
    if extent is not None:
        rows.append((0, int(ends[0]), extent, EXTENT_ASKED, 0))
    for why, values in ((SIZE_ASKED, asked.sizes), (START_ASKED, asked.starts), (END_ASKED, asked.ends)):
        for node, value in ((index[own], value) for (own, along), value in values.items() if along == axis):
            origin = int(starts[node]) if why == SIZE_ASKED else 0
            rows.append((origin, int((starts if why == START_ASKED else ends)[node]), value, why, node))
    table = np.array(rows, dtype=float).reshape(-1, 5)
    before, after, whys, nodes = (table[:, column].astype(np.int64) for column in (0, 1, 3, 4))
    none = np.full(len(rows), -1)
    return Relations(
        before, after, table[:, 2], np.zeros(len(rows)), none, none, whys, np.stack([nodes, nodes], axis=1)
    )


def of_classes(classes: Classes, lines: tuple[Ints, Ints]) -> Relations:
    """Return that each node is as large as its class."""
    starts, ends = lines
    keys = (starts[classes.nodes] * (1 + len(starts)) + ends[classes.nodes]) * classes.forms.shape[0]
    _, once = np.unique(keys + classes.numbers, return_index=True)
    nodes, count = classes.nodes[once], len(once)
    return Relations(
        starts[nodes],
        ends[nodes],
        np.zeros(count),
        np.ones(count),
        classes.numbers[once],
        np.full(count, -1),
        np.full(count, LIKE),
        np.stack([nodes, nodes], axis=1),
    )


def of_alignments(alignments: Alignments, classes: Classes, lines: tuple[Ints, Ints]) -> Relations:
    """Return that anchors keep their distance; those of centres hang on the sizes of both elements."""
    starts, ends = lines
    first, second = alignments.first, alignments.second
    number = np.full(len(starts), -1)
    number[classes.nodes] = classes.numbers
    centred = (alignments.anchors == CENTRE) & ((number[first] != number[second]) | (number[first] < 0))
    at_end = alignments.anchors == END
    return Relations(
        np.where(at_end, ends[first], starts[first]),
        np.where(at_end, ends[second], starts[second]),
        alignments.distances,
        np.where(centred, 0.5, 0.0),
        np.where(centred, number[first], -1),
        np.where(centred, number[second], -1),
        np.full(len(first), ALIGNED),
        np.stack([first, second], axis=1),
    )
