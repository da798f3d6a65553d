"""Words that read the same backwards are found by their halves: all of them, each once."""

from __future__ import annotations

from itertools import product

from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints.covering import Covering, Piece
from layoutkit_relayout.words.machine import Machine, build
from layoutkit_relayout.words.mirrored import mirrored

LETTERS = "abc"
PIECES = st.lists(
    st.builds(
        Piece,
        st.lists(st.frozensets(st.sampled_from(LETTERS), min_size=1), min_size=1, max_size=3).map(tuple),
        st.booleans(),
        st.booleans(),
    ),
    min_size=1,
    max_size=6,
)
PARTNERS = st.sampled_from([dict(zip(LETTERS, p, strict=True)) for p in ("abc", "bac", "acb", "cba")])
LONGEST = 6


def words(machine: Machine) -> list[tuple[str, ...]]:
    """Return all words of a machine's own letters up to some length."""
    found = []
    pending: list[tuple[int, tuple[str, ...]]] = [] if machine.empty else [(0, ())]
    while pending:
        state, word = pending.pop()
        if machine.accepting[state]:
            found.append(word)
        if len(word) < LONGEST:
            for letter, after in zip(machine.letters, machine.next[state], strict=True):
                if after >= 0:
                    pending.append((int(after), (*word, letter)))
    return found


@given(PIECES, PARTNERS)
def test_halves_spell_the_palindromes(pieces: list[Piece], partners: dict[str, str]) -> None:
    same = {letter: letter for letter in LETTERS}
    machine = build(LETTERS, [(Covering(tuple(pieces)), same)])
    halved = mirrored(machine, {one: (other,) for one, other in partners.items()})
    spelled = [halved.spell(word) for word in words(halved)]
    assert len(spelled) == len(set(spelled))
    expected = {
        word
        for length in range(LONGEST + 1)
        for word in product(LETTERS, repeat=length)
        if machine.accepts(word) and word == tuple(partners[letter] for letter in reversed(word))
    }
    assert {word for word in spelled if len(word) <= LONGEST} == expected
    assert all(halved.accepts(word) == (word in expected) for word in words(machine) if len(word) <= LONGEST)
