"""The promises of every constraint kind, and what is this one's own."""

from __future__ import annotations

import statistics
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise

import pytest
from even_spacings.even import Even

from layoutkit.documents import read
from layoutkit.hooks.host import Host
from layoutkit.model import Facade, Layout, Measure, RegionSet
from layoutkit.samples import sample_path
from layoutkit.testing import ConstraintSuite


class TestEven(ConstraintSuite):
    kind = Even
    elements = [
        '<spacing:even of="@Shop | @Door | @Window" deviation="0.2"/>',
        '<spacing:even of="@Window | @Bay" deviation="25%"/>',
        '<spacing:even of="@Wall" deviation="0" weight="1"/>',
    ]


@pytest.fixture(scope="module")
def arcade() -> Facade:
    """Return narrow bays and wide ones in free order: the wide ones are seldom evenly spaced by chance."""
    facade = read(sample_path("arcade"), Host.load().constraints).model
    assert isinstance(facade, Facade)
    return facade


def run(facade: Facade, even: Even, **options: object) -> list[Layout | str]:
    """Return layouts with one constraint more, or why there is none."""
    stage = Host.load().stages.find("relayout")
    whole = replace(facade, constraints=(*facade.constraints, even))
    outcomes = stage.run(whole, replace(stage.options(), **options))
    return [o.document if isinstance(o.document, Layout) else o.status for o in outcomes]


def spacings(layout: Layout, floor: str, symbol: str) -> list[float]:
    """Return the distances between the regions of a symbol on a floor."""
    (region,) = {r.symbol: r for r in layout.root.children if r.symbol == floor}.values()
    ends, x = [], 0.0
    for child in region.children:
        if child.symbol == symbol:
            ends.append((x, x + child.width))
        x += child.width
    return [after[0] - before[1] for before, after in pairwise(ends)]


def test_spacings_vary_no_more_than_is_allowed(arcade: Facade) -> None:
    even = Even(of=RegionSet.parse("Facade/Arcade/Loggia"), deviation=Measure(0.05, True))
    for layout in run(arcade, even, count=2, seed=3, width=Measure(1.6, True)):
        assert isinstance(layout, Layout)
        assert layout.violations() == ()
        found = spacings(layout, "Arcade", "Loggia")
        if len(found) > 1:
            assert statistics.pstdev(found) <= 0.05 * statistics.fmean(found) + 1e-4


def test_cvxpy_is_imported_where_it_is_used_and_not_before() -> None:
    program = (
        "import sys; from layoutkit.hooks.host import Host; kinds = Host.load().constraints;"
        "print('spacing:even' in kinds, 'cvxpy' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["True", "False"]
