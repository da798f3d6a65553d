"""What holds where no constraint says otherwise: default sizes, and the input's words."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.sequence import Sequence
from layoutkit.constraints.size import Size, axis_of
from layoutkit.model import Facade, Measure, Region, RegionSet
from layoutkit.sizing.arrangement import AXIS

#: A region without a size constraint keeps to these shares of its input size (Bao et al. 2013, section 5.1:
#: "bounds at a fixed fraction from the center").
DEFAULT_LEAST, DEFAULT_MOST, DEFAULT_DEVIATION = 0.5, 2.0, 0.1


def default_sizes(facade: Facade) -> tuple[Size, ...]:
    """Return a size constraint for every region that has none and that nothing inside divides.

    Such are all terminals, and a bay of rows in a floor of columns; a floor's height, on the other hand,
    comes from what is inside.
    """
    sized = {path for c in facade.constraints if isinstance(c, Size) for path in facade.select(c.of)}
    return tuple(
        Size(
            of=RegionSet(path),
            min=Measure(DEFAULT_LEAST, relative=True),
            max=Measure(DEFAULT_MOST, relative=True),
            deviation=Measure(DEFAULT_DEVIATION, relative=True),
            comment="default size",
        )
        for path, region in facade.regions.items()
        if "/" in path and path not in sized and not divided(region, axis_of(facade, path))
    )


def divided(region: Region, axis: int) -> bool:
    """Tell whether some region inside is split along the axis."""
    if region.split is None:
        return False
    return AXIS[region.split] == axis or any(divided(child, axis) for child in region.children)


def effective_constraints(facade: Facade) -> tuple[Constraint, ...]:
    """Return the facade's constraints, and those that hold by default."""
    return (*facade.constraints, *default_sizes(facade))


def replicated(facade: Facade) -> Iterator[str]:
    """Yield the composite regions that no sequence speaks of: they keep the input's word."""
    spoken = {path for c in facade.constraints if isinstance(c, Sequence) for path in c.within}
    yield from (path for path, region in facade.regions.items() if region.split and path not in spoken)
