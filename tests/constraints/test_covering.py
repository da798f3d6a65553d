"""Sequences: the automaton, the checker and the definition agree on which words a chain covers."""

from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints.covering import Covering, Piece
from layoutkit.constraints.sequence import covered

CASES = Path(__file__).parents[3] / "shared" / "judge" / "sequences.json"
Word = Sequence[str]


def accepts(pieces: Sequence[Piece], word: Word) -> bool:
    """Run the automaton."""
    covering = Covering(tuple(pieces))
    state = covering.start()
    for symbol in word:
        after = covering.step(state, symbol)
        if after is None:
            return False
        state = after
    return covering.accepts(state)


def by_definition(pieces: Sequence[Piece], word: Word) -> bool:
    """Look for the chain itself: instantiations, of which each shares a subregion with the one before.

    The word is framed by its ends. A chain may come back to an instantiation, which changes nothing that it
    covers; so it covers the whole word if all that can be reached from one at the start does.
    """
    framed = ("⊢", *word, "⊣")
    places = []
    for piece in pieces:
        spelled = [*(["⊢"] if piece.at_start else []), *piece.sets, *(["⊣"] if piece.at_end else [])]
        for start in range(len(framed) - len(spelled) + 1):
            if all(framed[start + i] in allowed for i, allowed in enumerate(spelled)):
                places.append(range(start, start + len(spelled)))
    subregions = set(range(1, len(word) + 1))
    reached = {place for place in places if place.start == 0}
    while True:
        covered_ = {position for place in reached for position in place}
        # Each sequence names a subregion, so that an instantiation at the start has one to share.
        more = {p for p in places if any(set(p) & set(q) & subregions for q in reached)} - reached
        if not more:
            return covered_ == set(range(len(framed)))
        reached |= more


def pieces_of(case: dict[str, Any]) -> list[Piece]:
    found = []
    for sets in case["sequences"]:
        inner = [frozenset(s) for s in sets if s not in (["⊢"], ["⊣"])]
        found.append(Piece(tuple(inner), sets[0] == ["⊢"], sets[-1] == ["⊣"]))
    return found


@pytest.mark.skipif(not CASES.is_file(), reason="the cases of sequences are not beside the project")
def test_cases_made_by_others() -> None:
    cases = json.loads(CASES.read_text(encoding="utf-8"))
    assert len(cases) > 100
    for number, case in enumerate(cases):
        pieces = pieces_of(case)
        if "words" in case:
            letters, expected = case["alphabet"], set(case["words"])
            # All words up to the length; the longest ones of large alphabets only where they are few.
            longest = min(case["longest"], 6 if len(letters) < 4 else 5)
            judged = [w for n in range(longest + 1) for w in map("".join, product(letters, repeat=n))]
            judged += sorted(expected)
        else:
            expected = set(case["accepted"])
            judged = [*case["accepted"], *case["rejected"]]
        for word in judged:
            for judge in (accepts, covered_by):
                assert judge(pieces, word) is (word in expected), (number, judge.__name__, word)


def covered_by(pieces: Sequence[Piece], word: Word) -> bool:
    return covered(tuple(word), list(pieces))


SETS = st.frozensets(st.sampled_from("abc"), min_size=1)
PIECES = st.builds(Piece, st.lists(SETS, min_size=1, max_size=4).map(tuple), st.booleans(), st.booleans())
TWO_LETTERS = st.frozensets(st.sampled_from("ab"), min_size=1)
SHORT = st.builds(
    Piece, st.lists(TWO_LETTERS, min_size=1, max_size=4).map(tuple), st.booleans(), st.booleans()
)


@settings(max_examples=120)
@given(st.lists(PIECES, min_size=1, max_size=6))
def test_three_readings_agree(pieces: list[Piece]) -> None:
    for word in (w for n in range(6) for w in product("abc", repeat=n)):
        expected = by_definition(pieces, word)
        assert accepts(pieces, word) is expected, word
        assert covered_by(pieces, word) is expected, word


@settings(max_examples=250)
@given(st.lists(SHORT, min_size=2, max_size=8))
def test_three_readings_agree_on_longer_words(pieces: list[Piece]) -> None:
    for word in (w for n in range(7) for w in product("ab", repeat=n)):
        expected = by_definition(pieces, word)
        assert accepts(pieces, word) is expected, word
        assert covered_by(pieces, word) is expected, word


def pieces(*texts: str) -> list[Piece]:
    """Read pieces written like ⊢a(bc)⊣."""
    found = []
    for text in texts:
        sets, inner = [], text.strip("⊢⊣")
        while inner:
            end = inner.index(")") if inner[0] == "(" else 0
            sets.append(frozenset(inner[: end + 1].strip("()")))
            inner = inner[end + 1 :]
        found.append(Piece(tuple(sets), text.startswith("⊢"), text.endswith("⊣")))
    return found


@pytest.mark.parametrize(
    ("given_", "accepted", "rejected"),
    [
        pytest.param(["⊢ab⊣"], ["ab"], ["", "a", "b", "aab", "abb", "ba"], id="whole"),
        pytest.param(["⊢a", "a⊣"], ["a"], ["aa", ""], id="neighbours only touch"),
        pytest.param(["⊢a", "aa", "a⊣"], ["a", "aa", "aaaa"], [""], id="repeat"),
        pytest.param(["⊢a(bc)", "(bd)⊣"], ["ab"], ["ac", "ad"], id="in both sets"),
        pytest.param(["⊢ab", "abc⊣"], ["abc"], ["ab", "ababc"], id="the next begins as early"),
        pytest.param(["⊢abc", "b", "cd⊣"], ["abcd"], ["abc"], id="one inside another adds nothing"),
        pytest.param(["a", "aa"], [], ["", "a", "aa"], id="without ends"),
        pytest.param(["⊢ab", "bc", "cd⊣", "xa"], ["abcd"], ["xabcd"], id="nothing before the start"),
    ],
)
def test_chains_by_hand(given_: list[str], accepted: list[str], rejected: list[str]) -> None:
    for judge in (accepts, covered_by, by_definition):
        for word in (*accepted, *rejected):
            assert judge(pieces(*given_), word) is (word in accepted), (judge.__name__, word)


def test_a_dead_end_stays_one() -> None:
    covering = Covering(tuple(pieces("⊢ab⊣")))
    assert covering.step(covering.start(), "b") is None
    assert not covering.accepts(covering.start())
