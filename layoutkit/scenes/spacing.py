"""Shape arrays: a placement that is filled with shapes of one size, instead of one that is stretched.

Guerrero et al. 2015, section 4.1; supplement, section 1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.model.learning import Spacing
from layoutkit.model.scene import Placement

#: Placements are filled with at most so many shapes altogether.
MOST = 10_000

_TOPIC = "placement"


@dataclass(frozen=True, slots=True)
class _Row:
    """How shapes stand along one side of placements.

    Attributes
    ----------
    side, size_name, gap_name
        What is filled, and what the settings are called.
    size, gap
        Of each shape along it, and between shapes; size None: one takes all of it.
    """

    side: str
    size_name: str
    gap_name: str
    size: float | None
    gap: float

    def count(self, room: float) -> float:
        """Return how many there is room for, at least 1; maybe infinitely many."""
        if self.size is None or self.size > room:
            return 1
        many = (room + self.gap) / (self.size + self.gap) + 1e-9
        return max(1, math.floor(many)) if math.isfinite(many) else many

    def positions(self, room: float) -> list[tuple[float, float]]:
        """Return the centres of shapes from the middle of the room, with their sizes along it."""
        if self.size is None or self.size > room:
            return [(0.0, room)]
        count = int(self.count(room))
        if count == 1:
            return [(0.0, self.size)]
        step = (room - self.size) / (count - 1)
        return [(index * step - (room - self.size) / 2, self.size) for index in range(count)]

    def enough(self, room: float, most: int) -> str:
        """Return a size of which no more than so many have room, as a hint; empty if these have."""
        if self.count(room) <= most:
            return ""
        return f"{self.size_name} {1.01 * ((room + self.gap) / most - self.gap):.3g}"


def check(spacing: Spacing) -> None:
    """Raise `Faulty` unless a spacing makes sense (LK872)."""
    for row in _rows(spacing):
        if row.size is not None and not (row.size > 0 and math.isfinite(row.size)):
            raise Faulty([_fault(f"{row.size_name} is {row.size:g}", "give shapes a size above 0")])
        if row.gap < 0 or not math.isfinite(row.gap):
            raise Faulty([_fault(f"{row.gap_name} is {row.gap:g}", "a gap is 0 or more")])
        if row.gap and row.size is None:
            message = f"{row.gap_name} is of no use without {row.size_name}: nothing is filled"
            raise Faulty([_fault(message, f"add {row.size_name}, or leave {row.gap_name} away")])


def fill(placements: Sequence[Placement], spacing: Spacing) -> tuple[Placement, ...]:
    """Return the shapes that fill some placements.

    Raises
    ------
    Faulty
        If there were more than `MOST` (LK872).
    """
    across, up = _rows(spacing)
    count = sum(across.count(whole.width) * up.count(whole.height) for whole in placements)
    if count > MOST:
        share = max(1, MOST // len(placements))
        most = share if spacing.each_width is None or spacing.each_height is None else math.isqrt(share)
        width, height = (max(getattr(p, side) for p in placements) for side in ("width", "height"))
        sizes = " ".join(filter(None, (across.enough(width, most), up.enough(height, most))))
        message = f"placements would be filled with {count:,.0f} shapes, and {MOST:,} is the most"
        raise Faulty([_fault(message, f"fewer would fill them with {sizes}" if sizes else "lower the limit")])
    return tuple(shape for whole in placements for shape in filled(whole, spacing))


def filled(whole: Placement, spacing: Spacing) -> Iterator[Placement]:
    """Yield the shapes that fill a placement: as many as there is room for, evenly spaced.

    There is no gap before the first and after the last one; a single one stands in the middle.
    """
    across, up = _rows(spacing)
    columns, rows = across.positions(whole.width), up.positions(whole.height)
    cosine, sine = math.cos(math.radians(whole.angle)), math.sin(math.radians(whole.angle))
    for v, own_height in rows:
        for u, own_width in columns:
            x, y = whole.x + cosine * u - sine * v, whole.y + sine * u + cosine * v
            yield replace(whole, x=x, y=y, width=own_width, height=own_height)


def remarks(placements: Sequence[Placement], spacing: Spacing) -> Iterator[Diagnostic]:
    """Say where shapes are larger than every placement, so that none is filled with them (LK877)."""
    for row in _rows(spacing):
        widest = max((getattr(placement, row.side) for placement in placements), default=math.inf)
        if row.size is not None and row.size > widest:
            yield Diagnostic(
                "LK877",
                f"{row.size_name} is {row.size:g}, and no placement's {row.side} is more than {widest:.3g}",
                hint=f"choose a smaller one: placements keep their {row.side} as it is",
                severity=Severity.NOTE,
                topic=_TOPIC,
            )


def _rows(spacing: Spacing) -> tuple[_Row, _Row]:
    return (
        _Row("width", "each-width", "gap-across", spacing.each_width, spacing.gap_across),
        _Row("height", "each-height", "gap-up", spacing.each_height, spacing.gap_up),
    )


def _fault(message: str, hint: str) -> Diagnostic:
    return Diagnostic("LK872", message, hint=hint, topic=_TOPIC)
