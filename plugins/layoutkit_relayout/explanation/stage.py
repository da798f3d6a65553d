"""The explain stage: a layout that shows that there is one, or why there is none."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Facade, Measure

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend
    from layoutkit_relayout.explanation.judge import Judge

#: Words tried to tell whether there is a layout.
NODE_LIMIT = 2000


@dataclass(frozen=True)
class ExplainOptions:
    """Options of the explain stage.

    Attributes
    ----------
    width, height
        The size in question, absolute or a percentage of the input's.
    seed
        Start of the random choices in the layouts that are shown.
    node_limit
        Words tried to tell whether there is a layout; what comes after takes a like effort.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    width: Measure = field(default=Measure(1.0, relative=True))
    height: Measure = field(default=Measure(1.0, relative=True))
    seed: int = 0
    node_limit: int = NODE_LIMIT
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class Explain(Stage):
    """Tells which constraints cannot hold together at a size, by how much they miss, and what would help."""

    name: ClassVar[str] = "explain"
    summary: ClassVar[str] = "Tells why a facade has no layout at a size, or shows one."
    options: ClassVar[type] = ExplainOptions

    def run(self, facade: Facade, options: ExplainOptions) -> Iterator[Outcome]:
        """Yield one outcome: a layout that was found, or an explanation of why there is none."""
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_relayout.explanation.judge import Judge
        from layoutkit_relayout.stage import layout_size

        start = time.perf_counter()
        size = layout_size(facade, options.width, options.height)
        with single_threaded():
            yield _outcome(
                Judge(facade, size, options.seed, backends=options.backends), options.node_limit, start
            )


def _outcome(judge: Judge, node_limit: int, start: float) -> Outcome:
    from layoutkit_relayout.explanation.best_effort import as_layout
    from layoutkit_relayout.explanation.explaining import explained
    from layoutkit_relayout.explanation.report import diagnostics, too_small, undecided

    facade = judge.facade
    verdict = judge.first(node_limit)
    if verdict.root is not None:
        layout = as_layout(facade, verdict.root, "witness", judge.seed)
        return Outcome("found", layout, (), time.perf_counter() - start)
    explanation = explained(judge)
    found = diagnostics(explanation, facade)
    if verdict.status == "limit":
        found = (undecided(facade, judge.size, verdict.nodes),)
    elif not found:
        found = (too_small(explanation, facade),)
    return Outcome(verdict.status, None, found, time.perf_counter() - start, explanation)
