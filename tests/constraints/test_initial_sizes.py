"""Initial sizes: the distributions that variations draw from, and biased ones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from houses import house
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import Size
from layoutkit.model import Measure, RegionSet
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import Target


def target(**attributes: object) -> Target:
    """Return what sizing is told to draw a pier from, which is 1 m wide in the input."""
    constraint = Size(of=RegionSet("H/F/P"), **attributes)  # type: ignore[arg-type]
    assert list(constraint.faults(house(constraint))) == []
    facade = house(constraint)
    words = {path: region.word for path, region in facade.regions.items() if region.split}
    (found,) = [r for r in constraint.size_rules(Arrangement(facade, words)) if isinstance(r, Target)]
    return found


def test_normal_by_default() -> None:
    found = target(min=Measure(0.5), max=Measure(2.0))
    assert (found.distribution, found.centre, found.deviation) == ("normal", 1.0, 0.05)


@pytest.mark.parametrize(
    ("bias", "centre"), [(0.0, 1.0), (1.0, 2.0), (-1.0, 0.5), (0.5, 1.5), (-0.5, 0.75), (0.25, 1.25)]
)
@pytest.mark.parametrize("distribution", ["normal", "triangular"])
def test_bias_moves_the_centre_towards_an_end(distribution: str, bias: float, centre: float) -> None:
    found = target(min=Measure(0.5), max=Measure(2.0), bias=bias, distribution=distribution)
    assert found.centre == pytest.approx(centre)


def test_bias_starts_from_the_centre_given() -> None:
    assert target(max=Measure(2.0), centre=Measure(1.6), bias=0.5).centre == pytest.approx(1.8)


@given(
    st.floats(0.1, 1.0), st.floats(1.0, 3.0), st.floats(0.05, 3.0), st.sampled_from(["uniform", "triangular"])
)
def test_deviations_are_those_of_the_distribution(
    least: float, most: float, centre: float, distribution: str
) -> None:
    """They say how hard a drawn size pulls, and how far sizes may be from comfortable ones."""
    found = target(min=Measure(least), max=Measure(most), centre=Measure(centre), distribution=distribution)
    assert (found.distribution, found.least, found.most) == (distribution, least, most)
    shares = np.linspace(0.0, 1.0, 20_001)
    if distribution == "uniform":
        sizes = least + shares * (most - least)
        assert found.centre == pytest.approx((least + most) / 2)
    else:
        assert least <= found.centre <= most
        rising = (found.centre - least) / (most - least) if most > least else 1.0
        below = least + np.sqrt(shares * rising) * (most - least)
        above = most - np.sqrt((1 - shares) * (1 - rising)) * (most - least)
        sizes = np.where(shares <= rising, below, above)
    assert found.deviation == pytest.approx(float(np.std(sizes)), rel=2e-3, abs=1e-9)


def test_a_range_without_width_leaves_no_deviation() -> None:
    for distribution in ("uniform", "triangular"):
        found = target(min=Measure(1.5), max=Measure(1.5), distribution=distribution)
        assert (found.centre, found.deviation) == (1.5, 0.0)
        assert math.isfinite(found.centre)
