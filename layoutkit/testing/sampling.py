"""Words and layouts to try constraints with: some drawn by chance, small sets of words in full."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from layoutkit.constraints.size import input_size
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.arrangement import AXIS, Arrangement
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Floats

Words = Mapping[str, tuple[str, ...]]
Size = tuple[float, float]

#: Words of one region are tried up to so many symbols, and up to so many of them.
_LONGEST, _MOST_WORDS = 6, 150
#: Sizes of layouts, as shares of the input's.
_SHARES = ((1.0, 1.0), (1.4, 0.8), (0.75, 1.25))
#: By how much the logarithms of proportions vary.
_SPREADS = (0.0, 0.05, 0.5)


@dataclass(frozen=True, eq=False)
class Sample:
    """A layout: what it is an arrangement of, the values of all variables, and its regions."""

    arrangement: Arrangement
    values: tuple[Floats, Floats]
    root: Region

    @property
    def view(self) -> LayoutView:
        """The layout as constraints look at it when they check it."""
        facade = self.arrangement.facade
        return LayoutView(Layout("sample", facade.units, self.root, facade), facade)

    def lines(self) -> tuple[str, ...]:
        """Return the layout in a few lines, for findings."""
        return tuple(_described(self.root))

    def without(self, path: str) -> Sample:
        """Return the same layout with the words of one region, and of all inside it, undecided."""
        kept = {p: w for p, w in self.arrangement.words.items() if not f"{p}/".startswith(f"{path}/")}
        return placed(Arrangement(self.arrangement.facade, kept), self.root)


def _described(region: Region, indent: str = "") -> Iterator[str]:
    inside = f" {region.split}: {' '.join(region.word)}" if region.split else ""
    yield f"{indent}{region.symbol} {region.width:.6g} × {region.height:.6g}{inside}"
    for child in {child.symbol: child for child in region.children}.values():
        yield from _described(child, f"{indent}  ")


def reached(facade: Facade, words: Words) -> dict[str, tuple[str, ...]]:
    """Return those of the words that a layout reaches from the root."""
    found: dict[str, tuple[str, ...]] = {}
    pending = [facade.root.symbol]
    for path in pending:  # which grows meanwhile
        if path in words and path not in found:
            found[path] = words[path]
            pending += [f"{path}/{symbol}" for symbol in dict.fromkeys(words[path])]
    return found


def word_choices(facade: Facade, rng: np.random.Generator, mixed: int) -> list[Words]:
    """Return choices of words for all regions: the input's, others in one region, and mixed ones.

    Parameters
    ----------
    mixed
        How many there are of the last.
    """
    own = {path: region.word for path, region in facade.regions.items() if region.split}
    pools = {path: _words(facade.regions[path], rng) for path in own}
    choices: list[Words] = [own]
    choices += [{**own, path: word} for path, pool in pools.items() for word in pool]
    for _ in range(mixed):
        choices.append({path: pool[int(rng.integers(len(pool)))] for path, pool in pools.items()})
    unique = {tuple(sorted(r.items())): r for r in (reached(facade, choice) for choice in choices)}
    return list(unique.values())


def _words(region: Region, rng: np.random.Generator) -> list[tuple[str, ...]]:
    """Return words over a region's symbols, the short ones all, of the others some."""
    symbols = tuple(dict.fromkeys(region.word))
    found: list[tuple[str, ...]] = [region.word]
    for length in range(1, max(_LONGEST, len(region.word)) + 1):
        room = _MOST_WORDS - len(found)
        if len(symbols) ** length <= room // 2:
            found += product(symbols, repeat=length)
            continue
        drawn = rng.integers(len(symbols), size=(room // 3, length))
        found += [tuple(symbols[i] for i in row) for row in drawn]
    return list(dict.fromkeys(found))


def sizes_of(facade: Facade) -> tuple[Size, ...]:
    """Return the sizes at which layouts are tried."""
    return tuple((facade.root.width * x, facade.root.height * y) for x, y in _SHARES)


def drawn(facade: Facade, words: Words, size: Size, rng: np.random.Generator) -> Sample:
    """Return a layout of chance proportions."""
    arrangement = Arrangement(facade, words)
    spread = _SPREADS[int(rng.integers(len(_SPREADS)))]
    own = {path: input_size(facade, path) * float(np.exp(spread * rng.normal())) for path in facade.regions}
    return sample(arrangement, _nominal(arrangement, size, own))


def placed(arrangement: Arrangement, root: Region) -> Sample:
    """Return an arrangement with the sizes that its regions have in a layout."""
    own: dict[str, float] = {}
    pending: list[tuple[str, Region]] = [(root.symbol, root)]
    for path, region in pending:  # which grows meanwhile
        for child in {child.symbol: child for child in region.children}.values():
            own[f"{path}/{child.symbol}"] = (child.width, child.height)[AXIS[region.split or "columns"]]
            pending.append((f"{path}/{child.symbol}", child))
    return replace(sample(arrangement, _nominal(arrangement, (root.width, root.height), own)), root=root)


def _nominal(arrangement: Arrangement, size: Size, own: Mapping[str, float]) -> tuple[Floats, Floats]:
    one, other = (np.array(arrangement.nominal(axis, size[axis], own.__getitem__)) for axis in (0, 1))
    return one, other


def sample(arrangement: Arrangement, values: Sequence[Floats]) -> Sample:
    """Return the layout of an arrangement, given the values of its variables."""
    return Sample(arrangement, (values[0], values[1]), region_tree(arrangement, values))
