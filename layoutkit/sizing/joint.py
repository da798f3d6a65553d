"""Both axes as one, for rules that relate widths to heights: their variables behind one another.

Widths and heights are sized apart as long as nothing relates them. Where a rule does, one program over the
variables of both is stated, in units of the greater of the two sizes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from layoutkit.sizing.answers import ranges_of
from layoutkit.sizing.arrangement import Slot
from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import (
    SIZE,
    UNIT,
    Aligned,
    Convex,
    Form,
    Quantity,
    Range,
    Rows,
    SizeRule,
    Target,
)
from layoutkit.sizing.solve import Axis, Drawn, Sized

Pair = tuple[Floats, Floats]


def joined(axes: tuple[Axis, Axis], across: Sequence[SizeRule], size: tuple[float, float]) -> Axis:
    """Return both axes as one.

    Its first variable is the scale, `scale_of` the size; those of x follow, then those of y. Its targets are
    those of x, then those of y.

    Parameters
    ----------
    across
        Rules that relate quantities of both.
    size
        Width and height of the layout: their ratio is part of the rules.
    """
    first, second = axes
    slots: dict[int, Slot] = {}
    rules = [_moved(rule, axis, axes, slots) for axis in axes for rule in axis.rules]
    rules += [_moved(rule, first, axes, slots) for rule in across]
    scale = scale_of(size)
    for axis, own in zip(axes, size, strict=True):
        given = {_variable(SIZE, axis.number, axes): 1.0, SIZE: -own / scale}
        rules.append(Range(0, given, 0.0, 0.0, None, ()))
    nominals = [
        np.concatenate([[scale], one[:-1], other[:-1], [1.0]])
        for one, other in zip(first.nominals, second.nominals, strict=True)
    ]
    return Axis(0, 1 + first.count + second.count, _stated(rules), nominals)


def scale_of(size: tuple[float, float]) -> float:
    """Return the size of the joint axis."""
    return max(size)


def drawn_together(drawn: Sequence[Drawn]) -> Drawn:
    """Return what is drawn for both axes as one."""
    return Drawn(np.concatenate([d.sizes for d in drawn]), np.concatenate([d.weights for d in drawn]))


def parted(sized: Sized, axes: tuple[Axis, Axis]) -> Pair | None:
    """Return the values of the variables of each axis, and 1 behind them."""
    if sized.values is None:
        return None
    middle = 1 + axes[0].count
    return np.append(sized.values[1:middle], 1.0), sized.values[middle:]


def _stated(rules: Sequence[SizeRule]) -> list[SizeRule]:
    """Return rules with all rows as ranges."""
    return [own for rule in rules for own in (ranges_of(rule) if isinstance(rule, Rows) else (rule,))]


def _moved(rule: SizeRule, axis: Axis, axes: tuple[Axis, Axis], slots: dict[int, Slot]) -> SizeRule:
    """Return a rule over the joint variables."""
    if isinstance(rule, Rows | Convex):
        own = tuple(Quantity(0, _shifted(q.form, q.axis, axes)) for q in rule.quantities)
        return replace(rule, quantities=own)
    if isinstance(rule, Range | Target):
        return replace(rule, axis=0, form=_shifted(rule.form, axis.number, axes))
    for slot in (*rule.first, *rule.second):
        ends = (_shifted(form, axis.number, axes) for form in (slot.start, slot.end))
        slots.setdefault(id(slot), Slot(slot.symbol_path, slot.parent, slot.order, *ends))
    first, second = (tuple(slots[id(slot)] for slot in side) for side in (rule.first, rule.second))
    return Aligned(0, first, second, rule.lines, rule.origin)


def _shifted(form: Form, axis: int, axes: tuple[Axis, Axis]) -> Form:
    return {_variable(variable, axis, axes): factor for variable, factor in form.items()}


def _variable(variable: int, axis: int, axes: tuple[Axis, Axis]) -> int:
    if variable == UNIT:
        return UNIT
    return 1 + variable + (axes[0].count if axis == 1 else 0)
