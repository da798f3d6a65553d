"""Diagnostics in the order in which they help: causes before what follows from them, nothing twice."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from dataclasses import replace

from layoutkit.diagnostics.diagnostic import Diagnostic, Place

#: Beginnings of codes, the longest that fits decides: what stands first is to be mended first, as later ones
#: may follow from it. A plugin that failed may be why elements are unknown; sums and symbols decide which
#: names there are; constraints, what layouts may be.
_CAUSES = (
    ("LK4", "LK9"),
    ("LK0", "LK101"),
    ("LK1", "LK21", "LK8"),
    ("LK2", "LK3", "LK7"),
    ("LK203", "LK6"),
    ("LK5",),
)
_ORDER = {prefix: rank for rank, prefixes in enumerate(_CAUSES) for prefix in prefixes}

#: Names of constraints and grids that are not there.
_OF_NAMES = frozenset({"LK201", "LK241"})
#: What it is a name of, and the name.
_UNKNOWN = re.compile(r"names the (?P<what>.+?) '(?P<name>[^']*)', which is not there$")
_WITHIN = re.compile(r"(?:symbol in|direct subregion of) (?P<path>\S+)")
#: What layouts break: their messages begin with the path of a region.
_OF_REGIONS = frozenset({"LK501", "LK502", "LK506"})
#: As many places are told in words; `Diagnostic.related` has them all.
_SHOWN = 10


def ranked(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Return the diagnostics of a document, most useful first, none repeated in a cascade.

    Errors come before warnings, and these before notes; within these, causes before what may follow from
    them; then they keep the order in which they are given, which is that of the document.

    The same fault in several places becomes one diagnostic, with all places in `Diagnostic.related` and in
    its details. So does a name that several constraints use though it is not there, with all that would be
    inside of it, and a constraint that a layout breaks by the same amount in several regions.

    Parameters
    ----------
    diagnostics
        In document order.
    """
    once = list(dict.fromkeys(diagnostics))
    missing = {(_file(d), name) for d in once if (name := _unknown_name(d))}
    folded: dict[tuple[object, ...], list[Diagnostic]] = {}
    for diagnostic in once:
        folded.setdefault(_subject(diagnostic, missing), []).append(diagnostic)
    return tuple(sorted(map(_as_one, folded.values()), key=_rank))


def _rank(diagnostic: Diagnostic) -> tuple[int, int]:
    fitting = [prefix for prefix in _ORDER if diagnostic.code.startswith(prefix)]
    cause = _ORDER[max(fitting, key=len)] if fitting else len(_CAUSES)
    return -diagnostic.severity, cause


def _subject(diagnostic: Diagnostic, missing: Collection[tuple[str, str]]) -> tuple[object, ...]:
    """Return what a diagnostic is about: those of one subject say the same."""
    file = _file(diagnostic)
    kind = (file, diagnostic.code, diagnostic.severity)
    if name := _unknown_name(diagnostic):
        steps = name.split("/")
        outer = ("/".join(steps[:count]) for count in range(1, len(steps) + 1))
        return (*kind, next(path for path in outer if (file, path) in missing))
    if diagnostic.code in _OF_REGIONS:
        return (*kind, diagnostic.message.partition(": ")[2], diagnostic.details)
    return (*kind, diagnostic.topic, diagnostic.message, diagnostic.details, diagnostic.hint)


def _file(diagnostic: Diagnostic) -> str:
    return diagnostic.place.file if diagnostic.place else ""


def _unknown_name(diagnostic: Diagnostic) -> str:
    """Return the name that is not there, as a path where one is known; empty for another kind of fault."""
    told = diagnostic.code in _OF_NAMES and diagnostic.count == 1  # else it speaks of other names as well
    found = _UNKNOWN.search(diagnostic.message) if told else None
    if found is None:
        return ""
    within = _WITHIN.fullmatch(found["what"])
    if within and not found["name"].startswith("@"):
        return f"{within['path']}/{found['name']}"
    return f"{found['what']} {found['name']}" if found["what"] != "region" else found["name"]


def _as_one(alike: list[Diagnostic]) -> Diagnostic:
    """Return the first of diagnostics on one subject, with the places of all."""
    # Of unknown names the outermost speaks for those inside of it.
    first, *others = sorted(alike, key=lambda d: len(_unknown_name(d)))
    if not others:
        return first
    places = tuple(dict.fromkeys(place for d in (first, *others) for place in (d.place, *d.related) if place))
    if first.code in _OF_REGIONS:
        also = f"the same of {_some([d.message.partition(': ')[0] for d in others])}"
    elif len(places) > 1:
        also = f"the same at {_some([_short(p) for p in places if p != first.place])}"
    else:  # a name that a constraint uses twice
        return first
    return replace(
        first, details=(*first.details, also), related=places if len(places) > 1 else first.related
    )


def _short(place: Place) -> str:
    return ":".join(str(number) for number in (place.line, place.column) if number) or place.file


def _some(names: list[str]) -> str:
    rest = len(names) - _SHOWN
    return ", ".join(names[:_SHOWN]) + (f" and {rest:,} more" if rest > 0 else "")
