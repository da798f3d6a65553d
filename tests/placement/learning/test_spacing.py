"""Placements that are filled with shapes of one size: how many, what makes no sense, and what is said."""

from __future__ import annotations

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from placement.learning.test_learner import ASKED, SHOWN, wall
from placement.learning.test_learning_degenerate import model

from layoutkit.diagnostics import Faulty, Severity
from layoutkit.model.learning import Spacing
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.spacing import MOST, check, fill, remarks
from layoutkit_placement.stages.place import Place, PlaceOptions

SHELF = Placement(1, 2, 3, 0.5, 30, "Shelf", 0.9)

_SIZES = st.one_of(st.none(), st.floats(1e-12, 10))


def told(faulty: Faulty) -> str:
    (diagnostic,) = faulty.diagnostics
    assert diagnostic.code == "LK872"
    return f"{diagnostic.message}; {diagnostic.hint}"


@pytest.mark.parametrize(
    ("spacing", "reason"),
    [
        (Spacing(each_width=0), "each-width is 0"),
        (Spacing(each_height=-1), "each-height is -1"),
        (Spacing(each_width=math.nan), "each-width is nan"),
        (Spacing(each_width=1, gap_across=math.inf), "gap-across is inf"),
        (Spacing(gap_across=3), "gap-across is of no use without each-width"),
        (Spacing(each_width=1, gap_up=3), "gap-up is of no use without each-height"),
    ],
)
def test_what_makes_no_sense_is_refused(spacing: Spacing, reason: str) -> None:
    with pytest.raises(Faulty) as raised:
        check(spacing)
    assert reason in told(raised.value)


@given(_SIZES, _SIZES, st.floats(0, 2), st.floats(0, 2), st.integers(1, 30))
def test_there_are_never_too_many_and_the_hint_would_do(
    width: float | None, height: float | None, across: float, up: float, count: int
) -> None:
    spacing = Spacing(width, height, across if width else 0.0, up if height else 0.0)
    check(spacing)
    try:
        assert len(fill([SHELF] * count, spacing)) <= MOST
    except Faulty as faulty:
        sizes = {name: float(size) for name, size in re.findall(r"each-(\w+) (\S+)", told(faulty))}
        assert sizes
        width, height = sizes.get("width", width), sizes.get("height", height)
        mended = Spacing(width, height, spacing.gap_across, spacing.gap_up)
        assert 1 <= len(fill([SHELF] * count, mended)) <= MOST


def test_infinitely_many_are_refused() -> None:
    with pytest.raises(Faulty) as raised:
        fill([SHELF], Spacing(each_width=5e-324))
    assert "with each-width 0.000303" in told(raised.value)


def test_a_size_larger_than_all_is_told() -> None:
    (note,) = remarks([SHELF], Spacing(each_width=100, each_height=0.1))
    assert (note.code, note.severity) == ("LK877", Severity.NOTE)
    assert "each-width is 100, and no placement's width is more than 3" in note.message
    assert fill([SHELF], Spacing(each_width=100)) == (SHELF,)
    assert list(remarks([], Spacing(each_width=100))) == []


def test_evidence_is_of_what_was_scored_and_not_of_the_pieces() -> None:
    asked, own = wall("asked", 12, ASKED), model(wall("shown", 11, SHOWN, True))
    options = PlaceOptions(model=own, limit=2, evidence=True, spacing=Spacing(each_width=0.2))
    [outcome] = Place().run(asked, options)
    assert isinstance(outcome.document, Scene)
    assert outcome.evidence is not None
    scored = outcome.evidence.placements
    assert len(scored) == len(outcome.evidence.contributions) == 2
    assert len(outcome.document.placements) > 6
    assert all(piece.width == 0.2 for piece in outcome.document.placements)
    for placement, adds in zip(scored, outcome.evidence.contributions, strict=True):
        assert placement.width > 0.5
        assert sum(adds.values()) == pytest.approx(placement.score)


def test_a_limit_below_one_is_refused() -> None:
    asked, own = wall("asked", 12, ASKED), model(wall("shown", 11, SHOWN, True))
    with pytest.raises(Faulty) as raised:
        list(Place().run(asked, PlaceOptions(model=own, limit=0)))
    assert "the limit is 0" in told(raised.value)
