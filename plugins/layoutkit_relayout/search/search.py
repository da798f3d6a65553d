"""The search: words first, group by group, then both axes sized at once; ever more patiently."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from layoutkit.model import Region
from layoutkit.sizing.qp import Backend
from layoutkit_relayout.bounding.foresight import Foresight
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.candidates import Candidates
from layoutkit_relayout.search.descent import Descent, Patience, Progress, Words
from layoutkit_relayout.sizes.measures import Measures

#: Successive multiples of it spread evenly over 0 to 1, whatever their number.
_GOLDEN = 0.6180339887498949

#: Few at first, all words at last.
ROUNDS = (Patience(5, 12, 0), Patience(40, 60, 6), Patience(math.inf, 400, 6))
#: Linear programs for a proof by numbers and sizes alone, once words have been tried in vain.
_PROGRAMS = 200


@dataclass(frozen=True)
class Found:
    """What a search ends with: the regions, or why there are none.

    Attributes
    ----------
    nodes
        How many words were tried.
    """

    status: Literal["found", "infeasible", "limit"]
    root: Region | None
    nodes: int


class Search:
    """Finds layouts of one facade at one size; its tables serve every variation.

    Parameters
    ----------
    size
        Width and height, in document units.

    Attributes
    ----------
    programs
        Linear programs that a proof by numbers and sizes alone may take; 0: none is solved, for such proofs
        or to look ahead.
    """

    programs = _PROGRAMS

    def __init__(self, model: Model, size: tuple[float, float], backends: Sequence[Backend]) -> None:
        self.model, self.size = model.at(size), size
        self.candidates = Candidates(self.model, size)
        self.measures = Measures(self.model, backends)

    @cached_property
    def foresight(self) -> Foresight:
        """What numbers and sizes alone forbid; most searches never ask."""
        return Foresight(self.model, self.size)

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Find one layout; variation `index` of a seed is the same whichever others are made."""
        offsets = np.random.default_rng(np.random.SeedSequence(seed))
        shares = {group: float((offsets.random() + index * _GOLDEN) % 1.0) for group in self.model.groups}
        progress = Progress(node_limit)
        self.candidates.exact = True  # as far as this variation looks
        for patience in ROUNDS:
            progress.patience, progress.cut_short, progress.undecided = patience, False, False
            descent = Descent(self, progress, shares, generator_of(seed, index, 0))
            for words in descent.complete():
                sizes = generator_of(seed, index, 1)
                measured = self.measures.whole(words, self.size, sizes, patience.problems)
                if measured.root is not None:
                    return Found("found", measured.root, progress.used)
                progress.undecided |= measured.conflict is None
                descent.fail(measured)
            if not (progress.cut_short or progress.undecided or progress.used >= progress.nodes):
                break
            if self._refuted(node_limit):
                return Found("infeasible", None, progress.used)
            if progress.used >= progress.nodes:
                break
        proved = not (progress.undecided or progress.used >= progress.nodes)
        proved &= self.candidates.exact and self.model.exact
        return Found("infeasible" if proved else "limit", None, progress.used)

    def _refuted(self, node_limit: int) -> bool:
        """Tell whether numbers and sizes alone prove that there is no layout."""
        return self.model.exact and self.foresight.refutes({}, min(node_limit, self.programs))

    def arrangements(self, node_limit: int) -> Iterator[Words]:
        """Yield the words of every layout that exists, by symbol path, each assignment once.

        Raises
        ------
        Undecided
            If the budget does not suffice to tell.
        """
        progress = Progress(node_limit)
        self.candidates.exact = True
        generator = np.random.default_rng(0)
        descent = Descent(self, progress, {}, generator)
        for words in descent.complete():
            measured = self.measures.whole(words, self.size, generator, progress.patience.problems)
            if measured.root is not None:
                yield words
            elif measured.conflict is None:
                raise Undecided(
                    f"sizing one arrangement takes more than {progress.patience.problems} programs"
                )
            else:
                descent.fail(measured)
        if progress.used >= progress.nodes:
            raise Undecided(f"there are more than {node_limit} words to try")


class Undecided(Exception):  # noqa: N818 - names the fact
    """A budget ended what was to be told for certain."""


def generator_of(seed: int, index: int, purpose: int) -> np.random.Generator:
    """Return the source of a variation's random choices: of words (0), or of sizes (1).

    Sizes have one of their own, so that they do not hang on how many words failed before.
    """
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(index, purpose)))
