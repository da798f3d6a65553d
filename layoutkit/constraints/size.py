"""Size: how large a region may be along its parent's split (Bao et al. 2013, section 5.1, region size)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar

from layoutkit.constraints.attributes import BIAS, MEASURE, REGIONS, attribute, choice
from layoutkit.constraints.claims import Claim, Relates, Sized
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Measure, RegionSet, Violation
from layoutkit.sizing.arrangement import AXIS, Arrangement
from layoutkit.sizing.rules import Range, SizeRule, Target

if TYPE_CHECKING:
    from typing import Self

#: No region gets smaller than this share of its input size.
LEAST_SHARE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Size(Constraint):
    """The width of a column, the height of a row: bounds, and where in them variations begin."""

    kind: ClassVar[str] = "size"
    summary: ClassVar[str] = (
        "The regions' size along their parent's split lies between min and max; variations start from sizes "
        "drawn from a distribution over that range."
    )

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    min: Measure | None = attribute(MEASURE, "Least size, absolute or as a share of the input's.", None)
    max: Measure | None = attribute(MEASURE, "Greatest size, absolute or as a share of the input's.", None)
    centre: Measure = attribute(
        MEASURE,
        "Mean of normal initial sizes, the likeliest of triangular ones.",
        Measure(1.0, relative=True),
        demands=False,
    )
    deviation: Measure = attribute(
        MEASURE,
        "Standard deviation of normal initial sizes; 0 always starts from the centre.",
        Measure(0.05, True),
        demands=False,
    )
    distribution: str = attribute(
        choice("distribution", "normal", "uniform", "triangular"),
        "Of the initial sizes: normal, truncated to the range; uniform or triangular from min to max.",
        "normal",
        demands=False,
    )
    bias: float = attribute(
        BIAS,
        "Moves the centre towards min (below 0, down to -1) or max (above 0, up to 1).",
        0.0,
        demands=False,
    )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, bounds that cross, and distributions that lack an end."""
        unknown = list(unknown_names(self, self.of, facade))
        yield from unknown
        yield from self._undetermined()
        if unknown:
            return
        for path in facade.select(self.of):
            least, most = self.bounds(facade, path)
            if least > most:
                yield Diagnostic(
                    "LK202",
                    f"the least size of {path} is above its greatest: {least:g} > {most:g}",
                    self.place,
                    "exchange min and max, or widen one of them",
                    topic="sizing",
                )

    def _undetermined(self) -> Iterator[Diagnostic]:
        spread = self.distribution != "normal"
        missing = [
            name
            for name, end, needed in (
                ("min", self.min, spread or self.bias < 0),
                ("max", self.max, spread or self.bias > 0),
            )
            if needed and end is None
        ]
        why = f"a {self.distribution} distribution runs from min to max" if spread else "bias moves to an end"
        if missing:
            yield self._unclear(f"{why}, and {' and '.join(missing)} is not given", f"add {missing[0]}")
        if self.distribution == "uniform" and self.bias:
            yield self._unclear("a uniform distribution has no centre that a bias could move", "delete bias")

    def _unclear(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK214", message, self.place, hint, topic="sizing")

    def bounds(self, facade: Facade, path: str) -> tuple[float, float]:
        """Return least and greatest size of the region at `path`; a region never vanishes."""
        size = input_size(facade, path)
        least = max(self.min.of(size) if self.min is not None else 0.0, LEAST_SHARE * size)
        return least, self.max.of(size) if self.max is not None else float("inf")

    def shape(self, facade: Facade, path: str) -> tuple[float, float]:
        """Return centre and standard deviation of a region's initial sizes, truncation aside."""
        size = input_size(facade, path)
        least, most = self.bounds(facade, path)
        if self.distribution == "uniform":
            return (least + most) / 2, (most - least) / math.sqrt(12)
        centre = self.centre.of(size)
        if self.bias:
            centre += abs(self.bias) * ((most if self.bias > 0 else least) - centre)
        if self.distribution == "normal":
            return centre, self.deviation.of(size)
        centre = min(max(centre, least), most)
        spans = (centre - least) ** 2 + (most - centre) ** 2 + (most - least) ** 2
        return centre, math.sqrt(spans / 36)

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield the size of each region."""
        for path, _, (least, most), (centre, deviation) in self._measures(facade):
            yield Sized(path, least, most, centre, deviation)

    def relations(self, facade: Facade) -> tuple[Relates, ...]:
        """Return nothing: a region's own range relates it to no other."""
        return ()

    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        """Return the size of each region."""
        return {path: replace(self, of=RegionSet(path)) for path in facade.select(self.of)}

    def altered(self, **values: Any) -> Self:
        """Return another size: without an end, other distributions than the normal have nowhere to run."""
        if None in (values.get("min", self), values.get("max", self)):
            values = {"distribution": "normal", "bias": 0.0, **values}
        return replace(self, **values)

    @property
    def idle(self) -> bool:
        """Whether it has neither end."""
        return self.min is None and self.max is None

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield a range and a target for each symbol: its occurrences are replicas."""
        for path, axis, (least, most), (centre, deviation) in self._measures(arrangement.facade):
            if path in arrangement.frames:
                form = arrangement.extent(path, axis)
                parent, _, symbol = path.rpartition("/")
                weight = float(arrangement.words[parent].count(symbol)) if parent else 1.0
                yield Range(axis, form, least, most, self, (parent,))
                yield Target(axis, form, centre, deviation, least, most, weight, self.distribution)

    def _measures(
        self, facade: Facade
    ) -> tuple[tuple[str, int, tuple[float, float], tuple[float, float]], ...]:
        """Return path, axis, bounds, centre and deviation of each region."""
        key = (id(self), "measures")
        if key not in facade.memory:
            measures = tuple(
                (path, axis_of(facade, path), self.bounds(facade, path), self.shape(facade, path))
                for path in facade.select(self.of)
            )
            facade.memory[key] = self, measures
        found: tuple[tuple[str, int, tuple[float, float], tuple[float, float]], ...] = facade.memory[key][1]
        return found

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every placed region out of its range."""
        for path in view.facade.select(self.of):
            least, most = self.bounds(view.facade, path)
            axis = axis_of(view.facade, path)
            for placed in view.places(path):
                size = (placed.box.width, placed.box.height)[axis]
                amount = max(least - size, size - most)
                if amount > view.tolerance:
                    allowed = f"between {least:g} and {most:g}" if most < math.inf else f"at least {least:g}"
                    yield Violation(self, placed.path, f"is {size:g}, not {allowed}", amount)


def axis_of(facade: Facade, path: str) -> int:
    """Return the axis that the parent of `path` splits (for the root, and for a face: its own split)."""
    parent = "" if path in facade.faces else path.rpartition("/")[0]
    split = facade.regions[parent or path].split
    return AXIS["rows" if split == "rows" else "columns"]


def input_size(facade: Facade, path: str) -> float:
    """Return the size in the input along the axis that the parent of `path` splits."""
    region = facade.regions[path]
    return (region.width, region.height)[axis_of(facade, path)]
