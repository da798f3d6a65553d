"""What is left to chance: which of several shapes is propagated, and where (section 9)."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence

import numpy as np

from layoutkit.scenes.features import Array, Indices


def chosen(scopes: Sequence[Hashable], count: int, generator: np.random.Generator) -> Mapping[Hashable, int]:
    """Draw one of so many shapes for each scope, in order of appearance."""
    return {scope: int(generator.integers(count)) for scope in dict.fromkeys(scopes)}


def drawn(weights: Array, count: int, generator: np.random.Generator) -> Indices:
    """Draw indices without repetition, each in turn as likely as its weight says; none of weight 0.

    Gumbel noise on the logarithms makes one sort of it.
    """
    (some,) = np.nonzero(weights > 0)
    keys = np.log(weights[some]) + generator.gumbel(size=len(some))
    return some[np.argsort(-keys, kind="stable")[:count]]
