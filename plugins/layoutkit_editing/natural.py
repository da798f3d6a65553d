"""How large a facade gets where nobody says: as large as what its grids stand in asks for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from layoutkit_editing.sizing.flat import TERMINAL, Flat
from layoutkit_editing.sizing.solving import Sized, Unsizable
from layoutkit_editing.state import State


def naturally_sized(state: State, size: Callable[[State], Sized | Unsizable]) -> Sized | Unsizable:
    """Size a state whose facade is as large as is natural, where the user does not say how large.

    The paper leaves that to the objective (Dang et al. 2014, section 5). A column more would then be squeezed
    in: cornices, which reach over the whole facade, hold on to their widths as firmly as windows do. The
    objective still decides where no facade is of the natural size, which nobody asked for.
    """
    asked = with_extents(state)
    found = size(asked)
    while isinstance(found, Unsizable):
        given, wanted = list(state.targets.extents), list(asked.targets.extents)
        if given[found.axis] is not None or wanted[found.axis] is None:
            return found
        wanted[found.axis] = None
        asked = replace(asked, targets=replace(asked.targets, extents=(wanted[0], wanted[1])))
        found = size(asked)
    return found


def with_extents(state: State) -> State:
    """Return the state with the facade's extents among its targets: natural ones, where none were given."""
    given = state.targets.extents
    if None not in given:
        return state
    natural = _extents(state)
    width, height = (own if own is not None else natural[axis] for axis, own in enumerate(given))
    return replace(state, targets=replace(state.targets, extents=(width, height)))


def _extents(state: State) -> tuple[float, float]:
    """Return the natural extents of the facade: of what is side by side the sum, of others the mean.

    Those with more elements of grids count for more; those without count only where none has any.
    """
    flat = Flat.of(state.tree)
    terminal = flat.along == TERMINAL
    extents = np.where(terminal, state.original.sizes[:, flat.sources], 0.0)
    for own, size in state.rests.items():
        extents[:, flat.index[own]] = size
    held = np.zeros(len(flat))
    elements = [flat.index[own] for lattice in state.lattices for own in lattice.elements]
    np.add.at(held, elements, 1.0)
    for level in reversed(flat.levels):
        inside = held[level.start : level.end]
        within = np.add.reduceat(inside, level.blocks)
        counted = np.repeat(within > 0, flat.counts[level.parents])
        weights = np.where(counted, inside, 1.0)
        sums = np.add.reduceat(extents[:, level.start : level.end], level.blocks, axis=1)
        weighted = np.add.reduceat(weights * extents[:, level.start : level.end], level.blocks, axis=1)
        means = weighted / np.add.reduceat(weights, level.blocks)
        along = flat.along[level.parents]
        extents[:, level.parents] = np.where(along == np.array([[0], [1]]), sums, means)
        held[level.parents] += within
    return float(extents[0, 0]), float(extents[1, 0])
