"""Arrangements: all words chosen, no size known yet; placed regions as linear forms over cut lines.

Each symbol (within its parent) has one frame: its cut lines, kept where it occurs first. Further
occurrences are replicas: they share the interior lines, moved by the difference of two lines of their
parent, and a single row says that they are as large (Bao et al. 2013, section 7.2, in the space of lines
instead of sizes).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from layoutkit.model import Facade, Split
from layoutkit.sizing.rules import Form, Range

#: Axis numbers: x is divided by columns, y (down from the top) by rows.
AXIS: Mapping[Split, int] = {"columns": 0, "rows": 1}


@dataclass(frozen=True, slots=True, eq=False)
class Slot:
    """A region placed along one axis, its size still unknown.

    Occurrences that stand in the same place along the axis, as all bays of a floor do in height, are one.

    Attributes
    ----------
    order
        The places in their words of the slot's ancestors that the axis divides, and of itself.
    start, end
        Its ends along the axis.
    """

    symbol_path: str
    parent: Slot | None
    order: tuple[int, ...]
    start: Form
    end: Form

    def inside(self, ancestor: Slot) -> bool:
        """Tell whether the slot lies in `ancestor`; it does not lie in itself."""
        slot = self.parent
        while slot is not None and slot is not ancestor:
            slot = slot.parent
        return slot is ancestor

    def line(self, share: float) -> Form:
        """Return the line at a share of the extent: 0 the start, 0.5 the centre, 1 the end."""
        if share in (0.0, 1.0):
            return self.end if share else self.start
        return add({line: value * (1 - share) for line, value in self.start.items()}, self.end, share)


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
        self._slots: dict[tuple[str, int], tuple[Slot, ...]] = {}
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

    def slots(self, path: str, axis: int) -> tuple[Slot, ...]:
        """Return the places of a symbol path along an axis, in reading order; none if no word reaches it."""
        if path not in self.frames:
            return ()
        key = (path, axis)
        if key not in self._slots:
            self._slots[key] = tuple(self._place(path, axis))
        return self._slots[key]

    def _place(self, path: str, axis: int) -> Iterator[Slot]:
        start, end = self.frames[path].ends[axis]
        parent_path, _, symbol = path.rpartition("/")
        if not parent_path:
            yield Slot(path, None, (), {start: 1.0}, {end: 1.0})
            return
        frame, word = self.frames[parent_path], self.words[parent_path]
        divided = AXIS[self.facade.regions[parent_path].split or "columns"] == axis
        origin = {frame.ends[axis][0]: 1.0}
        for parent in self.slots(parent_path, axis):
            shift = _difference(parent.start, origin)
            if not divided:
                yield Slot(path, parent, parent.order, add({start: 1.0}, shift), add({end: 1.0}, shift))
                continue
            for index in (i for i, s in enumerate(word) if s == symbol):
                left, right = ({frame.cuts[index + i]: 1.0} for i in (0, 1))
                yield Slot(path, parent, (*parent.order, index), add(left, shift), add(right, shift))

    def count(self, path: str, counted: Collection[str]) -> tuple[int, bool]:
        """Return how many counted regions stand in a region of the path, and whether all words are known."""
        total, known = 0, True
        if self.facade.regions[path].split is not None:
            known = path in self.words
            for symbol, times in Counter(self.words.get(path, ())).items():
                inside, inner_known = self.count(f"{path}/{symbol}", counted)
                total += times * (inside + (f"{path}/{symbol}" in counted))
                known &= inner_known
        return total, known

    def extent(self, path: str, axis: int) -> Form:
        """Return the size of the symbol along an axis, the same for all its occurrences."""
        start, end = self.frames[path].ends[axis]
        return {end: 1.0, start: -1.0}

    def run(self, path: str, start: int, end: int) -> Form:
        """Return the extent of the children from `start` to before `end` of the symbol, along its split."""
        cuts = self.frames[path].cuts
        return {cuts[end]: 1.0, cuts[start]: -1.0}


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
