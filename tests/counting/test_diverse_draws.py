"""Diverse sampling: arrangements are farther from each other than weighted ones."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import pytest
from countable import row, search

from layoutkit.documents import read
from layoutkit.hooks.host import Host
from layoutkit.model import Facade, Region
from layoutkit.samples import list_samples
from layoutkit_relayout.sampling.distances import arrangements, distance
from layoutkit_relayout.sampling.sampling import CANDIDATES, Diverse, Sampler
from layoutkit_relayout.search.search import Search

ONE_OR_TWO = {"a": (1.0, 1.0), "b": (2.0, 2.0)}


def sample(name: str) -> Facade:
    (path,) = (own.path for own in list_samples() if own.name == name)
    found = read(path, Host.load().constraints).model
    assert isinstance(found, Facade)
    return found


def made(sampler: Sampler, seed: int, count: int) -> list[Region]:
    found = [sampler.variation(seed, index, 2000).root for index in range(count)]
    return [root for root in found if root is not None]


def distances(roots: Sequence[Region]) -> list[int]:
    own = [arrangements(root) for root in roots]
    return [distance(one, other) for one, other in combinations(own, 2)]


@pytest.mark.parametrize("name", ["arcade", "townhouse", "carpet"])
def test_samples_are_spread_farther(name: str) -> None:
    facade = sample(name)
    wide = search(facade, 1.3 * facade.root.width)
    weighted, diverse = (distances(made(own, 0, 8)) for own in (wide, Diverse(wide)))
    assert len(weighted) == len(diverse) == 28
    assert sum(diverse) > sum(weighted)
    assert min(diverse) > min(weighted)


def test_there_is_no_double_while_there_is_another() -> None:
    """The row has 8 arrangements: those drawn come all up before any does twice."""
    found = search(row(ONE_OR_TWO), 5.0)
    drawn = {root.word for root in made(found, 1, 8 * CANDIDATES)}
    words = [root.word for root in made(Diverse(found), 1, 8)]
    assert len(set(words)) == min(8, len(drawn))
    assert len(drawn) >= 5


def test_a_variation_is_the_same_however_many_are_made() -> None:
    found = search(row(ONE_OR_TWO), 8.0)
    one, other = Diverse(found), Diverse(Search(found.model, found.size, found.measures.backends))
    fourth = one.variation(3, 3, 100).root
    assert [own.root for own in (other.variation(3, index, 100) for index in range(6))][3] == fourth
    assert one.variation(4, 3, 100).root != fourth


def test_where_there_is_none_that_is_proved() -> None:
    found = Diverse(search(row(ONE_OR_TWO), 5.5)).variation(0, 2, 100)
    assert (found.status, found.root) == ("infeasible", None)
