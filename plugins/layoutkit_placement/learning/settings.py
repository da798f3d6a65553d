"""Whether the settings of learning make sense."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.model.learning import LearningSettings
from layoutkit.scenes.relationship import Relationship

#: What numbers are between, 0 apart where it means none: a tolerance below would take a grid that is too fine
#: to be looked at, and beyond all of them nothing is told from anything.
_RANGES: Mapping[str, tuple[float, float]] = {
    "tolerance": (1e-3, 1e3),
    "regularisation": (1e-9, 1e9),
    "reach": (1e-3, 1e6),
    "shape_tolerance": (1e-3, 1e3),
    "area_tolerance": (1e-3, 1e3),
    "nearest": (1, 1e6),
}
#: Of these 0 means none.
_NONE = ("reach", "shape_tolerance", "area_tolerance", "nearest")


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
            yield fault(f"there is no relationship function {name!r}", did_you_mean(name, names))
        elif next(each for each in known if each.name == name).directional:
            hint = "learning relates points, which have no direction; `propagate` relates poses"
            yield fault(f"{name} needs a direction", hint)
    for name, (least, most) in _RANGES.items():
        value = getattr(settings, name)
        if not least <= value <= most and not (value == 0 and name in _NONE):
            none = "0, or " if name in _NONE else ""
            yield fault(f"{name} is {value:g}", f"give {none}a number from {least:g} to {most:g}")


def fault(message: str, hint: str) -> Diagnostic:
    """Return that an option of learning or placing makes no sense (LK872)."""
    return Diagnostic("LK872", message, hint=hint, topic="placement")
