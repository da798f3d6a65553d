"""What is said where a propagation comes to less than one might expect."""

from __future__ import annotations

import math

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


def none_good(placement: Placement, best: float, threshold: float) -> Diagnostic:
    """Say that a shape goes nowhere, though there are areas for it, and how good the best place is."""
    return _nowhere(
        placement,
        f"the best place keeps {best:.2g} of its relationships, and the threshold is {threshold:g}",
        "lower --threshold to see it",
    )


def no_corner_alike(placement: Placement, best: float | None, threshold: float) -> Diagnostic:
    """Say that a shape is carried nowhere, and how good the best corner is; None: there is none at all."""
    if best is None:
        return _nowhere(
            placement,
            "the polygon that it stands in has no corner, or those like it have none",
            "carry it by the boundary instead: --carry boundary",
        )
    return _nowhere(
        placement,
        f"the corner most like its own is so by {best:.2g}, and the threshold is {threshold:g}",
        "lower --threshold to see it, or carry it by the boundary: --carry boundary",
    )


def none_free(placement: Placement, found: int) -> Diagnostic:
    """Say that a shape goes nowhere, as it would overlap something everywhere."""
    where = "at the place that was found" if found == 1 else f"at all of {found} places that were found"
    return _nowhere(
        placement,
        f"{where}, it would overlap what stands there, or stick out",
        "let it overlap to see: --crossing, --overlapping",
    )


def _nowhere(placement: Placement, why: str, hint: str) -> Diagnostic:
    return Diagnostic(
        "LK864",
        f"{_named(placement)} goes nowhere: {why}",
        placement.place,
        hint=hint,
        severity=Severity.NOTE,
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


def too_many(first: Placement, count: float, most: int, least: float) -> Diagnostic:
    """Say that an array would have too many shapes, and from which spacing on it would not."""
    shown = f"about {count:.3g}" if math.isfinite(count) else "countless"
    return Diagnostic(
        "LK865",
        f"the array from {_named(first)} would have {shown} shapes, and may have {most}",
        first.place,
        hint=f"give --array a spacing of at least {_rounded_up(least):g}",
        topic=_TOPIC,
    )


def stands_in_none(placement: Placement) -> Diagnostic:
    """Say that a shape stands in no polygon, whose coordinates would carry it."""
    return Diagnostic(
        "LK869",
        f"{_named(placement)} stands in no polygon, so there are no local coordinates to carry it by",
        placement.place,
        hint="propagate it by relationships instead: --carry relationships",
        severity=Severity.WARNING,
        topic=_TOPIC,
    )


def _rounded_up(number: float) -> float:
    """Return the next number with two digits."""
    digit = 10.0 ** (math.floor(math.log10(number)) - 1)
    return math.ceil(number / digit) * digit


def _named(placement: Placement) -> str:
    what = placement.label or "the shape"
    return f"{what} at {placement.x:g},{placement.y:g}"
