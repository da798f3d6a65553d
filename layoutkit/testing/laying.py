"""Layouts that keep rules on sizes, as the solver finds them; drawn to all sides, and to the ends of rows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from layoutkit.constraints.size import axis_of, input_size
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.joint import drawn_together, joined, parted, scale_of
from layoutkit.sizing.rules import BOTH, Aligned, Convex, Range, Rows, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, Drawn, size_axis
from layoutkit.testing.sampling import Sample, Size, sample

#: Every region keeps to these shares of its input size, so that layouts look like some.
_LEAST, _MOST = 0.2, 4.0
#: So many programs may be solved for one layout.
_PROGRAMS = 60
#: By how much a row is missed on purpose, as a share of the size of the layout.
GAP = 0.01


def laid_out(
    arrangement: Arrangement, rules: Sequence[SizeRule], size: Size, rng: np.random.Generator
) -> Sample | None:
    """Return a layout that keeps rules, its sizes near to chance ones; None where none is found."""
    loose = list(_loose(arrangement))
    own = [*rules, *loose, *arrangement.tilings, *_targets(arrangement, size)]
    axes = tuple(_axis(n, arrangement, own, size) for n in (0, 1))
    pulled = drawn_together([_pulled(axis, rng) for axis in axes])
    across = [rule for rule in own if rule.axis == BOTH]
    pair = axes[0], axes[1]
    sized = size_axis(joined(pair, across, size), scale_of(size), pulled, BACKENDS, Budget(_PROGRAMS))
    values = parted(sized, pair)
    return None if values is None else sample(arrangement, values)


def _axis(number: int, arrangement: Arrangement, rules: Sequence[SizeRule], size: Size) -> Axis:
    likely = arrangement.nominal(number, size[number], lambda path: input_size(arrangement.facade, path))
    own = [rule for rule in rules if rule.axis == number]
    return Axis(number, arrangement.variables[number], own, (np.array(likely),))


def _loose(arrangement: Arrangement) -> Iterator[Range]:
    for path, frame in arrangement.frames.items():
        source = arrangement.facade.regions[path]
        for axis, own in enumerate((source.width, source.height)):
            yield Range(axis, frame.extent[axis], _LEAST * own, _MOST * own, None)


def _targets(arrangement: Arrangement, size: Size) -> Iterator[Target]:
    facade = arrangement.facade
    for path, frame in arrangement.frames.items():
        if "/" in path:
            axis, own = axis_of(facade, path), input_size(facade, path)
            yield Target(axis, frame.extent[axis], own, own, 0.0, size[axis])


def _pulled(axis: Axis, rng: np.random.Generator) -> Drawn:
    centres = np.array([target.centre for target in axis.targets])
    return Drawn(centres * np.exp(0.5 * rng.normal(size=len(centres))), 1 / np.maximum(centres, 1e-9) ** 2)


def single_rows(rules: Iterable[SizeRule]) -> list[SizeRule]:
    """Return the rules with every row as a rule of its own."""
    found: list[SizeRule] = []
    for rule in rules:
        if isinstance(rule, Rows):
            each = zip(rule.matrix, rule.least, rule.most, strict=True)
            found += [
                replace(rule, matrix=r[None], least=np.array([a]), most=np.array([b])) for r, a, b in each
            ]
        else:
            found.append(rule)
    return found


def at_ends(rules: Sequence[SizeRule]) -> Iterator[list[SizeRule]]:
    """Yield the rules again and again, each time with one row held at one of its ends.

    Parameters
    ----------
    rules
        As `single_rows` returns them.
    """
    for number, row in enumerate(rules):
        if isinstance(row, Range | Rows):
            least, most = _ends(row)
            for end in (least, most) if least < most else ():
                if np.isfinite(end):
                    yield [*rules[:number], _between(row, end, end), *rules[number + 1 :]]


def beyond_ends(rules: Sequence[SizeRule], gap: float) -> Iterator[list[SizeRule]]:
    """Yield the rules again and again, each time with one row missed, beyond one of its ends.

    Parameters
    ----------
    rules
        As `single_rows` returns them.
    gap
        By how much it is missed at least, for a row whose factors add up to 1.
    """
    for number, row in enumerate(rules):
        if isinstance(row, Range | Rows):
            (least, most), far = _ends(row), gap * _factors(row)
            for low, high in ((most + far, np.inf), (-np.inf, least - far)):
                if np.isfinite(low) or np.isfinite(high):
                    yield [*rules[:number], _between(row, low, high), *rules[number + 1 :]]


def without_bends(rules: Sequence[SizeRule]) -> Iterator[list[SizeRule]]:
    """Yield the rules again and again, each time without one convex rule, or one alignment."""
    for number, rule in enumerate(rules):
        if isinstance(rule, Convex | Aligned):
            yield [*rules[:number], *rules[number + 1 :]]


def _ends(row: Range | Rows) -> tuple[float, float]:
    return (row.least, row.most) if isinstance(row, Range) else (float(row.least[0]), float(row.most[0]))


def _between(row: Range | Rows, least: float, most: float) -> SizeRule:
    if isinstance(row, Range):
        return replace(row, least=least, most=most)
    return replace(row, least=np.array([least]), most=np.array([most]))


def _factors(row: Range | Rows) -> float:
    if isinstance(row, Range):
        return sum(map(abs, row.form.values()))
    return float(np.abs(row.matrix).sum())
