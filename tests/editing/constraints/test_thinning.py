"""Words and patterns in other names, or without some: what they still admit."""

from __future__ import annotations

import re
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints.pattern import Either, Marked, One, Pattern, either, row
from layoutkit.model import RegionSet, Word
from layoutkit_editing.constraints.thinning import pattern_of, word_of

LETTERS = "abc"
#: Longer arrangements are not compared.
LONGEST = 5


def changed(**names: str) -> dict[str, tuple[str, ...]]:
    return {name: tuple(new.split()) for name, new in names.items()}


def test_words_in_other_names() -> None:
    names = changed(a="a a_2", b="b", c="")
    assert str(word_of(Word.parse("⊢ a {b c} @L"), {**names, "@L": ("@L",)}.__getitem__)) == "⊢ {a a_2} b @L"
    assert word_of(Word.parse("a c"), names.__getitem__) is None


@pytest.mark.parametrize(
    ("pattern", "left"),
    [
        ("a b", "a b"),
        ("a c", None),
        ("a c?", "a"),
        ("(a|c) b", "a b"),
        ("(a c | b)+", "b+"),
        ("(c|c b)? a", "a"),
        ("(a|c?) b", "a? b"),
        ("a+[c]", "a"),
        ("a*[c]", "a?"),
        ("(c?)+[b] a", "b* a"),
        ("(c?)*[b] a", "b* a"),
        ("(c*)?", None),
        ("a+[c?]", "a+"),
        ("c+ | c", None),
    ],
)
def test_patterns_without_a_name(pattern: str, left: str | None) -> None:
    found = pattern_of(Pattern.parse(pattern), changed(a="a", b="b", c="").__getitem__)
    assert (None if found is None else str(found)) == left


def patterns() -> st.SearchStrategy[Pattern]:
    names = st.sampled_from([*LETTERS, "a | b", "b | c"]).map(lambda text: One(RegionSet.parse(text)))

    def more(inner: st.SearchStrategy[Pattern]) -> st.SearchStrategy[Pattern]:
        several = st.lists(inner, min_size=2, max_size=3)
        marks = st.builds(Marked, inner, st.sampled_from("?+*"))
        between = st.builds(Marked, inner, st.sampled_from("+*"), inner)
        return several.map(lambda own: row(*own)) | several.map(lambda own: either(*own)) | marks | between

    return st.recursive(names, more, max_leaves=6)


def expression(pattern: Pattern) -> str:
    """Return a regular expression for the arrangements of a pattern, one letter a region."""
    if isinstance(pattern, One):
        return f"[{''.join(pattern.regions.names())}]"
    if isinstance(pattern, Either):
        return f"(?:{'|'.join(map(expression, pattern.ways))})"
    if isinstance(pattern, Marked):
        part = f"(?:{expression(pattern.part)})"
        if pattern.between is not None:
            part = f"(?:{part}(?:(?:{expression(pattern.between)}){part})*)"
            return part if pattern.mark == "+" else f"{part}?"
        return f"{part}{pattern.mark}"
    return "".join(map(expression, pattern.parts))  # type: ignore[attr-defined]  # a row


def renamings() -> st.SearchStrategy[dict[str, str]]:
    options = {name: st.sampled_from(["", name, f"{name} {name.upper()}"]) for name in LETTERS}
    return st.fixed_dictionaries(options)


@given(patterns(), renamings())
def test_what_is_left_of_a_pattern_admits_what_it_did_in_other_names(
    pattern: Pattern, become: dict[str, str]
) -> None:
    names = changed(**become)
    found = pattern_of(pattern, names.__getitem__)
    was = re.compile(expression(pattern))
    now = re.compile(expression(found)) if found is not None else None
    old = {new: name for name, own in names.items() for new in own}
    for length in range(1, LONGEST):
        for word in map("".join, product(old, repeat=length)):
            expected = was.fullmatch("".join(old[letter] for letter in word)) is not None
            assert (now is not None and now.fullmatch(word) is not None) == expected, word
    if found is not None:
        assert Pattern.parse(str(found)) == found
