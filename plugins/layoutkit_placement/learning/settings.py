"""Whether the settings of learning make sense."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.model.learning import LearningSettings
from layoutkit.scenes.relationship import Relationship

#: A tolerance below this would take a grid that is too fine to be looked at.
_LEAST = 1e-3


def check_settings(settings: LearningSettings, known: Sequence[Relationship]) -> None:
    """Raise what makes no sense.

    Raises
    ------
    Faulty
        If a number is out of its range, or a relationship function is not known or needs a direction (LK872).
    """
    if faults := list(_faults(settings, known)):
        raise Faulty(faults)


def _faults(settings: LearningSettings, known: Sequence[Relationship]) -> Iterator[Diagnostic]:
    names = [each.name for each in known]
    for name in settings.relationships:
        if name not in names:
            yield _fault(f"there is no relationship function {name!r}", did_you_mean(name, names))
        elif next(each for each in known if each.name == name).directional:
            hint = "learning relates points, which have no direction; `propagate` relates poses"
            yield _fault(f"{name} needs a direction", hint)
    for name, least in (("tolerance", _LEAST), ("regularisation", 1e-9)):
        if not math.inf > getattr(settings, name) >= least:
            yield _fault(f"{name} is {getattr(settings, name):g}", f"give a number of at least {least:g}")
    for name in ("reach", "nearest", "shape_tolerance", "area_tolerance"):
        if not math.inf > getattr(settings, name) >= 0:
            yield _fault(f"{name} is {getattr(settings, name):g}", "give a number of at least 0")


def _fault(message: str, hint: str) -> Diagnostic:
    return Diagnostic("LK872", message, hint=hint, topic="placement")
