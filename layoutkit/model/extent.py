"""Extents: single regions, or runs of neighbouring ones, whose size constraints speak of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from layoutkit.model.region import Region
from layoutkit.model.selection import RegionSet
from layoutkit.model.word import Word


@dataclass(frozen=True, slots=True)
class Extent:
    """Regions, written as a set (``Facade/Floor/Bay``), or a run within some: ``Facade/Side: P Q R S``.

    Attributes
    ----------
    regions
        The set, where it is one.
    within, word
        Path of the composite region, or several separated by spaces, and the run in it, where it is not.
    """

    regions: RegionSet | None = None
    within: str = ""
    word: Word | None = None

    @classmethod
    def parse(cls, text: str) -> Extent:
        """Read either form.

        Raises
        ------
        ValueError
            If the text is of neither.
        """
        within, colon, word = text.partition(":")
        if not colon:
            return cls(RegionSet.parse(text))
        paths = within.split()
        if not paths or any(RegionSet.parse(path).operator for path in paths):
            raise ValueError(f"a path is expected before the colon in {text!r}")
        return cls(None, " ".join(paths), Word.parse(word))

    @property
    def paths(self) -> tuple[str, ...]:
        """The composite regions that a run is looked for in."""
        return tuple(self.within.split())

    def __str__(self) -> str:
        return str(self.regions) if self.regions is not None else f"{self.within}: {self.word}"


def occurrences(word: Word, source: Region, arrangement: tuple[str, ...]) -> Iterator[tuple[int, int]]:
    """Yield start and end (exclusive) of every run in an arrangement that instantiates the word.

    Parameters
    ----------
    source
        The facade's region, whose children know their labels.
    arrangement
        Symbols of the region's children.
    """
    names = {c.symbol: frozenset({c.symbol, *(f"@{label}" for label in c.labels)}) for c in source.children}
    length = len(word.sets)
    for start in range(len(arrangement) - length + 1):
        if (word.at_start and start > 0) or (word.at_end and start + length < len(arrangement)):
            continue
        run = arrangement[start : start + length]
        if all(s.contains(names[symbol]) for s, symbol in zip(word.sets, run, strict=True)):
            yield start, start + length
