"""Region sets, words and extents: what is written reads back, and means what sets mean."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import END, START, Extent, Region, RegionSet, Word
from layoutkit.model.extent import occurrences

SYMBOLS = st.from_regex(r"[^\W\d]\w{0,3}", fullmatch=True)
PATHS = st.lists(SYMBOLS, min_size=1, max_size=3).map("/".join)
NAMES = PATHS | SYMBOLS.map("@{}".format)
FEW = st.sampled_from(["A", "B", "C", "@L", "@M"])


def sets(names: st.SearchStrategy[str]) -> st.SearchStrategy[RegionSet]:
    return st.recursive(
        names.map(RegionSet),
        lambda inner: st.builds(RegionSet, st.just(""), st.sampled_from("|&-"), inner, inner),
        max_leaves=6,
    )


@given(sets(NAMES))
def test_sets_read_back(regions: RegionSet) -> None:
    assert RegionSet.parse(str(regions)) == regions


@given(sets(NAMES), st.data())
def test_white_space_means_nothing(regions: RegionSet, data: st.DataObject) -> None:
    spaced = str(regions)
    for sign in "|&-()":
        spaced = spaced.replace(sign, data.draw(st.sampled_from((f"  {sign} ", f"\t{sign}", sign))))
    assert RegionSet.parse(f" {spaced} ") == regions


@given(sets(FEW), st.frozensets(FEW))
def test_sets_contain_what_sets_of_regions_do(regions: RegionSet, names: frozenset[str]) -> None:
    """Evaluated over one region: a name stands for the set of it, where it goes by that name."""

    def value(node: RegionSet) -> set[str]:
        if node.left is None or node.right is None:
            return {"region"} if node.name in names else set()
        left, right = value(node.left), value(node.right)
        return {"|": left | right, "&": left & right, "-": left - right}[node.operator or ""]

    assert regions.contains(names) is bool(value(regions))


@given(sets(NAMES))
def test_names_and_terms(regions: RegionSet) -> None:
    assert all(name in str(regions) for name in regions.names())
    joined = (
        RegionSet.union(regions.terms())
        if all("(" not in t and " " not in t for t in regions.terms())
        else None
    )
    if joined is not None:
        assert joined.names() == regions.names()


@pytest.mark.parametrize(
    "text", ["", " ", "A |", "| A", "A B", "(A", "A)", "A / B", "1A", "A/", "@", "A || B", "@A/-B"]
)
def test_what_is_no_set(text: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        RegionSet.parse(text)


@given(st.text("AB@/|&-() {}⊢⊣1", max_size=12))
def test_any_text_is_read_or_refused(text: str) -> None:
    for kind in (RegionSet, Word, Extent):
        try:
            parsed = kind.parse(text)
        except ValueError as error:
            assert str(error)  # noqa: PT017 - either outcome is right
        else:
            assert kind.parse(str(parsed)) == parsed


WORDS = st.builds(
    Word,
    st.lists(
        st.lists(SYMBOLS | SYMBOLS.map("@{}".format), min_size=1, max_size=3), min_size=1, max_size=4
    ).map(lambda sets: tuple(map(RegionSet.union, sets))),
    st.booleans(),
    st.booleans(),
)


@given(WORDS)
def test_words_read_back(word: Word) -> None:
    text = str(word)
    assert Word.parse(text) == word
    assert text.startswith(START) is word.at_start
    assert text.endswith(END) is word.at_end
    assert Word.parse(text.replace("⊢", "|-").replace("⊣", "-|")) == word


@pytest.mark.parametrize(
    "text", ["", "⊢", "⊢ ⊣", "A ⊢", "⊣ A", "A ⊣ B", "⊢ ⊢ A", "{A", "{}", "A/B", "A | B", "A ⊣ ⊣"]
)
def test_what_is_no_word(text: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        Word.parse(text)


@given(sets(NAMES).map(Extent) | st.builds(Extent, st.none(), PATHS, WORDS))
def test_extents_read_back(extent: Extent) -> None:
    assert Extent.parse(str(extent)) == extent


LETTERS = st.sampled_from("ABC")


@given(
    st.lists(st.lists(LETTERS, min_size=1, max_size=2), min_size=1, max_size=3),
    st.booleans(),
    st.booleans(),
    st.lists(LETTERS, max_size=8),
)
def test_occurrences_are_the_runs_that_match(
    spelled: list[list[str]], at_start: bool, at_end: bool, arrangement: list[str]
) -> None:
    source = Region("F", 3.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0, labels=(f"L{s}",)) for s in "ABC"))
    found = set(
        occurrences(Word(tuple(map(RegionSet.union, spelled)), at_start, at_end), source, tuple(arrangement))
    )
    labelled = Word(tuple(RegionSet.union(f"@L{s}" for s in some) for some in spelled), at_start, at_end)
    assert set(occurrences(labelled, source, tuple(arrangement))) == found
    size = len(spelled)
    for start in range(len(arrangement) + 1):
        inside = start + size <= len(arrangement)
        fits = inside and all(arrangement[start + i] in some for i, some in enumerate(spelled))
        tied = (not at_start or start == 0) and (not at_end or start + size == len(arrangement))
        assert ((start, start + size) in found) is (fits and tied)
