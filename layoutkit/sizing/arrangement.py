"""Arrangements: all words chosen, no size known yet; placed regions as linear forms over cut lines.

Each symbol (within its parent) has one frame: its cut lines, kept where it occurs first. Further
occurrences are replicas: they share the interior lines, moved by the difference of two lines of their
parent, and a single row says that they are as large (Bao et al. 2013, section 7.2, in the space of lines
instead of sizes).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from layoutkit.model import Facade, Region, Split
from layoutkit.sizing.rules import Form, Range

#: Axis numbers: x is divided by columns, y (down from the top) by rows.
AXIS: Mapping[Split, int] = {"columns": 0, "rows": 1}

Interval = tuple[Form, Form]


@dataclass(frozen=True, slots=True, eq=False)
class Slot:
    """A placed region whose size is still unknown.

    Attributes
    ----------
    symbol_path
        Its symbol path; `index` is its place in the parent's word.
    spans
        Start and end, as forms over the lines of x and of y.
    """

    symbol_path: str
    region: Region
    parent: Slot | None
    index: int
    spans: tuple[Interval, Interval]

    @property
    def order(self) -> tuple[int, ...]:
        """The places in their words of the slot's ancestors along its own axis, and of itself."""
        split = self.parent.region.split if self.parent is not None else None
        order: list[int] = []
        slot = self
        while slot.parent is not None:
            if slot.parent.region.split == split:
                order.append(slot.index)
            slot = slot.parent
        return tuple(reversed(order))

    def inside(self, ancestor: Slot) -> bool:
        """Tell whether the slot lies in `ancestor`, or is it."""
        slot: Slot | None = self
        while slot is not None and slot is not ancestor:
            slot = slot.parent
        return slot is ancestor


@dataclass(frozen=True, slots=True)
class Frame:
    """The cut lines of one symbol: start and end in each axis, and those between along its split."""

    ends: tuple[tuple[int, int], tuple[int, int]]
    cuts: tuple[int, ...] = ()


class Arrangement:
    """The words of all composite regions that a layout reaches, and the lines that they make.

    Parameters
    ----------
    facade
        What is laid out anew.
    words
        The word of every composite symbol path that the words themselves reach; one without a word is
        still undecided, and stands as a box without an inside.
    size
        Width and height.

    Attributes
    ----------
    frames
        Frame by symbol path, parents first.
    lines
        How many lines each axis has; numbers 0 and 1 are the facade's own two ends.
    replicas
        The equality rows of replicas, one for each further occurrence.
    """

    def __init__(
        self, facade: Facade, words: Mapping[str, tuple[str, ...]], size: tuple[float, float]
    ) -> None:
        self.facade, self.words, self.size = facade, words, size
        self.lines = [2, 2]
        self.frames: dict[str, Frame] = {}
        self.replicas: list[Range] = []
        self._slots: dict[str, tuple[Slot, ...]] = {}
        self._add(facade.root.symbol, ((0, 1), (0, 1)))

    def _add(self, root: str, ends: tuple[tuple[int, int], tuple[int, int]]) -> None:
        pending = [(root, ends)]
        while pending:
            path, (x, y) = pending.pop()
            region = self.facade.regions[path]
            word = self.words.get(path)
            if region.split is None or word is None:
                self.frames[path] = Frame((x, y))
                continue
            axis = AXIS[region.split]
            start, end = (x, y)[axis]
            inner = tuple(range(self.lines[axis], self.lines[axis] + len(word) - 1))
            self.lines[axis] += len(inner)
            cuts = (start, *inner, end)
            self.frames[path] = Frame((x, y), cuts)
            first: dict[str, int] = {}
            for index, symbol in enumerate(word):
                if symbol in first:
                    self.replicas.append(_as_large(axis, cuts, first[symbol], index))
                    continue
                first[symbol] = index
                span = (cuts[index], cuts[index + 1])
                pending.append((f"{path}/{symbol}", (span, y) if axis == 0 else (x, span)))

    def occurrences(self, path: str) -> tuple[Slot, ...]:
        """Return every placed region of the symbol path, in reading order; none if no word reaches it."""
        if path not in self.frames:
            return ()
        if path not in self._slots:
            self._slots[path] = tuple(self._place(path))
        return self._slots[path]

    def _place(self, path: str) -> Iterator[Slot]:
        region, frame = self.facade.regions[path], self.frames[path]
        spans = tuple(({start: 1.0}, {end: 1.0}) for start, end in frame.ends)
        parent_path, _, symbol = path.rpartition("/")
        if not parent_path:
            yield Slot(path, region, None, 0, (spans[0], spans[1]))
            return
        parent_frame, word = self.frames[parent_path], self.words[parent_path]
        split = self.facade.regions[parent_path].split
        axis = AXIS["rows" if split == "rows" else "columns"]
        first = word.index(symbol)
        for parent in self.occurrences(parent_path):
            shifts = [_difference(parent.spans[a][0], {parent_frame.ends[a][0]: 1.0}) for a in (0, 1)]
            for index in (i for i, s in enumerate(word) if s == symbol):
                moved = list(shifts)
                step = _difference({parent_frame.cuts[index]: 1.0}, {parent_frame.cuts[first]: 1.0})
                moved[axis] = add(moved[axis], step)
                placed = [(add(spans[a][0], moved[a]), add(spans[a][1], moved[a])) for a in (0, 1)]
                yield Slot(path, region, parent, index, (placed[0], placed[1]))

    def extent(self, path: str, axis: int) -> Form:
        """Return the size of the symbol along an axis, the same for all its occurrences."""
        start, end = self.frames[path].ends[axis]
        return {end: 1.0, start: -1.0}


def add(first: Form, second: Form, factor: float = 1.0) -> Form:
    """Return first + factor · second, without the lines that cancel."""
    total = dict(first)
    for line, value in second.items():
        total[line] = total.get(line, 0.0) + factor * value
        if total[line] == 0.0:
            del total[line]
    return total


def _difference(first: Form, second: Form) -> Form:
    return add(first, second, -1.0)


def _as_large(axis: int, cuts: tuple[int, ...], first: int, other: int) -> Range:
    size = {cuts[first + 1]: 1.0, cuts[first]: -1.0}
    form = _difference({cuts[other + 1]: 1.0, cuts[other]: -1.0}, size)
    return Range(axis, form, 0.0, 0.0, None)
