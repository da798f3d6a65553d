"""Repeated random sub-sampling cross-validation (Guerrero et al. 2015, section 5).

In each split, examples are drawn from as many scenes, one from each, and what is learned from the first one,
two, and so on of them proposes placements in other scenes. All methods get the same splits.
"""

from __future__ import annotations

import time
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.placement.matching import Judged, Quality, best, judged
from benchmarks.placement.methods import Method
from benchmarks.placement.operations import Operation, Stage

#: Shapes are learned from at most so many examples.
EXAMPLES = 5


@dataclass(frozen=True, slots=True)
class Split:
    """Who teaches and who is asked.

    Attributes
    ----------
    examples
        A stage each, and which of its shapes is the example.
    tests
        Stages that none of the examples is from.
    """

    examples: tuple[tuple[int, int], ...]
    tests: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Result:
    """What a method did in one split with one number of examples.

    Attributes
    ----------
    quality
        At the threshold that is best for these proposals, as a user would set it after this propagation.
    found
        The proposals of all test scenes together.
    fitting, proposing
        Seconds to learn, and to propose in one scene, in the mean.
    """

    operation: str
    method: str
    split: int
    examples: int
    quality: Quality
    found: Judged
    fitting: float
    proposing: float


def splits(operation: Operation, stages: Sequence[Stage], count: int, tests: int, seed: int) -> list[Split]:
    """Draw splits; the same for the same arguments.

    Parameters
    ----------
    count
        How many.
    tests
        In how many scenes of each placements are proposed; fewer where there are not as many.

    Raises
    ------
    ValueError
        If there are not enough scenes for the examples and a test.
    """
    if len(stages) <= EXAMPLES:
        raise ValueError(f"{operation.name}: {len(stages)} scenes are not enough, {EXAMPLES + 1} are needed")
    rng = np.random.default_rng([seed, zlib.crc32(operation.name.encode())])
    found = []
    for _ in range(count):
        order = rng.permutation(len(stages)).tolist()
        examples = tuple((own, int(rng.integers(len(stages[own].truths)))) for own in order[:EXAMPLES])
        found.append(Split(examples, tuple(order[EXAMPLES : EXAMPLES + tests])))
    return found


def results(
    operation: Operation,
    method: Method,
    stages: Sequence[Stage],
    split: Split,
    number: int,
    examples: Sequence[int],
) -> Iterator[Result]:
    """Yield what a method does in one split, for each number of examples that it can learn from."""
    shown = [stages[own].example(which) for own, which in split.examples]
    for count in (each for each in examples if each <= method.most):
        start = time.perf_counter()
        fitted = method.fit(shown[:count], operation.settings)
        learned = time.perf_counter()
        parts = [judged(fitted.propose(stages[own].scene), stages[own].truths) for own in split.tests]
        proposing = (time.perf_counter() - learned) / len(parts)
        found = Judged.together(parts)
        yield Result(
            operation.name, method.name, number, count, best(found), found, learned - start, proposing
        )
