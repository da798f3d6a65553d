"""Spatial optimisation stated plainly, as in section 5 of Dang et al. 2014: over leaf sizes, in cvxpy.

Every size and place is a row of leaf sizes (the paper's α and β), and every constraint a row of its own. It
shares nothing with `layoutkit_editing.sizing` but the state, and serves tests as an oracle, too.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array

from layoutkit.model import Region
from layoutkit_editing.state import State
from layoutkit_editing.tree import NEW

Floats = NDArray[np.float64]
Row = dict[int, float]

#: What terminals keep of the facade, and, if they are as small as that, of themselves.
LEAST_SHARE, LEAST_OF_ITSELF = 1e-3, 0.5


@dataclass(frozen=True)
class Rows:
    """Rows of leaf sizes, and what they are equal to."""

    entries: list[tuple[int, int, float]] = field(default_factory=list)
    ends: list[float] = field(default_factory=list)

    def add(self, row: Row, end: float) -> None:
        """Add Σ factor · size = end."""
        number = len(self.ends)
        self.entries.extend((number, leaf, factor) for leaf, factor in row.items() if factor)
        self.ends.append(end)

    def matrix(self, leaves: int) -> csr_array:
        """Return the rows as a sparse matrix."""
        numbers, columns, factors = zip(*self.entries, strict=True) if self.entries else ((), (), ())
        return coo_array((factors, (numbers, columns)), shape=(len(self.ends), leaves)).tocsr()


@dataclass(frozen=True)
class PlainSizing:
    """The program of one axis."""

    state: State
    axis: int

    @cached_property
    def leaves(self) -> dict[int, int]:
        """The terminals' columns, by id."""
        tree = self.state.tree
        terminals = [own for own in tree.inside(tree.root) if tree.nodes[own].split is None]
        return {own: column for column, own in enumerate(terminals)}

    @cached_property
    def alphas(self) -> dict[int, Row]:
        """Each node's size as a row of leaf sizes."""
        nodes, rows = self.state.tree.nodes, dict[int, Row]()
        for own in reversed(list(self.state.tree.inside(self.state.tree.root))):
            if nodes[own].split is None:
                rows[own] = {self.leaves[own]: 1.0}
            elif self._along(own):
                rows[own] = {leaf: one for child in nodes[own].children for leaf, one in rows[child].items()}
            else:
                rows[own] = rows[nodes[own].children[0]]
        return rows

    @cached_property
    def betas(self) -> dict[int, Row]:
        """Where each node starts, as a row of leaf sizes."""
        tree, rows = self.state.tree, {self.state.tree.root: Row()}
        for own in tree.inside(tree.root):
            start = rows[own]
            for child in tree.nodes[own].children:
                rows[child] = start
                if self._along(own):
                    start = _sum((1.0, start), (1.0, self.alphas[child]))
        return rows

    def _along(self, own: int) -> bool:
        return self.state.tree.nodes[own].split == ("columns", "rows")[self.axis]

    @cached_property
    def equalities(self) -> Rows:
        """Hierarchy, alignment, symmetry and targets."""
        rows = Rows()
        for own, node in self.state.tree.nodes.items():
            if node.split is not None and not self._along(own):
                for one, other in pairwise(node.children):
                    rows.add(_sum((1.0, self.alphas[one]), (-1.0, self.alphas[other])), 0.0)
        for one, other, anchor, distance in self._aligned():
            rows.add(_sum((1.0, self._anchor(other, anchor)), (-1.0, self._anchor(one, anchor))), distance)
        for one, other in self._alike():
            rows.add(_sum((1.0, self.alphas[one]), (-1.0, self.alphas[other])), 0.0)
        targets = self.state.targets
        extent = targets.extents[self.axis]
        if extent is not None:
            rows.add(self.alphas[self.state.tree.root], extent)
        for found, asked in ((self.alphas, targets.sizes), (self.betas, targets.starts)):
            for (own, axis), value in asked.items():
                if axis == self.axis:
                    rows.add(found[own], value)
        return rows

    def _anchor(self, own: int, share: float) -> Row:
        return _sum((1.0, self.betas[own]), (share, self.alphas[own]))

    def _span(self, own: int) -> tuple[float, float]:
        original, shift = self.state.original, self.state.shifts.get(own, (0.0, 0.0))[self.axis]
        start, end = original.spans[self.axis, self.state.tree.nodes[own].source].tolist()
        return start + shift, end + shift

    def _aligned(self) -> Iterator[tuple[int, int, float, float]]:
        """Yield neighbours, their anchors, and how far these are apart."""
        apart = 1e-6 * float(self.state.original.sizes[self.axis, 0])
        for lattice in self.state.lattices:
            for line in lattice.lines(self.axis):
                run: list[int] = []
                for own in (*(element for element in line if element is not None), None):
                    if own is not None and run and self._overlap(run[-1], own) > apart:
                        run.append(own)
                        continue
                    yield from self._run(run)
                    run = [] if own is None else [own]

    def _overlap(self, one: int, other: int) -> float:
        nodes = self.state.tree.nodes
        if NEW in (nodes[one].source, nodes[other].source):
            return 0.0
        first, second = self._span(one), self._span(other)
        return min(first[1], second[1]) - max(first[0], second[0])

    def _run(self, run: list[int]) -> Iterator[tuple[int, int, float, float]]:
        if len(run) < 2:
            return
        sets = {share: [(1 - share) * start + share * end for start, end in map(self._span, run)]
                for share in (0.5, 0.0, 1.0)}  # fmt: skip
        spreads = {share: float(np.std(np.array(places) - places[0])) for share, places in sets.items()}
        least = min(spreads.values())
        share = next(s for s, spread in spreads.items() if spread <= least + self.state.original.tolerance)
        for (one, other), (start, end) in zip(pairwise(run), pairwise(sets[share]), strict=True):
            yield one, other, share, end - start

    def _alike(self) -> Iterator[tuple[int, int]]:
        """Yield nodes of one size: like elements of a lattice, and what is inside them."""
        tree = self.state.tree
        for lattice in self.state.lattices:
            left = list(lattice.elements)
            while left:
                head = left[0]
                same = [own for own in left if self._like(head, own)]
                left = [own for own in left if own not in same]
                for one, other in pairwise(same):
                    yield from zip(tree.inside(one), tree.inside(other), strict=True)

    def _like(self, one: int, other: int) -> bool:
        nodes, places, tolerance = (
            self.state.tree.nodes,
            self.state.original.places,
            self.state.original.tolerance,
        )
        first, second = nodes[one], nodes[other]
        if first.split != second.split or len(first.children) != len(second.children):
            return False
        if (first.source == NEW) != (second.source == NEW):
            return False
        if first.source != NEW:
            a, b = places[first.source].region, places[second.source].region
            if _looks(a) != _looks(b):
                return False
            if first.split is None and max(abs(a.width - b.width), abs(a.height - b.height)) > tolerance:
                return False
        return all(map(self._like, first.children, second.children))

    @cached_property
    def originals(self) -> Floats:
        """The sizes of the terminals' sources."""
        nodes, sizes = self.state.tree.nodes, self.state.original.sizes
        return np.array([sizes[self.axis, nodes[own].source] for own in self.leaves])

    @cached_property
    def weights(self) -> Floats:
        """W² of each terminal."""
        nodes, sizes = self.state.tree.nodes, self.state.original.sizes
        areas = np.array([np.prod(sizes[:, nodes[own].source]) for own in self.leaves])
        return np.minimum(10.0, np.prod(sizes[:, 0]) / areas) ** 2

    @cached_property
    def least(self) -> Floats:
        """The least size of each terminal."""
        extent = float(self.state.original.sizes[self.axis, 0])
        return np.minimum(LEAST_SHARE * extent, LEAST_OF_ITSELF * self.originals)

    def problem(self) -> tuple[Any, Any]:
        """Return the program and its variables, the leaf sizes as a share of the facade's."""
        import cvxpy as cp

        unit = float(self.state.original.sizes[self.axis, 0])
        sizes = cp.Variable(len(self.leaves))
        rows = self.equalities
        constraints = [sizes >= self.least / unit]
        if rows.ends:
            constraints.append(rows.matrix(len(self.leaves)) @ sizes == np.array(rows.ends) / unit)
        cost = cp.sum_squares(cp.multiply(np.sqrt(self.weights), sizes - self.originals / unit))
        return cp.Problem(cp.Minimize(cost), constraints), sizes

    def solved(self) -> Floats:
        """Return the terminals' sizes in document order, which have to be feasible."""
        import cvxpy as cp

        problem, sizes = self.problem()
        for tolerance in (1e-11, 1e-8):
            settings = {"tol_gap_abs": tolerance, "tol_gap_rel": tolerance, "tol_feas": tolerance}
            with warnings.catch_warnings(), suppress(cp.SolverError):
                warnings.simplefilter("ignore")  # near the tolerance asked for is near enough
                problem.solve(solver=cp.CLARABEL, **settings)
                return np.asarray(sizes.value) * float(self.state.original.sizes[self.axis, 0])
        raise RuntimeError("cvxpy could not tell")

    def feasible(self) -> bool:
        """Return whether any sizes keep all rows, by linear programming."""
        from scipy.optimize import linprog

        unit = float(self.state.original.sizes[self.axis, 0])
        rows = self.equalities
        found = linprog(
            np.zeros(len(self.leaves)),
            A_eq=rows.matrix(len(self.leaves)) if rows.ends else None,
            b_eq=np.array(rows.ends) / unit if rows.ends else None,
            bounds=np.stack([self.least / unit, np.full(len(self.leaves), np.inf)], axis=1),
        )
        return bool(found.status == 0)

    def cost(self, sizes: Floats) -> float:
        """Return the objective at some leaf sizes."""
        return float((self.weights * (sizes - self.originals) ** 2).sum())

    def residual(self, sizes: Floats) -> float:
        """Return by how much some leaf sizes miss the worst row."""
        rows = self.equalities
        off = np.abs(rows.matrix(len(self.leaves)) @ sizes - np.array(rows.ends))
        return float(max(off.max(initial=0.0), (self.least - sizes).max(initial=0.0)))


def _sum(*parts: tuple[float, Row]) -> Row:
    total: Row = {}
    for factor, row in parts:
        for leaf, value in row.items():
            total[leaf] = total.get(leaf, 0.0) + factor * value
    return total


def _looks(region: Region) -> tuple[object, ...]:
    return (region.labels, region.fill, region.depth, region.material)
