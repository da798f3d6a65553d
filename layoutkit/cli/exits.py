"""Exit codes, and which diagnostics lead to which."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Diagnostic, Severity

if TYPE_CHECKING:
    from layoutkit.hooks import Status


class Exit(enum.IntEnum):
    """How a command ends."""

    DONE = 0
    FAULTS = 1
    USAGE = 2
    INFEASIBLE = 3
    LIMIT = 4
    PLUGIN = 5
    INTERNAL = 70
    INTERRUPTED = 130
    BROKEN_PIPE = 141


#: Exit codes by how a search ended.
EXITS: Mapping[Status, Exit] = {"found": Exit.DONE, "infeasible": Exit.INFEASIBLE, "limit": Exit.LIMIT}

#: Exit codes by the beginning of a diagnostic's code; the longest that fits decides. All others are faults of
#: the document.
_BY_CODE: Mapping[str, Exit] = {
    "LK4": Exit.PLUGIN,
    "LK406": Exit.USAGE,  # a name that no plugin has: asked for by the user
    "LK408": Exit.USAGE,  # a name to leave out, which no plugin has
    "LK651": Exit.USAGE,  # a grid that the facade lacks: asked for by the user
    "LK658": Exit.USAGE,  # a region that it lacks
    "LK7": Exit.USAGE,
    "LK857": Exit.USAGE,  # a scene to choose of several
    "LK858": Exit.USAGE,  # a scene that a file lacks
    "LK890": Exit.USAGE,  # a folder that holds other results
    "LK891": Exit.USAGE,  # a folder in use
    "LK893": Exit.USAGE,  # a cluster that is not there
    "LK894": Exit.USAGE,  # or is not like this machine
    "LK9": Exit.INTERNAL,
}

#: Where several apply, the first of these is the answer: what hinders most comes first.
_ORDER = (Exit.INTERNAL, Exit.PLUGIN, Exit.USAGE, Exit.FAULTS)


def exit_of(diagnostics: Iterable[Diagnostic]) -> Exit:
    """Return the exit code that the errors among `diagnostics` lead to."""
    found = {exit_of_code(d.code) for d in diagnostics if d.severity is Severity.ERROR}
    return next((code for code in _ORDER if code in found), Exit.DONE)


def exit_of_code(code: str) -> Exit:
    """Return the exit code that an error of a diagnostic's code leads to."""
    fitting = [prefix for prefix in _BY_CODE if code.startswith(prefix)]
    return _BY_CODE[max(fitting, key=len)] if fitting else Exit.FAULTS
