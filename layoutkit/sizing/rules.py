"""Rules on sizes, as linear forms over the variables of an axis; or as what relates such forms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from layoutkit.sizing.arrangement import Slot
    from layoutkit.sizing.qp import Floats

#: A linear form: variable to factor. Positions run in reading direction: right, or down.
Form = Mapping[int, float]
#: The variable that is the facade's own extent, and the one that is always 1.
SIZE, UNIT = 0, -1
#: The axis of rules that relate sizes or places of x to such of y.
BOTH = 2


@dataclass(frozen=True, slots=True)
class Range:
    """`least` ≤ form ≤ `most`; equal ends make it an equality.

    Attributes
    ----------
    axis
        0 for x (lines of columns), 1 for y (lines of rows, counted down from the top).
    origin
        The constraint that asks for it.
    words
        Paths of the composite regions on whose words the row hangs, beside those of all that they lie in;
        None: on every word. The search goes back to these words where the row cannot hold.
    """

    axis: int
    form: Form
    least: float
    most: float
    origin: Any
    words: tuple[str, ...] | None = None


@dataclass(frozen=True, slots=True)
class Target:
    """The form should be near a value that is drawn for each variation.

    Attributes
    ----------
    centre, deviation, least, most
        The distribution's mean (the mode, if it is triangular), standard deviation and ends; a deviation of 0
        always gives the centre.
    weight
        Factor of the squared distance in the objective.
    distribution
        ``normal``, truncated to the ends; ``uniform`` or ``triangular`` from end to end.
    """

    axis: int
    form: Form
    centre: float
    deviation: float
    least: float
    most: float
    weight: float = 1.0
    distribution: str = "normal"


@dataclass(frozen=True, slots=True)
class Aligned:
    """Wherever a region of `first` and one of `second` overlap along the axis, their lines coincide.

    Attributes
    ----------
    lines
        The lines, as shares of the regions' extents: 0 the start, 0.5 the centre, 1 the end.
    """

    axis: int
    first: tuple[Slot, ...]
    second: tuple[Slot, ...]
    lines: tuple[float, ...]
    origin: Any


@dataclass(frozen=True, slots=True)
class Quantity:
    """A size or a place along one axis: what `Rows` and `Convex` speak of."""

    axis: int
    form: Form


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """`least` ≤ matrix @ quantities ≤ `most`, row by row, in document units.

    Attributes
    ----------
    quantities
        n sizes or places, of one axis or of both.
    matrix
        An array of m × n.
    least, most
        Arrays of m; infinite where a row has no such end.
    origin
        The constraint that asks for it.
    words
        As for `Range`.
    """

    quantities: tuple[Quantity, ...]
    matrix: Floats
    least: Floats
    most: Floats
    origin: Any
    words: tuple[str, ...] | None = None

    @property
    def axis(self) -> int:
        """The axis of all its quantities, or `BOTH`."""
        return axis_of(self.quantities)


@dataclass(frozen=True, slots=True, eq=False)
class Convex:
    """A convex function of some quantities is at most 0.

    Attributes
    ----------
    excess
        Given the quantities, a cvxpy expression of n entries in document units, it returns one that is convex
        in them (a scalar, or a vector of which each entry is to be at most 0).
    origin, words
        As for `Range`.
    """

    quantities: tuple[Quantity, ...]
    excess: Callable[[Any], Any]
    origin: Any
    words: tuple[str, ...] | None = None

    @property
    def axis(self) -> int:
        """The axis of all its quantities, or `BOTH`."""
        return axis_of(self.quantities)


def axis_of(quantities: Sequence[Quantity]) -> int:
    """Return the axis that quantities share, or `BOTH`."""
    axes = {quantity.axis for quantity in quantities}
    return axes.pop() if len(axes) == 1 else BOTH


SizeRule = Range | Target | Aligned | Rows | Convex
