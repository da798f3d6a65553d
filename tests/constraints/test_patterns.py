"""Patterns: how they are written, which words they describe, and which sequences say the same."""

from __future__ import annotations

from itertools import count, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from patterns import LETTERS, NAMES, patterns, spelled_out

from layoutkit.constraints.chains import Inexpressible, chained
from layoutkit.constraints.covering import Covering, Piece
from layoutkit.constraints.generators import own_names, repetition, spelled
from layoutkit.constraints.language import DEAD, Language, TooManyStates, language
from layoutkit.constraints.pattern import Either, Marked, One, Pattern, Row
from layoutkit.constraints.sequence import covered
from layoutkit.model import RegionSet

SYMBOLS = patterns(st.sampled_from(LETTERS))
SETS = patterns(st.sampled_from(["a", "b", "c", "@V", "@L", "a b", "b c", "@V b"]))


@given(SETS)
def test_patterns_read_as_they_are_written(pattern: Pattern) -> None:
    assert Pattern.parse(str(pattern)) == pattern


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("O(P Q R)+[S]T", "O (P Q R)+[S] T"),
        (" ( A ) ", "A"),
        ("A|B C|D", "A | B C | D"),
        ("{A  @Door}?", "{A @Door}?"),
        ("(A?)+", "(A?)+"),
        ("A*[B|C]", "A*[B | C]"),
        ("(A B) (C (D))", "A B C D"),
    ],
)
def test_how_patterns_are_shown(text: str, shown: str) -> None:
    assert str(Pattern.parse(text)) == shown


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a region is missing (at the beginning"),
        ("A | ", "a region is missing (behind 'A |'"),
        ("A (B", "'(' is not closed (behind 'A (B'"),
        ("A+[B", "'[' is not closed"),
        ("A (B]", "'(' is not closed (behind 'A (B'"),
        ("A)", "')' closes nothing (behind 'A'"),
        ("+A", "'+' stands behind nothing"),
        ("A [B]", "'[' stands behind nothing"),
        ("A?*", "'*' does not go with the mark '?'"),
        ("A?[B]", "'[' does not go with the mark '?'"),
        ("A $ B", "'$' is not expected (behind 'A'"),
        ("A {B", "'{' is not expected"),
        ("A {}", "a set of regions cannot be empty"),
        ("|- A", "⊢ and ⊣ are not written"),
        ("A ⊣", "⊢ and ⊣ are not written"),
        ("A/B", "'/' is not expected"),
        ("(" * 50 + "A" + ")" * 50, "parentheses stand inside one another"),
    ],
)
def test_patterns_that_cannot_be_read(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=r"of the pattern") as error:
        Pattern.parse(text)
    assert message in str(error.value)


@given(st.text("ab@{}()[]|?*+⊢⊣ -", max_size=12))
def test_any_text_is_a_pattern_or_a_value_error(text: str) -> None:
    try:
        pattern = Pattern.parse(text)
    except ValueError:
        return
    assert Pattern.parse(str(pattern)) == pattern


@settings(max_examples=150)
@given(SETS)
def test_a_pattern_describes_what_a_regular_expression_does(pattern: Pattern) -> None:
    words = spelled(pattern, NAMES)
    expected = spelled_out(pattern, NAMES, 5)
    assert {"".join(w) for n in range(6) for w in product(LETTERS, repeat=n) if w in words} == expected


@settings(max_examples=200)
@given(SETS)
def test_sequences_say_exactly_what_the_pattern_says_or_it_is_refused(pattern: Pattern) -> None:
    excess = _excess(pattern)
    if excess is not None:
        assert excess not in spelled(pattern, NAMES)
        return
    pieces = chained(spelled(pattern, NAMES))
    assert language(Covering(pieces), tuple(NAMES)) == spelled(pattern, NAMES)
    expected = spelled_out(pattern, NAMES, 4)
    for word in (w for n in range(1, 5) for w in product(LETTERS, repeat=n)):
        assert covered(word, pieces) is ("".join(word) in expected), word


def _excess(pattern: Pattern) -> tuple[str, ...] | None:
    """Return what the refusal of a pattern shows; None if it is not refused."""
    try:
        chained(spelled(pattern, NAMES))
    except Inexpressible as error:
        return error.excess
    return None


