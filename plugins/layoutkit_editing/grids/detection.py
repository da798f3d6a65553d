"""Grids that a facade has, found without help, the most useful first."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model import Grid
from layoutkit_editing.grids.blocks import blocks
from layoutkit_editing.grids.elements import Families, as_bits
from layoutkit_editing.grids.lattices import cells_of, lattice_of
from layoutkit_editing.grids.likeness import types as types_of
from layoutkit_editing.grids.usefulness import Judge, Traits, most_useful
from layoutkit_editing.original import Original
from layoutkit_editing.state import Matrix

if TYPE_CHECKING:
    from layoutkit_editing.grids.likeness import Numbers

#: Of two sets of elements that have this share of all of theirs in common, one is enough.
ALIKE = 0.8
#: How much less useful a grid is, if all of its elements are in one that is offered before it.
KNOWN = 0.5
#: What is less useful than this share of the best is not offered.
WORTHWHILE = 0.15
#: No more than this many grids are offered.
OFFERED = 24


@dataclass(frozen=True, slots=True)
class Found:
    """A grid that was found.

    Attributes
    ----------
    grid
        As documents have it.
    cells
        Its rows and columns of sources.
    score
        How useful it is; comparable within a facade.
    """

    grid: Grid
    cells: Matrix
    traits: Traits
    score: float

    @property
    def rows(self) -> int:
        """How many rows it has."""
        return self.traits.rows

    @property
    def columns(self) -> int:
        """How many columns it has."""
        return self.traits.columns

    @property
    def phantoms(self) -> int:
        """How many places in it are empty."""
        return self.rows * self.columns - self.traits.elements

    @property
    def regular(self) -> bool:
        """Whether like elements fill evenly spaced rows and columns."""
        return self.traits.regular


@dataclass(frozen=True, slots=True)
class _Candidate:
    names: tuple[str, ...]
    sources: tuple[int, ...]
    cells: Matrix
    traits: Traits
    score: float


def detected(original: Original) -> tuple[Found, ...]:
    """Return grids that a facade has besides those of its document, the most useful first.

    Elements are regions of one type, of one name (labels, or else a symbol), or of several names that fill
    one grid: windows and doors. They have to be in line, and to leave few cells empty; where all of them do
    not, those rows or columns are taken that do. Grids that repeat what another has come later, and near
    duplicates not at all. There are at most `OFFERED`.

    Raises
    ------
    Faulty
        If a grid of the document names what is not there.
    """
    types = types_of(original)
    families = Families(original, types)
    given = original.facade.grids
    known = [tuple(sorted(lattice_of(original, grid).elements)) for grid in given]
    chosen = _offered(_candidates(original, families, types), known, families)
    names = _names((own.names for own, _ in chosen), {grid.name for grid in given})
    return tuple(
        Found(
            Grid(name, elements=tuple(original.places[source].path for source in own.sources)),
            own.cells,
            own.traits,
            score,
        )
        for name, (own, score) in zip(names, chosen, strict=True)
    )


def _candidates(original: Original, families: Families, types: Numbers) -> list[_Candidate]:
    """Return what may be offered, the most useful first."""
    judge, seen, best = Judge(original, types, families.names), set[tuple[int, ...]](), 0.0
    found: list[_Candidate] = []
    for family in families:
        for sources in blocks(cells_of(original, family)):
            if len(sources) < 2 or sources in seen:
                continue
            seen.add(sources)
            names, worth = families.shown(sources)
            cells = cells_of(original, sources)
            if worth * most_useful(len(cells), len(cells[0]), len(sources)) >= WORTHWHILE * best:
                traits = judge.traits(cells)
                found.append(_Candidate(names, sources, cells, traits, worth * traits.usefulness))
                best = max(best, found[-1].score)
    worthwhile = (own for own in found if own.score >= WORTHWHILE * best)
    return sorted(worthwhile, key=lambda own: (-own.score, own.sources))


def _offered(
    ranked: Sequence[_Candidate], known: Iterable[tuple[int, ...]], families: Families
) -> list[tuple[_Candidate, float]]:
    """Choose candidates one after the other: the most useful, but for what those before them have."""
    sets = [as_bits(own.sources) for own in ranked]
    pending = {number: own.score for number, own in enumerate(ranked)}
    chosen: list[tuple[_Candidate, float]] = []

    def now_known(sources: tuple[int, ...]) -> None:
        same, related = as_bits(sources), families.related(sources)
        for number, score in tuple(pending.items()):
            own, shared = ranked[number], (sets[number] & same).bit_count()
            if shared >= ALIKE * (len(own.sources) + len(sources) - shared):
                del pending[number]
            else:
                repeated = (sets[number] & related).bit_count() / len(own.sources)
                pending[number] = min(score, own.score * (1 - KNOWN * repeated))

    for sources in known:
        now_known(sources)
    while pending and len(chosen) < OFFERED:
        number = max(pending, key=lambda n: (pending[n], -n))
        chosen.append((ranked[number], pending.pop(number)))
        now_known(ranked[number].sources)
    return chosen


def _names(named: Iterable[Sequence[str]], taken: set[str]) -> Iterator[str]:
    """Yield a free name for each grid after what is in it."""
    for names in named:
        name = base = "_and_".join(_plural(name) for name in names)
        number = 1
        while name in taken:
            number += 1
            name = f"{base}_{number}"
        taken.add(name)
        yield name


def _plural(name: str) -> str:
    word = re.sub(r"\W+", "_", name.strip().lower())
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return f"{word[:-1]}ies"
    return f"{word}es" if word.endswith(("s", "x", "z", "ch", "sh")) else f"{word}s"
