"""Shape arrays: a placement that is filled with shapes of one size, instead of one that is stretched.

Guerrero et al. 2015, section 4.1; supplement, section 1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from layoutkit.model.learning import Spacing
from layoutkit.model.scene import Placement


def filled(whole: Placement, spacing: Spacing) -> Iterator[Placement]:
    """Yield the shapes that fill a placement: as many as there is room for, evenly spaced.

    There is no gap before the first and after the last one; a single one stands in the middle.
    """
    columns = _positions(whole.width, spacing.each_width, spacing.gap_across)
    rows = _positions(whole.height, spacing.each_height, spacing.gap_up)
    cosine, sine = math.cos(math.radians(whole.angle)), math.sin(math.radians(whole.angle))
    for v, own_height in rows:
        for u, own_width in columns:
            x, y = whole.x + cosine * u - sine * v, whole.y + sine * u + cosine * v
            yield replace(whole, x=x, y=y, width=own_width, height=own_height)


def _positions(room: float, size: float | None, gap: float) -> list[tuple[float, float]]:
    """Return the centres of shapes from the middle of the room, with their sizes along it."""
    if not size or size > room:
        return [(0.0, room)]
    count = int((room + gap) / (size + gap) + 1e-9)
    if count <= 1:
        return [(0.0, size)]
    step = (room - size) / (count - 1)
    return [(index * step - (room - size) / 2, size) for index in range(count)]
