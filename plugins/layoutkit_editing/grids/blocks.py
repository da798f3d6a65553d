"""Which parts of a family of elements stand together in rows and columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from layoutkit_editing.state import Matrix

#: A block takes rows (or columns) in as long as this share of its cells is filled.
FILLED = 0.8


def blocks(cells: Matrix) -> Iterator[tuple[int, ...]]:
    """Yield elements of a lattice that fill rows and columns well: those of some of its rows, or columns.

    All of them come first. Each set is in ascending order.
    """
    found: dict[tuple[int, ...], None] = {}
    for lines in (cells, tuple(zip(*cells, strict=True))):
        for group in (tuple(range(len(lines))), *_groups(lines)):
            own = tuple(sorted(own for line in group for own in lines[line] if own is not None))
            found[own] = None
    return iter(found)


def _groups(lines: Matrix) -> list[tuple[int, ...]]:
    """Put lines together that fill the same places, then those that nearly do.

    Returns
    -------
    list[tuple[int, ...]]
        Numbers of lines: groups that fill all their places, then groups that fill `FILLED` of them.
    """
    alike: dict[int, list[int]] = {}
    for number, line in enumerate(lines):
        mask = sum(1 << place for place, own in enumerate(line) if own is not None)
        alike.setdefault(mask, []).append(number)
    groups = [
        _Group(tuple(numbers), mask, mask.bit_count() * len(numbers)) for mask, numbers in alike.items()
    ]
    full = [group.lines for group in groups]
    while pair := _best_pair(groups):
        groups = [group for group in groups if group not in pair] + [pair[0] | pair[1]]
    return full + [group.lines for group in groups]


class _Group(NamedTuple):
    """Lines, the places that any of them fills, as bits, and how many elements they hold."""

    lines: tuple[int, ...]
    places: int
    elements: int

    def __or__(self, other: _Group) -> _Group:
        lines = tuple(sorted(self.lines + other.lines))
        return _Group(lines, self.places | other.places, self.elements + other.elements)


def _best_pair(groups: Sequence[_Group]) -> tuple[_Group, _Group] | None:
    """Return those two groups that fill their places best together; None if none do well enough."""
    best, chosen = FILLED, None
    for number, one in enumerate(groups):
        for other in groups[:number]:
            cells = (one.places | other.places).bit_count() * (len(one.lines) + len(other.lines))
            share = (one.elements + other.elements) / cells
            if share >= best:
                best, chosen = share, (other, one)
    return chosen
