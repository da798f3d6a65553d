"""Facades by code: parts with a size along their parent's split, words of parts, and their constraints."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from layoutkit.constraints import Alignment, Constraint, Frequency, SameSize, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Split, Word


@dataclass(frozen=True, slots=True)
class Part:
    """A region before it knows how large its parent is.

    Attributes
    ----------
    size
        Extent along the parent's split, in metres.
    children
        In reading order; their sizes have to add up where the part is divided.
    """

    symbol: str
    size: float
    split: Split | None = None
    children: tuple[Part, ...] = ()
    labels: tuple[str, ...] = ()


def leaf(symbol: str, size: float, *labels: str) -> Part:
    """Return a terminal part."""
    return Part(symbol, size, labels=labels)


def columns(symbol: str, size: float, word: str, parts: Iterable[Part], *labels: str) -> Part:
    """Return a part that is divided into columns.

    Parameters
    ----------
    word
        Symbols of the parts, separated by spaces.
    """
    return Part(symbol, size, "columns", _spelled(word, parts), labels)


def rows(symbol: str, size: float, word: str, parts: Iterable[Part], *labels: str) -> Part:
    """Return a part that is divided into rows, listed from the top down."""
    return Part(symbol, size, "rows", _spelled(word, parts), labels)


def _spelled(word: str, parts: Iterable[Part]) -> tuple[Part, ...]:
    by_symbol = {part.symbol: part for part in parts}
    return tuple(by_symbol[symbol] for symbol in word.split())


def total(word: str, parts: Iterable[Part]) -> float:
    """Return the extent of a word of parts."""
    return round(sum(part.size for part in _spelled(word, parts)), 6)


def facade(name: str, root: Part, width: float, height: float, constraints: Iterable[Constraint]) -> Facade:
    """Return the facade of a root part.

    Raises
    ------
    ValueError
        If the children of some part do not add up.
    """
    return Facade(name, "m", _region(root, width, height, root.symbol), constraints=tuple(constraints))


def _region(part: Part, width: float, height: float, path: str) -> Region:
    if part.split is None:
        return Region(part.symbol, width, height, labels=part.labels)
    extent = width if part.split == "columns" else height
    length = sum(child.size for child in part.children)
    if abs(length - extent) > 1e-9 * extent:
        raise ValueError(f"the children of {path} are {length:g} m together, not {extent:g} m")
    made: dict[str, Region] = {}
    for child in part.children:
        if child.symbol not in made:
            size = (child.size, height) if part.split == "columns" else (width, child.size)
            made[child.symbol] = _region(child, *size, f"{path}/{child.symbol}")
    return Region(
        part.symbol, width, height, part.split, tuple(made[c.symbol] for c in part.children), part.labels
    )


def sequences(within: str, *words: str) -> list[Constraint]:
    """Return a sequence constraint for each word."""
    return [SequenceConstraint(within=(within,), word=Word.parse(word)) for word in words]


def shuffled(word: str) -> tuple[str, ...]:
    """Return every pair of neighbours in a word, and its reverse, once each (two-shuffle)."""
    symbols = word.split()
    pairs = dict.fromkeys(pairwise(symbols))
    pairs.update(dict.fromkeys((b, a) for a, b in list(pairs)))
    return tuple(f"{a} {b}" for a, b in pairs)


def in_line(first: str, second: str, lines: str) -> list[Constraint]:
    """Return an alignment for each of the lines, as the paper counts them."""
    sets = RegionSet.parse(first), RegionSet.parse(second)
    return [Alignment(first=sets[0], second=sets[1], lines=(line,)) for line in lines.split()]


def alike(dimension: str, first: str, *others: str) -> list[Constraint]:
    """Return a same-size constraint between an extent and each of the others."""
    return [
        SameSize(first=Extent.parse(first), second=Extent.parse(other), dimension=dimension)
        for other in others
    ]


def frequency(of: str, within: str, least: str = "", most: str = "") -> list[Constraint]:
    """Return a frequency constraint; an empty end is open."""
    ends = [Measure.parse(end) if end else None for end in (least, most)]
    return [Frequency(of=RegionSet.parse(of), within=within, min=ends[0], max=ends[1])]


def sizes(least: str, most: str, deviation: str, *of: str) -> list[Constraint]:
    """Return a size constraint on some regions, whose initial sizes are spread by `deviation`."""
    return [
        Size(
            of=RegionSet.union(of),
            min=Measure.parse(least),
            max=Measure.parse(most),
            deviation=Measure.parse(deviation),
        )
    ]


def joined(*groups: Sequence[Constraint]) -> Iterator[Constraint]:
    """Yield the constraints of all groups."""
    for group in groups:
        yield from group
