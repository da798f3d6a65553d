"""The constraint ``spacing:even``: a convex rule, stated to cvxpy."""

from __future__ import annotations

import math
import statistics
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import MEASURE, REGIONS, attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Measure, RegionSet, Violation
from layoutkit.sizing.arrangement import AXIS, Arrangement
from layoutkit.sizing.rules import Convex, Quantity, Rows, SizeRule

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class Even(Constraint):
    """Regions whose distances from one to the next, within each parent, are nearly the same."""

    kind: ClassVar[str] = "even"
    namespace: ClassVar[Namespace] = Namespace("spacing", "urn:example:even-spacings:1")
    summary: ClassVar[str] = (
        "Within each parent, the distances from one region of the set to the next vary little: their "
        "standard deviation is limited."
    )

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    deviation: Measure = attribute(
        MEASURE,
        "Greatest standard deviation of the distances; a percentage is of their mean.",
        Measure(0.1, True),
    )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield names that the facade has not."""
        yield from unknown_names(self, self.of, facade)

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield the children of each region that holds some of the set: the rule relates their sizes."""
        for parent in dict.fromkeys(path.rpartition("/")[0] for path in facade.select(self.of)):
            if parent:
                children = dict.fromkeys(facade.regions[parent].word)
                axis = AXIS[facade.regions[parent].split or "columns"]
                yield axis, tuple(f"{parent}/{symbol}" for symbol in children)

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield, for each region whose word has three or more of the set, a rule on their distances.

        A region's rule hangs on its own word alone: it can be stated as soon as that word is chosen, whatever
        the words still to be chosen are.
        """
        import numpy as np

        members = frozenset(arrangement.facade.select(self.of))
        for parent, word in arrangement.words.items():
            gaps = tuple(_gaps(parent, word, members, arrangement))
            if len(gaps) < 2:
                continue
            if self.deviation.value > 0:
                yield Convex(gaps, self._excess, self, (parent,))
            else:  # exactly even: then it is linear, each distance the same as the next
                steps = np.diff(np.eye(len(gaps)), axis=0)
                none = np.zeros(len(steps))
                yield Rows(gaps, steps, none, none, self, (parent,))

    def _excess(self, gaps: Any) -> Any:
        """Return by how much the deviation is too great: a norm, less what is linear, is convex."""
        from cvxpy.atoms.norm import norm

        count = gaps.shape[0]
        allowed = self.deviation.value * gaps.mean() if self.deviation.relative else self.deviation.value
        return norm(_centring(count) @ gaps) / math.sqrt(count) - allowed

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every placed region within which the distances vary too much."""
        within: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
        for path in view.facade.select(self.of):
            for placed in view.places(path):
                if parent := placed.path.rpartition("/")[0]:
                    axis = AXIS[view.by_path[parent].region.split or "columns"]
                    within[parent].append(view.interval(placed.box, axis))
        for parent, intervals in within.items():
            intervals.sort()
            gaps = [start - end for (_, end), (start, _) in pairwise(intervals)]
            if len(gaps) < 2:
                continue
            found, most = statistics.pstdev(gaps), self.deviation.of(statistics.fmean(gaps))
            if found - most > view.tolerance:
                message = f"its spacings of {self.of} vary by {found:.4g}, not by {most:.4g} at most"
                yield Violation(self, parent, message, found - most)


def _gaps(
    parent: str, word: tuple[str, ...], members: frozenset[str], arrangement: Arrangement
) -> Iterator[Quantity]:
    """Yield the distances between neighbours of the set in a region, as sizing knows them."""
    axis = AXIS[arrangement.facade.regions[parent].split or "columns"]
    places = [index for index, symbol in enumerate(word) if f"{parent}/{symbol}" in members]
    for one, other in pairwise(places):
        yield Quantity(axis, arrangement.run(parent, one + 1, other))


def _centring(count: int) -> NDArray[np.float64]:
    """Return the matrix that takes the mean off `count` numbers."""
    import numpy as np

    centring: NDArray[np.float64] = np.eye(count) - 1.0 / count
    return centring
