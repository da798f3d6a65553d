"""Machines accept the words of their automata: built, trimmed and made small."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints.covering import Covering, Piece
from layoutkit.constraints.word_rules import Automaton, Exactly
from layoutkit_relayout.words.extremes import longest, shortest
from layoutkit_relayout.words.machine import Counting, Machine, TooManyStates, build, chain, trim

LETTERS = "ab", "abc"
PIECES = st.builds(
    Piece,
    st.lists(st.frozensets(st.sampled_from("abc"), min_size=1), min_size=1, max_size=3).map(tuple),
    st.booleans(),
    st.booleans(),
)
COVERINGS = st.lists(PIECES, min_size=1, max_size=5).map(lambda pieces: Covering(tuple(pieces)))
COUNTS = st.tuples(st.integers(0, 2), st.integers(0, 2)).map(lambda two: (min(two), max(two)))
COUNTINGS = st.builds(
    Counting,
    st.fixed_dictionaries(dict.fromkeys("abc", COUNTS)),
    st.integers(-1, 4),
    st.integers(0, 5) | st.just(float("inf")),
)
EXACT = st.text("abc", min_size=1, max_size=4).map(Exactly)
AUTOMATA = st.lists(COVERINGS | COUNTINGS | EXACT, min_size=1, max_size=3)


def words(longest_word: int, letters: str = "abc") -> list[tuple[str, ...]]:
    return [word for n in range(longest_word + 1) for word in product(letters, repeat=n)]


def reads(automaton: Automaton, word: Sequence[str]) -> bool:
    state = automaton.start()
    for symbol in word:
        state = automaton.step(state, symbol)
        if state is None:
            return False
    return automaton.accepts(state)


def same(*automata: Automaton) -> list[tuple[Automaton, dict[str, str]]]:
    return [(automaton, {letter: letter for letter in "abc"}) for automaton in automata]


@given(AUTOMATA)
def test_a_machine_accepts_what_all_its_automata_do(automata: list[Automaton]) -> None:
    machine = build("abc", same(*automata))
    for word in words(6):
        assert machine.accepts(word) is all(reads(automaton, word) for automaton in automata), word
    assert not machine.accepts(("z",))


@given(COVERINGS)
def test_letters_may_go_by_other_names(covering: Covering) -> None:
    names = {"x": "c", "y": "a", "z": "b"}
    machine = build("xyz", [(covering, names)])
    for word in words(5, "xyz"):
        assert machine.accepts(word) is reads(covering, [names[letter] for letter in word])


@given(AUTOMATA)
def test_machines_have_no_idle_state_and_no_two_alike(automata: list[Automaton]) -> None:
    machine = build("abc", same(*automata))
    count = len(machine.accepting)
    if machine.empty:
        assert not any(all(reads(a, word) for a in automata) for word in words(7))
        return
    reached, completed = {0}, set(np.flatnonzero(machine.accepting))
    for _ in range(count):
        reached |= {int(s) for r in reached for s in machine.next[r] if s >= 0}
        completed |= {s for s in range(count) if set(machine.next[s]) & completed}
    assert reached == completed == set(range(count))
    # No two states complete the same words (Myhill and Nerode): the machine is the smallest.
    ends = {s: frozenset(w for w in words(min(count, 7)) if _from(machine, s, w)) for s in range(count)}
    if count <= 7:
        assert len(set(ends.values())) == count


def _from(machine: Machine, state: int, word: Sequence[str]) -> bool:
    for letter in word:
        if state < 0:
            return False
        state = int(machine.next[state, machine.letters.index(letter)])
    return state >= 0 and bool(machine.accepting[state])


@given(st.data(), st.integers(1, 6))
def test_trimming_any_table_keeps_its_words(data: st.DataObject, states: int) -> None:
    rows = st.lists(st.integers(-1, states - 1), min_size=2, max_size=2)
    following = np.array(data.draw(st.lists(rows, min_size=states, max_size=states)), dtype=np.int64)
    accepting = np.array(data.draw(st.lists(st.booleans(), min_size=states, max_size=states)))
    whole = Machine(("a", "b"), following, accepting)
    trimmed = trim(("a", "b"), following, accepting)
    for word in words(states + 2, "ab"):
        assert trimmed.accepts(word) is whole.accepts(word)


@given(AUTOMATA)
def test_what_is_said_of_all_words(automata: list[Automaton]) -> None:
    machine = build("abc", same(*automata))
    own = [word for word in words(7) if machine.accepts(word)]
    for letter in "abc":
        if machine.needs(letter):
            assert all(letter in word for word in own)
        elif not machine.empty and len(machine.accepting) <= 7:
            assert any(letter not in word for word in own), "one of the shortest words shows it"
    only = machine.only_word()
    if only is not None:
        assert own == ([only] if len(only) <= 7 else [])
    elif own and len(machine.accepting) <= 3:
        assert len(own) > 1


@given(AUTOMATA, st.lists(st.floats(0.1, 5), min_size=3, max_size=3))
def test_shortest_and_longest_words(automata: list[Automaton], sizes: list[float]) -> None:
    machine = build("abc", same(*automata))
    lengths = [
        sum(sizes["abc".index(letter)] for letter in word) for word in words(7) if machine.accepts(word)
    ]
    if machine.empty:
        assert (shortest(machine, sizes), longest(machine, sizes)) == (float("inf"), float("-inf"))
        return
    least, most = shortest(machine, sizes), longest(machine, sizes)
    assert all(least - 1e-9 <= length <= most + 1e-9 for length in lengths)
    if len(machine.accepting) <= 7:
        assert least == pytest.approx(min(lengths))
        looped = any(machine.accepts(word) for word in words(7) if len(word) >= len(machine.accepting))
        assert most == (float("inf") if looped else pytest.approx(max(lengths)))


def test_the_machine_of_one_word() -> None:
    for word in ("a", "abca", "ccc"):
        single = chain(("a", "b", "c"), tuple(word))
        assert single.only_word() == tuple(word)
        assert [w for w in words(5) if single.accepts(w)] == [tuple(word)]
        built = build("abc", same(Exactly(word)))
        assert np.array_equal(built.next, single.next)
        assert np.array_equal(built.accepting, single.accepting)


def test_too_many_states_are_refused() -> None:
    counting = same(Counting(dict.fromkeys("abc", (1.0, 1.0)), 0.0, 9.0))
    with pytest.raises(TooManyStates, match="more than 5 states"):
        build("abc", counting, 5)
    assert len(build("abc", counting, 10).accepting) == 10


def _always(letters: Sequence[str]) -> Callable[[Sequence[str]], bool]:
    return lambda word: set(letters) <= set(word)


def test_a_letter_that_every_word_needs() -> None:
    pieces = (
        Piece((frozenset("a"),), at_start=True),
        Piece((frozenset("a"), frozenset("bc"))),
        Piece((frozenset("bc"), frozenset("a"))),
        Piece((frozenset("a"),), at_end=True),
    )
    machine = build("abc", same(Covering(pieces)))
    assert [machine.needs(letter) for letter in "abc"] == [True, False, False]
    assert all(_always("a")(word) for word in words(6) if machine.accepts(word))
