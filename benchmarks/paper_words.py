"""Words of one region, grown from left to right, all symbols sized anew at each step (section 7.2)."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.contenders import Size
from benchmarks.stated import Line, Run, Stated

Floats = NDArray[np.float64]
Word = tuple[str, ...]

#: Regions overlap, or are out of line, from this share of the facade's size on.
_OVERLAP = 2e-7
#: Programs solved for one word, as alignments become active.
_ROUNDS = 12
#: The paper spreads initial sizes little; regions that nothing bounds are not spread further than this share.
_WIDEST = 0.2
#: Draws of an initial size before the nearest that is allowed is taken.
_DRAWS = 20
#: How daqp marks equalities.
_EQUALITY = 5


@dataclass(frozen=True, eq=False)
class Placed:
    """All occurrences of a region: its width and height, and where it starts along x and (down) along y."""

    size: tuple[float, float]
    starts: tuple[Floats, Floats]


@dataclass(frozen=True, eq=False)
class _Other:
    """A placed region that another has to align with: where it stands along an axis, and at which lines."""

    starts: Floats
    size: float
    shares: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class _Row:
    """least ≤ factors · sizes ≤ most, over the symbols of a region."""

    factors: Floats
    least: float
    most: float


class Laid:
    """What is laid out so far.

    Attributes
    ----------
    words, sizes
        The word of each region that has one; the size along its parent's split of each that is placed.
    placed
        Where each region stands.
    """

    def __init__(self, stated: Stated, size: Size) -> None:
        self.stated, self.size = stated, size
        self.words: dict[str, Word] = {}
        self.sizes: dict[str, float] = {}
        origin = np.zeros(1)
        self.placed = {stated.facade.root.symbol: Placed(size, (origin, origin))}

    def growth(self, path: str) -> float:
        """Return a region's size along its split over its input size."""
        axis, region = self.stated.axis[path], self.stated.facade.regions[path]
        return self.placed[path].size[axis] / (region.width, region.height)[axis]

    def count(self, path: str, counted: frozenset[str]) -> tuple[int, bool]:
        """Return how many counted regions stand in a region, and whether all words in it are known."""
        if path not in self.stated.axis:
            return 0, True
        if path not in self.words:
            return 0, not any(other.startswith(f"{path}/") for other in counted)
        count, known = 0, True
        for symbol, times in Counter(self.words[path]).items():
            inside, known_inside = self.count(f"{path}/{symbol}", counted)
            count += times * (inside + (f"{path}/{symbol}" in counted))
            known &= known_inside
        return count, known


@dataclass(frozen=True, eq=False)
class Grown:
    """A word with the sizes of its symbols, and where each of its elements starts."""

    word: Word
    sizes: dict[str, float]
    starts: Floats


@dataclass(frozen=True, eq=False)
class _Growth:
    """A word so far: its first elements and, in a mirrored region, as many last ones.

    Attributes
    ----------
    rows
        Alignments that have become active.
    """

    state: int = 0
    word: Word = ()
    rows: tuple[_Row, ...] = ()
    targets: dict[str, float] = field(default_factory=dict)


