"""Arrangements: all words chosen, no size known yet; placed regions as linear forms over few variables.

Each symbol (within its parent) has one frame, in coordinates of its own, from 0 to its extent: however
often it occurs, its inside is stated once. What is unknown about a frame is either the size of each of its
symbols (where some occur more than once) or the cut lines between its children (where none does). Bao et al.
2013, section 7.2, have one unknown for each placed child instead.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import TYPE_CHECKING

from layoutkit.model import Facade, Split
from layoutkit.sizing.rules import SIZE, UNIT, Form, Quantity, Range

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Floats

#: Axis numbers: x is divided by columns, y (down from the top) by rows.
AXIS: Mapping[Split, int] = {"columns": 0, "rows": 1, "faces": 0}

#: Words of more different symbols than this are stated by their lines: sums of so many sizes are long rows.
_MOST_SYMBOLS = 48


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
        return add(
            {variable: factor * (1 - share) for variable, factor in self.start.items()}, self.end, share
        )

    def place(self, axis: int, share: float) -> Quantity:
        """Return the same line for rules that relate quantities; `axis` is the one that the slot is of."""
        return Quantity(axis, self.line(share))


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """The inside of one symbol, in coordinates of its own.

    Attributes
    ----------
    extent
        Its width and its height.
    cuts
        From 0 to the extent, the ends of the children along its split; none where it has no inside.
    """

    extent: tuple[Form, Form]
    cuts: tuple[Form, ...] = ()


class Arrangement:
    """The words of all composite regions that a layout reaches, and the unknowns that they leave.

    Parameters
    ----------
    facade
        What is laid out anew.
    words
        The word of every composite symbol path that the words themselves reach; one without a word is
        still undecided, and stands as a box without an inside.

    Attributes
    ----------
    frames
        Frame by symbol path, parents first.
    variables
        How many variables each axis has; the first is the facade's own size, which is given.
    tilings
        The rows that make children fill their parents, where cut lines alone do not.
    """

    def __init__(self, facade: Facade, words: Mapping[str, tuple[str, ...]]) -> None:
        self.facade, self.words = facade, words
        self.variables = [1, 1]
        self.frames: dict[str, Frame] = {}
        self.tilings: list[Range] = []
        self._slots: dict[tuple[str, int], tuple[Slot, ...]] = {}
        self._lines: dict[str, tuple[int, ...]] = {}
        self._sizes: dict[str, Mapping[str, int]] = {}
        self._add(facade.root.symbol)

    def _add(self, root: str) -> None:
        pending: list[tuple[str, tuple[Form, Form]]] = [(root, ({SIZE: 1.0}, {SIZE: 1.0}))]
        for path, extent in pending:  # which grows meanwhile
            region, word = self.facade.regions[path], self.words.get(path)
            if region.split is None or word is None or region.split == "faces":
                self.frames[path] = Frame(extent)
                pending += self._faces(path) if region.split == "faces" else ()
                continue
            axis = AXIS[region.split]
            cuts, sizes = self._divided(path, axis, word, extent[axis])
            self.frames[path] = Frame(extent, cuts)
            for symbol, size in sizes.items():
                pending.append((f"{path}/{symbol}", (size, extent[1]) if axis == 0 else (extent[0], size)))

    def _faces(self, root: str) -> Iterator[tuple[str, tuple[Form, Form]]]:
        """Yield a building's faces: their sizes are given."""
        for symbol in dict.fromkeys(self.words[root]):
            box = self.facade.faces[f"{root}/{symbol}"]
            yield f"{root}/{symbol}", ({UNIT: box.width}, {UNIT: box.height})

    def _divided(
        self, path: str, axis: int, word: Sequence[str], extent: Form
    ) -> tuple[tuple[Form, ...], dict[str, Form]]:
        """Return the cuts of a word, and the size of each of its symbols."""
        times = Counter(word)
        if len(times) == 1:
            size = {variable: factor / len(word) for variable, factor in extent.items()}
            cuts = tuple({v: n * factor for v, factor in size.items()} for n in range(len(word)))
            return ({}, *cuts[1:], extent), {word[0]: size}
        if len(times) == len(word) or len(times) > _MOST_SYMBOLS:
            return self._by_lines(path, axis, word, extent)
        return self._by_sizes(path, axis, word, extent, times)

    def _by_lines(
        self, path: str, axis: int, word: Sequence[str], extent: Form
    ) -> tuple[tuple[Form, ...], dict[str, Form]]:
        unknown = tuple(self._variable(axis) for _ in word[1:])
        self._lines[path] = unknown
        cuts: tuple[Form, ...] = ({}, *({variable: 1.0} for variable in unknown), extent)
        sizes: dict[str, Form] = {}
        for index, symbol in enumerate(word):
            size = add(cuts[index + 1], cuts[index], -1.0)
            if symbol in sizes:
                self.tilings.append(Range(axis, add(size, sizes[symbol], -1.0), 0.0, 0.0, None, (path,)))
            else:
                sizes[symbol] = size
        return cuts, sizes

    def _by_sizes(
        self, path: str, axis: int, word: Sequence[str], extent: Form, times: Mapping[str, int]
    ) -> tuple[tuple[Form, ...], dict[str, Form]]:
        unknown = {symbol: self._variable(axis) for symbol in times}
        self._sizes[path] = unknown
        total = {unknown[symbol]: float(n) for symbol, n in times.items()}
        self.tilings.append(Range(axis, add(total, extent, -1.0), 0.0, 0.0, None, (path,)))
        cuts: list[dict[int, float]] = [{}]
        for symbol in word[:-1]:
            cut = dict(cuts[-1])
            cut[unknown[symbol]] = cut.get(unknown[symbol], 0.0) + 1.0
            cuts.append(cut)
        return (*cuts, extent), {symbol: {variable: 1.0} for symbol, variable in unknown.items()}

    def _variable(self, axis: int) -> int:
        self.variables[axis] += 1
        return self.variables[axis] - 1

    def slots(self, path: str, axis: int) -> tuple[Slot, ...]:
        """Return the places of a symbol path along an axis, in reading order; none if no word reaches it."""
        if path not in self.frames:
            return ()
        key = (path, axis)
        if key not in self._slots:
            self._slots[key] = tuple(self._place(path, axis))
        return self._slots[key]

    def _place(self, path: str, axis: int) -> Iterator[Slot]:
        parent_path, _, symbol = path.rpartition("/")
        if not parent_path:
            yield Slot(path, None, (), {}, {SIZE: 1.0})
            return
        frame = self.frames[parent_path]
        if path in self.facade.faces:
            box = self.facade.faces[path]
            # Along y, down from the top of the highest face.
            start: Form = {UNIT: box.x0} if axis == 0 else {SIZE: 1.0, UNIT: -box.y1}
            (parent,) = self.slots(parent_path, axis)
            yield Slot(path, parent, parent.order, start, add(start, self.extent(path, axis)))
            return
        if AXIS[self.facade.regions[parent_path].split or "columns"] != axis:
            for parent in self.slots(parent_path, axis):
                yield Slot(path, parent, parent.order, parent.start, parent.end)
            return
        places = [i for i, s in enumerate(self.words[parent_path]) if s == symbol]
        for parent in self.slots(parent_path, axis):
            for index in places:
                start, end = (add(parent.start, frame.cuts[index + i]) for i in (0, 1))
                yield Slot(path, parent, (*parent.order, index), start, end)

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

    def nominal(self, axis: int, size: float, centre: Callable[[str], float]) -> list[float]:
        """Return all variables, and 1 behind them, where each region has its share of its parent.

        Parameters
        ----------
        size
            The facade's extent along the axis.
        centre
            Gives the size of a region, by its path, of which its share is that of its siblings' sum.
        """
        values = [0.0] * (self.variables[axis] + 1)
        values[0], values[-1] = size, 1.0
        for path in self.frames:
            if path not in self._lines and path not in self._sizes:
                continue
            if AXIS[self.facade.regions[path].split or "columns"] != axis:
                continue
            word = self.words[path]
            own = {symbol: centre(f"{path}/{symbol}") for symbol in dict.fromkeys(word)}
            factor = value(self.frames[path].extent[axis], values) / sum(own[symbol] for symbol in word)
            for symbol, variable in self._sizes.get(path, {}).items():
                values[variable] = own[symbol] * factor
            ends = accumulate(own[symbol] for symbol in word)
            for end, variable in zip(ends, self._lines.get(path, ()), strict=False):
                values[variable] = end * factor
        return values

    def extent(self, path: str, axis: int) -> Form:
        """Return the size of the symbol along an axis, the same for all its occurrences."""
        return self.frames[path].extent[axis]

    def size(self, path: str, axis: int) -> Quantity:
        """Return the size of the symbol along an axis, for rules that relate quantities."""
        return Quantity(axis, self.extent(path, axis))

    def run(self, path: str, start: int, end: int) -> Form:
        """Return the extent of the children from `start` to before `end` of the symbol, along its split."""
        cuts = self.frames[path].cuts
        return add(cuts[end], cuts[start], -1.0)


def add(first: Form, second: Form, factor: float = 1.0) -> dict[int, float]:
    """Return first + factor · second, without the variables that cancel."""
    total = dict(first)
    for variable, own in second.items():
        new = total.get(variable, 0.0) + factor * own
        if abs(new) < 1e-12:
            total.pop(variable, None)
        else:
            total[variable] = new
    return total


def value(form: Form, values: Sequence[float] | Floats) -> float:
    """Return the value of a form, given all variables: the first is the facade's size, the last is 1."""
    return float(sum(factor * values[variable] for variable, factor in form.items()))
