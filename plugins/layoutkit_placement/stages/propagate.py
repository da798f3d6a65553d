"""The stage that propagates shapes from where they stand to like places."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.diagnostics.suggestions import did_you_mean
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.propagation.settings import PropagationSettings

if TYPE_CHECKING:
    from layoutkit_placement.propagation.preparing import Task

_TOPIC = "placement"


@dataclass(frozen=True)
class PropagateOptions:
    """Options of the stage `propagate`.

    Attributes
    ----------
    shapes
        What is propagated; for an array its first and its last shape. Shapes of their labels in the source
        are not scenery; those in the target stay, and nothing is placed upon them.
    source
        The scene in which they stand; None: the target itself.
    settings
        What it goes by.
    alternatives
        Polygons that stand for those of the same names where overlaps are looked for.
    relationships
        The relationship functions that the settings may name; none: those that are built in.
    seed
        Of what is left to chance.
    """

    shapes: tuple[Placement, ...] = ()
    source: Scene | None = None
    settings: PropagationSettings = field(default_factory=PropagationSettings)
    alternatives: tuple[Polygon, ...] = ()
    relationships: tuple[Relationship, ...] = ()
    seed: int = 0


class Propagate(Stage):
    """Propagates shapes by geometric relationships (Guerrero et al. 2014)."""

    name: ClassVar[str] = "propagate"
    summary: ClassVar[str] = "Finds the places that are like those of given shapes."
    options: ClassVar[type] = PropagateOptions
    takes: ClassVar[type] = Scene

    def run(self, scene: Scene, options: PropagateOptions) -> Iterator[Outcome]:
        """Yield the scene once, with the shapes that were placed behind the placements that it has.

        The evidence has a heat map of poses, and what each function adds to each new placement.

        Raises
        ------
        Faulty
            If there is no shape, a shape has no size, or a setting makes no sense, such as an array of too
            many shapes (LK865).
        """
        from layoutkit.scenes.soundness import examined
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_placement.propagation.propagating import propagate

        start = time.perf_counter()
        scenes = {"target": scene, "source": options.source or scene}
        looked_at = {which: examined(own.polygons) for which, own in scenes.items()}
        sound = {which: replace(own, polygons=looked_at[which].polygons) for which, own in scenes.items()}
        with single_threaded():
            found = propagate(_task(sound["source"], sound["target"], options))
        placed = replace(scene, placements=(*scene.placements, *found.placements))
        left_out = dict.fromkeys(remark for own in looked_at.values() for remark in own.left_out)
        yield Outcome(
            "found",
            placed,
            (*left_out, *found.diagnostics),
            time.perf_counter() - start,
            evidence=found.evidence,
        )


def _task(source: Scene, target: Scene, options: PropagateOptions) -> Task:
    """Return what is to be done.

    Raises
    ------
    Faulty
        If that makes no sense.
    """
    import numpy as np

    from layoutkit_placement.functions import BUILT_IN
    from layoutkit_placement.propagation.preparing import Task

    faults = [*_shape_faults(options), *_setting_faults(options.settings, target)]
    functions = {f.name: f for f in options.relationships or BUILT_IN if not f.directional}
    faults += _unknown(options.settings.relationships, functions)
    if faults:
        raise Faulty(faults)
    from layoutkit_placement.propagation.query import PAPER

    known = {**{f.name: f for f in BUILT_IN}, **functions}
    return Task(
        source,
        target,
        options.shapes,
        tuple(known[name] for name in options.settings.relationships or PAPER),
        options.settings,
        dict(map(_clearance, options.settings.clearances)),
        options.alternatives,
        np.random.default_rng(options.seed),
    )


def _shape_faults(options: PropagateOptions) -> Iterator[Diagnostic]:
    if not options.shapes:
        yield _fault("there is no shape to propagate", "name a placement, or a polygon by its label")
    if options.settings.array > 0 and len(options.shapes) != 2:
        yield _fault(
            f"an array takes two shapes, its first and its last, and there are {len(options.shapes)}",
            "name both",
        )
    for shape in options.shapes:
        numbers = (shape.x, shape.y, shape.width, shape.height, shape.angle)
        if not (all(map(math.isfinite, numbers)) and shape.width > 0 and shape.height > 0):
            yield _fault(
                f"{shape.label or 'a shape'} at {shape.x:g},{shape.y:g} is {shape.width:g} by "
                f"{shape.height:g}, which is no size",
                "give it a width and a height above 0",
                shape,
            )
        elif max(map(abs, numbers)) > _FARTHEST or min(shape.width, shape.height) < _SMALLEST:
            yield _fault(
                f"{shape.label or 'a shape'} at {shape.x:g},{shape.y:g} is {shape.width:g} by "
                f"{shape.height:g}, which cannot be calculated with",
                f"let its sizes be from {_SMALLEST:g} to {_FARTHEST:g}, and its place and angle within "
                f"{_FARTHEST:g}",
                shape,
            )


def _setting_faults(settings: PropagationSettings, target: Scene) -> Iterator[Diagnostic]:
    for name, least in _LEAST.items():
        value = getattr(settings, name)
        if not (math.isfinite(value) and value >= least):
            yield _fault(f"{name} is {value:g}", f"{_option(name)} is at least {least:g}")
    for name, most in _MOST.items():
        if getattr(settings, name) > most:
            yield _fault(f"{name} is {getattr(settings, name):g}", f"{_option(name)} is at most {most:g}")
    for one, other in _APART:
        if _is_used(settings, one) and _is_used(settings, other):
            first, second = _option(one), _option(other)
            yield _fault(f"{first} and {second} do not go together", f"leave {first} away: it has no effect")
    for entry in settings.clearances:
        try:
            label, distance = _clearance(entry)
        except ValueError:
            label, distance = "", -1.0
        if not 0 <= distance <= _FARTHEST:
            yield _fault(
                f"clearances has {entry!r}", "write a label and a distance, as in --clearances Door=0.6"
            )
        else:
            yield from _unknown_label(f"clearances has {label}", label, target)
    for name in ("scope", "matches_in"):
        if label := getattr(settings, name):
            yield from _unknown_label(f"{name} is {label}", label, target)


def _unknown_label(said: str, label: str, target: Scene) -> Iterator[Diagnostic]:
    if label not in target.labels:
        yield _fault(f"{said}, a label that {target.name} lacks", did_you_mean(label, target.labels))


#: Coordinates and lengths are at most so large, and sizes at least so small, in document units: products of
#: those beyond are no numbers any more.
_FARTHEST, _SMALLEST = 1e12, 1e-9
#: What settings are at most: what is beyond takes more memory than there is, or is no length.
_MOST: Mapping[str, float] = {
    "points": 4e6,
    "directions": 720,
    "samples": 100_000,
    "kernel": 1e6,
    "density": 1e6,
    "array": _FARTHEST,
}
#: Settings the first of which would do nothing beside the second.
_APART = (
    ("samples", "poses"),
    ("matches", "array"),
    ("matches", "carry"),
    ("mirrored", "carry"),
    ("samples", "carry"),
)


def _option(name: str) -> str:
    """Return a setting, or the space of poses, as it is asked for on the command line."""
    return "--space poses" if name == "poses" else f"--{name.replace('_', '-')}"


def _is_used(settings: PropagationSettings, name: str) -> bool:
    """Tell whether a setting, or the space of poses, is asked for."""
    if name == "poses":
        return settings.space == "poses"
    return settings.carry != "relationships" if name == "carry" else bool(getattr(settings, name))


#: What settings are at least.
_LEAST: Mapping[str, float] = {
    "threshold": 0,
    "density": 0,
    "matches": 0,
    "array": 0,
    "samples": 0,
    "kernel": 1e-6,
    "points": 1,
    "directions": 4,
}


def _unknown(names: Sequence[str], known: Mapping[str, Relationship]) -> Iterator[Diagnostic]:
    for name in names:
        if name not in known:
            yield _fault(
                f"there is no relationship function of points named {name}", did_you_mean(name, known)
            )


def _clearance(entry: str) -> tuple[str, float]:
    label, _, distance = entry.rpartition("=")
    return label, float(distance)


def _fault(message: str, hint: str = "", shape: Placement | None = None) -> Diagnostic:
    return Diagnostic("LK865", message, shape.place if shape else None, hint=hint, topic=_TOPIC)
