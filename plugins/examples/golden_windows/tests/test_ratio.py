"""The promises of every constraint kind, and what is this one's own."""

from __future__ import annotations

from dataclasses import replace

import pytest
from golden_windows.ratio import GOLDEN, Ratio

from layoutkit.documents import read
from layoutkit.hooks.host import Host
from layoutkit.model import Facade, Layout, Measure, RegionSet
from layoutkit.samples import sample_path
from layoutkit.testing import ConstraintSuite


class TestRatio(ConstraintSuite):
    kind = Ratio
    elements = [
        '<golden:ratio of="@Window"/>',
        '<golden:ratio of="@Door" ratio="1.2" tolerance="10%"/>',
        '<golden:ratio of="@Wall" ratio="3" tolerance="0.5" weight="2"/>',
    ]


@pytest.fixture(scope="module")
def plain() -> Facade:
    """Return a house with twenty windows, none of them golden."""
    facade = read(sample_path("plain"), Host.load().constraints).model
    assert isinstance(facade, Facade)
    return facade


def vary(facade: Facade, *more: Ratio, **options: object) -> list[Layout | str]:
    """Return layouts with further constraints, or why there is none."""
    stage = Host.load().stages.find("relayout")
    whole = replace(facade, constraints=(*facade.constraints, *more))
    outcomes = stage.run(whole, replace(stage.options(), **options))
    return [o.document if isinstance(o.document, Layout) else o.status for o in outcomes]


def test_windows_become_golden_within_the_tolerance(plain: Facade) -> None:
    golden = Ratio(of=RegionSet.parse("@Window"), ratio=1.3, tolerance=Measure(0.01, True))
    for layout in vary(plain, golden, count=3, seed=1):
        assert isinstance(layout, Layout)
        assert layout.violations() == ()
        windows = [r for floor in layout.root.children for bay in floor.children for r in bay.children]
        ratios = [r.height / r.width for r in windows if "Window" in r.labels]
        assert ratios
        assert all(1.3 * 0.99 - 1e-5 <= ratio <= 1.3 * 1.01 + 1e-5 for ratio in ratios)


def test_what_the_sizes_do_not_allow_is_refused_with_a_proof(plain: Facade) -> None:
    assert vary(plain, Ratio(of=RegionSet.parse("@Window"), ratio=3.0), count=1) == ["infeasible"]


def test_a_soft_one_gives_way(plain: Facade) -> None:
    (layout,) = vary(plain, Ratio(of=RegionSet.parse("@Window"), ratio=3.0, weight=1.0), count=1)
    assert isinstance(layout, Layout)


@pytest.mark.parametrize("text", ["0", "-1", "nan", "wide", "1e999"])
def test_a_ratio_is_a_number_above_0(text: str) -> None:
    (ratio,) = (a for a in Ratio.attributes() if a.name == "ratio")
    with pytest.raises(ValueError, match="is not a finite number above 0"):
        ratio.type.parse(text)


def test_without_attributes_the_ratio_is_the_golden_one() -> None:
    assert Ratio(of=RegionSet.parse("@Window")).ends == (GOLDEN, GOLDEN)
