"""The algorithm of Bao, Schwarz and Wonka 2013, section 7: left to right, a quadratic program at each step.

Regions are laid out from the top down, depth first. A word grows symbol by symbol (`paper_words`); where no
successor is left, the search goes back; after 1000 times it starts anew.

What the paper leaves open is decided in its favour: successors that lead into a dead end of the sequences are
left out, and so are those whose content cannot have the size across; a symbol's replicas share one variable.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from benchmarks.contenders import Attempt, Maker, Size
from benchmarks.paper_words import Grown, Laid, Placed, RegionWords
from benchmarks.stated import Stated, tree
from layoutkit.model import Facade

#: Steps back before the search starts anew (section 7.3).
MOST_BACKTRACKS = 1000


class PaperBaseline:
    """Grows words left to right and restarts, as the paper does.

    Parameters
    ----------
    seconds
        For one variation, however often it starts anew.
    """

    name: ClassVar[str] = "baseline"

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds

    def maker(self, facade: Facade, size: Size) -> Maker:
        """Return a search at one size."""
        return _Descending(Stated(facade), size, self.seconds)


@dataclass(frozen=True)
class _Descending:
    stated: Stated
    size: Size
    seconds: float

    def attempt(self, seed: int) -> Attempt:
        generator = np.random.default_rng(seed)
        deadline = time.perf_counter() + self.seconds
        while time.perf_counter() < deadline:
            descent = _Descent(Laid(self.stated, self.size), generator, deadline)
            try:
                if descent.complete():
                    laid = descent.laid
                    return Attempt("found", tree(self.stated.facade, laid.words, laid.sizes, self.size))
            except _Restart:
                continue
        return Attempt("limit")


class _Restart(Exception):  # noqa: N818 - names the fact
    """Too many steps back, or too much time."""


class _Descent:
    """One descent from the root, until it succeeds or starts anew."""

    def __init__(self, laid: Laid, generator: np.random.Generator, deadline: float) -> None:
        self.laid, self.generator, self.deadline = laid, generator, deadline
        self.backtracks = 0

    def complete(self) -> bool:
        """Lay out everything; False if the whole space was searched in vain."""
        return self._complete((self.laid.stated.facade.root.symbol,))

    def _complete(self, pending: tuple[str, ...]) -> bool:
        if not pending:
            return True
        path, rest = pending[0], pending[1:]
        words = RegionWords(self.laid, path, self.generator, self._step_back)
        for grown in words.all():
            inner = self._place(path, grown)
            if self._counts(path) and self._complete((*inner, *rest)):
                return True
            self._remove(path)
        return False

    def _step_back(self) -> None:
        self.backtracks += 1
        if self.backtracks > MOST_BACKTRACKS or time.perf_counter() > self.deadline:
            raise _Restart

    def _place(self, path: str, grown: Grown) -> tuple[str, ...]:
        """Place the children of a region; return those to lay out, in random order."""
        laid, stated = self.laid, self.laid.stated
        laid.words[path] = grown.word
        axis, own = stated.axis[path], laid.placed[path]
        inner = []
        for symbol in dict.fromkeys(grown.word):
            child, along = f"{path}/{symbol}", grown.sizes[symbol]
            at = np.array([start for start, s in zip(grown.starts, grown.word, strict=True) if s == symbol])
            places = (own.starts[axis][:, None] + at[None, :]).ravel()
            size = (along, own.size[1]) if axis == 0 else (own.size[0], along)
            starts = (places, own.starts[1]) if axis == 0 else (own.starts[0], places)
            laid.placed[child], laid.sizes[child] = Placed(size, starts), along
            if child in stated.axis:
                inner.append(child)
        return tuple(inner[number] for number in self.generator.permutation(len(inner)))

    def _remove(self, path: str) -> None:
        for symbol in set(self.laid.words.pop(path)):
            del self.laid.placed[f"{path}/{symbol}"], self.laid.sizes[f"{path}/{symbol}"]

    def _counts(self, path: str) -> bool:
        """Tell whether the frequencies around a region that now has its word can still hold."""
        for rule in self.laid.stated.counts:
            if path == rule.path or path.startswith(f"{rule.path}/"):
                count, known = self.laid.count(rule.path, rule.counted)
                growth = self.laid.growth(rule.path)
                short = known and count < rule.least.at(growth) - 1e-6
                if short or count > rule.most.at(growth) + 1e-6:
                    return False
        return True