class RegionWords:
    """The words and sizes of one region, given all that is placed before it."""

    def __init__(
        self, laid: Laid, path: str, generator: np.random.Generator, step_back: Callable[[], None]
    ) -> None:
        self.laid, self.path, self.stated = laid, path, laid.stated
        self.generator, self.step_back = generator, step_back
        self.axis = self.stated.axis[path]
        own = laid.placed[path]
        self.length, across = own.size[self.axis], own.size[1 - self.axis]
        self.bases = np.unique(own.starts[self.axis])
        self.grammar = self.stated.grammars[path]
        self.partners = self.stated.partners.get(path)
        self.symbols = self.stated.children(path)
        self.number = {symbol: number for number, symbol in enumerate(self.symbols)}
        self.identity: Floats = np.eye(len(self.symbols))
        hulls = [self.stated.hull(f"{path}/{symbol}", self.axis) for symbol in self.symbols]
        self.least = np.array([low for low, _ in hulls])
        self.most = np.array([high for _, high in hulls])
        self.open = {symbol for symbol in self.symbols if self._fits_across(symbol, across)}
        self.others = {symbol: self._aligned(symbol) for symbol in self.symbols}
        self.tolerance = _OVERLAP * max(laid.size)
        self.constants = [self._constant(number) for number in range(len(self.stated.equal))]

    def _fits_across(self, symbol: str, across: float) -> bool:
        low, high = self.stated.hull(f"{self.path}/{symbol}", 1 - self.axis)
        return low <= across * (1 + 1e-9) and across * (1 - 1e-9) <= high

    def _aligned(self, symbol: str) -> list[_Other]:
        """Return the regions placed elsewhere that a child may have to align with."""
        child = f"{self.path}/{symbol}"
        shares: defaultdict[str, set[float]] = defaultdict(set)
        for line in self.stated.lines:
            if line.axis == self.axis:
                for other in _opposite(line, child):
                    if other in self.laid.placed and other.rpartition("/")[0] != self.path:
                        shares[other].add(line.share)
        placed = ((self.laid.placed[other], tuple(sorted(own))) for other, own in shares.items())
        return [_Other(np.unique(one.starts[self.axis]), one.size[self.axis], own) for one, own in placed]

    def _constant(self, number: int) -> float | None:
        """Return the size that a same-size constraint has from what is placed already."""
        equal = self.stated.equal[number]
        if equal.axis != self.axis:
            return None
        for path in equal.regions:
            if path in self.laid.placed and path.rpartition("/")[0] != self.path:
                return self.laid.placed[path].size[self.axis]
        for run in equal.runs:
            if run.within != self.path and run.within in self.laid.words:
                word = self.laid.words[run.within]
                for start, end in run.occurrences(word):
                    return sum(self.laid.sizes[f"{run.within}/{symbol}"] for symbol in word[start:end])
        return None

    def all(self) -> Iterator[Grown]:
        """Yield every word that can be sized, in random order."""
        yield from self._grow(_Growth())

    def _grow(self, growth: _Growth) -> Iterator[Grown]:
        options: list[str | None] = [s for s in self.grammar.next[growth.state] if s in self.open]
        options += self._endings(growth)
        for number in self.generator.permutation(len(options)):
            symbol = options[number]
            if symbol in ("", None):
                yield from self._ended(growth, symbol == "")
            elif (longer := self._longer(growth, symbol)) is not None:
                yield from self._grow(longer)
        self.step_back()

    def _endings(self, growth: _Growth) -> list[str | None]:
        """Return the ways to end here: None plainly; "" with the last element in the middle of a mirror."""
        if self.partners is None:
            return [None] if growth.state in self.grammar.accepting else []
        return [None, ""] if growth.word else []

    def _whole(self, growth: _Growth, centred: bool) -> Word:
        if self.partners is None:
            return growth.word
        mirrored = tuple(self.partners[symbol] for symbol in reversed(growth.word))
        return growth.word + mirrored[1 if centred else 0 :]

    def _ended(self, growth: _Growth, centred: bool) -> Iterator[Grown]:
        word = self._whole(growth, centred)
        if self.partners is not None and not self.grammar.accepts(word):
            return
        if centred and self.partners is not None and self.partners[growth.word[-1]] != growth.word[-1]:
            return
        found = self._sized(_Elements(self, word, ()), growth.rows, growth.targets, True)
        if found is not None:
            sizes, _, elements = found
            values = {symbol: float(sizes[number]) for symbol, number in self.number.items()}
            yield Grown(word, values, elements.starts(sizes))

    def _longer(self, growth: _Growth, symbol: str) -> _Growth | None:
        """Return the word with one more symbol, if it can be sized."""
        word = (*growth.word, symbol)
        if self._too_many(word):
            return None
        targets = growth.targets
        if symbol not in targets:
            targets = {**targets, symbol: self._initial(symbol)}
        mirrored = () if self.partners is None else tuple(self.partners[s] for s in growth.word)
        elements = _Elements(self, word, mirrored)
        if float(elements.counts @ self.least) > self.length * (1 + 1e-9):
            return None
        found = self._sized(elements, growth.rows, targets, False)
        if found is None:
            return None
        return _Growth(self.grammar.next[growth.state][symbol], word, found[1], targets)

    def _initial(self, symbol: str) -> float:
        """Draw from the symbol's normal distribution, truncated to its bounds by drawing again."""
        number = self.number[symbol]
        least, most = float(self.least[number]), float(min(self.most[number], self.length))
        centre, deviation = self.stated.shapes[f"{self.path}/{symbol}"]
        for _ in range(_DRAWS):
            drawn = float(self.generator.normal(centre, min(deviation, _WIDEST * centre)))
            if least <= drawn <= most:
                return drawn
        return min(max(centre, least), most)

    def _too_many(self, word: Word) -> bool:
        """Tell whether the last symbol breaks a frequency of direct children."""
        for rule in self.stated.counts:
            if rule.path == self.path:
                factor = 1 if self.partners is None else 2
                count = sum(f"{self.path}/{symbol}" in rule.counted for symbol in word[:-1]) * factor
                count += f"{self.path}/{word[-1]}" in rule.counted
                if count > rule.most.at(self.laid.growth(self.path)) + 1e-6:
                    return True
        return False

    def _sized(
        self, elements: _Elements, rows: tuple[_Row, ...], targets: dict[str, float], ended: bool
    ) -> tuple[Floats, tuple[_Row, ...], _Elements] | None:
        """Return the sizes nearest to the targets, and the alignments that they keep."""
        fixed = [*self._same_sizes(elements), elements.total(ended)]
        for _ in range(_ROUNDS):
            sizes = self._solved(elements, [*fixed, *rows], targets)
            if sizes is None:
                return None
            active = elements.out_of_line(sizes)
            if not active:
                return sizes, rows, elements
            rows = (*rows, *active)
        return None

    def _same_sizes(self, elements: _Elements) -> Iterator[_Row]:
        for equal, constant in zip(self.stated.equal, self.constants, strict=True):
            if equal.axis == self.axis:
                forms = list(elements.extents(equal.regions, equal.runs))
                if constant is not None:
                    yield from (_Row(form, constant, constant) for form in forms)
                for form in forms[1:] if constant is None else ():
                    if np.any(form != forms[0]):
                        yield _Row(form - forms[0], 0.0, 0.0)

    def _solved(self, elements: _Elements, rows: Sequence[_Row], targets: dict[str, float]) -> Floats | None:
        import daqp

        counts = elements.counts
        wanted = np.array([targets.get(symbol, 0.0) for symbol in self.symbols]) / self.length
        weights = np.where(counts > 0, 2.0 * counts, 1e-9)
        absent = counts == 0
        least = np.where(absent, 0.0, self.least / self.length)
        most = np.where(absent, 0.0, np.minimum(self.most / self.length, 2.0))
        factors = np.array([row.factors for row in rows])
        lower = np.concatenate([least, [row.least / self.length for row in rows]])
        upper = np.concatenate([most, [row.most / self.length for row in rows]])
        sense = np.where(lower == upper, _EQUALITY, 0).astype(np.int32)
        x, _, flag, _ = daqp.solve(
            np.diag(weights), -weights * wanted, factors, upper, lower, sense, primal_tol=1e-10
        )
        if flag != 1:
            return None
        values = np.concatenate([x, factors @ x])
        if max(np.max(lower - values), np.max(values - upper)) > 1e-8:
            return None
        return np.asarray(x) * self.length


