"""Completion tables: the words that fit, all of them, by their weights."""

from __future__ import annotations

from collections import Counter
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from test_machines import COVERINGS, same

from layoutkit.constraints.covering import Covering
from layoutkit_relayout.words.machine import Counting, Machine, build
from layoutkit_relayout.words.table import COARSE, Completions, CompletionTable, Letters

#: Any word over two or three letters.
ANY_WORD = Counting(dict.fromkeys("abc", (0.0, 0.0)), 0.0, 1.0)
Range = tuple[float, float]
RANGES = st.tuples(st.floats(1.0, 4.0), st.floats(0.0, 3.0)).map(lambda two: (two[0], two[0] + two[1]))
WHOLE = st.tuples(st.integers(180, 400), st.integers(0, 300)).map(lambda two: (two[0], two[0] + two[1]))
REACH = 8.0


def table(
    machine: Machine, ranges: list[Range], reach: float, weights: list[float] | None = None
) -> CompletionTable:
    each = np.tile(weights or [1.0] * len(ranges), (len(machine.accepting), 1))
    least, most = np.array(ranges, dtype=float).reshape(-1, 2).T
    return CompletionTable(machine, Letters(least, most, each), reach)


def fitting(
    machine: Machine, ranges: list[Range], length: Range, slack: float = 0.0
) -> list[tuple[str, ...]]:
    """Return the words that fit, from the definition; each letter may be off by the slack."""
    longest = int(length[1] / min(low - slack for low, _ in ranges)) + 1
    found = []
    for word in (w for n in range(longest + 1) for w in product(machine.letters, repeat=n)):
        own = [ranges[machine.letters.index(letter)] for letter in word]
        extra = slack * (len(word) + 2)
        low, high = sum(r[0] for r in own), sum(r[1] for r in own)
        if machine.accepts(word) and low <= length[1] + extra and high >= length[0] - extra:
            found.append(word)
    return found


@given(COVERINGS, st.lists(RANGES, min_size=3, max_size=3), st.floats(2, REACH), st.floats(0, 1))
def test_no_fitting_word_is_lost_and_few_others_come(
    covering: Covering, ranges: list[Range], longest: float, share: float
) -> None:
    machine = build("abc", same(covering))
    length = (longest * share, longest)
    completions = table(machine, ranges, REACH).at(*length)
    found = list(completions.words())
    assert len(found) == len(set(found))
    assert set(fitting(machine, ranges, length)) <= set(found)
    assert set(found) <= set(fitting(machine, ranges, length, 2 * REACH / COARSE))
    assert completions.empty is (not found)


@given(COVERINGS, st.lists(WHOLE, min_size=3, max_size=3), st.integers(200, COARSE), st.integers(0, 400))
def test_on_the_grid_exactly_the_fitting_words_come(
    covering: Covering, ranges: list[tuple[int, int]], longest: int, open_: int
) -> None:
    machine = build("abc", same(covering))
    length = (float(max(1, longest - open_)), float(longest))
    completions = table(machine, [(float(a), float(b)) for a, b in ranges], float(COARSE)).at(*length)
    expected = fitting(machine, [(float(a), float(b)) for a, b in ranges], length)
    assert sorted(completions.words()) == sorted(expected)
    assert completions.total == pytest.approx(len(expected))
    assert (completions.total == 0) is completions.empty is (not expected)


@given(
    COVERINGS,
    st.lists(WHOLE, min_size=3, max_size=3),
    st.lists(st.sampled_from([0.1, 0.25, 1.0, 3.0]), min_size=3, max_size=3),
    st.integers(300, COARSE),
)
def test_draws_reproduce_the_weights(
    covering: Covering, ranges: list[tuple[int, int]], weights: list[float], longest: int
) -> None:
    machine = build("abc", same(covering))
    spans = [(float(a), float(b)) for a, b in ranges]
    length = (longest - 100.0, float(longest))
    expected = fitting(machine, spans, length)
    assume(0 < len(expected) <= 60)
    mass = {word: float(np.prod([weights["abc".index(letter)] for letter in word])) for word in expected}
    completions = table(machine, spans, float(COARSE), weights).at(*length)
    assert completions.total == pytest.approx(sum(mass.values()))
    shares = 600
    drawn = Counter(completions.draw((i + 0.5) / shares) for i in range(shares))
    assert set(drawn) <= set(mass)
    # Each word takes one stretch of the shares: its count is its weight's, one off at most. Over all words
    # this keeps the chi-square far below what chance would give.
    for word, weight in mass.items():
        assert abs(drawn[word] - shares * weight / completions.total) <= 1.0 + 1e-6


def test_draws_are_evenly_spread_among_equal_words() -> None:
    completions = any_word([(64.0, 64.0), (64.0, 64.0)]).at(640.0, 640.0)
    shares = 1 << 14
    drawn = Counter(completions.draw((i + 0.5) / shares) for i in range(shares))
    assert completions.total == len(drawn) == 1 << 10
    expected = shares / len(drawn)
    assert sum((count - expected) ** 2 / expected for count in drawn.values()) < 1.0


def any_word(ranges: list[Range], weights: list[float] | None = None) -> CompletionTable:
    letters = "abc"[: len(ranges)]
    return table(build(letters, same(ANY_WORD)), ranges, float(COARSE), weights)


def only(completions: Completions) -> tuple[str, ...]:
    (word,) = completions.words()
    return word


def test_words_of_vanishing_weight_are_not_lost() -> None:
    """Sixteen letters fit, and they all have to be the rarest: a share of 1e-32 of the words that do not."""
    completions = any_word([(61.0, 61.0), (61.0, 64.0)], [0.99, 0.01]).at(1024.0, 1024.0)
    assert not completions.empty
    assert only(completions) == ("b",) * 16
    for share in (0.0, 0.3, 1.0):
        assert completions.draw(share) == ("b",) * 16


def test_that_there_is_no_word_is_exact() -> None:
    completions = any_word([(61.0, 61.0), (61.0, 63.0)], [0.99, 0.01]).at(1024.0, 1024.0)
    assert completions.empty
    assert completions.total == 0
    assert list(completions.words()) == []


def test_a_letter_without_a_size_is_not_used() -> None:
    completions = any_word([(200.0, 300.0), (1.0, 0.0)]).at(500.0, 500.0)
    assert only(completions) == ("a", "a")


def test_a_letter_may_be_of_any_size() -> None:
    completions = any_word([(500.0, float("inf")), (250.0, 260.0)]).at(1000.0, 1000.0)
    assert sorted(completions.words()) == sorted([("a",), ("a", "a"), ("a", "b"), ("b", "a"), ("a", "b", "b"),
                                                  ("b", "a", "b"), ("b", "b", "a"), ("b",) * 4])  # fmt: skip


def test_letters_narrower_than_the_finest_cell_are_not_vouched_for() -> None:
    assert any_word([(200.0, 300.0), (0.2, 300.0)]).exact
    assert not any_word([(200.0, 300.0), (0.01, 300.0)]).exact


def test_a_machine_without_words() -> None:
    nothing = build("ab", same(Counting({"a": (0.0, 0.0), "b": (0.0, 0.0)}, 3.0, 2.0)))
    assert nothing.empty
    completions = table(nothing, [(100.0, 200.0)] * 2, 1000.0).at(500.0, 500.0)
    assert completions.empty
    assert completions.total == 0
    assert list(completions.words()) == []
