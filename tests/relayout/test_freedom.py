"""Three levels of freedom: three clearly different models of one facade (Bao et al. 2013, Fig. 14)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest
from variety import Variety, loose_edges, variety

from layoutkit.constraints import BUILT_IN
from layoutkit.constraints.expansion import sequences_of
from layoutkit.documents import read
from layoutkit.model import Facade, Layout, Measure, place
from layoutkit_formats.cmp import CmpFormat
from layoutkit_relayout.inference.freedom import LEVELS, Level
from layoutkit_relayout.inference.stage import inferred
from layoutkit_relayout.sampling.distances import edit_distance
from layoutkit_relayout.stage import Relayout, RelayoutOptions

ROOT = Path(__file__).parents[2]
CMP = ROOT.parent / "shared" / "data" / "cmp"
KINDS = {kind.kind: kind for kind in BUILT_IN}
DESIGNS = ("plain", "arcade", "townhouse")
#: Plain grids, balconies, many unlike windows.
REAL = ("b0012", "b0033", "b0042", "b0048")
SIZES = ((1.0, 1.0), (1.3, 1.0), (2.0, 1.0))
COUNT = 4
ORDER: tuple[Level, ...] = ("strict", "medium", "loose")


def facade_of(name: str) -> Facade:
    """A design without its own constraints, or a real facade."""
    if name in DESIGNS:
        found = read(ROOT / "facades" / name / "facade.xml", KINDS).model
        assert isinstance(found, Facade)
        return replace(found, constraints=())
    if not CMP.is_dir():
        pytest.skip("the CMP facades are not beside the project")
    return CmpFormat().read(CMP / f"cmp_{name}.xml", CMP / f"cmp_{name}.jpg")[0]


def variations(facade: Facade) -> list[Layout]:
    found = []
    for width, height in SIZES:
        options = RelayoutOptions(COUNT, 0, Measure(width, relative=True), Measure(height, relative=True))
        outcomes = list(Relayout().run(facade, options))
        assert [outcome.status for outcome in outcomes] == ["found"] * COUNT, (width, height)
        found += [outcome.document for outcome in outcomes if isinstance(outcome.document, Layout)]
    return found


@cache
def varieties(name: str) -> dict[Level, Variety]:
    facade = facade_of(name)
    levels = {level: replace(facade, constraints=inferred(facade, LEVELS[level])) for level in ORDER}
    open_paths = sequences_of(levels["loose"]).keys()
    return {level: variety(facade, variations(levels[level]), open_paths) for level in ORDER}


@pytest.mark.parametrize("name", [*DESIGNS, *REAL])
def test_each_level_varies_more_than_the_stricter_one(name: str) -> None:
    found = varieties(name)
    for less, more in pairwise(ORDER):
        assert found[less].words < found[more].words
    assert 1.5 * max(found["strict"].stretch, found["medium"].stretch) < found["loose"].stretch


@pytest.mark.parametrize("name", [*DESIGNS, *REAL])
def test_strict_stays_near_the_input(name: str) -> None:
    found = varieties(name)
    assert found["strict"].edits < min(found["medium"].edits, found["loose"].edits)
    assert found["strict"].words * 2 < found["loose"].words


@pytest.mark.parametrize("name", [*DESIGNS, *REAL])
def test_windows_stand_in_line_as_in_the_input_but_for_loose(name: str) -> None:
    facade, found = facade_of(name), varieties(name)
    windows = [p for p in place(facade.root) if "Window" in p.region.labels]
    own = loose_edges(windows, 1e-4 * facade.root.width)
    for level in ("strict", "medium"):
        assert found[level].loose_edges <= own + 0.05, level
    assert found["loose"].loose_edges > found["medium"].loose_edges + 0.1


@pytest.mark.parametrize(
    ("one", "other", "steps"), [("", "", 0), ("ABA", "ABBA", 1), ("AB", "BA", 2), ("A", "", 1)]
)
def test_edit_distances(one: str, other: str, steps: int) -> None:
    assert edit_distance(tuple(one), tuple(other)) == edit_distance(tuple(other), tuple(one)) == steps