def _opposite(line: Line, path: str) -> Iterator[str]:
    if path in line.first:
        yield from line.second
    if path in line.second:
        yield from line.first


class _Elements:
    """A word so far as forms over its symbols' sizes: where each element starts.

    Parameters
    ----------
    word
        From the region's start.
    last
        From its end inwards.
    """

    def __init__(self, region: RegionWords, word: Word, last: Word) -> None:
        self.region, self.word, self.last = region, word, last
        first, mirrored = (self._units(own) for own in (word, last))
        before = np.cumsum(first, axis=0) - first
        self.units = np.concatenate([first, mirrored])
        self.forms: Floats = np.concatenate([before, -np.cumsum(mirrored, axis=0)])
        self.offsets = np.concatenate([np.zeros(len(word)), np.full(len(last), region.length)])
        self.counts: Floats = self.units.sum(axis=0)

    def _units(self, word: Word) -> Floats:
        return self.region.identity[[self.region.number[symbol] for symbol in word]]

    def starts(self, sizes: Floats) -> Floats:
        """Return where each element starts, given the sizes of the symbols."""
        return np.asarray(self.offsets + self.forms @ sizes)

    def total(self, ended: bool) -> _Row:
        """Return the row that keeps the elements within their region, or lets them fill it."""
        length = self.region.length
        return _Row(self.counts, length if ended else 0.0, length)

    def extents(self, regions: Sequence[str], runs: Sequence[Run]) -> Iterator[Floats]:
        """Yield the sizes of regions and runs among the elements, as forms."""
        for path in regions:
            parent, _, symbol = path.rpartition("/")
            if parent == self.region.path and symbol in (*self.word, *self.last):
                yield self._units((symbol,))[0]
        for run in runs:
            if run.within == self.region.path:
                for start, end in run.occurrences(self.word):
                    yield self._units(self.word[start:end]).sum(axis=0)

    def out_of_line(self, sizes: Floats) -> list[_Row]:
        """Return a row for each element that overlaps a region and is out of line with it."""
        rows: list[_Row] = []
        starts, word = self.starts(sizes), (*self.word, *self.last)
        for symbol in dict.fromkeys(word):
            if others := self.region.others[symbol]:
                own = np.array([number for number, other in enumerate(word) if other == symbol])
                size = float(sizes[self.region.number[symbol]])
                places = starts[own][:, None, None] + self.region.bases[None, :, None]
                for other in others:
                    rows += self._missed(own, places, size, other)
        return rows

    def _missed(self, own: NDArray[Any], places: Floats, size: float, other: _Other) -> Iterator[_Row]:
        tolerance, theirs = self.region.tolerance, other.starts[None, None, :]
        overlap = np.minimum(places + size, theirs + other.size) - np.maximum(places, theirs)
        if not np.any(overlap > tolerance):
            return
        for share in other.shares:
            gap = np.abs(places + share * size - theirs - share * other.size)
            for element, base, number in np.argwhere((overlap > tolerance) & (gap > tolerance)):
                place = other.starts[number] + share * other.size - self.region.bases[base]
                place -= self.offsets[own[element]]
                yield _Row(self.forms[own[element]] + share * self.units[own[element]], place, place)
