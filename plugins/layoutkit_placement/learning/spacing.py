"""Shape arrays: a placement that is filled with shapes of one size, instead of one that is stretched.

Guerrero et al. 2015, section 4.1; supplement, section 1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from layoutkit.model.scene import Placement


@dataclass(frozen=True, slots=True)
class Spacing:
    """Along which dimensions shapes are repeated, and how far apart they stand at least.

    Attributes
    ----------
    across, up
        The least gap between shapes along the width and the height, in document units; None: the shape is
        stretched along it.
    size
        Width and height of one shape, in document units; None: those of the examples in the mean.
    """

    across: float | None = None
    up: float | None = None
    size: tuple[float, float] | None = None

    def filled(self, whole: Placement, mean: tuple[float, float]) -> Iterator[Placement]:
        """Yield the shapes that fill a placement: as many as there is room for, evenly spaced.

        There is no gap before the first and after the last one; a single one stands in the middle.

        Parameters
        ----------
        mean
            Mean width and height of the examples.
        """
        width, height = self.size or mean
        columns = _positions(whole.width, width, self.across)
        rows = _positions(whole.height, height, self.up)
        cosine, sine = math.cos(math.radians(whole.angle)), math.sin(math.radians(whole.angle))
        for v, own_height in rows:
            for u, own_width in columns:
                x, y = whole.x + cosine * u - sine * v, whole.y + sine * u + cosine * v
                yield replace(whole, x=x, y=y, width=own_width, height=own_height)


def _positions(room: float, size: float, gap: float | None) -> list[tuple[float, float]]:
    """Return the centres of shapes from the middle of the room, with their sizes along it."""
    if gap is None or size > room:
        return [(0.0, room)]
    count = int((room + gap) / (size + gap) + 1e-9)
    if count <= 1:
        return [(0.0, size)]
    step = (room - size) / (count - 1)
    return [(index * step - (room - size) / 2, size) for index in range(count)]
