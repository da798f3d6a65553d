"""Refusals: what is said, at little cost, where there are no variations."""

from __future__ import annotations

from dataclasses import dataclass, replace

from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade
from layoutkit.model.conflict import Conflict, Explanation
from layoutkit_relayout.explanation.explaining import explained
from layoutkit_relayout.explanation.judge import Judge, Size, Verdict
from layoutkit_relayout.explanation.report import diagnostics, too_small, undecided
from layoutkit_relayout.search.search import Found

#: Of more members than these, most have nothing to do with it where it is not proved that they have.
_READABLE = 12
#: The command that tells the rest.
_EXPLAIN = "`layoutkit explain` at this size tells"


@dataclass(frozen=True)
class Refusal:
    """Why there is no variation.

    Attributes
    ----------
    explanation
        A conflict, where it is proved that there is one, and the layout that comes nearest.
    """

    diagnostics: tuple[Diagnostic, ...]
    explanation: Explanation


def refusal(judge: Judge, found: Found) -> Refusal:
    """Tell why a search found nothing, as far as that takes little.

    Parameters
    ----------
    judge
        Of whom nothing has been asked yet, and whose effort says what explaining may cost.
    found
        What the search for all constraints ended with.
    """
    facade, size = judge.facade, judge.size
    judge.told(Verdict(found.status, None, found.nodes))
    explanation = explained(judge, most=1)
    if found.status != "infeasible":
        told = undecided(facade, size, found.nodes)
        return Refusal((_adding(told, "which layout comes nearest"),), explanation)
    if any(_says_little(conflict) for conflict in explanation.conflicts):
        return Refusal((_unexplained(facade, size),), replace(explanation, conflicts=()))
    if judge.effort.spent:
        # What would help was not looked for to the end: half of the truth would mislead.
        known = tuple(replace(conflict, short=(), remedies=()) for conflict in explanation.conflicts)
        explanation = replace(explanation, conflicts=known, complete=False)
    found_out = diagnostics(explanation, facade) or (too_small(explanation, facade),)
    if not explanation.complete:
        more = "what would help" if judge.effort.spent else "of all conflicts"
        found_out = tuple(_adding(diagnostic, more) for diagnostic in found_out)
    return Refusal(found_out, explanation)


def _says_little(conflict: Conflict) -> bool:
    """Tell whether so little is proved of a conflict that its members may well have nothing to do with it."""
    needed = [member.needed for member in conflict.members]
    return not any(needed) or (len(needed) > _READABLE and not all(needed))


def _adding(diagnostic: Diagnostic, more: str) -> Diagnostic:
    """Say what a longer look would tell."""
    return replace(diagnostic, hint=f"{diagnostic.hint}; {_EXPLAIN} {more}")


def _unexplained(facade: Facade, size: Size) -> Diagnostic:
    at = f"{size[0]:g} × {size[1]:g} {facade.units}"
    return Diagnostic(
        "LK203",
        f"these constraints cannot hold together at {at}; which of them are in conflict takes longer to tell",
        hint=f"{_EXPLAIN} which, and what would help",
        topic="search",
    )
