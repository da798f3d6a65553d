"""Sequence generators: the words that their sequences admit are those that they promise."""

from __future__ import annotations

from itertools import pairwise, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints.generators import (
    framed,
    repetition,
    replication,
    reversal,
    sequences,
    two_shuffle,
)
from layoutkit.constraints.sequence import covered
from layoutkit.model import Region, Word

LETTERS = "abcd"
REGION = Region("R", 4.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in LETTERS))
LISTS = st.text("abc", min_size=1, max_size=5)
POSITIONS = st.frozensets(st.integers(0, 3))


def admitted(words: tuple[Word, ...], letters: str, longest: int) -> set[str]:
    """Return the words up to a length that the sequences cover."""
    pieces = [constraint.piece(REGION) for constraint in sequences(["R"], words, "")]
    every = (w for n in range(longest + 1) for w in product(letters, repeat=n))
    return {"".join(word) for word in every if covered(word, pieces)}


@given(LISTS)
def test_replication_admits_one_word(word: str) -> None:
    assert admitted(replication(word), "abc", len(word) + 1) == {word}


@settings(max_examples=50)
@given(st.integers(1, 4), POSITIONS, POSITIONS)
def test_repetition_keeps_the_order(count: int, optional: frozenset[int], repeating: frozenset[int]) -> None:
    word = LETTERS[:count]
    optional, repeating = (frozenset(p for p in chosen if p < count) for chosen in (optional, repeating))
    if len(optional) == count:
        optional -= {0}
    expected = set()
    longest = 7 - count // 2
    for times in product(range(longest + 1), repeat=count):
        right = all((n > 0 or p in optional) and (n < 2 or p in repeating) for p, n in enumerate(times))
        if right and sum(times) <= longest:
            expected.add("".join(s * n for s, n in zip(word, times, strict=True)))
    assert admitted(repetition(word, optional, repeating), word, longest) == expected


def test_repetition_with_everything_optional_still_has_a_symbol() -> None:
    assert "" not in admitted(repetition("ab", {0, 1}, {1}), "ab", 4)
    assert admitted(repetition("ab", {0, 1}, {1}), "ab", 3) == {"a", "b", "ab", "bb", "abb", "bbb"}


def test_repetition_tells_no_occurrences_apart() -> None:
    with pytest.raises(ValueError, match="stands twice"):
        repetition("aba", (), ())


@given(LISTS)
def test_two_shuffle_pairs_neighbours_both_ways(word: str) -> None:
    words = two_shuffle(word)
    assert len(set(map(str, words))) == len(words)
    found = {tuple(str(s) for s in w.sets) for w in words}
    assert found == {pair for a, b in pairwise(word) for pair in ((a, b), (b, a))}
    assert not any(w.at_start or w.at_end for w in words)


@settings(max_examples=50)
@given(st.lists(st.text("ab", min_size=1, max_size=3), min_size=1, max_size=4), st.booleans(), st.booleans())
def test_reversal_reads_backwards(texts: list[str], start: bool, end: bool) -> None:
    words = tuple(
        Word.parse(" ".join([*("⊢" * (start and i == 0)), *text, *("⊣" * (end and i == len(texts) - 1))]))
        for i, text in enumerate(texts)
    )
    assert reversal(reversal(words)) == words
    backwards = {word[::-1] for word in admitted(reversal(words), "ab", 6)}
    assert backwards == admitted(words, "ab", 6)


@settings(max_examples=50)
@given(
    st.sets(st.sampled_from("abc"), min_size=1),
    st.sets(st.sampled_from("abc"), min_size=1),
    st.dictionaries(st.sampled_from("abc"), st.sets(st.sampled_from("abc"))),
)
def test_framed_admits_the_words_of_its_chain(
    starts: set[str], ends: set[str], after: dict[str, set[str]]
) -> None:
    words = framed(sorted(starts), {s: sorted(others) for s, others in after.items()}, sorted(ends))
    expected = {
        "".join(word)
        for n in range(1, 6)
        for word in product("abc", repeat=n)
        if word[0] in starts and word[-1] in ends and all(b in after.get(a, ()) for a, b in pairwise(word))
    }
    assert admitted(words, "abc", 5) == expected


def test_only_the_first_sequence_carries_the_comment() -> None:
    found = sequences(["R", "S"], two_shuffle("ab"), "shuffled")
    assert [c.comment for c in found] == ["shuffled", ""]
    assert {c.within for c in found} == {("R", "S")}
