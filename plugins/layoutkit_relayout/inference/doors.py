"""Frequencies: a house has the doors it has."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.constraints import Frequency
from layoutkit.model import Facade, Measure, RegionSet
from layoutkit_relayout.inference.lockstep import locksteps

#: Up to so many doors a facade keeps their number; more of them grow with the width.
FEW_DOORS = 2


def doors(facade: Facade) -> Iterator[Frequency]:
    """Yield the range of the number of doors, in each floor that has some."""
    if "Door" not in facade.labels:
        return
    for path in (path for lockstep in locksteps(facade) for path in lockstep.paths):
        first = facade.places[path][0].path
        paths = facade.select(RegionSet("@Door"), path)
        count = sum(p.path.startswith(f"{first}/") for inner in paths for p in facade.places[inner])
        if 0 < count <= FEW_DOORS:
            least, most = Measure(float(count)), Measure(float(count))
        elif count:
            least, most = Measure(0.5, relative=True), Measure(1.5, relative=True)
        else:
            continue
        comment = "one door" if count == 1 else f"{count} doors in the input"
        yield Frequency(of=RegionSet("@Door"), within=path, min=least, max=most, comment=comment)
