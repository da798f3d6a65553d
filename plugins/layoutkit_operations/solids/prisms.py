"""Prisms over outlines on a surface, with a flat cap, a roof, or none (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from layoutkit.model.world import Frame
from layoutkit_operations.solids.frames import Array, in_space, turned
from layoutkit_operations.solids.polyhedra import Facet
from layoutkit_operations.solids.roofs import convex, eaves_of_gable, planes, profile

Cap = Literal["flat", "gable", "hip", "none"]
#: Sides by where they look, in quarters of a turn from the outline's own x axis.
_QUARTERS = ("Right", "Back", "Left", "Front")
#: Sides that look between two of them, as of an octagon, belong to the one before, whatever the rounding.
_TIE = 1e-6


@dataclass(frozen=True, eq=False)
class Prism:
    """What is to be built over an outline.

    Attributes
    ----------
    outline
        Shape (points, 2), counter-clockwise, on the surface.
    frame
        That of the surface.
    angle
        The direction of the outline's own x axis, in degrees.
    height
        To the cap, or to the eaves of a roof; below 0: into the surface.
    cap
        What is on the far end.
    pitch
        Of a roof, in degrees.
    labels
        Further labels of the side over each edge.
    """

    outline: Array
    frame: Frame
    angle: float
    height: float
    cap: Cap = "flat"
    pitch: float = 40.0
    labels: Sequence[tuple[str, ...]] = ()

    def why_no_roof(self) -> str:
        """Say why the roof that is asked for cannot stand on the outline; empty if it can."""
        if self.cap not in ("gable", "hip"):
            return ""
        if not convex(self.outline):
            return "its outline has inner corners"
        if self.cap == "gable" and len(self.outline) != 4:
            return f"its outline has {len(self.outline)} sides, and gables are built over four"
        return ""

    def facets(self) -> Iterator[Facet]:
        """Yield its facets: the sides in the order of the outline, then the cap, last the base."""
        low, high = min(self.height, 0.0), max(self.height, 0.0)
        eaves = self._eaves()
        slope = math.tan(math.radians(self.pitch))
        parts = [(edge, part, slope * distances) for edge, part, distances in planes(self.outline, eaves)]
        for edge in range(len(self.outline)):
            yield self._side(edge, low, high)
        for edge, part, rises in parts:
            yield self._facet(part, high + rises, ("Roof",))
            if self.cap == "gable":
                gable = (edge + 1) % len(self.outline)
                yield self._gable(gable, high, [(p, r) for _, p, r in parts])
        if self.height > 0:
            if not parts and self.cap != "none":
                yield self._facet(self.outline, high, ("Top",))
            yield self._facet(self.outline[::-1], low, ("Base",))
        else:
            if self.cap != "none":
                yield self._facet(self.outline[::-1], low, ("Top",))
            yield self._facet(self.outline, high, ("Base",))

    def _eaves(self) -> tuple[int, ...]:
        if self.cap == "hip":
            return tuple(range(len(self.outline)))
        return eaves_of_gable(self.outline) if self.cap == "gable" else ()

    def _side(self, edge: int, low: float, high: float) -> Facet:
        ends = self._ends(edge)
        return self._facet(np.array([*ends, *ends[::-1]]), np.array([low, low, high, high]), self._own(edge))

    def _gable(self, edge: int, high: float, parts: list[tuple[Array, Array]]) -> Facet:
        start, end = self._ends(edge)
        cut = profile(self.outline, edge, parts)
        points = np.array([start, end, *(point for point, _ in cut)])
        rises = np.array([0.0, 0.0, *(rise for _, rise in cut)])
        return self._facet(points, high + rises, ("Gable",))

    def _ends(self, edge: int) -> list[Array]:
        return [self.outline[edge], self.outline[(edge + 1) % len(self.outline)]]

    def _own(self, edge: int) -> tuple[str, ...]:
        """Return the labels of the side over an edge: what it is, where it looks, and what the edge has."""
        (x0, y0), (x1, y1) = (point.tolist() for point in self._ends(edge))
        looks = math.degrees(math.atan2(x0 - x1, y1 - y0)) - self.angle
        further = self.labels[edge] if self.labels else ()
        return tuple(dict.fromkeys(("Side", _QUARTERS[round(looks / 90 - _TIE) % 4], *further)))

    def _facet(self, flat: Array, out: float | Array, labels: tuple[str, ...]) -> Facet:
        return Facet(in_space(flat, self.frame, out), labels, turned(self.frame, self.angle))


def straightened(outline: Array, labels: Sequence[tuple[str, ...]]) -> tuple[Array, list[tuple[str, ...]]]:
    """Return an outline without points that lie on the straight line between their neighbours.

    An edge that goes on where another one ended has the labels of both.
    """
    size = float(np.ptp(outline, axis=0).max())
    ahead = np.roll(outline, -1, axis=0) - outline
    behind = np.roll(ahead, 1, axis=0)
    off = np.abs(behind[:, 0] * ahead[:, 1] - behind[:, 1] * ahead[:, 0]) / np.hypot(
        *(ahead + behind).T
    ).clip(1e-300)
    on = (off <= 1e-7 * size) & ((behind * ahead).sum(axis=1) > 0)
    kept = np.flatnonzero(~on).tolist()
    count = len(outline)
    own = [
        tuple(dict.fromkeys(label for at in range(one, other) for label in labels[at % count]))
        for one, other in pairwise([*kept, kept[0] + count])
    ]
    return outline[kept], own
