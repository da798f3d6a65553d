"""The garden and the carpet: what their variations keep, and that they vary."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import pytest

from facades.painting.knots import INDIGO, MADDER, Quarter
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Box, Facade, Layout, Measure, PlacedRegion, place
from layoutkit.samples import sample_path
from layoutkit_relayout.stage import Relayout, RelayoutOptions

KINDS = {kind.kind: kind for kind in BUILT_IN}
SIZES = [(0.6, 1.0), (1.4, 1.0), (2.0, 1.3), (1.0, 0.6), (0.8, 2.0)]


def variations(name: str, width: float, height: float, count: int = 4) -> list[Layout]:
    source = read(sample_path(name), KINDS).model
    assert isinstance(source, Facade)
    options = RelayoutOptions(count=count, width=Measure(width, True), height=Measure(height, True))
    found = [outcome.document for outcome in Relayout().run(source, options)]
    assert all(isinstance(layout, Layout) for layout in found)
    return [layout for layout in found if isinstance(layout, Layout)]


def named(layout: Layout, symbol_path: str) -> list[PlacedRegion]:
    return [placed for placed in place(layout.root) if placed.symbol_path == symbol_path]


def mirrored(layout: Layout, axis: int, pairs: dict[str, str]) -> bool:
    """Tell whether the layout's terminals, turned over at its middle, lie on terminals of their kind."""
    width, height = layout.root.width, layout.root.height
    own: defaultdict[str, list[Box]] = defaultdict(list)
    turned: defaultdict[str, list[Box]] = defaultdict(list)
    for placed in place(layout.root):
        if placed.region.terminal:
            x0, y0, x1, y1 = placed.box
            path = "/".join(pairs.get(symbol, symbol) for symbol in placed.symbol_path.split("/"))
            own[placed.symbol_path].append(placed.box)
            turned[path].append(
                Box(width - x1, y0, width - x0, y1) if axis == 0 else Box(x0, height - y1, x1, height - y0)
            )
    return own.keys() == turned.keys() and all(matched(own[path], turned[path], width) for path in own)


def matched(own: list[Box], turned: list[Box], size: float) -> bool:
    """Tell whether each box of one list has its own in the other, up to the tolerance of layouts."""
    apart = np.abs(np.array(own)[:, None] - np.array(turned)[None, :]).max(axis=2)
    partners = apart.argmin(axis=1)
    return len(set(partners)) == len(turned) and bool((apart.min(axis=1) < 1e-5 * size).all())


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_a_garden_has_one_tomb_one_great_gate_and_its_entries_on_alleys(width: float, height: float) -> None:
    for layout in variations("garden", width, height):
        middle = layout.root.width / 2
        for path in ("Charbagh/Terrace/Mausoleum", "Charbagh/Gates/Gate", "Charbagh/Garden/Cross/Canal"):
            (only,) = named(layout, path)
            assert (only.box.x0 + only.box.x1) / 2 == pytest.approx(middle)
        entries = named(layout, "Charbagh/Gates/Postern")
        assert len(entries) >= 2
        for entry in entries:
            centre = (entry.box.x0 + entry.box.x1) / 2
            for alley in named(layout, "Charbagh/Garden/Cross/Path"):
                if min(entry.box.x1, alley.box.x1) - max(entry.box.x0, alley.box.x0) > 1e-4:
                    assert (alley.box.x0 + alley.box.x1) / 2 == pytest.approx(centre, abs=1e-3)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_canals_of_a_garden_meet(width: float, height: float) -> None:
    """Every row of the garden has its canals, channels and alleys at the same places as the row above it."""
    for layout in variations("garden", width, height):
        (garden,) = named(layout, "Charbagh/Garden")
        words = {row.word for row in garden.region.children}
        edges = {tuple(round(child.width, 4) for child in row.children) for row in garden.region.children}
        assert len(words) == len(edges) == 1
        assert [row.symbol for row in garden.region.children].count("Cross") == 1


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_a_garden_mirrors_itself_from_west_to_east(width: float, height: float) -> None:
    for layout in variations("garden", width, height):
        assert mirrored(layout, 0, {"Mosque": "Jawab", "Jawab": "Mosque"})


def test_gardens_differ_in_number_and_style_of_plots() -> None:
    layouts = variations("garden", 1.4, 1.0, count=8)
    rows = {named(layout, "Charbagh/Garden")[0].region.word for layout in layouts}
    columns = {named(layout, "Charbagh/Garden/Cross")[0].region.word for layout in layouts}
    plots = {sum("Plot" in p.region.labels for p in place(layout.root)) for layout in layouts}
    terraces = {named(layout, "Charbagh/Terrace")[0].region.word for layout in layouts}
    gates = {named(layout, "Charbagh/Gates")[0].region.word for layout in layouts}
    assert min(len(rows), len(columns), len(plots), len(terraces), len(gates)) >= 4


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_a_carpet_mirrors_itself_both_ways_round_one_medallion(width: float, height: float) -> None:
    for layout in variations("carpet", width, height):
        assert mirrored(layout, 0, {})
        assert mirrored(layout, 1, {"Upper": "Lower", "Lower": "Upper"})
        assert sum("Medallion" in p.region.labels for p in place(layout.root)) == 1
        assert sum("Corner" in p.region.labels for p in place(layout.root)) == 4


def test_carpets_differ_in_field_and_border() -> None:
    layouts = variations("carpet", 1.4, 1.0, count=8)
    for end in ("Field", "Field/First", "Border/Head", "Belt/Side"):
        words = {
            next(p.region.word for p in place(layout.root) if p.symbol_path.endswith(end))
            for layout in layouts
        }
        assert len(words) >= 4, end


def test_a_chart_is_its_quarter_mirrored_to_all_sides() -> None:
    quarter = Quarter(7, 5, INDIGO)
    quarter.dots([(2, 1), (0, 2)], MADDER)
    whole = np.asarray(quarter.whole())
    assert whole.shape == (5, 7, 3)
    assert np.array_equal(whole, whole[::-1])
    assert np.array_equal(whole, whole[:, ::-1])
    assert [tuple(map(int, at)) for at in np.argwhere((whole == MADDER).all(axis=2))] == [
        (0, 3), (1, 1), (1, 5), (3, 1), (3, 5), (4, 3),
    ]  # fmt: skip
