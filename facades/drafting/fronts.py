"""Fronts of houses, on which flower boxes are put."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from layoutkit.model import Placement, Polygon, Scene

#: Height of a storey, of what is below its windows, and of a flower box.
STOREY, BREAST, BOX = 3.2, 1.0, 0.3
#: How far a flower box reaches beyond its window, at either side.
BEYOND = 0.1

#: Where a window's left side is, how wide it is, and how high.
Window = tuple[float, float, float]


def example() -> Scene:
    """Return a house with two storeys above its shops, and boxes under three of its windows."""
    first: Sequence[Window] = ((1.0, 1.2, 1.6), (3.6, 1.2, 1.6), (6.2, 1.2, 1.6), (8.8, 1.2, 1.6))
    second: Sequence[Window] = ((0.8, 1.6, 1.4), (4.2, 2.6, 1.4), (8.6, 1.6, 1.4))
    polygons = _front(11.0, (first, second))
    boxes = (_box(first[1], 1), _box(first[2], 1), _box(second[1], 2))
    return Scene("flower-boxes", "m", tuple(polygons), boxes)


def target() -> Scene:
    """Return a wider and higher house, with other windows and no boxes."""
    storeys: Sequence[Sequence[Window]] = (
        tuple((0.9 + 2.3 * i, 1.1, 1.9) for i in range(6)),
        ((0.9, 1.1, 1.7), (2.9, 2.2, 1.7), (6.0, 2.4, 1.7), (9.3, 2.2, 1.7), (12.4, 1.1, 1.7)),
        tuple((1.2 + 3.1 * i, 1.5, 1.5) for i in range(4)),
        ((2.0, 0.8, 1.2), (6.6, 1.2, 1.2), (11.6, 0.8, 1.2)),
    )
    return Scene("house", "m", tuple(_front(14.4, storeys)))


def _front(width: float, storeys: Sequence[Sequence[Window]]) -> Iterator[Polygon]:
    """Yield a front: shops with a door between them, then storeys with their windows."""
    height = STOREY * (len(storeys) + 1)
    yield Polygon.rectangle("House", 0.0, 0.0, width, height, ("Facade",))
    yield Polygon.rectangle("Ground", 0.0, 0.0, width, STOREY, ("Base",))
    middle = round(width / 2, 2)
    yield Polygon.rectangle("Door", middle - 0.6, 0.0, middle + 0.6, 2.4, ("Door",))
    yield Polygon.rectangle("Shop_1", 0.8, 0.6, middle - 1.2, 2.5, ("Shop",))
    yield Polygon.rectangle("Shop_2", middle + 1.2, 0.6, width - 0.8, 2.5, ("Shop",))
    for number, windows in enumerate(storeys, 1):
        floor = round(number * STOREY, 2)
        yield Polygon.rectangle(f"Storey_{number}", 0.0, floor, width, round(floor + STOREY, 2), ("Storey",))
        for position, (left, wide, high) in enumerate(windows, 1):
            x, y = round(left, 2), round(floor + BREAST, 2)
            name = f"Window_{number}_{position}"
            yield Polygon.rectangle(name, x, y, round(x + wide, 2), round(y + high, 2), ("Window",))


def _box(window: Window, storey: int) -> Placement:
    left, wide, _ = window
    y = round(storey * STOREY + BREAST - BOX / 2, 3)
    return Placement(round(left + wide / 2, 3), y, round(wide + 2 * BEYOND, 3), BOX, label="FlowerBox")
