"""Sums and products of ways: every rank is a way, and every way has one rank."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import prod
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chisquare

from layoutkit_relayout.counting.effort import Effort, Uncountable
from layoutkit_relayout.counting.ways import Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.sampling.distances import distance, edit_distance
from layoutkit_relayout.sampling.sampling import below


class Some(Listed):
    """Ways of one group: its words, by number."""

    def __init__(self, group: int, words: Sequence[int]) -> None:
        super().__init__([{group: (str(word),)} for word in words])  # type: ignore[dict-item]  # any key will do


def written(ways: Ways) -> list[tuple[Any, ...]]:
    return [tuple(sorted(ways.at(rank).items())) for rank in range(ways.most)]  # type: ignore[type-var]  # words of one group


SIZES = st.lists(st.integers(0, 4), min_size=1, max_size=4)


@given(SIZES)
def test_together_is_the_product(sizes: list[int]) -> None:
    ways = Together([Some(group, range(size)) for group, size in enumerate(sizes)])
    assert ways.least == ways.most == prod(sizes)
    assert len(set(written(ways))) == ways.most


@given(SIZES)
def test_either_is_the_sum(sizes: list[int]) -> None:
    ends = [sum(sizes[:number]) for number in range(len(sizes) + 1)]
    ways = Either([Some(0, range(low, high)) for low, high in pairwise(ends)])
    assert ways.least == ways.most == sum(sizes)
    assert written(ways) == [((0, (str(number),)),) for number in range(sum(sizes))]


@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=1, max_size=3))
def test_what_may_not_exist_counts_at_one_end(sizes: list[tuple[int, int]]) -> None:
    ways = Together(
        [
            Either([Some(group, range(sure)), Perhaps(Some(group, range(sure, sure + doubtful)))])
            for group, (sure, doubtful) in enumerate(sizes)
        ]
    )
    assert ways.least == prod(sure for sure, _ in sizes)
    assert ways.most == prod(map(sum, sizes)) == len(set(written(ways)))
    assert ways.exact == (ways.least == ways.most)


@pytest.mark.parametrize("number", [1, 2, 3, 255, 256, 257, 10**40])
def test_numbers_drawn_are_below(number: int) -> None:
    generator = np.random.default_rng(1)
    assert all(0 <= below(number, generator) < number for _ in range(200))


def test_numbers_drawn_are_even() -> None:
    generator = np.random.default_rng(2)
    seen = Counter(below(11, generator) for _ in range(5500))
    assert chisquare([seen[n] for n in range(11)]).pvalue > 0.01


def test_effort_ends() -> None:
    effort = Effort(10.0)
    effort.spend(12.0)
    assert effort.left == 0.0
    with pytest.raises(Uncountable):
        effort.spend(12.0)


WORD = st.text("abc", max_size=6)


@given(WORD, WORD, WORD)
def test_edit_distance_is_a_metric(one: str, other: str, third: str) -> None:
    assert (edit_distance(one, other) == 0) == (one == other)
    assert edit_distance(one, other) == edit_distance(other, one)
    assert edit_distance(one, third) <= edit_distance(one, other) + edit_distance(other, third)
    assert abs(len(one) - len(other)) <= edit_distance(one, other) <= max(len(one), len(other))


@pytest.mark.parametrize(
    ("one", "other", "edits"), [("kitten", "sitting", 3), ("", "abc", 3), ("abc", "abc", 0), ("ab", "ba", 2)]
)
def test_edit_distances(one: str, other: str, edits: int) -> None:
    assert edit_distance(one, other) == edits


WORDS = st.dictionaries(st.sampled_from(["R", "R/F"]), st.lists(st.tuples(st.sampled_from("ab")), max_size=2))


@given(WORDS, WORDS)
def test_distance_of_arrangements(one: Mapping[str, Any], other: Mapping[str, Any]) -> None:
    first, second = ({p: tuple(words) for p, words in own.items() if words} for own in (one, other))
    assert distance(first, second) == distance(second, first)
    assert (distance(first, second) == 0) == (first == second)
