"""Elements that are to have one size: the paper's symmetry constraints, and what follows inside them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import chain, count
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.lattices import Members
from layoutkit_editing.sizing.matrices import Matrix, entered

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Classes:
    """Nodes by the size that they share, and these sizes as sums of few variables.

    Attributes
    ----------
    nodes
        Positions in the tree, each once.
    numbers
        The class of each.
    forms
        The size of each class (classes × variables), and an empty row at the end.
    """

    nodes: Ints
    numbers: Ints
    forms: Matrix


def like(members: Members, kinds: Ints) -> tuple[Ints, Ints]:
    """Return the elements, each once, and the class of each: like ones of a lattice are of one class.

    An element of several lattices joins their classes.
    """
    keys, numbers = np.unique(members.lattices * (1 + kinds.max(initial=0)) + kinds, return_inverse=True)
    nodes, first, own = np.unique(members.nodes, return_index=True, return_inverse=True)
    if len(nodes) < len(members.nodes):
        numbers = _joined(np.arange(len(keys)), numbers, numbers[first[own]])[numbers]
    return nodes, numbers[first]


def _joined(names: Ints, first: Ints, second: Ints) -> Ints:
    """Return a name for each class, the same for those that pairs join: the number of the first of them."""
    while True:
        least = np.minimum(names[first], names[second])
        new = names.copy()
        np.minimum.at(new, first, least)
        np.minimum.at(new, second, least)
        new = new[new]
        if np.array_equal(new, names):
            return names
        names = new


class Opening:
    """Opens like elements alike: where one has constraints inside, the interiors of all are tied.

    The children of each rank are a class then, and so on inwards, as far as there are constraints. Of others
    no rows are needed: alike, and of one size, they are divided alike.

    Attributes
    ----------
    open_
        Composites with constraints inside.
    groups
        Members of each class of two or more.
    """

    def __init__(self, flat: Flat, open_: Flags, nodes: Ints, numbers: Ints) -> None:
        self.flat, self.open_ = flat, open_.copy()
        order = np.argsort(numbers, kind="stable")
        bounds = np.flatnonzero(np.diff(numbers[order])) + 1
        groups = [group.tolist() for group in np.split(nodes[order], bounds) if len(group) > 1]
        self.groups: dict[int, list[int]] = dict(enumerate(groups))
        self._inner: dict[int, list[int]] = {}
        pending = [number for number, group in self.groups.items() if self.open_[group].any()]
        if pending:
            self._class_of = {node: number for number, group in self.groups.items() for node in group}
            self._numbers = count(len(self.groups))
            while pending:
                number = pending.pop()
                if number in self.groups:
                    pending += self._open(number)

    def _open(self, number: int) -> list[int]:
        """Open a class, and return the classes of children that have to be opened next."""
        nodes = self.groups[number]
        self.open_[nodes] = True
        first, found = self.flat.first[nodes], []
        self._inner[number] = first[0] + np.arange(self.flat.counts[nodes[0]])
        for rank in range(int(self.flat.counts[nodes[0]])):
            inner = self._tie((first + rank).tolist())
            if inner is not None and self.open_[self.groups[inner]].any():
                found.append(inner)
        return found

    def _tie(self, nodes: list[int]) -> int | None:
        """Make nodes, and all that they are tied to, one class; return it unless it was one before."""
        classes = self._class_of
        numbers = [classes.get(node, -1) for node in nodes]
        known = [number for number in dict.fromkeys(numbers) if number >= 0]
        new = [node for node, number in zip(nodes, numbers, strict=True) if number < 0]
        if len(known) == 1 and not new:
            return None
        number = known[0] if known else next(self._numbers)
        for other in known[1:]:
            new += self.groups.pop(other)
        self.groups.setdefault(number, []).extend(new)
        classes.update((node, number) for node in new)
        return number

    def classes(self, axis: int, singles: Iterable[int], lines: tuple[Ints, Ints]) -> Classes:
        """Return all classes, and further nodes as classes of one.

        Classes with nodes between the same two lines are one. The size of an open class that is divided along
        the axis is the sum of those of its children.
        """
        sizes = self.flat.sizes
        groups = sorted(self.groups.items(), key=lambda item: int(sizes[item[1][0]]))  # inner ones first
        members = [nodes for _, nodes in groups] + [[node] for node in singles]
        row = {number: place for place, (number, _) in enumerate(groups)}
        sums = {row[number]: self._sum(number, axis, row) for number in self._inner if number in row}
        nodes = np.fromiter(chain.from_iterable(members), np.int64)
        numbers = np.repeat(np.arange(len(members)), list(map(len, members)))
        names = _between(nodes, numbers, set(sums), lines)
        return Classes(nodes, names[numbers], _forms(names, sums))

    def _sum(self, number: int, axis: int, row: dict[int, int]) -> list[int]:
        """Return the classes whose sizes add up to that of an open one."""
        inner = [row[self._class_of[int(child)]] for child in self._inner[number]]
        return inner if self.flat.along[self.groups[number][0]] == axis else inner[:1]


def _forms(names: Ints, sums: dict[int, list[int]]) -> Matrix:
    """Return the size of each class: a variable, or the sum of others; and an empty row at the end."""
    variable = np.ones(len(names), dtype=bool)
    variable[list(sums)] = False
    own, columns = np.unique(names[variable], return_inverse=True)
    rows, values = np.flatnonzero(variable), np.ones(len(columns))
    if sums:
        totals: dict[int, Counter[int]] = {}
        column_of = dict(zip(rows.tolist(), columns.tolist(), strict=True))
        for place in sorted(sums):  # inner ones first
            totals[place] = Counter()
            for inner in sums[place]:
                totals[place].update(totals[inner] if inner in totals else (column_of[inner],))
        more = [(place, *item) for place, total in totals.items() for item in total.items()]
        table = np.array(more, dtype=np.int64)
        rows, columns = np.append(rows, table[:, 0]), np.append(columns, table[:, 1])
        values = np.append(values, table[:, 2].astype(float))
    return entered(rows, columns, values, (len(names) + 1, len(own)))


def _between(nodes: Ints, numbers: Ints, sums: set[int], lines: tuple[Ints, Ints]) -> Ints:
    """Return a name for each class, the same for those with nodes between the same lines, except sums."""
    starts, ends = lines
    names = np.arange(int(numbers.max(initial=-1)) + 1)
    if sums:
        plain = ~np.isin(numbers, list(sums))
        nodes, numbers = nodes[plain], numbers[plain]
    keys = starts[nodes] * (1 + len(starts)) + ends[nodes]
    order = np.argsort(keys, kind="stable")
    same = np.flatnonzero(keys[order[1:]] == keys[order[:-1]])
    pairs = np.unique(numbers[order[same]] * len(names) + numbers[order[same + 1]])
    return names if not len(pairs) else _joined(names, pairs // len(names), pairs % len(names))
