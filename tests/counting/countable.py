"""Walls of bays whose arrangements can be counted by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from layoutkit.constraints import Constraint, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.model import Facade, Measure, Region, RegionSet, Word
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search

#: Least and greatest width of each symbol of a floor.
Widths = Mapping[str, tuple[float, float]]


def floor(symbol: str, widths: Widths, height: float = 3.0) -> Region:
    """Return a floor with one bay of each symbol, as narrow as it may be."""
    bays = tuple(Region(name, least, height, labels=(name.upper(),)) for name, (least, _) in widths.items())
    return Region(symbol, sum(bay.width for bay in bays), height, "columns", bays)


def sized(path: str, widths: Widths) -> list[Constraint]:
    """Return what keeps the bays of a floor to their widths."""
    return [
        Size(of=RegionSet(f"{path}/{name}"), min=Measure(least), max=Measure(most))
        for name, (least, most) in widths.items()
    ]


def sequences(path: str, *words: str, weight: float = 1.0) -> list[Constraint]:
    """Return sequences of one region."""
    return [SequenceConstraint(within=(path,), word=Word.parse(word), weight=weight) for word in words]


def anything(path: str, symbols: Sequence[str]) -> list[Constraint]:
    """Return sequences that allow every word of some symbols."""
    own = "{" + " ".join(symbols) + "}"
    return sequences(path, f"⊢ {own}", f"{own} {own}", f"{own} ⊣")


def row(widths: Widths, *more: Constraint) -> Facade:
    """Return a facade of one floor of any bays, at any length."""
    root = floor("R", widths)
    return Facade("row", "m", root, constraints=(*sized("R", widths), *anything("R", [*widths]), *more))


def stack(floors: Mapping[str, Widths], *more: Constraint) -> Facade:
    """Return a facade of floors, each of any bays, at any length."""
    made = [floor(symbol, widths) for symbol, widths in floors.items()]
    width = max(own.width for own in made)
    children = tuple(
        Region(own.symbol, width, own.height, own.split, _stretched(own.children, width / own.width))
        for own in made
    )
    root = Region("R", width, sum(own.height for own in made), "rows", children)
    spoken: list[Constraint] = []
    for symbol, widths in floors.items():
        spoken += [*sized(f"R/{symbol}", widths), *anything(f"R/{symbol}", [*widths])]
    return Facade("stack", "m", root, constraints=(*spoken, *more))


def _stretched(bays: Sequence[Region], factor: float) -> tuple[Region, ...]:
    return tuple(Region(b.symbol, b.width * factor, b.height, labels=b.labels) for b in bays)


def search(facade: Facade, width: float, height: float = 0.0) -> Search:
    """Return the search for layouts of a width, and of the input's height unless another is given."""
    return Search(Model(facade), (width, height or facade.root.height), BACKENDS)
