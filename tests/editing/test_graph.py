"""Neighbourhood graphs: made from decomposition trees, and back."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from layoutkit.model import Split
from layoutkit_editing.topology.graph import (
    AFTER,
    BEFORE,
    Extents,
    Graph,
    NoDecomposition,
    decomposed,
    graph_of,
)

#: A composite in the making: how it is split, and its parts.
Part = tuple[Split | None, tuple[int, ...]]
#: The way from the root to a leaf: for each step, along which axis and which of the parts.
Way = tuple[tuple[int, int], ...]
Parting = Callable[[int, int], int]


def unparted(first: int, second: int) -> int:
    """Fail: no four shapes meet in a point."""
    raise AssertionError(f"{first} and {second} meet in a corner")


def boxes_of(random: np.random.Generator, most: int) -> tuple[dict[int, Extents], Parting]:
    """Return the leaves of a random decomposition, its lines on a coarse raster so that many meet.

    With them goes what tells along which axis two leaves are parted.
    """
    pending: list[tuple[Extents, Way]] = [((0.0, 24.0, 0.0, 24.0), ())]
    leaves: list[tuple[Extents, Way]] = []
    while pending:
        box, way = pending.pop()
        axis = int(random.integers(2))
        start, end = box[2 * axis : 2 * axis + 2]
        inner = np.arange(start + 1, end)
        if len(inner) == 0 or len(leaves) + len(pending) >= most or random.random() < 0.15:
            leaves.append((box, way))
            continue
        cuts = sorted(random.choice(inner, size=min(len(inner), int(random.integers(1, 4))), replace=False))
        for number, (low, high) in enumerate(zip([start, *cuts], [*cuts, end], strict=True)):
            part = list(box)
            part[2 * axis : 2 * axis + 2] = float(low), float(high)
            pending.append(((part[0], part[1], part[2], part[3]), (*way, (axis, number))))

    def parting(first: int, second: int) -> int:
        steps = zip(leaves[first][1], leaves[second][1], strict=False)
        return next(one[0] for one, other in steps if one != other)

    return {own: box for own, (box, _) in enumerate(leaves)}, parting


def rebuilt(graph: Graph, boxes: dict[int, Extents]) -> dict[int, Extents]:
    """Return where leaves stand in the tree that a graph collapses to, by sizes and tiling alone."""
    parts: dict[int, Part] = {}

    def add(split: Split, children: tuple[int, ...]) -> int:
        parts[len(boxes) + len(parts)] = split, children
        return len(boxes) + len(parts) - 1

    root = decomposed(graph, add)

    def size(own: int) -> tuple[float, float]:
        if own in boxes:
            x0, x1, y0, y1 = boxes[own]
            return x1 - x0, y1 - y0
        split, children = parts[own]
        sizes = [size(child) for child in children]
        along = 0 if split == "columns" else 1
        assert len({s[1 - along] for s in sizes}) == 1, "children reach across their parent"
        total = sum(s[along] for s in sizes)
        return (total, sizes[0][1]) if along == 0 else (sizes[0][0], total)

    found: dict[int, Extents] = {}

    def stand(own: int, x: float, y: float) -> None:
        width, height = size(own)
        if own in boxes:
            found[own] = (x, x + width, y, y + height)
            return
        split, children = parts[own]
        for child in children:
            stand(child, x, y)
            x, y = (x + size(child)[0], y) if split == "columns" else (x, y + size(child)[1])

    stand(root, 0.0, 0.0)
    return found


@pytest.mark.parametrize("seed", range(20))
def test_tree_to_graph_to_tree_gives_the_same_rectangles(seed: int) -> None:
    random = np.random.default_rng(seed)
    for _ in range(30):
        boxes, parting = boxes_of(random, 40)
        assert rebuilt(graph_of(boxes, parting, 1e-6), boxes) == boxes


def test_neighbours_share_a_border_and_stand_in_reading_order() -> None:
    random = np.random.default_rng(5)
    for _ in range(50):
        boxes, parting = boxes_of(random, 30)
        graph = graph_of(boxes, parting, 1e-6)
        for axis in (0, 1):
            lines, others = slice(2 * axis, 2 * axis + 2), slice(2 - 2 * axis, 4 - 2 * axis)
            for first, one in boxes.items():
                touching = [
                    (boxes[second][others], second)
                    for second, other in boxes.items()
                    if one[lines][1] == other[lines][0]
                    and max(one[others][0], other[others][0]) < min(one[others][1], other[others][1])
                ]
                found = graph.beside[axis][AFTER][first]
                assert [own for own in found if own in dict(map(reversed, touching))] == [
                    second for _, second in sorted(touching)
                ]
                for second in found:
                    assert first in graph.beside[axis][BEFORE][second]


def test_lines_that_differ_by_noise_are_one() -> None:
    noise = 1e-9
    boxes = {0: (0.0, 1.0, 0.0, 1.0), 1: (1.0 + noise, 2.0, 0.0, 1.0), 2: (0.0, 2.0, 1.0 - noise, 2.0)}
    graph = graph_of(boxes, unparted, 1e-6)
    assert sorted(graph.edges()) == [(0, 0, 1), (1, 0, 2), (1, 1, 2)]


def test_a_windmill_is_no_decomposition() -> None:
    boxes = {
        0: (0.0, 2.0, 0.0, 1.0),
        1: (2.0, 3.0, 0.0, 2.0),
        2: (1.0, 3.0, 2.0, 3.0),
        3: (0.0, 1.0, 1.0, 3.0),
        4: (1.0, 2.0, 1.0, 2.0),
    }
    with pytest.raises(NoDecomposition, match="5 shapes interlock"):
        decomposed(graph_of(boxes, unparted, 1e-6), lambda split, children: 9)


def test_a_node_takes_over_the_neighbours_on_its_side() -> None:
    """Dang et al. 2014, figure 6: e(N, 8) is inserted.

    1 and 2 stand left of 8, 4 and 5 above it, 6 and 7 below it. Afterwards N stands between: 1 and 2 are left
    of N, N touches the leftmost of those above and of those below.
    """
    boxes = {
        1: (0.0, 1.0, 1.0, 2.0),
        2: (0.0, 1.0, 2.0, 3.0),
        8: (1.0, 3.0, 1.0, 3.0),
        4: (0.0, 2.0, 0.0, 1.0),
        5: (2.0, 3.0, 0.0, 1.0),
        6: (0.0, 2.0, 3.0, 4.0),
        7: (2.0, 3.0, 3.0, 4.0),
    }
    graph = graph_of(boxes, unparted, 1e-6)
    graph.insert(9, [8], 0, BEFORE)
    assert graph.beside[0][AFTER][1] == graph.beside[0][AFTER][2] == [9]
    assert graph.beside[0][BEFORE][9] == [1, 2]
    assert graph.beside[0][BEFORE][8] == [9]
    assert graph.beside[1][BEFORE][9] == [4]
    assert graph.beside[1][AFTER][9] == [6]
    assert graph.beside[1][AFTER][4] == [1, 9, 8]
    assert graph.beside[1][BEFORE][6] == [2, 9, 8]
