"""Whatever the boxes: the facade tiles exactly, one symbol means one region, and a rerun gives the same."""

from __future__ import annotations

import itertools

from annotated import check_exact
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.model import Facade
from layoutkit_formats.boxes import PAINTING, LabelBox
from layoutkit_formats.facade import Annotation, facade
from layoutkit_formats.hierarchy import Piece, Prices, guillotine

SIZE = 120

COORDINATES = st.floats(0, SIZE, allow_nan=False) | st.integers(0, SIZE).map(float)


@st.composite
def boxes(draw: st.DrawFn) -> LabelBox:
    (x0, x1), (y0, y1) = (sorted(draw(st.tuples(COORDINATES, COORDINATES))) for _ in range(2))
    return LabelBox(draw(st.sampled_from(PAINTING)), x0, y0, x1, y1)


def made(found: list[LabelBox]) -> Facade:
    return facade(Annotation("any", SIZE, SIZE, tuple(found)))


some = st.lists(boxes().filter(lambda b: b.width > 0 and b.height > 0), min_size=1, max_size=14)


@given(some)
@settings(max_examples=150)
def test_any_boxes_tile_exactly(found: list[LabelBox]) -> None:
    check_exact(made(found))


@given(some)
@settings(max_examples=20)
def test_a_rerun_gives_the_same(found: list[LabelBox]) -> None:
    assert made(found) == made(found)


@given(st.lists(boxes(), max_size=8))
def test_free_trees_lose_nothing(found: list[LabelBox]) -> None:
    """Where terminals cost nothing but a trifle, whatever guillotine cuts can show is shown."""
    frame = LabelBox("Wall", 0.0, 0.0, float(SIZE), float(SIZE))
    columns = [b._replace(y0=0.0, y1=float(SIZE)) for b in found if b.width > 0]
    piece = guillotine(columns, frame, Prices(1e-9, 0.0))
    areas: dict[str, float] = {}
    for leaf in leaves(piece):
        areas[leaf.label] = areas.get(leaf.label, 0.0) + leaf.width * leaf.height
    lines = sorted({0.0, float(SIZE), *(v for b in columns for v in (b.x0, b.x1))})
    for x0, x1 in itertools.pairwise(lines):
        top = next((b.label for b in reversed(columns) if b.x0 <= x0 and x1 <= b.x1), "Wall")
        areas[top] = areas.get(top, 0.0) - (x1 - x0) * SIZE
    assert all(abs(area) < 1e-6 for area in areas.values())


def leaves(piece: Piece) -> list[Piece]:
    return [leaf for child in piece.children for leaf in leaves(child)] if piece.children else [piece]
