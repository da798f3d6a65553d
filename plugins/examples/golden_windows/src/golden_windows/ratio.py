"""The constraint ``golden:ratio``: linear rows across both axes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import MEASURE, REGIONS, AttributeType, attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Measure, RegionSet, Violation
from layoutkit.model.measure import format_number
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Rows, SizeRule

#: The golden ratio, to four digits.
GOLDEN = 1.618


def _ratio(text: str) -> float:
    """Read a ratio.

    Raises
    ------
    ValueError
        If it is no finite number above 0.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{text!r} is not a finite number above 0")
    return value


#: A type of attribute of our own: what text means, how it is written, and what the schema lets through.
RATIO = AttributeType("ratio", _ratio, format_number, r"\s*\+?[0-9.]+([eE][+\-]?[0-9]+)?\s*")


@dataclass(frozen=True, kw_only=True)
class Ratio(Constraint):
    """Regions whose height is a fixed multiple of their width."""

    kind: ClassVar[str] = "ratio"
    namespace: ClassVar[Namespace] = Namespace("golden", "urn:example:golden-windows:1")
    summary: ClassVar[str] = (
        "The height of each region is its width times a ratio, by default the golden one."
    )

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    ratio: float = attribute(RATIO, "Height over width.", GOLDEN)
    tolerance: Measure = attribute(
        MEASURE, "How far the ratio may be off, either way; a percentage is of the ratio.", Measure(0.0, True)
    )

    @property
    def ends(self) -> tuple[float, float]:
        """The least and the greatest ratio of height to width."""
        off = self.tolerance.of(self.ratio)
        return max(self.ratio - off, 0.0), self.ratio + off

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield names that the facade has not."""
        yield from unknown_names(self, self.of, facade)

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield, for each region that stands in the layout, rows over its width and its height.

        One equality where nothing may be off: least × width − height = 0. Otherwise two rows, so that the
        height is between least × width and most × width.
        """
        import numpy as np

        least, most = self.ends
        for path in arrangement.facade.select(self.of):
            if path not in arrangement.frames:
                continue
            sides = arrangement.size(path, 0), arrangement.size(path, 1)
            if least == most:
                yield Rows(sides, np.array([[least, -1.0]]), np.zeros(1), np.zeros(1), self)
            else:
                matrix = np.array([[-least, 1.0], [most, -1.0]])
                yield Rows(sides, matrix, np.zeros(2), np.full(2, np.inf), self)

    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        """Return the constraint region by region: a conflict then names the region, and not all windows."""
        return {path: replace(self, of=RegionSet(path)) for path in facade.select(self.of)}

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every placed region that is too low or too high for its width."""
        least, most = self.ends
        for path in view.facade.select(self.of):
            for placed in view.places(path):
                width, height = placed.box.width, placed.box.height
                amount = max(least * width - height, height - most * width)
                if amount > view.tolerance:
                    wanted = f"{least:.4g}" if least == most else f"between {least:.4g} and {most:.4g}"
                    message = f"is {width:.4g} wide and {height:.4g} high: {height / width:.4g}, not {wanted}"
                    yield Violation(self, placed.path, message, amount)
