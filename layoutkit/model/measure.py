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
        try:
            value = _shifted(stripped[:-1], -2) if relative else float(stripped)
        except ValueError:
            value = math.nan
        if not math.isfinite(value) or value < 0:
            raise ValueError(f"{text!r} is not a finite number of at least 0")
        return cls(value, relative)

    def of(self, reference: float) -> float:
        """Return the measure in absolute terms, where the input has `reference`."""
        return self.value * reference if self.relative else self.value

    def __str__(self) -> str:
        if not self.relative:
            return format_number(self.value)
        # As a decimal: 100 * 0.57 is not 57 in floats, and the text has to read back as the same share.
        from decimal import Decimal

        return f"{Decimal(repr(float(self.value))).scaleb(2).normalize():f}%"


def format_number(value: float) -> str:
    """Return the shortest text that reads back as the same float, whole numbers without a point."""
    return str(int(value)) if value == int(value) and abs(value) < 1e16 else repr(float(value))


def _shifted(text: str, places: int) -> float:
    """Return the number that `text` spells, its point moved: dividing by 100 would round a second time."""
    digits, _, exponent = text.lower().partition("e")
    return float(f"{digits.strip()}e{int(exponent or 0) + places}")
