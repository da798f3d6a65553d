"""The stage that learns shape placements from examples in scenes."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Scene
from layoutkit.scenes.relationship import Relationship

_TOPIC = "placement"


@dataclass(frozen=True)
class LearnOptions:
    """Options of the stage `learn`.

    Attributes
    ----------
    label
        Shapes of this label are the examples, placements and polygons; empty: the label of the scenes'
        placements, if these have but one.
    more
        Further scenes with examples.
    chosen
        Which of the shapes are examples, by their numbers from 1 on, over all scenes; none: all.
    settings
        What learning goes by.
    relationships
        The relationship functions that the settings may name; none: those that are built in.
    """

    label: str = ""
    more: tuple[Scene, ...] = ()
    chosen: tuple[int, ...] = ()
    settings: LearningSettings = field(default_factory=LearningSettings)
    relationships: tuple[Relationship, ...] = ()


class Learn(Stage):
    """Learns where shapes are placed (Guerrero et al. 2015)."""

    name: ClassVar[str] = "learn"
    summary: ClassVar[str] = "Learns from examples where shapes of a label are placed."
    options: ClassVar[type] = LearnOptions
    takes: ClassVar[type] = Scene

    def run(self, scene: Scene, options: LearnOptions) -> Iterator[Outcome]:
        """Yield a placement model.

        Raises
        ------
        Faulty
            If there are no examples, or it is not clear which they are (LK871), or a setting makes no sense
            (LK872).
        """
        from layoutkit.scenes.soundness import examined
        from layoutkit.sizing.threads import single_threaded
        from layoutkit_placement.functions import BUILT_IN
        from layoutkit_placement.learning.learner import Learner
        from layoutkit_placement.learning.models import model_of
        from layoutkit_placement.learning.settings import check_settings

        start = time.perf_counter()
        scenes = (scene, *options.more)
        known = options.relationships or BUILT_IN
        check_settings(options.settings, known)
        label = options.label or _only_label(scenes)
        examples = _chosen(_examples(scenes, label), options.chosen, label)
        _check_targets(examples)
        left_out = dict.fromkeys(d for own in scenes for d in examined(own.polygons).left_out)
        with single_threaded():
            fitted = Learner(options.settings, known).fit(examples)
            model = model_of(fitted, label)
        remarks = [*left_out, *_remarks(examples, fitted.informed)]
        yield Outcome("found", model, tuple(remarks), time.perf_counter() - start)


def _only_label(scenes: Sequence[Scene]) -> str:
    labels = tuple(dict.fromkeys(p.label for scene in scenes for p in scene.placements if p.label))
    if len(labels) == 1:
        return labels[0]
    if not labels:
        known = tuple(dict.fromkeys(label for scene in scenes for label in scene.labels))
        what = f"the scenes have {', '.join(known)}" if known else "the scenes are empty"
        raise _no_examples("it is not said what the examples are", f"name their label; {what}")
    raise _no_examples(f"the placements have several labels: {', '.join(labels)}", "name one of them")


def _examples(scenes: Sequence[Scene], label: str) -> tuple[Example, ...]:
    from layoutkit_placement.examples import examples_of

    found = examples_of(scenes, label)
    if not found:
        known = tuple(dict.fromkeys(each for scene in scenes for each in scene.labels))
        hint = did_you_mean(label, known) if known else "the scenes are empty: add polygons and examples"
        raise _no_examples(f"nothing has the label {label!r}", hint)
    usable = tuple(e for e in found if e.placement.width > 0 and e.placement.height > 0)
    if not usable:
        raise _no_examples(
            f"all shapes of the label {label} lack a width or a height", "give them sizes above 0"
        )
    return usable


def _check_targets(examples: Sequence[Example]) -> None:
    """Raise what makes no sense of the examples' target values (LK871)."""
    for example in examples:
        shape = example.placement
        if not 0 <= shape.target <= 1:
            message = f"the example at {shape.x:g},{shape.y:g} has the target value {shape.target:g}"
            hint = "write 1 for a good place, less for one that is less so, 0 for a wrong one"
            raise Faulty([Diagnostic("LK871", message, shape.place, hint, topic=_TOPIC)])
    if not any(example.placement.target for example in examples):
        raise _no_examples("all examples have the target value 0", "show a place where shapes should stand")


def _chosen(examples: tuple[Example, ...], numbers: Sequence[int], label: str) -> tuple[Example, ...]:
    for number in numbers:
        if not 1 <= number <= len(examples):
            count = f"{len(examples)} shape{'s' * (len(examples) != 1)}"
            raise _no_examples(
                f"there is no example {number}: {count} have the label {label}", "count from 1"
            )
    return tuple(examples[number - 1] for number in dict.fromkeys(numbers)) or examples


def _remarks(examples: Sequence[Example], informed: Sequence[bool]) -> Iterator[Diagnostic]:
    """Say of which examples nothing can be learned."""
    for example, known in zip(examples, informed, strict=True):
        if not known:
            shape = example.placement
            yield Diagnostic(
                "LK873",
                f"nothing stands about the example at {shape.x:g},{shape.y:g}, so nothing is learned from it",
                shape.place,
                "show shapes that stand in a polygon, or beside one",
                Severity.WARNING,
                _TOPIC,
            )


def _no_examples(message: str, hint: str) -> Faulty:
    return Faulty([Diagnostic("LK871", message, hint=hint, topic=_TOPIC)])
