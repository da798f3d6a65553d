"""Counts beyond what proofs by numbers go up to are no ground to call anything impossible."""

from __future__ import annotations

import pytest

from layoutkit.constraints import Frequency, Sequence
from layoutkit.constraints.generators import framed, sequences
from layoutkit.model import Facade, Measure, Region, RegionSet
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search

TILE = Region("T", 1.0, 1.0, labels=("Tile",))


def grid(columns: int, rows: int) -> Region:
    """Return rows of tiles, and a free column beside them, so that there is something to choose."""
    row = Region("R", float(columns), 1.0, split="columns", children=(TILE,) * columns)
    tiled = Region("G", float(columns), float(rows), split="rows", children=(row,) * rows)
    halves = tuple(Region(symbol, 1.0, rows / 2) for symbol in "ab")
    free_column = Region("W", 1.0, float(rows), split="rows", children=halves)
    return Region("F", columns + 1.0, float(rows), split="columns", children=(tiled, free_column))


def free() -> list[Sequence]:
    return sequences(("F/W",), framed("ab", {"a": "ab", "b": "ab"}, "ab"))


def refuted(facade: Facade) -> bool:
    size = (facade.root.width, facade.root.height)
    return Search(Model(facade), size, BACKENDS).foresight.refutes({}, 200)


def test_more_regions_inside_one_than_are_counted() -> None:
    tiles = Frequency(of=RegionSet("@Tile"), within="F", min=Measure(13_000.0))
    facade = Facade("grid", "m", grid(120, 120), constraints=(*free(), tiles))
    assert not refuted(facade)


@pytest.mark.nightly
def test_more_letters_of_one_kind_than_are_counted() -> None:
    facade = Facade("strip", "m", grid(10_050, 1), constraints=tuple(free()))
    assert not refuted(facade)
