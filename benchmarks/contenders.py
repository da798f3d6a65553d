"""What the benchmarks compare: makers of variations, all on the same facades, judged by the same checker."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import ClassVar, Protocol

from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search
from layoutkit_relayout.stage import NODE_LIMIT

Size = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Attempt:
    """What a contender says of one variation.

    Attributes
    ----------
    status
        ``found``, ``infeasible`` (proved) or ``limit``.
    root
        The regions, where it found some.
    """

    status: str
    root: Region | None = None


class Maker(Protocol):
    """Makes variations of one facade at one size."""

    def attempt(self, seed: int) -> Attempt:
        """Try to make one."""
        ...


class Contender(Protocol):
    """A way to make variations.

    Attributes
    ----------
    name
        What tables call it.
    """

    name: ClassVar[str]

    def maker(self, facade: Facade, size: Size) -> Maker:
        """Make ready for a facade and a size; what this takes is no part of a variation's time."""
        ...


class Ours:
    """The relayout stage's own search; a facade is compiled once for all sizes."""

    name: ClassVar[str] = "layoutkit"

    def __init__(self, node_limit: int = NODE_LIMIT) -> None:
        self.node_limit = node_limit
        self._models: dict[int, tuple[Facade, Model]] = {}

    def maker(self, facade: Facade, size: Size) -> Maker:
        """Return a search at one size."""
        if id(facade) not in self._models:
            self._models[id(facade)] = facade, Model(facade)
        return _Searching(Search(self._models[id(facade)][1], size, BACKENDS), self.node_limit)


@dataclass(frozen=True)
class _Searching:
    search: Search
    node_limit: int

    def attempt(self, seed: int) -> Attempt:
        found = self.search.variation(seed, 0, self.node_limit)
        return Attempt(found.status, found.root)


@dataclass(frozen=True, slots=True)
class Trial:
    """One variation, timed and checked.

    Attributes
    ----------
    status
        The contender's, or ``wrong`` for a layout that the checker does not pass.
    milliseconds, processor, checking
        Search and sizing, by the clock and by the processor; the check of the finished layout.
    terminals
        How many the layout has; 0 where there is none.
    """

    size: Size
    seed: int
    status: str
    milliseconds: float
    processor: float
    checking: float
    terminals: int


def trial(facade: Facade, size: Size, maker: Maker, seed: int) -> Trial:
    """Make one variation, and check it with the checker that every layout has to pass."""
    start, busy = time.perf_counter(), time.process_time()
    attempt = maker.attempt(seed)
    times = 1000 * (time.perf_counter() - start), 1000 * (time.process_time() - busy)
    if attempt.root is None:
        return Trial(size, seed, attempt.status, *times, 0.0, 0)
    layout = Layout(f"{facade.name}-{seed}", facade.units, attempt.root, facade, seed=seed)
    start = time.perf_counter()
    status = "wrong" if layout.violations() else "found"
    checking = 1000 * (time.perf_counter() - start)
    return Trial(size, seed, status, *times, checking, terminals_of(attempt.root))


def terminals_of(root: Region) -> int:
    """Return how many terminals stand in a region; replicas, which are one object, are counted once each."""
    counts: dict[int, int] = {}
    pending = [root]
    while pending:
        region = pending[-1]
        open_children = [child for child in region.children if id(child) not in counts]
        if open_children:
            pending += open_children
            continue
        pending.pop()
        counts[id(region)] = sum(counts[id(child)] for child in region.children) if region.children else 1
    return counts[id(root)]
