"""The rating of whole placements, and which of them stay (Guerrero et al. 2015, sections 3.5 and 4.1)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Array
from layoutkit.scenes.shapes import shapes
from layoutkit_placement.areas import Area
from layoutkit_placement.learning.descriptors import Terms, Vocabulary, describe
from layoutkit_placement.learning.kernel import Stacks, kernel
from layoutkit_placement.learning.samples import Boxes, sample_points
from layoutkit_placement.learning.tiles import boxes_about, near

#: So many boxes are described at once: those next to each other see the same features.
_TOGETHER = 24
#: From this share on, two shapes that are placed overlap each other.
APART = 0.02


@dataclass(frozen=True)
class ShapeModel:
    """What was learned of whole placements.

    Attributes
    ----------
    examples
        The feature sets of the examples, of all sample points.
    weights
        How much the similarity to each counts.
    words
        Numbers of labels.
    """

    examples: Stacks
    weights: Array
    words: Vocabulary
    terms: Terms

    def values(self, boxes: Boxes, area: Area) -> Array:
        """Return how well boxes in an area agree with all examples, shape (boxes,)."""
        found = np.zeros(len(boxes))
        points = sample_points(boxes)
        about = boxes_about(area.features)
        cell = self.terms.farthest if np.isfinite(self.terms.farthest) else np.inf
        order = np.lexsort((boxes[:, 0], np.floor(boxes[:, 1] / cell)))
        for start in range(0, len(order), _TOGETHER):
            some = order[start : start + _TOGETHER]
            features = area.features.take(near(about, points[some].reshape(-1, 2), self.terms.farthest))
            queries = describe(points[some], features, self.terms, self.words)
            found[some] = kernel(self.examples, len(self.weights), queries, len(some)) @ self.weights
        return found


def apart(placements: Sequence[Placement]) -> list[int]:
    """Return which placements to keep, best first, where none may overlap a better one."""
    import shapely

    own = shapes(placements)
    areas = shapely.area(own)
    order = sorted(range(len(placements)), key=lambda index: -(placements[index].score or 0.0))
    tree = shapely.STRtree(own)
    gone: set[int] = set()
    kept = []
    for index in order:
        if index in gone:
            continue
        kept.append(index)
        others = tree.query(own[index], predicate="intersects")
        shared = shapely.area(shapely.intersection(own[index], own[others]))
        gone.update(others[shared > APART * np.minimum(areas[index], areas[others])].tolist())
    return kept
