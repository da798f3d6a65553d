"""Placed regions: they tile, their paths are unique, and facades find them; measures read back."""

from __future__ import annotations

import math
from collections import Counter
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Facade, Measure, PlacedRegion, Region, RegionSet, place
from layoutkit.model.measure import format_number
from layoutkit.model.region import TILING_TOLERANCE

POSITIVE = st.floats(0, 1e300, allow_infinity=False, allow_nan=False)


@st.composite
def trees(draw: st.DrawFn, width: float = 12.0, height: float = 9.0, depth: int = 3) -> Region:
    """A region whose children share it by random weights."""
    symbol = draw(st.sampled_from("ABC"))
    labels = tuple(draw(st.sets(st.sampled_from(["L", "M"]))))
    split = draw(st.sampled_from(("columns", "rows", None))) if depth else None
    if split is None:
        return Region(symbol, width, height, labels=labels)
    weights = draw(st.lists(st.floats(0.1, 10), min_size=1, max_size=4))
    shares = [w / sum(weights) for w in weights]
    children = tuple(
        draw(
            trees(width * s, height, depth - 1) if split == "columns" else trees(width, height * s, depth - 1)
        )
        for s in shares
    )
    return Region(symbol, width, height, split, children, labels)


@given(trees())
def test_children_tile_their_parent(root: Region) -> None:
    placed = list(place(root))
    assert placed[0].box == (0.0, 0.0, root.width, root.height)
    for parent in placed:
        inside = [p for p in placed if p.path.rpartition("/")[0] == parent.path]
        assert len(inside) == len(parent.region.children)
        if not inside:
            continue
        box, columns = parent.box, parent.region.split == "columns"
        ends = [(p.box.x0, p.box.x1) if columns else (-p.box.y1, -p.box.y0) for p in inside]
        assert [b for _, b in ends[:-1]] == [a for a, _ in ends[1:]], "neighbours share their line exactly"
        assert (ends[0][0], ends[-1][1]) == ((box.x0, box.x1) if columns else (-box.y1, -box.y0))
        for child in inside:
            across = (child.box.y0, child.box.y1) if columns else (child.box.x0, child.box.x1)
            assert across == ((box.y0, box.y1) if columns else (box.x0, box.x1))
            tolerance = 4 * TILING_TOLERANCE * 12
            assert math.isclose(child.box.width, child.region.width, abs_tol=tolerance)
            assert math.isclose(child.box.height, child.region.height, abs_tol=tolerance)


@given(trees())
def test_paths_are_unique_numbered_and_in_document_order(root: Region) -> None:
    placed = list(place(root))
    assert len({p.path for p in placed}) == len(placed)
    seen: Counter[tuple[str, str]] = Counter()

    def walk(region: Region, path: str, symbols: str) -> list[tuple[str, str]]:
        found = [(path, symbols)]
        for child in region.children:
            seen[path, child.symbol] += 1
            number = seen[path, child.symbol]
            shown = child.symbol if number == 1 else f"{child.symbol}.{number}"
            found += walk(child, f"{path}/{shown}", f"{symbols}/{child.symbol}")
        return found

    assert [(p.path, p.symbol_path) for p in placed] == walk(root, root.symbol, root.symbol)


@given(trees())
def test_a_facade_finds_every_place_once(root: Region) -> None:
    facade = Facade("f", "m", root)
    every: list[PlacedRegion] = [p for places in facade.places.values() for p in places]
    assert sorted(p.path for p in every) == sorted(p.path for p in place(root))
    assert list(facade.regions) == list(dict.fromkeys(p.symbol_path for p in place(root)))
    assert facade.labels == {label for region in facade.regions.values() for label in region.labels}


@given(trees(), st.sampled_from(["@L", "@M", "@L - @M", "A/B | @M", "@L & @M"]))
def test_selection_is_by_names(root: Region, text: str) -> None:
    facade, regions = Facade("f", "m", root), RegionSet.parse(text)
    expected = [
        path
        for path, region in facade.regions.items()
        if regions.contains(frozenset({path, *(f"@{label}" for label in region.labels)}))
    ]
    assert list(facade.select(regions)) == expected
    for path, region in facade.regions.items():
        if region.children:
            inside = facade.select(RegionSet(region.children[0].symbol), path)
            assert inside == (f"{path}/{region.children[0].symbol}",)
            assert set(facade.select(regions, path)) <= {p for p in expected if p.startswith(f"{path}/")}


@given(POSITIVE)
def test_numbers_read_back(value: float) -> None:
    text = format_number(value)
    assert float(text) == value
    assert not text.endswith(".0")


@given(POSITIVE, st.booleans())
def test_measures_read_back(value: float, relative: bool) -> None:
    measure = Measure(value, relative)
    assert Measure.parse(str(measure)) == measure


@given(st.integers(0, 10**6), st.integers(0, 6))
def test_a_percentage_is_the_float_nearest_to_its_share(digits: int, places: int) -> None:
    text = str(Fraction(digits, 1)) if not places else f"{digits / 10**places:.{places}f}"
    expected = float(Fraction(text) / 100)
    assert Measure.parse(f" {text} % ") == Measure(expected, True)
    assert Measure.parse(f"{text}%").of(2.0) == expected * 2


@pytest.mark.parametrize(
    "text", ["", "%", "nan", "inf", "nan%", "inf%", "-1", "-1%", "1m", "1 2", "1e", "1e999", "1e999%", "%1"]
)
def test_what_is_no_measure(text: str) -> None:
    with pytest.raises(ValueError, match="is not a finite number of at least 0"):
        Measure.parse(text)
