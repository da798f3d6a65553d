"""Feature sets and scenes drawn at random, for tests of learning."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.model.learning import Example
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit_placement.learning.descriptors import FeatureSets, Group

#: Values of the tuples of each type of features, as in the paper.
VALUES = {"polygon": 9, "segment": 2, "corner": 2}


def feature_sets(rng: np.random.Generator, samples: int, codes: int = 2, most: int = 5) -> FeatureSets:
    """Return the feature sets of one shape, with up to so many features of each type and label."""
    found = {}
    for of, values in VALUES.items():
        counts = rng.integers(0, most + 1, codes)
        own = np.repeat(np.arange(codes), counts)
        found[of] = Group(
            rng.uniform(0, 6, (1, samples, len(own), values)),
            rng.uniform(0, 1, (1, samples, len(own))),
            own,
            np.arange(len(own)),
        )
    return found


def polygon(rng: np.random.Generator, name: str, label: str, x: float, y: float, size: float) -> Polygon:
    """Return a star-shaped polygon about a point: a triangle up to an octagon."""
    count = int(rng.integers(3, 9))
    turns = np.sort(rng.uniform(0, 2 * np.pi, count))
    turns += np.linspace(0, 0.5, count)
    reach = rng.uniform(0.5, 1.0, count) * size
    points = tuple(
        (x + float(r * np.cos(t)), y + float(r * np.sin(t))) for r, t in zip(reach, turns, strict=True)
    )
    return Polygon(name, points, (label,))


def scene(rng: np.random.Generator, count: int = 8, size: float = 10.0) -> Scene:
    """Return a room with polygons of two labels strewn over it."""
    room = Polygon.rectangle("Room", 0, 0, size, size * 0.8, ("Room",))
    places = rng.uniform(1, (size - 1, size * 0.8 - 1), (count, 2)).tolist()
    labels = rng.choice(["A", "B"], count).tolist()
    things = [
        polygon(rng, f"P{k}", label, x, y, 0.7)
        for k, (label, (x, y)) in enumerate(zip(labels, places, strict=True))
    ]
    return Scene("drawn", "m", (room, *things))


def examples(rng: np.random.Generator, count: int, polygons: int = 8) -> Sequence[Example]:
    """Return placements anywhere in scenes of their own."""
    found = []
    for _ in range(count):
        x, y = rng.uniform(2, 6, 2)
        width, height = rng.uniform(0.6, 1.6, 2)
        placement = Placement(float(x), float(y), float(width), float(height), label="T")
        found.append(Example(scene(rng, polygons), placement))
    return found
