"""Initial sizes are drawn from the distribution that the document asks for, truncated to its range."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from layoutkit.sizing.rules import Target
from layoutkit_relayout.sizes.draws import Distributions

SIZES = st.floats(0.1, 100.0)


def drawn(target: Target, count: int = 4000) -> np.ndarray:
    generator = np.random.default_rng(7)
    return Distributions([target] * count).draw(generator).sizes


@given(SIZES, SIZES, SIZES, SIZES, st.sampled_from(["normal", "uniform", "triangular"]))
def test_no_size_is_out_of_its_range(a: float, b: float, centre: float, deviation: float, kind: str) -> None:
    least, most = sorted((a, b))
    centre = min(max(centre, least), most) if kind == "triangular" else centre
    sizes = drawn(Target(0, {}, centre, deviation, least, most, 1.0, kind), 50)
    assert np.all((sizes >= least - 1e-9) & (sizes <= most + 1e-9))


@pytest.mark.parametrize(
    ("kind", "law"),
    [
        ("normal", stats.truncnorm(-2.0, 4.0, loc=2.0, scale=0.5)),
        ("uniform", stats.uniform(1.0, 3.0)),
        ("triangular", stats.triang(1 / 3, loc=1.0, scale=3.0)),
    ],
)
def test_sizes_follow_the_law(kind: str, law: stats.rv_continuous) -> None:
    sizes = drawn(Target(0, {}, 2.0, 0.5, 1.0, 4.0, 1.0, kind))
    assert stats.kstest(sizes, law.cdf).pvalue > 0.01


def test_without_deviation_it_is_the_centre() -> None:
    assert set(drawn(Target(0, {}, 2.0, 0.0, 1.0, 4.0), 10)) == {2.0}


def test_far_out_ranges_are_drawn_from_their_near_end() -> None:
    sizes = drawn(Target(0, {}, 1.0, 0.01, 5.0, 6.0), 100)
    assert np.all((sizes >= 5.0) & (sizes < 5.1))
