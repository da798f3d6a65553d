"""The relayout stage: variations of a facade at a given size."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Facade, Layout, Measure

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend
    from layoutkit_relayout.explanation.refusal import Refusal
    from layoutkit_relayout.sampling.sampling import Sampling
    from layoutkit_relayout.search.search import Found
    from layoutkit_relayout.search.wishes import Granted

#: Words tried for one variation before the search gives up.
NODE_LIMIT = 2000
#: What explaining may cost where there is no variation: about a second.
EFFORT = 60_000


@dataclass(frozen=True)
class RelayoutOptions:
    """Options of the relayout stage.

    Attributes
    ----------
    count
        How many variations.
    first
        Index of the first one: variation k of a seed is the same whichever others are made.
    width, height
        Target size, absolute or a percentage of the input's.
    seed
        Start of all random choices.
    sampling
        Which arrangements they have: ``weighted``, likely ones; ``uniform``, each that exists equally often;
        ``diverse``, such as are far from each other, of which more are drawn than are taken.
    node_limit
        Words tried for one variation before the search gives up.
    effort
        What it may cost to tell why there is no variation: each search, and each word tried in it, as much as
        the input has regions.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    count: int = 8
    first: int = 0
    width: Measure = field(default=Measure(1.0, relative=True))
    height: Measure = field(default=Measure(1.0, relative=True))
    seed: int = 0
    sampling: Sampling = "weighted"
    node_limit: int = NODE_LIMIT
    effort: int = EFFORT
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class Relayout(Stage):
    """Lays a facade out anew (Bao, Schwarz and Wonka 2013, section 7)."""

    name: ClassVar[str] = "relayout"
    summary: ClassVar[str] = "Makes variations of a facade that keep its constraints."
    options: ClassVar[type] = RelayoutOptions

    def run(self, facade: Facade, options: RelayoutOptions) -> Iterator[Outcome]:
        """Yield `count` outcomes in the order of their index, every layout checked.

        Parameters
        ----------
        facade
            With its constraints; without any, terminals keep to the default sizes and words to the input's.
        """
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_relayout.words.machine import TooManyStates

        made = 0
        with single_threaded():
            try:
                for outcome in self._variations(facade, options):
                    yield outcome
                    made += 1
            except TooManyStates as error:
                for _ in range(options.count - made):
                    yield Outcome("limit", None, (too_many(error),))

    def _variations(self, facade: Facade, options: RelayoutOptions) -> Iterator[Outcome]:
        from layoutkit_relayout.explanation.judge import Judge
        from layoutkit_relayout.explanation.refusal import refusal
        from layoutkit_relayout.sampling.sampling import SAMPLERS
        from layoutkit_relayout.search.wishes import granted

        start = time.perf_counter()
        size = layout_size(facade, options.width, options.height)
        found_out = granted(facade, size, options.backends, options.node_limit)
        sampler, remarks = SAMPLERS[options.sampling](found_out.search), tuple(left_out(found_out))
        refusals: dict[tuple[str, int], Refusal] = {}
        for index in range(options.first, options.first + options.count):
            found = sampler.variation(options.seed, index, options.node_limit)
            seconds = time.perf_counter() - start
            if found.root is None:
                if remark := _told(found):
                    yield Outcome(found.status, None, remark, seconds)
                else:
                    # Others that fail as far on fail for the same reason; what is told hangs on no other.
                    key = (found.status, found.nodes if found.status == "limit" else 0)
                    if key not in refusals:
                        judge = Judge(facade, size, options.seed, options.effort, options.backends)
                        refusals[key] = refusal(judge, found)
                    why = refusals[key]
                    yield Outcome(found.status, None, why.diagnostics, seconds, why.explanation)
            else:
                layout = Layout(
                    f"{facade.name}-{index + 1}",
                    facade.units,
                    found.root,
                    facade,
                    seed=options.seed,
                    index=index,
                    mass=None if facade.building is None else facade.building.mass,
                )
                yield _with((*remarks, *_told(found)), _checked(layout, seconds))
                remarks = ()
            start = time.perf_counter()


def left_out(found: Granted) -> Iterator[Diagnostic]:
    """Yield a note of every soft constraint that no layout of this size keeps."""
    for constraint in found.refused:
        yield Diagnostic(
            "LK603",
            f"this soft constraint cannot be kept at this size: {constraint}",
            constraint.place,
            "it gives way to the hard ones and to soft ones of greater weight",
            Severity.NOTE,
            "search",
        )
    for constraint in found.undecided:
        yield Diagnostic(
            "LK603",
            f"this soft constraint is left out, as no layout with it was found in time: {constraint}",
            constraint.place,
            "raise the node limit",
            Severity.NOTE,
            "search",
        )


def _with(remarks: tuple[Diagnostic, ...], outcome: Outcome) -> Outcome:
    return replace(outcome, diagnostics=(*remarks, *outcome.diagnostics))


def layout_size(facade: Facade, width: Measure, height: Measure) -> tuple[float, float]:
    """Return width and height of layouts: what is asked for; a building's mass gives its own."""
    if facade.faces:
        return max(box.x1 for box in facade.faces.values()), max(box.y1 for box in facade.faces.values())
    return width.of(facade.root.width), height.of(facade.root.height)


def _checked(layout: Layout, seconds: float) -> Outcome:
    broken = layout.violations()
    if not broken:
        return Outcome("found", layout, (), seconds)
    first = broken[0]
    about = Diagnostic(
        "LK901",
        f"the search made a layout that breaks {len(broken)} rules; it is dropped",
        hint="this is a fault of layoutkit: please report it with the document",
        topic="search",
        details=(f"{first.path}: {first.message} ({first.constraint or 'rule of every layout'})",),
    )
    return Outcome("limit", None, (about,), seconds)


def too_many(error: Exception) -> Diagnostic:
    """Return what is to be said of sequences that are too many to search."""
    return Diagnostic(
        "LK601",
        f"the sequences of a region are too many to search: {error}",
        hint="write fewer or shorter sequences: long runs of sets multiply what has to be kept in mind",
        topic="search",
    )


def _told(found: Found) -> tuple[Diagnostic, ...]:
    """Return what there is to say of an even draw."""
    from layoutkit_relayout.sampling.sampling import Told

    if not isinstance(found, Told) or not found.remark:
        return ()
    if found.root is not None:
        return (Diagnostic("LK604", found.remark, severity=Severity.NOTE, topic="search"),)
    return (
        Diagnostic(
            "LK605",
            f"no variation was drawn evenly: {found.remark}",
            hint="vary with --sampling weighted or diverse, or at another size",
            topic="search",
        ),
    )
