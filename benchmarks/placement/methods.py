"""What the evaluation compares: ways to place shapes by example, all behind one interface."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar, Protocol

from benchmarks.placement.comparisons import Closest, Comparison, Gaussian, Histograms
from benchmarks.placement.descriptions import CentroidOffset
from benchmarks.placement.pipeline import Pooled
from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.relationship import Relationship

#: Poses that keep less than this share of the relationships are not looked at; the best threshold is higher.
LEAST = 0.3
#: About how many points the grid of a propagation has.
POINTS = 20_000


class Fitted(Protocol):
    """What has been learned from some examples."""

    def propose(self, scene: Scene) -> Sequence[Placement]:
        """Return placements with scores, best first."""
        ...


class Method(Protocol):
    """A way to place shapes by example."""

    @property
    def name(self) -> str:
        """What tables call it."""
        ...

    @property
    def most(self) -> int:
        """From how many examples it can learn."""
        ...

    def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Fitted:
        """Learn from examples."""
        ...


@dataclass(frozen=True)
class Learned:
    """What layoutkit learns (Guerrero et al. 2015).

    Attributes
    ----------
    contrast
        Whether boxes beside examples are learned as wrong places; the paper's regression sees examples alone.
    """

    name: str
    contrast: bool
    most: ClassVar[int] = 5

    def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Fitted:
        """Learn from examples."""
        from layoutkit_placement.learning import Learner

        return Learner(replace(settings, contrast=self.contrast)).fit(examples)


@dataclass(frozen=True)
class Baseline:
    """The same with another comparison of descriptions, and with tolerances that suit it best.

    Attributes
    ----------
    comparison
        How descriptions are compared.
    relationships
        What they consist of.
    tolerance
        Factor on all variances.
    floor
        Maxima of sample points below this share of the greatest are none; like the tolerance chosen on the
        half of the scenes for tuning.
    contrast
        Whether whole placements are told apart from boxes beside the examples, as layoutkit does.
    """

    name: str
    comparison: Comparison
    relationships: tuple[Relationship, ...]
    tolerance: float
    floor: float
    contrast: bool = False
    most: int = 5

    def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Fitted:
        """Learn from examples."""
        own = replace(settings, tolerance=self.tolerance)
        return Pooled(tuple(examples), own, self.relationships, self.comparison, self.floor, self.contrast)


@dataclass(frozen=True)
class Propagation:
    """Propagation of one pose (Guerrero et al. 2014); what is placed keeps the size of the example.

    Attributes
    ----------
    kernel
        How far from a relationship's value a pose still counts, in diagonals of the shape, chosen on the half
        of the scenes for tuning.
    """

    kernel: float
    name: ClassVar[str] = "propagation"
    most: ClassVar[int] = 1

    def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Fitted:
        """Take the only example."""
        (example,) = examples
        return _Propagated(example, settings, self.kernel)


@dataclass(frozen=True)
class _Propagated:
    example: Example
    settings: LearningSettings
    kernel: float

    def propose(self, scene: Scene) -> Sequence[Placement]:
        """Return all placements that keep to anything of the example."""
        from layoutkit_placement.propagation.settings import PropagationSettings
        from layoutkit_placement.stages.propagate import Propagate, PropagateOptions

        settings = PropagationSettings(
            threshold=LEAST, hierarchy=self.settings.hierarchy, kernel=self.kernel, points=POINTS
        )
        options = PropagateOptions((self.example.placement,), self.example.scene, settings)
        (outcome,) = Propagate().run(scene, options)
        assert isinstance(outcome.document, Scene)
        return sorted(outcome.document.placements, key=lambda placed: -(placed.score or 0.0))


def _of_the_paper() -> tuple[Relationship, ...]:
    from layoutkit_placement.functions import BUILT_IN
    from layoutkit_placement.learning.learner import PAPER

    by_name = {each.name: each for each in BUILT_IN}
    return tuple(by_name[name] for name in PAPER)


METHODS: Mapping[str, Method] = {
    each.name: each
    for each in (
        Learned("learned", contrast=True),
        Learned("no contrast", contrast=False),
        Baseline("closest", Closest(), _of_the_paper(), 1.5, 0.5),
        Baseline("closest contrast", Closest(), _of_the_paper(), 1.5, 0.5, contrast=True),
        Baseline("histogram", Histograms(), _of_the_paper(), 2.5, 0.5),
        Baseline("gaussian", Gaussian(), (CentroidOffset(),), 4.0, 0.1),
        Propagation(0.1),
    )
}
