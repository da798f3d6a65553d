"""What users are told of grids."""

from __future__ import annotations

from layoutkit.model import Box, PlacedRegion, Region
from layoutkit.model.grid_traits import phantoms, regular, summary


def element(
    x: float, y: float, width: float = 1.0, height: float = 2.0, label: str = "Window"
) -> PlacedRegion:
    region = Region("W", width, height, labels=(label,))
    return PlacedRegion("F/W", "F/W", region, Box(x, y, x + width, y + height))


EVEN = [[element(2.0 * x, 3.0 * y) for x in range(4)] for y in (2, 1, 0)]


def test_like_elements_evenly_spaced_are_regular() -> None:
    assert regular(EVEN)
    assert regular([row[:1] for row in EVEN])
    assert regular([EVEN[0][:2]])
    assert (phantoms(EVEN), summary(EVEN)) == (0, "3 rows × 4 columns")


def test_hand_drawn_edges_do_not_matter() -> None:
    near = element(2.05, 6.02, width=0.93, height=2.1)
    assert regular([[EVEN[0][0], near, *EVEN[0][2:]], *EVEN[1:]])


def test_what_is_not_regular() -> None:
    assert not regular([[*EVEN[0][:3], None], *EVEN[1:]])
    assert not regular([[*EVEN[0][:3], element(6.0, 6.0, label="Door")], *EVEN[1:]])
    assert not regular([[*EVEN[0][:3], element(6.0, 6.0, width=1.3)], *EVEN[1:]])
    assert not regular([[row[0], row[1], row[3]] for row in EVEN])
    assert not regular([EVEN[0], *([element(2.0 * x, y) for x in range(4)] for y in (2.5, 0.0))])


def test_phantoms_are_counted() -> None:
    missing = [[EVEN[0][0], None], [None, EVEN[1][1]]]
    assert (phantoms(missing), summary(missing)) == (2, "2 rows × 2 columns, 2 phantoms")
    assert summary([[EVEN[0][0]], [None]]) == "2 rows × 1 column, 1 phantom"
    assert summary([[EVEN[0][0]]]) == "1 row × 1 column"
