"""Inferred constraints: the input keeps them, every group says why, and they leave room for variations."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby, pairwise
from pathlib import Path
from typing import get_args

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import Constraint, Replication, Sequence, Size
from layoutkit.constraints.covering import Covering
from layoutkit.constraints.expansion import sequences_of
from layoutkit.constraints.generators import names_of, replication, sequences
from layoutkit.constraints.language import Language, language
from layoutkit.model import Facade, Layout, Measure, Region
from layoutkit_formats.cmp import CmpFormat
from layoutkit_relayout.inference.freedom import Level
from layoutkit_relayout.inference.stage import Infer, InferOptions
from layoutkit_relayout.stage import Relayout, RelayoutOptions

CMP = Path(__file__).parents[3] / "shared" / "data" / "cmp"
LEVELS = get_args(Level)
SIZES = ((0.8, 1.0), (1.0, 1.0), (1.3, 1.0), (2.0, 1.0), (1.0, 1.5))
#: Plain grids, balconies, shops, several buildings.
REAL = ("b0001", "b0012", "b0033", "b0055", "b0246", "b0318")


def bay(symbol: str, opening: str, width: float, height: float) -> Region:
    """A bay: wall, opening, wall, from the top down."""
    heights = (0.2, 0.8, 0.0) if opening == "Door" else (0.2, 0.55, 0.25)
    names = (("top", "Wall"), ("opening", opening), ("below", "Wall"))
    rows = tuple(
        Region(name, width, share * height, labels=(label,))
        for (name, label), share in zip(names, heights, strict=True)
        if share
    )
    return Region(symbol, width, height, "rows", rows, ("Bay",))


def floor(symbol: str, openings: str, height: float) -> Region:
    """A floor: piers, and between them a bay for each letter of `openings`: window, wide window, door."""
    made = {
        "w": bay("W", "Window", 1.1, height),
        "v": bay("V", "Window", 1.7, height),
        "d": bay("D", "Door", 1.3, height),
    }
    children = [Region("E", 0.7, height, labels=("Pier",))]
    for number, opening in enumerate(openings):
        if number:
            children.append(Region("P", 0.5, height, labels=("Pier",)))
        children.append(made[opening])
    children.append(Region("E", 0.7, height, labels=("Pier",)))
    return Region(symbol, sum(c.width for c in children), height, "columns", tuple(children), ("Floor",))


def house(upper: str, ground: str, storeys: int, cornice: bool) -> Facade:
    """Upper floors of one kind over a ground floor as wide."""
    floors = [floor(f"F{number}", upper, 3.0) for number in range(storeys)]
    foot = floor("G", ground, 3.6)
    width = floors[0].width if floors else foot.width
    foot = _stretched(foot, width)
    rows = [Region("C", width, 0.5, labels=("Cornice",))] if cornice else []
    rows += [*floors, foot]
    return Facade("house", "m", Region("H", width, sum(r.height for r in rows), "rows", tuple(rows)))


def _stretched(region: Region, width: float) -> Region:
    """Return a floor whose edge piers are as wide as they must be to fill the width."""
    spare = (width - region.width) / 2
    children = tuple(replace(c, width=c.width + spare) if c.symbol == "E" else c for c in region.children)
    return replace(region, width=width, children=children)


BAYS = st.text("wwv", min_size=2, max_size=7)
HOUSES = st.builds(
    lambda upper, door, storeys, cornice: house(
        upper, upper[: door % len(upper)] + "d" + upper[door % len(upper) + 1 :], storeys, cornice
    ),
    BAYS,
    st.integers(0, 6),
    st.integers(0, 4),
    st.booleans(),
)


def inferred(facade: Facade, freedom: Level) -> Facade:
    (outcome,) = Infer().run(facade, InferOptions(freedom))
    assert outcome.status == "found"
    assert isinstance(outcome.document, Facade)
    return outcome.document


def check(facade: Facade, freedom: Level) -> Facade:
    """Infer constraints, and check what holds for all of them."""
    found = inferred(facade, freedom)
    assert found.constraints[: len(facade.constraints)] == facade.constraints
    assert [str(d) for c in found.constraints for d in c.faults(found)] == []
    broken = Layout("input", facade.units, facade.root, found).violations()
    assert broken == (), [f"{v.path}: {v.message} ({v.constraint})" for v in broken]
    for kind, group in groupby(found.constraints[len(facade.constraints) :], key=_group):
        assert next(group).comment, kind
    return found


def _group(constraint: Constraint) -> tuple[str, object]:
    """Return what a group shares: the kind; and for sequences, which belong together, the regions."""
    together = constraint if isinstance(constraint, Sequence | Replication) else None
    return constraint.kind, together and together.within


def statuses(facade: Facade, width: float, height: float, count: int = 8) -> list[str]:
    options = RelayoutOptions(
        count=count, width=Measure(width, relative=True), height=Measure(height, relative=True)
    )
    return [outcome.status for outcome in Relayout().run(facade, options)]


@settings(max_examples=60)
@given(HOUSES, st.sampled_from(LEVELS))
def test_a_house_keeps_what_is_inferred_from_it(facade: Facade, freedom: Level) -> None:
    check(facade, freedom)


@pytest.mark.parametrize(("width", "height"), SIZES)
@pytest.mark.parametrize(
    "facade",
    [
        house("wwwwww", "wwdwww", 3, True),
        house("wvwvw", "wvdvw", 4, True),
        house("vwwwwv", "vwwdwv", 2, False),
        house("wwww", "wdww", 1, True),
    ],
    ids=["grid", "two-kinds", "wide-ends", "low"],
)
def test_houses_vary_at_every_size(facade: Facade, width: float, height: float) -> None:
    assert statuses(inferred(facade, "medium"), width, height) == ["found"] * 8


def admitted(facade: Facade, path: str) -> Language:
    """Return the arrangements that a region's sequences cover; the input's where it has none."""
    region = facade.regions[path]
    words = sequences_of(facade).get(path, sequences([path], replication(region.word)))
    return language(Covering(tuple(c.piece(region) for c in words)), tuple(names_of(region)))


@settings(max_examples=40)
@given(HOUSES)
def test_each_freedom_leaves_what_the_stricter_one_does(facade: Facade) -> None:
    levels = [inferred(facade, freedom) for freedom in ("strict", "medium", "loose")]
    for path, region in facade.regions.items():
        if region.split:
            words = [admitted(level, path) for level in levels]
            assert all(one.without(other) is None for one, other in pairwise(words)), path
            assert region.word in words[0]
    for one, other in pairwise(levels):
        assert len(bounds(one)) == len(bounds(other))
        for path, (least, most) in bounds(one).items():
            assert bounds(other)[path][0] <= least <= most <= bounds(other)[path][1]


def bounds(facade: Facade) -> dict[str, tuple[float, float]]:
    return {
        path: constraint.bounds(facade, path)
        for constraint in facade.constraints
        if isinstance(constraint, Size)
        for path in facade.select(constraint.of)
    }


def kinds_of(facade: Facade, freedom: Level) -> list[str]:
    return [str(c) for c in inferred(facade, freedom).constraints if c.kind not in ("size", "alignment")]


def test_strict_keeps_the_order_and_the_symmetry() -> None:
    found = kinds_of(house("wwvww", "wwdww", 3, True), "strict")
    floors = "H/F0 H/F1 H/F2"
    assert found == [
        'repetition within="H" pattern="C F0 F1+ F2+ G"',
        f'same-arrangement of="{floors}"',
        f'repetition within="{floors}" pattern="E W+[P+[V]] E"',
        'frequency of="V" within="H/F2" min="1" max="1"',
        f'symmetry of="{floors}"',
        'repetition within="H/G" pattern="E W+[P+[D]] E"',
        'frequency of="D" within="H/G" min="1" max="1"',
        'symmetry of="H/G"',
        'frequency of="@Door" within="H/G" min="1" max="1"',
    ]


def test_strict_repeats_the_longest_run_where_nothing_is_symmetric() -> None:
    found = kinds_of(house("wvwwww", "wdwwww", 1, False), "strict")
    assert 'repetition within="H/F0" pattern="E W P V (P W)+ E"' in found
    assert 'repetition within="H/G" pattern="E W P D (P W)+ E"' in found


def test_loose_puts_bays_in_any_order() -> None:
    facade = house("wvwww", "wvwww", 2, False)
    rows = [
        replace(f, children=(*f.children[:-1], replace(f.children[-1], symbol="R")))
        for f in facade.root.children
    ]
    found = kinds_of(replace(facade, root=replace(facade.root, children=tuple(rows))), "loose")
    floors = "H/F0 H/F1 H/G"
    assert found[-3:] == [
        f'replication within="{floors}" of="⊢ E {{W V}}"',
        f'replication within="{floors}" of="{{W V}} R ⊣"',
        f'two-shuffle within="{floors}" of="{{W V}} P"',
    ]
    assert not [c for c in found if c.startswith("same-arrangement")]


@pytest.mark.skipif(not CMP.is_dir(), reason="the CMP facades are not beside the project")
@pytest.mark.parametrize("name", REAL)
def test_real_facades(name: str) -> None:
    facade, _ = CmpFormat().read(CMP / f"cmp_{name}.xml", CMP / f"cmp_{name}.jpg")
    for freedom in LEVELS:
        check(facade, freedom)
    found = inferred(facade, "medium")
    for width, height in SIZES:
        assert statuses(found, width, height) == ["found"] * 8, (width, height)
