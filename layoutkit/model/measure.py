"""Measures: absolute values, or percentages of what the input has."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Measure:
    """A number as a user writes it: ``3.5`` in document units (or a count), or ``120%`` of the input's.

    Attributes
    ----------
    value
        The number; for a percentage the share, so that ``120%`` holds 1.2.
    relative
        Whether it is a share of the input's.
    """

    value: float
    relative: bool = False

    @classmethod
    def parse(cls, text: str) -> Measure:
        """Read ``3.5`` or ``120%``.

        Raises
        ------
        ValueError
            If the text is no finite number of at least 0.
        """
        stripped = text.strip()
        relative = stripped.endswith("%")
        value = float(stripped[:-1]) / 100 if relative else float(stripped)
        if not math.isfinite(value) or value < 0:
            raise ValueError(f"{text!r} is not a finite number of at least 0")
        return cls(value, relative)

    def of(self, reference: float) -> float:
        """Return the measure in absolute terms, where the input has `reference`."""
        return self.value * reference if self.relative else self.value

    def __str__(self) -> str:
        if not self.relative:
            return format_number(self.value)
        return f"{format_number(round(self.value * 100, 10))}%"


def format_number(value: float) -> str:
    """Return the shortest text that reads back as the same float, whole numbers without a point."""
    return str(int(value)) if value == int(value) and abs(value) < 1e16 else repr(float(value))
