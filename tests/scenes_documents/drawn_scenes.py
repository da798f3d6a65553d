"""Scenes as hypothesis draws them: every polygon sound, every name its own."""

from __future__ import annotations

import math

from hypothesis import strategies as st

from layoutkit.model import Picture, Placement, Polygon, Scene
from layoutkit.model.scene import OwnLabels

NUMBERS = st.floats(-1e6, 1e6, allow_nan=False)
SIZES = st.floats(1e-3, 1e6)
TEXT = st.text(st.characters(codec="utf-8", exclude_categories=("Cs", "Cc", "Cn")), max_size=8)
LABEL = st.sampled_from(("Window", "Door", "_x", "Größe", "A1"))
LABELS = st.lists(LABEL, max_size=3, unique=True).map(tuple)


@st.composite
def polygons(draw: st.DrawFn, name: str) -> Polygon:
    """A star about a centre, in either direction: it never crosses itself."""
    count = draw(st.integers(3, 8))
    x, y = draw(st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4)))
    radii = draw(st.lists(st.floats(0.5, 50), min_size=count, max_size=count))
    points = [
        (x + r * math.cos(k * math.tau / count), y + r * math.sin(k * math.tau / count))
        for k, r in enumerate(radii)
    ]
    if draw(st.booleans()):
        points.reverse()
    angle = draw(st.none() | st.floats(-360, 360))
    return Polygon(name, tuple(points), draw(LABELS), draw(_own(count)), draw(_own(count)), angle)


def _own(count: int) -> st.SearchStrategy[OwnLabels]:
    entry = st.tuples(st.integers(0, count - 1), LABELS)
    return st.lists(entry, max_size=3, unique_by=lambda own: own[0]).map(tuple)


PLACEMENTS = st.builds(
    Placement,
    x=NUMBERS,
    y=NUMBERS,
    width=SIZES,
    height=SIZES,
    angle=st.floats(-720, 720),
    label=st.just("") | LABEL,
    score=st.none() | st.floats(-10, 10),
    mirrored=st.booleans(),
)
PICTURES = st.builds(
    lambda left, top, width, height: Picture("photos/a.jpg", (left, top, left + width, top + height)),
    *(st.floats(0, 1e3), st.floats(0, 1e3), st.floats(1, 1e3), st.floats(1, 1e3)),
)


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    names = draw(st.lists(TEXT.filter(bool), max_size=4, unique=True))
    return Scene(
        draw(TEXT),
        draw(st.sampled_from(("m", "px"))),
        tuple(draw(polygons(name)) for name in names),
        tuple(draw(st.lists(PLACEMENTS, max_size=3))),
        draw(st.none() | PICTURES),
    )
