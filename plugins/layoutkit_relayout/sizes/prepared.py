"""An arrangement made ready to be sized again and again: its rules, axis by axis."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np

from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.joint import joined
from layoutkit.sizing.rules import BOTH, Range, SizeRule
from layoutkit.sizing.solve import Axis
from layoutkit_relayout.model import Floats, Model
from layoutkit_relayout.sizes.differing import Twins, twins
from layoutkit_relayout.sizes.draws import Distributions


class Prepared:
    """What is known of an arrangement; all of it is worked out when it is asked for, and kept.

    Parameters
    ----------
    size
        Width and height of the layout, in document units.
    """

    def __init__(self, model: Model, arrangement: Arrangement, size: tuple[float, float]) -> None:
        self.model, self.arrangement, self.size = model, arrangement, size
        self._joined: tuple[tuple[float, float], Axis] | None = None

    @cached_property
    def axes(self) -> tuple[Axis, Axis]:
        """The rules on x, and those on y."""
        rules, count = self._rules, self.arrangement.variables
        one, other = (
            Axis(n, count[n], [r for r in rules if r.axis == n], (self._by_centres(n), self.nominal[n]))
            for n in (0, 1)
        )
        return one, other

    @cached_property
    def across(self) -> tuple[SizeRule, ...]:
        """The rules that relate x to y."""
        return tuple(rule for rule in self._rules if rule.axis == BOTH)

    def joined(self, size: tuple[float, float]) -> Axis:
        """Return both axes as one, for layouts of a size; kept until another size is asked for."""
        if self._joined is None or self._joined[0] != size:
            self._joined = size, joined(self.axes, self.across, size)
        return self._joined[1]

    @cached_property
    def _rules(self) -> list[SizeRule]:
        return size_rules(self.model, self.arrangement)

    @cached_property
    def distributions(self) -> tuple[Distributions, Distributions]:
        """What the sizes of each axis are drawn from."""
        return Distributions(self.axes[0].targets), Distributions(self.axes[1].targets)

    @cached_property
    def twins(self) -> tuple[Twins, ...]:
        """The instances that have to differ, and can do so in a size alone."""
        return tuple(twins(self.arrangement, self.model.demands))

    @cached_property
    def nominal(self) -> tuple[Floats, Floats]:
        """The value of each variable where every region has its share of its parent, by what is inside it."""
        natural = self._natural()
        one, other = (
            np.array(self.arrangement.nominal(n, self.size[n], natural.__getitem__)) for n in (0, 1)
        )
        return one, other

    def _by_centres(self, axis: int) -> Floats:
        """Return the value of each variable where every region has its share by its likeliest size."""
        return np.array(self.arrangement.nominal(axis, self.size[axis], self.model.centre))

    def _natural(self) -> Mapping[str, float]:
        """Return the likeliest size of each region along its parent's split: the sum of what is inside it."""
        inside: dict[str, list[float]] = {}
        found: dict[str, float] = {}
        for path in reversed(self.arrangement.frames):  # children stand after their parents
            parent = path.rpartition("/")[0]
            axis = self.model.axis(parent) if parent else 0
            own = inside.get(path, [0.0, 0.0])[axis]
            found[path] = size = self.model.within(path, own) if own else self.model.centre(path)
            if not parent:
                continue
            sums = inside.setdefault(parent, [0.0, 0.0])
            sums[axis] += size * self.arrangement.words[parent].count(path.rpartition("/")[2])
            across = inside.get(path, [0.0, 0.0])[1 - axis]
            sums[1 - axis] = max(sums[1 - axis], across)
        return found


def size_rules(model: Model, arrangement: Arrangement) -> list[SizeRule]:
    """Return all rules on an arrangement's sizes."""
    found: list[SizeRule] = [r for c in model.constraints for r in size_rules_of(c, arrangement)]
    for path in arrangement.frames:
        if path in model.group_of and path not in arrangement.words:
            axis = model.axis(path)
            low, high = model.hull(path, axis)
            parent = path.rpartition("/")[0]
            found.append(Range(axis, arrangement.extent(path, axis), low, high, None, (parent,)))
    return [*found, *arrangement.tilings]
