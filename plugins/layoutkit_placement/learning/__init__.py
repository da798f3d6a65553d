"""Shape placements learned from examples (Guerrero et al. 2015)."""

from layoutkit_placement.examples import examples_of, shapes_of, without
from layoutkit_placement.learning.learner import Fitted, Learner

__all__ = ["Fitted", "Learner", "examples_of", "shapes_of", "without"]
