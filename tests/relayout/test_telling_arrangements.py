"""How inference tells arrangements: as patterns that say the same as sequences, and by their rhythm."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import Repetition, Replication, Sequence
from layoutkit.constraints.covering import Covering
from layoutkit.constraints.generators import framed, names_of, repetition, sequences, spelled
from layoutkit.constraints.language import Language, language
from layoutkit.constraints.pattern import Pattern
from layoutkit.model import Facade, Region
from layoutkit_relayout.inference.patterns import covered, pattern_of, told
from layoutkit_relayout.inference.rhythm import Run, inner, longest_told_apart, repeated, runs, units

LETTERS = "abcd"


def facade(word: str) -> Facade:
    children = tuple(Region(s, 1.0, 1.0) for s in word)
    return Facade("f", "m", Region("F", float(len(word)), 1.0, "columns", children))


def words_of(starts: set[str], ends: set[str], after: dict[str, set[str]]) -> Language:
    """Return the words of a chain: what begins it, what may follow each letter, what ends it."""
    chain = framed(sorted(starts), {s: sorted(others) for s, others in after.items()}, sorted(ends))
    region = facade(LETTERS).root
    pieces = tuple(c.piece(region) for c in sequences(["F"], chain))
    return language(Covering(pieces), tuple(LETTERS))


SOME = st.sets(st.sampled_from(LETTERS), min_size=1)
CHAINS = st.builds(words_of, SOME, SOME, st.dictionaries(st.sampled_from(LETTERS), SOME))


@settings(max_examples=150)
@given(CHAINS)
def test_the_pattern_of_a_language_spells_it(words: Language) -> None:
    if any(words.accepting):
        pattern = pattern_of(words)
        assert spelled(pattern, names_of(facade(LETTERS).root)) == words
        assert Pattern.parse(str(pattern)) == pattern


@pytest.mark.parametrize(
    "pattern",
    ["a b+ c", "a+[b]", "a+[{b c}]", "a+[b+[c]]", "(a b)+ c", "a b? c", "a (b c)* d", "{a b} c*", "a"],
)
def test_patterns_are_told_with_their_marks(pattern: str) -> None:
    words = spelled(Pattern.parse(pattern), names_of(facade(LETTERS).root))
    assert str(pattern_of(words)) == pattern


def test_arrangements_are_told_in_the_fewest_words() -> None:
    found = facade("abcb")
    (pattern,) = told(found, ["F"], repetition("a (b c)* b"), "why")
    assert isinstance(pattern, Repetition)
    assert (str(pattern.pattern), pattern.comment) == ("a b+[c]", "why")
    (same,) = told(found, ["F"], repetition("a b c b"), "why")
    assert isinstance(same, Replication)
    alternatives = framed("a", {"a": "bc", "b": "bd", "c": "ca", "d": "a"}, "bc")
    assert all(isinstance(c, Sequence) for c in told(facade(LETTERS), ["F"], alternatives, "why"))


@settings(max_examples=60)
@given(SOME, SOME, st.dictionaries(st.sampled_from(LETTERS), SOME))
def test_telling_keeps_the_meaning(starts: set[str], ends: set[str], after: dict[str, set[str]]) -> None:
    chain = framed(sorted(starts), {s: sorted(others) for s, others in after.items()}, sorted(ends))
    found = facade(LETTERS)
    allowed = covered(found, "F", chain)
    if not any(allowed.accepting):
        return
    said = list(told(found, ["F"], chain, "why"))
    if isinstance(said[0], Repetition | Replication):
        (only,) = said
        assert covered(found, "F", only.words(found, "F", {})) == allowed
    else:
        assert tuple(c.word for c in said if isinstance(c, Sequence)) == chain


@pytest.mark.parametrize(
    ("word", "pattern"),
    [
        ("EWPWPWE", "E W+[P] E"),
        ("PWPWP", "P+[W]"),
        ("EWPWPDPWPWPWE", "E W P W P D (P W)+ E"),
        ("PABPABPD", "(P A B)+ P D"),
        ("AAB", "A+ B"),
        ("EBPCPBPCPBE", "E (B P C P)+ B E"),
    ],
)
def test_runs_repeat(word: str, pattern: str) -> None:
    found = list(runs(word, "P", "D"))
    assert str(repeated(word, longest_told_apart(word, found))) == pattern


@pytest.mark.parametrize("word", ["EWE", "EWPDPWE", "PWP", "ABC", "A"])
def test_words_without_a_rhythm(word: str) -> None:
    """One bay, or the same space on both sides of one, is no rhythm."""
    assert list(runs(word, "P", "D")) == []


def test_units_where_there_is_no_rhythm() -> None:
    seen = {("P", "A"), ("A", "Q"), ("Q", "B"), ("B", "R"), ("Q", "A"), ("R", "B")}
    found = list(units("PAQBRS", "", lambda one, other: (one, other) in seen))
    assert found == [Run(1, 3, 2, 0), Run(3, 5, 2, 0)]
    assert str(repeated("PAQBRS", found)) == "P (A Q)+ (B R)+ S"
    assert list(units("PAQBRS", "A", lambda one, other: (one, other) in seen)) == [Run(3, 5, 2, 0)]


@given(st.text("abP", min_size=1, max_size=12))
def test_runs_are_in_the_word_and_apart(word: str) -> None:
    start, end = inner(word)
    place = start
    for run in runs(word, "P", ()):
        assert place <= run.start < run.end <= end
        place = run.end
        period = run.unit + run.between
        assert all(word[i] == word[i + period] for i in range(run.start, run.end - period))
        assert (run.end - run.start + run.between) % period == 0
        assert run.end - run.start > period
    pattern = repeated(word, list(runs(word, "P", ())))
    names = {letter: frozenset({letter}) for letter in dict.fromkeys(word)}
    assert tuple(word) in spelled(pattern, names)
