"""What is said where a propagation comes to less than one might expect."""

from __future__ import annotations

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Labels

_TOPIC = "placement"


def nothing_near(placement: Placement) -> Diagnostic:
    """Say that a shape is related to nothing."""
    return Diagnostic(
        "LK866",
        f"nothing stands near {_named(placement)}: there is nothing to find like places by",
        placement.place,
        hint="propagate a shape that stands in a polygon, or beside one",
        severity=Severity.WARNING,
        topic=_TOPIC,
    )


def no_such_area(labels: Labels, scene: str) -> Diagnostic:
    """Say that a scene has no polygon like the one that a shape stands in."""
    what = f"polygon labelled {' and '.join(labels)}" if labels else "polygon without labels"
    return Diagnostic(
        "LK867",
        f"the shape stands in a {what}, and {scene} has none",
        hint="label alike what is alike in both scenes",
        severity=Severity.WARNING,
        topic=_TOPIC,
    )


def no_array(area: str) -> Diagnostic:
    """Say that an array's first and last shape do not belong together."""
    where = f" in {area}" if area else ""
    return Diagnostic(
        "LK868",
        f"no array{where}: no place for the last shape is nearest to the same polygon as one for the first",
        hint="choose a first and a last shape beside one polygon",
        severity=Severity.WARNING,
        topic=_TOPIC,
    )


def stands_in_none(placement: Placement) -> Diagnostic:
    """Say that a shape stands in no polygon, whose coordinates would carry it."""
    return Diagnostic(
        "LK869",
        f"{_named(placement)} stands in no polygon, so there are no local coordinates to carry it by",
        placement.place,
        hint="propagate it by relationships instead",
        severity=Severity.WARNING,
        topic=_TOPIC,
    )


def _named(placement: Placement) -> str:
    what = placement.label or "the shape"
    return f"{what} at {placement.x:g},{placement.y:g}"
