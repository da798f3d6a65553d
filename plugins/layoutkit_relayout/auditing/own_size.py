"""Whether there is a layout of the facade's own size, where there may be some of others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import Facade
from layoutkit.model.conflict import Amount
from layoutkit.sizing.qp import Backend
from layoutkit_relayout.auditing.blame import Suspects, lines, places
from layoutkit_relayout.auditing.prospects import Prospects
from layoutkit_relayout.auditing.spelling import Spelling
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.conflict import Parts
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.refusal import refusal
from layoutkit_relayout.search.search import Search
from layoutkit_relayout.words.machine import TooManyStates

#: Shares of the size that may be rounding.
_ROUNDING = 1e-5
#: Moves of all machines together, instances under names of their own, beyond which words take too long.
_MOVES = 2_000
#: Words tried at most before there is anything to explain.
_WORDS = 10
_OPTIONS, _WIDE = ("--width", "--height"), ("wide", "high")


def own_size(prospects: Prospects, effort: int, backends: Sequence[Backend]) -> Iterator[Diagnostic]:
    """Yield why no layout has the facade's own size; nothing where that is not proved.

    Parameters
    ----------
    prospects
        Of a facade that may have layouts.
    effort
        What it may cost to prove and to explain that there is none: see `Effort`.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """
    if not prospects.tractable:
        return
    told = list(_out_of_range(prospects))
    yield from told or _refused(prospects, effort, backends)


def _out_of_range(prospects: Prospects) -> Iterator[Diagnostic]:
    """Yield, for each axis, that sizes add up to more, or to less, than the facade's own."""
    for axis in (0, 1):
        if missed := _missed(prospects, axis):
            facade = prospects.facade
            parts = Suspects(facade).at_fault(partial(_shows, axis, missed), facade.root.symbol)
            yield _told(facade, axis, missed, parts)


def _missed(prospects: Prospects, axis: int) -> float:
    """Return how far all layouts are above the facade's own size, or below it (negative); else 0."""
    size = (prospects.facade.root.width, prospects.facade.root.height)[axis]
    low, high = prospects.model.hull(prospects.facade.root.symbol, axis)
    nearest = low if low > size * (1 + _ROUNDING) else high if high < size * (1 - _ROUNDING) else size
    return nearest - size


def _shows(axis: int, missed: float, prospects: Prospects) -> bool:
    """Tell whether some constraints alone keep layouts off the facade's own size, to the same side."""
    return prospects.tractable and _missed(prospects, axis) * missed > 0


def _told(facade: Facade, axis: int, missed: float, parts: Parts) -> Diagnostic:
    size, bound = (facade.root.width, facade.root.height)[axis], "at least" if missed > 0 else "at most"
    own, near = wording.length(size, facade), wording.length(size + missed, facade)
    short, related = Amount(abs(missed), facade.units), places(facade, parts)
    return Diagnostic(
        "LK227",
        f"no layout has the facade's own size, {own} {_WIDE[axis]}: each is {bound} {near} {_WIDE[axis]}",
        related[0] if related else None,
        f"ask for {near} ({_OPTIONS[axis]}), or make up for the {wording.amount(short, facade)}",
        Severity.WARNING,
        "semantics",
        lines(facade, parts, (short,)),
        related if len(related) > 1 else (),
    )


def _refused(prospects: Prospects, effort: int, backends: Sequence[Backend]) -> Iterator[Diagnostic]:
    """Yield a conflict at the facade's own size, where a short search proves that there is one."""
    facade, size = prospects.facade, (prospects.facade.root.width, prospects.facade.root.height)
    price = sum(map(len, facade.places.values()))
    spelling = Spelling(prospects.model.at(size))
    if not spelling.tractable(facade.root.symbol) or spelling.moves > _MOVES:
        return
    try:
        search = Search(prospects.model, size, backends)
        search.programs = 0
        found = search.variation(0, 0, max(1, min(_WORDS, effort // price)))
    except TooManyStates:
        return
    if found.root is not None or found.status != "infeasible":
        return
    for diagnostic in refusal(Judge(facade, size, 0, effort, backends), found).diagnostics:
        message = f"no layout has the facade's own size: {diagnostic.message}"
        place = diagnostic.place or next(iter(places(facade, {})), None)
        yield replace(
            diagnostic,
            code="LK227",
            message=message,
            place=place,
            severity=Severity.WARNING,
            topic="semantics",
        )