@settings(max_examples=150)
@given(SYMBOLS)
def test_patterns_without_a_symbol_in_two_places_are_never_refused(pattern: Pattern) -> None:
    renamed = _renamed(pattern, count())
    pieces = chained(spelled(renamed, own_names(renamed)))
    assert language(Covering(pieces), tuple(own_names(renamed))) == spelled(renamed, own_names(renamed))


def _renamed(pattern: Pattern, numbers: count[int]) -> Pattern:
    """Give every place a symbol of its own."""
    match pattern:
        case Row(parts):
            return Row(tuple(_renamed(part, numbers) for part in parts))
        case Either(ways):
            return Either(tuple(_renamed(way, numbers) for way in ways))
        case Marked(part, mark, between):
            inner = _renamed(part, numbers)
            return Marked(inner, mark, _renamed(between, numbers) if between is not None else None)
    return One(RegionSet(f"s{next(numbers)}"))


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        # Bao, Schwarz and Wonka 2013, section 6: the top region, its middle part, the ornaments at the side.
        ("C? D C?", {"⊢ C D", "⊢ D", "D C ⊣", "D ⊣"}),
        ("@Space+[M]", {"⊢ @Space", "@Space M", "M @Space", "@Space ⊣"}),
        ("O (P Q R)+[S] T", {"⊢ O P", "P Q R S P", "P Q R T ⊣"}),
        # A word as it is.
        ("A B A", {"⊢ A B A ⊣"}),
        # Retargeting with one pier on either side of each bay.
        ("Pier+[{Bay Door}]", {"⊢ Pier", "Pier {Bay Door}", "{Bay Door} Pier", "Pier ⊣"}),
        # Symbols in two roles: W and P repeat before the door only.
        ("E (W P)+ D P W E", {"⊢ E W", "W P", "P {W D}", "D P W E ⊣"}),
        # B begins and ends what repeats.
        ("(B A A B)+", {"⊢ B", "B A", "A A B ⊣", "A A B B"}),
        # As many as come, none of them twice.
        ("A? B? C?", {"⊢ {A B C}", "{A B} C", "A B", "{A B C} ⊣"}),
    ],
)
def test_sequences_of_patterns(pattern: str, words: set[str]) -> None:
    assert {str(word) for word in repetition(pattern)} == words


def test_sets_are_written_as_the_pattern_writes_them() -> None:
    names = {"L": frozenset({"L", "@Space"}), "N": frozenset({"N", "@Space"}), "M": frozenset({"M"})}
    found = [str(word) for word in repetition("M (@Space M)* {L N}", names)]
    assert found == [str(word) for word in repetition("M (@Space M)* @Space", names)]
    assert set(found) == {"⊢ M", "M @Space", "@Space M", "@Space ⊣"}
    other = {**names, "K": frozenset({"K"})}
    assert {str(word) for word in repetition("M+[{@Space K}]", other)} == {
        "⊢ M",
        "M {@Space K}",
        "{@Space K} M",
        "M ⊣",
    }


@pytest.mark.parametrize(
    ("pattern", "excess"),
    [
        ("E W+[P] D W+[P] E", "E W P W E"),  # nothing asks for the door
        ("R (A A)+", "R A A A"),  # nothing counts
    ],
)
def test_patterns_that_sequences_cannot_say(pattern: str, excess: str) -> None:
    with pytest.raises(Inexpressible, match=f"would also admit '{excess}'") as error:
        repetition(pattern)
    assert error.value.excess == tuple(excess.split())


@pytest.mark.parametrize(
    "pattern",
    ["{A B}* A " + "{A B} " * 16, " ".join(f"A{n}?" for n in range(120)), "A " * 201],
    ids=["states", "sequences", "names"],
)
def test_patterns_that_are_too_large(pattern: str) -> None:
    with pytest.raises(TooManyStates, match="more than"):
        repetition(pattern)


def test_equal_sets_of_words_have_equal_automata() -> None:
    one, other = (spelled(Pattern.parse(text), NAMES) for text in ("a (b a)*", "a+[b]"))
    assert one == other
    assert one.without(other) is None
    wider = spelled(Pattern.parse("a+[@L]"), NAMES)
    assert wider.without(one) == ("a", "a", "a")
    assert one.without(wider) is None


def test_no_words_at_all() -> None:
    nothing = language(Covering((Piece((frozenset("a"),)),)), ("a", "b"))
    assert nothing == Language(("a", "b"), ((DEAD, DEAD),), (False,))
    assert ("a",) not in nothing
    assert chained(nothing) == ()
