"""Sizes for a state of an editing session (Dang et al. 2014, section 5)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit_editing.sizing.axis import Axis, Subject
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.refusals import Unsizable
from layoutkit_editing.sizing.rules import Rule
from layoutkit_editing.sizing.solver import Solver
from layoutkit_editing.state import State

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["Sized", "Unsizable", "sized"]


@dataclass(frozen=True, eq=False)
class Sized:
    """Where every node stands, in reading direction: along x from the left, along y from the top down.

    Children tile their parents exactly: each starts at the very number where the one before ends.

    Attributes
    ----------
    flat
        The tree as arrays: which node stands at which position in them.
    places
        Starts and ends along both axes by position (2 × n × 2), in document units.
    distortion
        How far terminals are off their sources' sizes: √(Σ W² (size − source's)² / Σ W² source's²) over both
        axes, with the weights of the program. 0 if none is; 0.1 if they are off by a tenth as a whole.
    """

    flat: Flat
    places: Floats
    distortion: float

    def span(self, own: int, axis: int) -> tuple[float, float]:
        """Return where a node starts and ends along an axis."""
        return self._listed[axis][self.flat.index[own]]

    @cached_property
    def _listed(self) -> list[list[tuple[float, float]]]:
        return [[(start, end) for start, end in spans.tolist()] for spans in self.places]

    @property
    def extents(self) -> tuple[float, float]:
        """Width and height of the facade."""
        return float(self.places[0, 0, 1]), float(self.places[1, 0, 1])

    @cached_property
    def ids(self) -> tuple[int, ...]:
        """The nodes in document order."""
        return tuple(self.flat.ids[position] for position in self.flat.preorder.tolist())

    @cached_property
    def spans(self) -> Floats:
        """Starts and ends along both axes in document order (2 × n × 2)."""
        return self.places[:, self.flat.preorder]


def sized(
    state: State, backends: Sequence[Backend] = BACKENDS, rules: Sequence[Rule] = ()
) -> Sized | Unsizable:
    """Return sizes of least deviation from the sources that keep hierarchy, alignments, likeness and targets.

    Parameters
    ----------
    backends
        Solvers of quadratic programs, in the order in which they are tried; asked only where least sizes or
        rules matter.
    rules
        Further rows to keep.
    """
    subject = Subject(state)
    places = np.empty((2, len(subject.flat), 2))
    for number in (0, 1):
        axis = Axis(number, subject, tuple(rule for rule in rules if rule.axis == number))
        found: Floats | Unsizable | None = axis.natural()
        if found is None:
            found = Solver(axis, backends).spans(*axis.bounds)
        if isinstance(found, Unsizable):
            return found
        places[number] = found
    return Sized(subject.flat, places, distortion(subject, places))


def distortion(subject: Subject, places: Floats) -> float:
    """Return how far terminals are off: see `Sized`."""
    flat, sources = subject.flat, subject.sources
    own = flat.sources[flat.terminals]
    weights, originals = sources.weights[own], sources.sizes[:, own]
    inner = places[:, flat.terminals]
    changes = inner[:, :, 1] - inner[:, :, 0] - originals
    return float(np.sqrt((weights * changes**2).sum() / (weights * originals**2).sum()))
