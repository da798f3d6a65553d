"""The count stage: how many arrangements a facade has at a size."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Count, Facade, Measure

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend

#: Programs solved, about, before the rest is left as a bound.
EFFORT = 20_000
#: Words tried to tell which soft constraints can be kept.
NODE_LIMIT = 2000


@dataclass(frozen=True)
class CountOptions:
    """Options of the count stage.

    Attributes
    ----------
    width, height
        The size in question, absolute or a percentage of the input's.
    effort
        What may be spent: programs solved, about. What is then not decided is left as a bound.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    width: Measure = field(default=Measure(1.0, relative=True))
    height: Measure = field(default=Measure(1.0, relative=True))
    effort: int = EFFORT
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class CountArrangements(Stage):
    """Counts the arrangements of which layouts exist that keep all constraints."""

    name: ClassVar[str] = "count"
    summary: ClassVar[str] = "Counts the arrangements that a facade has at a size."
    options: ClassVar[type] = CountOptions

    def run(self, facade: Facade, options: CountOptions) -> Iterator[Outcome]:
        """Yield one outcome, with the count: ``infeasible`` if it is 0, ``limit`` if it is not exact."""
        from layoutkit.sizing.threads import single_threaded

        with single_threaded():
            yield _outcome(facade, options)


def _outcome(facade: Facade, options: CountOptions) -> Outcome:
    from layoutkit_relayout.counting.counted import counted
    from layoutkit_relayout.search.wishes import granted
    from layoutkit_relayout.stage import layout_size, left_out, too_many
    from layoutkit_relayout.words.machine import TooManyStates

    start = time.perf_counter()
    size = layout_size(facade, options.width, options.height)
    try:
        wishes = granted(facade, size, options.backends, NODE_LIMIT)
        count = counted(wishes.search, options.effort)
        remarks = tuple(left_out(wishes))
    except TooManyStates as error:
        count, remarks = Count(size, 0, None, str(error)), (too_many(error),)
    seconds = time.perf_counter() - start
    if count.kind != "exact":
        remarks = (*remarks, _bounded(count.explanation))
        return Outcome("limit", None, remarks, seconds, count=count)
    return Outcome("found" if count.least else "infeasible", None, remarks, seconds, count=count)


def _bounded(reason: str) -> Diagnostic:
    return Diagnostic(
        "LK604",
        f"the number of arrangements is not exact: {reason}",
        hint="a greater effort may tell; regions that are coupled by alignments may take too much of it",
        severity=Severity.NOTE,
        topic="search",
    )
