"""The audit stage: semantic faults of a facade, told without making layouts of it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Facade, Layout

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend
    from layoutkit_relayout.model import Model

#: What searches may cost where the input is no layout: a fraction of a second.
EFFORT = 1_000


@dataclass(frozen=True)
class AuditOptions:
    """Options of the audit stage.

    Attributes
    ----------
    effort
        What it may cost to tell whether there is a layout of the facade's own size, where the input itself is
        none: each search, and each word tried in it, as much as the input has regions. What cannot be told
        within it is not told.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    effort: int = EFFORT
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class Audit(Stage):
    """Finds constraints that no layout keeps, such as none can activate, and regions out of reach."""

    name: ClassVar[str] = "audit"
    summary: ClassVar[str] = "Finds constraints that contradict each other, or that no layout can activate."
    options: ClassVar[type] = AuditOptions

    def run(self, facade: Facade, options: AuditOptions) -> Iterator[Outcome]:
        """Yield one outcome: what is wrong with a facade that has no faults of structure.

        All that is told is proved. Errors say that there is no layout of any size.
        """
        from layoutkit.sizing.threads import single_threaded

        start = time.perf_counter()
        with single_threaded():
            found = tuple(_audited(facade, options))
        yield Outcome("found", None, found, time.perf_counter() - start)


def _audited(facade: Facade, options: AuditOptions) -> Iterator[Diagnostic]:
    from layoutkit.constraints.defaults import effective_constraints
    from layoutkit_relayout.auditing.idle import idle, out_of_reach
    from layoutkit_relayout.auditing.labels import nearly_named
    from layoutkit_relayout.auditing.spelling import Spelling
    from layoutkit_relayout.model import Model

    model = Model(facade, [c for c in effective_constraints(facade) if not c.soft])
    if _keeps_all(facade):
        # The input is a layout itself: then there is one, of its own size, that has every region in it.
        spelling = Spelling(model, frozenset(facade.regions))
    else:
        spelling = Spelling(model)
        yield from _refuted(model, options)
        yield from out_of_reach(spelling)
    yield from idle(spelling)
    yield from nearly_named(facade)


def _keeps_all(facade: Facade) -> bool:
    """Tell whether the input keeps all hard constraints."""
    return facade.building is None and not Layout(facade.name, facade.units, facade.root, facade).violations()


def _refuted(model: Model, options: AuditOptions) -> Iterator[Diagnostic]:
    """Yield what no layout keeps, of any size; or else of the facade's own."""
    from layoutkit_relayout.auditing.impossible import faults
    from layoutkit_relayout.auditing.own_size import own_size
    from layoutkit_relayout.auditing.prospects import Prospects

    prospects = Prospects(model)
    found = faults(prospects)
    yield from found
    if not found:  # else the size is not why
        yield from own_size(prospects, options.effort, options.backends)
