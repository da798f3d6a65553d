"""The hierarchy read off boxes: grids are found again, symbols are shared, and few things are cut."""

from __future__ import annotations

from pathlib import Path

import pytest
from annotated import WHOLE, agreement, check_exact, composites, converted, grid

from layoutkit.model import Facade, Region

BAND = ("molding", 0.0, 0.48, 1.0, 0.52)


def floors(facade: Facade) -> list[Region]:
    return composites(facade, "Floor")


@pytest.mark.parametrize("sill", [False, True])
@pytest.mark.parametrize(("columns", "rows"), [(3, 2), (5, 4), (8, 3)])
def test_a_grid_is_found_exactly(tmp_path: Path, columns: int, rows: int, sill: bool) -> None:
    boxes = grid(columns, rows, sill=sill)
    facade = converted(tmp_path, boxes)
    assert agreement(facade, boxes) > 0.99  # edges at half a pixel may be painted either way
    (floor,) = floors(facade)
    assert facade.root.word.count(floor.symbol) == rows
    assert floor.word == ("Pier", *["Bay", "Pier2"] * (columns - 1), "Bay", "Pier")
    check_exact(facade)


@pytest.mark.parametrize("seed", range(4))
def test_jitter_is_evened_out(tmp_path: Path, seed: int) -> None:
    boxes = grid(5, 4, jitter=0.004, seed=seed)
    facade = converted(tmp_path, boxes)
    assert agreement(facade, boxes) > 0.96
    words = {floor.word for floor in floors(facade)}
    assert len(words) == 1
    assert words.pop().count("Bay") == 5
    windows = {(r.width) for r in facade.regions.values() if "Window" in r.labels and r.terminal}
    assert len(windows) <= len(floors(facade))
    check_exact(facade)


def test_bands_are_rows_that_repeat(tmp_path: Path) -> None:
    facade = converted(tmp_path, [*grid(4, 2), BAND])
    molding = next(child for child in facade.root.children if "Molding" in child.labels)
    assert molding.terminal
    assert molding.fill == "repeat"
    assert molding.height == pytest.approx(0.04 * 800)


def test_a_wide_balcony_is_cut_at_the_strips(tmp_path: Path) -> None:
    facade = converted(tmp_path, [*grid(5, 2), ("balcony", 0.22, 0.64, 0.78, 0.74)])
    word = floors(facade)[0].word
    assert len(word) == 11
    lower = next(f for f in floors(facade) if any("Balcony" in str(child) for child in f.children))
    assert sum(child.labels[-1:] == ("Bay",) for child in lower.children) == 5


def test_a_missing_window_leaves_wall_in_its_strip(tmp_path: Path) -> None:
    boxes = grid(5, 3)
    facade = converted(tmp_path, boxes[:1] + boxes[2:])
    words = {floor.word for floor in floors(facade)}
    assert len(words) == 1
    first = words.pop()[1]
    walls = [c for f in floors(facade) for c in f.children if c.symbol == first and c.terminal]
    assert {"Wall", "Bay"} in [set(c.labels) for c in walls]


def test_floors_of_another_rhythm_have_strips_of_their_own(tmp_path: Path) -> None:
    upper = [(n, x0, y0 / 2, x1, y1 / 2) for n, x0, y0, x1, y1 in grid(6, 2)[1:]]
    shops = [("shop", 0.05, 0.7, 0.4, 0.95), ("door", 0.45, 0.7, 0.55, 0.95), ("shop", 0.6, 0.7, 0.95, 0.95)]
    facade = converted(tmp_path, [WHOLE, *upper, *shops])
    ground = next(f for f in floors(facade) if f.symbol == "Ground")
    above = [f for f in floors(facade) if f.symbol != "Ground"]
    assert "DoorBay" in ground.word
    assert all(f.word.count("Bay") == 6 for f in above)


def test_pillars_are_strips(tmp_path: Path) -> None:
    pillars = [("pillar", x - 0.01, 0.05, x + 0.01, 0.95) for x in (0.25, 0.5, 0.75)]
    boxes = [*grid(4, 2), *pillars]
    facade = converted(tmp_path, boxes)
    assert agreement(facade, boxes) > 0.98
    assert any(word.count("PillarBay") == 3 for word in (f.word for f in floors(facade)))


def test_windows_under_one_hood_are_one_bay(tmp_path: Path) -> None:
    pairs = [WHOLE]
    for x in (0.1, 0.4, 0.7):
        pairs += [("window", x, 0.4, x + 0.08, 0.7), ("window", x + 0.1, 0.4, x + 0.18, 0.7)]
        pairs.append(("cornice", x, 0.34, x + 0.18, 0.4))
    facade = converted(tmp_path, pairs)
    assert agreement(facade, pairs) == 1.0
    (floor,) = floors(facade)
    assert floor.word == ("Pier", "Bay", "Pier2", "Bay", "Pier2", "Bay", "Pier2")


def test_buildings_side_by_side(tmp_path: Path) -> None:
    left = [("facade", 0.0, 0.0, 0.5, 1.0)]
    left += [(n, x0 / 2, y0, x1 / 2, y1) for n, x0, y0, x1, y1 in grid(3, 4)[1:]]
    right = [("facade", 0.5, 0.1, 1.0, 1.0)]
    for name, x0, y0, x1, y1 in grid(4, 3)[1:]:
        right.append((name, 0.5 + x0 / 2, 0.1 + 0.9 * y0, 0.5 + x1 / 2, 0.1 + 0.9 * y1))
    facade = converted(tmp_path, [*left, *right])
    assert facade.root.split == "columns"
    assert facade.root.word == ("Building", "Building2")
    assert agreement(facade, [*left, *right]) > 0.99


def test_what_no_cut_can_part_is_approximated(tmp_path: Path) -> None:
    pinwheel = [
        WHOLE,
        ("window", 0.1, 0.1, 0.6, 0.4),
        ("door", 0.6, 0.1, 0.9, 0.6),
        ("shop", 0.4, 0.6, 0.9, 0.9),
        ("balcony", 0.1, 0.4, 0.4, 0.9),
        ("deco", 0.4, 0.4, 0.6, 0.6),
    ]
    facade = converted(tmp_path, pinwheel)
    check_exact(facade)
    assert agreement(facade, pinwheel) > 0.95


def test_a_bare_wall_is_one_region(tmp_path: Path) -> None:
    facade = converted(tmp_path, [WHOLE])
    assert facade.root.terminal
    assert facade.root.labels == ("Wall", "Facade")


def test_hidden_boxes_leave_no_trace(tmp_path: Path) -> None:
    facade = converted(tmp_path, [*grid(3, 2), ("sill", 0.12, 0.2, 0.2, 0.3)])
    assert facade.root == converted(tmp_path, grid(3, 2)).root
