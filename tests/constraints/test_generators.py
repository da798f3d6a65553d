"""Sequence generators: the words that their sequences admit are those that they promise."""

from __future__ import annotations

from itertools import pairwise, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints.generators import (
    corresponding,
    framed,
    repetition,
    replication,
    reuse,
    reversal,
    sequences,
    two_shuffle,
)
from layoutkit.constraints.sequence import covered
from layoutkit.model import Region, Word

LETTERS = "abcd"
REGION = Region("R", 4.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in LETTERS))
LISTS = st.text("abc", min_size=1, max_size=5)


def admitted(words: tuple[Word, ...], letters: str, longest: int) -> set[str]:
    """Return the words up to a length that the sequences cover."""
    pieces = [constraint.piece(REGION) for constraint in sequences(["R"], words, "")]
    every = (w for n in range(longest + 1) for w in product(letters, repeat=n))
    return {"".join(word) for word in every if covered(word, pieces)}


@given(LISTS)
def test_replication_admits_one_word(word: str) -> None:
    assert admitted(replication(word), "abc", len(word) + 1) == {word}


def test_repetition_of_a_written_pattern() -> None:
    assert admitted(repetition("a? b+"), "ab", 3) == {"b", "ab", "bb", "abb", "bbb"}


def test_repetition_with_everything_optional_still_has_a_symbol() -> None:
    assert admitted(repetition("a? b*"), "ab", 3) == {"a", "b", "ab", "bb", "abb", "bbb"}


@given(LISTS)
def test_two_shuffle_pairs_neighbours_both_ways(word: str) -> None:
    words = two_shuffle(word)
    assert len(set(map(str, words))) == len(words)
    found = {tuple(str(s) for s in w.sets) for w in words}
    assert found == {pair for a, b in pairwise(word) for pair in ((a, b), (b, a))}
    assert not any(w.at_start or w.at_end for w in words)


def test_two_shuffle_of_labels_and_sets() -> None:
    assert list(map(str, two_shuffle(["G", "@Space", "I"]))) == [
        "G @Space",
        "@Space I",
        "@Space G",
        "I @Space",
    ]
    word = Word.parse("{G I} H J")
    assert list(map(str, two_shuffle(word))) == ["{G I} H", "H J", "H {G I}", "J H"]


def test_two_shuffle_of_windows_and_doors_between_walls() -> None:
    """Bao, Schwarz and Wonka 2013, section 6: the columns of the bottom region."""
    found = {str(word) for word in two_shuffle("GHIHJHG")}
    assert found == {"G H", "H G", "H I", "I H", "H J", "J H"}


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


@pytest.mark.parametrize(
    ("source", "target", "expected"),
    [
        ("PWP", "PDWP", {"P": "P", "W": "W"}),  # by name, wherever they stand
        ("PWP", "XYX", {"P": "X", "W": "Y"}),  # by place
        ("PWQ", "XYX", {"P": "X", "W": "Y", "Q": "X"}),
        ("PWP", "XYZ", None),  # P would be X and Z
        ("PWP", "XY", None),
        ("PWPDP", "PXPYP", {"P": "P", "W": "X", "D": "Y"}),
    ],
)
def test_which_symbols_correspond(source: str, target: str, expected: dict[str, str] | None) -> None:
    one, other = (
        Region("R", 1.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in word))
        for word in (source, target)
    )
    assert corresponding(one, other, dict.fromkeys(source)) == expected


def test_reuse_exchanges_symbols_and_keeps_labels() -> None:
    words = [Word.parse("⊢ a {b @Bay}"), Word.parse("b a ⊣")]
    assert list(map(str, reuse(words, {"a": "x", "b": "y"}))) == ["⊢ x {y @Bay}", "y x ⊣"]


def test_only_the_first_sequence_carries_the_comment() -> None:
    found = sequences(["R", "S"], two_shuffle("ab"), "shuffled")
    assert [c.comment for c in found] == ["shuffled", ""]
    assert {c.within for c in found} == {("R", "S")}
