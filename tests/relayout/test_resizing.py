"""A facade is dragged to other sizes: its words stay, its constraints hold, or what is in the way is told."""

from __future__ import annotations

from itertools import pairwise

import pytest

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Facade, Layout, Region, place
from layoutkit.samples import sample_path
from layoutkit.sizing.solve import Conflict
from layoutkit_relayout.sizes.resizing import Resizer
from layoutkit_relayout.stage import Relayout, RelayoutOptions


@pytest.fixture(scope="module")
def townhouse() -> Facade:
    document = read(sample_path("townhouse"), {kind.kind: kind for kind in BUILT_IN}).model
    assert isinstance(document, Facade)
    return document


def paths(root: Region) -> list[str]:
    return [placed.symbol_path for placed in place(root)]


@pytest.mark.parametrize("share", [0.97, 1.0, 1.03, 1.1])
def test_words_stay_and_constraints_hold_at_other_sizes(townhouse: Facade, share: float) -> None:
    size = (townhouse.root.width * share, townhouse.root.height * share)

    layout = Resizer(townhouse).at(*size)

    assert isinstance(layout, Layout)
    assert (layout.root.width, layout.root.height) == pytest.approx(size)
    assert paths(layout.root) == paths(townhouse.root)
    assert list(layout.violations()) == []


def test_a_variation_is_resized_as_well_as_the_input(townhouse: Facade) -> None:
    (outcome,) = Relayout().run(townhouse, RelayoutOptions(count=1, seed=3))
    assert isinstance(outcome.document, Layout)
    variation = outcome.document.root

    layout = Resizer(townhouse, variation).at(variation.width * 1.05, variation.height)

    assert isinstance(layout, Layout)
    assert paths(layout.root) == paths(variation)
    assert list(layout.violations()) == []


def test_sizes_change_steadily_along_a_drag(townhouse: Facade) -> None:
    resizer = Resizer(townhouse)
    widths = [townhouse.root.width * (1 + step / 1000) for step in range(3)]

    layouts = [resizer.at(width, townhouse.root.height) for width in widths]

    drawn = [[p.box.x0 for p in place(own.root)] for own in layouts if isinstance(own, Layout)]
    assert len(drawn) == 3
    for before, after in pairwise(drawn):
        assert max(abs(a - b) for a, b in zip(before, after, strict=True)) < 0.01 * widths[0]


def test_a_size_with_no_room_is_refused_with_what_is_in_the_way(townhouse: Facade) -> None:
    refused = Resizer(townhouse).at(townhouse.root.width / 20, townhouse.root.height)

    assert isinstance(refused, Conflict)
    assert refused.origins
