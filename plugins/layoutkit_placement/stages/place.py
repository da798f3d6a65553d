"""The stage that places shapes in a scene as a model says."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model.learning import PlacementModel, Spacing
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.relationship import Relationship

if TYPE_CHECKING:
    from layoutkit_placement.learning.learner import Fitted

_TOPIC = "placement"


@dataclass(frozen=True)
class PlaceOptions:
    """Options of the stage `place`.

    Attributes
    ----------
    model
        What was learned.
    limit
        How many placements are wanted at most, each of which may be filled with several shapes; None: all.
    threshold
        The least score: an example has about 1.
    spacing
        How shapes that keep their size fill placements, instead of one that is stretched; None: not.
    evidence
        Whether what speaks for the placements is wanted too: that takes many times as long.
    relationships
        The relationship functions that the model may name; none: those that are built in.
    """

    model: PlacementModel | None = None
    limit: int | None = None
    threshold: float = 0.3
    spacing: Spacing | None = None
    evidence: bool = False
    relationships: tuple[Relationship, ...] = ()


class Place(Stage):
    """Places shapes as was learned (Guerrero et al. 2015)."""

    name: ClassVar[str] = "place"
    summary: ClassVar[str] = "Places shapes in a scene where examples would have them."
    options: ClassVar[type] = PlaceOptions
    takes: ClassVar[type] = Scene

    def run(self, scene: Scene, options: PlaceOptions) -> Iterator[Outcome]:
        """Yield the scene once, with the shapes that were placed behind the placements that it has.

        Raises
        ------
        Faulty
            If there is no model, it names functions that are not known, or an option makes no sense (LK872).
        """
        from layoutkit.scenes.soundness import examined
        from layoutkit.scenes.spacing import fill
        from layoutkit.scenes.spacing import remarks as too_large
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_placement.functions import BUILT_IN
        from layoutkit_placement.learning.evidence import evidence
        from layoutkit_placement.learning.models import fitted_of

        model = _check(options)
        start = time.perf_counter()
        with single_threaded():
            fitted = fitted_of(model, options.relationships or BUILT_IN)
            every = fitted.propose(scene)
            found = tuple(own for own in every if (own.score or 0.0) >= options.threshold)[: options.limit]
            speaking = evidence(fitted, scene, found) if options.evidence else None
        shapes = found if options.spacing is None else fill(found, options.spacing)
        placed = replace(scene, placements=(*scene.placements, *shapes))
        remarks = [
            *examined(scene.polygons).left_out,
            *_remarks(model, scene, fitted),
            *too_large(found, options.spacing or Spacing()),
            *([] if found else [_nothing(options, scene, every, fitted.parents)]),
        ]
        yield Outcome("found", placed, tuple(remarks), time.perf_counter() - start, evidence=speaking)


def _check(options: PlaceOptions) -> PlacementModel:
    """Return the model, or raise `Faulty` where options make no sense."""
    from layoutkit.scenes.spacing import check
    from layoutkit_placement.learning.settings import fault

    if options.model is None:
        raise Faulty([fault("there is no model to place shapes by", "learn one from examples")])
    if options.limit is not None and options.limit < 1:
        raise Faulty([fault(f"the limit is {options.limit}", "let at least one be placed, or leave it away")])
    check(options.spacing or Spacing())
    return options.model


def _remarks(model: PlacementModel, scene: Scene, fitted: Fitted) -> Iterator[Diagnostic]:
    """Say where units differ, and where an area is too large to be looked at closely."""
    from layoutkit_placement.areas import Areas
    from layoutkit_placement.learning.search import is_coarse

    if model.units != scene.units:
        yield _warning(
            "LK874",
            f"the examples are in {model.units}, the scene {scene.name} in {scene.units}",
            "sizes are taken as they stand: scale one of them if they are to agree",
        )
    for area in Areas.of(scene, fitted.settings.hierarchy).of_labels(fitted.parents):
        if is_coarse(area, fitted.terms):
            where = area.polygons[0].name if area.parent else scene.name
            yield _warning(
                "LK876",
                f"{where} is so large for {model.label or 'the shape'} that places in it may be missed",
                "cut it into smaller polygons, of the same label, or raise the tolerance",
            )


def _nothing(
    options: PlaceOptions, scene: Scene, every: Sequence[Placement], parents: frozenset[tuple[str, ...]]
) -> Diagnostic:
    """Say that nothing was placed, and why."""
    label = options.model.label if options.model is not None else ""
    message = f"no place was found for {label or 'the shape'}"
    own = {tuple(sorted(set(polygon.labels))) for polygon in scene.polygons} | {()}
    hint = "raise the tolerance, or give the scene what the examples stand beside"
    if parents.isdisjoint(own):
        named = ", ".join(" ".join(labels) for labels in sorted(parents))
        hint = f"the examples stand in {named}, and the scene has none: label alike what is alike"
    elif every:
        best = every[0].score or 0.0
        message += f": the best has a score of {best:.2f}, and {options.threshold:g} is the threshold"
        hint = "lower the threshold, raise the tolerance"
        if options.model is not None and options.model.settings.hierarchy:
            hint += ", or learn without hierarchy (--no-hierarchy, or hierarchy=\"no\" in the model)"
    return _warning("LK875", message, hint)


def _warning(code: str, message: str, hint: str) -> Diagnostic:
    return Diagnostic(code, message, hint=hint, severity=Severity.WARNING, topic=_TOPIC)
