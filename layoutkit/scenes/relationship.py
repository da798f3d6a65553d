"""What a relationship function is: numbers that relate a point, or a pose, to a feature of a scene."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar, Literal, get_args

from layoutkit.scenes.features import Array, FeatureType
from layoutkit.scenes.view import View

#: What values are counted in: document units, shares of something of the feature's own, or radians.
Quantity = Literal["length", "share", "angle"]
QUANTITIES, FEATURE_TYPES = get_args(Quantity), get_args(FeatureType)


class Relationship(ABC):
    """Relates points or poses to features of one type (Guerrero et al. 2014, section 4.2).

    Instances are stateless; all methods take many points and all features at once.

    Attributes
    ----------
    name
        What commands and documents call it, e.g. ``boundary-distance``.
    summary
        What it tells, in one sentence.
    of
        The type of the features that it relates to.
    values
        What its numbers are, in order: a name each. Most have one.
    quantity
        What the numbers are counted in; tolerances for lengths are relative to the placed shape.
    directional
        Whether it needs the direction of a pose.
    """

    name: ClassVar[str]
    summary: ClassVar[str]
    of: ClassVar[FeatureType]
    values: ClassVar[tuple[str, ...]] = ("value",)
    quantity: ClassVar[Quantity]
    directional: ClassVar[bool] = False

    @abstractmethod
    def evaluate(self, view: View) -> Array:
        """Return the values, shape (points, features, values).

        Angles are from -pi to pi where they have a sense, and from 0 to pi where they have none. Where the
        papers leave a value undefined (a point at the corner itself), a value is defined and documented.
        """

    @abstractmethod
    def spread(self, view: View) -> Array:
        """Return how far a point moves until a value changes by one unit, shape (points, features, values).

        1 for distances. It turns differences of values into distances in the scene, where level sets are
        drawn; it may be 0 where any motion changes the value.
        """
