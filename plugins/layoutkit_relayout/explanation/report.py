"""Explanations as diagnostics: each conflict with its members, their places, amounts and remedies."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.model import Facade
from layoutkit.model.conflict import Conflict, Explanation, Member
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.units import FLOOR

#: Remedies that the hint names.
_MOST_REMEDIES = 4
#: Longer demands, as of many sequences, are cut.
_WIDEST = 72


def diagnostics(explanation: Explanation, facade: Facade) -> tuple[Diagnostic, ...]:
    """Return one diagnostic (LK203) for each conflict; none where it is the size alone that forbids all."""
    count = len(explanation.conflicts)
    width, height = explanation.size
    at = f"at {width:g} × {height:g} {facade.units}"
    found = []
    for number, conflict in enumerate(explanation.conflicts, 1):
        more = "" if explanation.complete else " or more"
        which = f" ({number} of {count}{more} conflicts)" if count > 1 or more else ""
        found.append(_diagnostic(conflict, f"these constraints cannot hold together {at}{which}", facade))
    return tuple(found)


def too_small(explanation: Explanation, facade: Facade) -> Diagnostic:
    """Return the diagnostic of a size at which nothing can be, whichever constraints are left out."""
    width, height = explanation.size
    at = f"{width:g} × {height:g} {facade.units}"
    return Diagnostic(
        "LK203",
        f"no constraint is at fault at {at}: there is no room for any region",
        hint=f"ask for a larger size: each region keeps at least {FLOOR:.0%} of what it has in the input",
        topic="sizing",
    )


def undecided(facade: Facade, size: tuple[float, float], nodes: int) -> Diagnostic:
    """Return the diagnostic of a search that found nothing, and proved nothing."""
    at = f"{size[0]:g} × {size[1]:g} {facade.units}"
    tried = f"{nodes} word{'' if nodes == 1 else 's'}"
    return Diagnostic(
        "LK601",
        f"no layout was found at {at} within {tried} tried, and it is not proved that there is none",
        hint="raise the node limit, or relax a constraint",
        topic="search",
    )


def _diagnostic(conflict: Conflict, message: str, facade: Facade) -> Diagnostic:
    places = sorted({p for member in conflict.members for p in _places(member)})
    return Diagnostic(
        "LK203",
        message,
        places[-1] if places else None,
        hint(conflict),
        topic="sizing",
        details=tuple(details(conflict, facade)),
        related=tuple(places),
    )


def details(conflict: Conflict, facade: Facade) -> Iterable[str]:
    """Yield a line for each member, in columns, and one for what they miss."""
    rows = [(m.subject, _cut(m.demand), _where(m)) for m in conflict.members]
    first, second = (max(len(row[column]) for row in rows) for column in (0, 1))
    for row in rows:
        yield f"{row[0]:{first}}  {row[1]:{second}}  {row[2]}".rstrip()
    if conflict.short:
        yield f"short by {' or '.join(wording.amount(some, facade) for some in conflict.short)}"
    if not conflict.minimal:
        doubtful = [m.subject for m in conflict.members if not m.needed]
        yield f"not proved that all of them are needed: {', '.join(doubtful)}"


def hint(conflict: Conflict) -> str:
    """Return the mildest remedies in one line."""
    texts = list(dict.fromkeys(remedy.text for remedy in conflict.remedies))[:_MOST_REMEDIES]
    if not texts:
        return "ask for another size, widen size ranges, or allow more arrangements by further sequences"
    return f"{', '.join(texts[:-1])}, or {texts[-1]}" if len(texts) > 1 else texts[0]


def _cut(text: str) -> str:
    return text if len(text) <= _WIDEST else f"{text[: _WIDEST - 2].rstrip(' ,')} …"


def _places(member: Member) -> list[Place]:
    return [c.place for c in member.constraints if c.place is not None]


def _where(member: Member) -> str:
    if member.by_default:
        return "(by default)"
    lines = sorted({place.line for place in _places(member) if place.line})
    return f"(line{'s' if len(lines) > 1 else ''} {_listed(lines)})" if lines else ""


def _listed(lines: Sequence[int]) -> str:
    if len(lines) > 2 and lines[-1] - lines[0] == len(lines) - 1:
        return f"{lines[0]} to {lines[-1]}"
    return ", ".join(map(str, lines))
