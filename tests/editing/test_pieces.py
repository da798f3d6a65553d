"""Pictures of what reaches across columns and rows: what it shows beside an element stays beside it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from layoutkit.model import Edit, Facade, Grid, Piece, Region, Resize, Split, place
from layoutkit.pictures import Photo, render_png
from layoutkit_editing.editor import Editor

#: Pixels a unit of the photos, and the one with which the pictures of edited facades are looked at.
SCALE = 10
#: Photos are grey; marks are as red as the number of their window says.
GREY, STEP = 90, 30


def across(split: Split, symbol: str, *parts: Region) -> Region:
    """Return a composite region that is divided along y for rows."""
    if split == "columns":
        return Region(symbol, sum(part.width for part in parts), parts[0].height, split, parts)
    return Region(symbol, parts[0].width, sum(part.height for part in parts), split, parts)


def leaf(symbol: str, along: float, beside: float, split: Split, fill: str = "stretch") -> Region:
    size = (along, beside) if split == "columns" else (beside, along)
    return Region(symbol, *size, labels=(symbol,), fill=fill)  # type: ignore[arg-type]


def house(split: Split = "columns", fill: str = "repeat") -> Facade:
    """Two storeys of three windows, a strip above each; turned on its side for rows.

    The windows of the lower storey are in bays, between jambs.
    """
    other: Split = "rows" if split == "columns" else "columns"
    wall, window = leaf("Wall", 2.0, 4.0, split), leaf("Window", 3.0, 4.0, split)
    upper = across(split, "Upper", wall, window, wall, window, wall, window, wall)
    sash = across(
        split, "Sash", *(leaf(s, w, 3.0, split) for s, w in (("L", 1.0), ("Window", 3.0), ("R", 1.0)))
    )
    bay = across(other, "Bay", sash, leaf("Sill", 5.0, 1.0, split))
    end = leaf("End", 1.0, 4.0, split)
    lower = across(split, "Lower", end, bay, bay, bay, end)
    strip = leaf("Strip", 17.0, 1.0, split, fill)
    root = across(other, "House", strip, upper, strip, lower)
    facade = Facade("house", "m", root)
    windows = tuple(p.path for p in place(root) if p.region.symbol == "Window")
    return replace(facade, grids=(Grid("windows", elements=windows),))


def photo(facade: Facade, split: Split) -> Photo:
    """Return a photo in which each strip has a mark, of its own colour, over the middle of each window."""
    pixels = np.full((round(facade.root.height * SCALE), round(facade.root.width * SCALE), 3), GREY, np.uint8)
    turned = pixels if split == "columns" else pixels.transpose(1, 0, 2)
    for strip in (0, 50):
        for number in range(3):
            turned[strip : strip + 10, 30 + 50 * number : 40 + 50 * number, 0] = GREY + STEP * (number + 1)
    return Photo(facade, Image.fromarray(pixels))


def marks(editor: Editor, shown: Photo, split: Split) -> list[list[tuple[float, int]]]:
    """Return middle and number of the marks of each strip, and windows of each storey likewise (number 0)."""
    facade = editor.facade
    pixels = np.asarray(render_png(facade, shown, origins=editor.moment.origins)).astype(int)
    axis = 0 if split == "columns" else 1
    found = []
    for placed in place(facade.root):
        if placed.region.symbol.startswith("Strip"):
            box, height = placed.box, facade.root.height
            middle = ((height - box.y1 + height - box.y0) if axis == 0 else (box.x0 + box.x1)) / 2 * SCALE
            line = pixels[int(middle), :, 0] if axis == 0 else pixels[:, int(middle), 0]
            red = np.flatnonzero(line > GREY + STEP // 2)
            runs = np.split(red, np.flatnonzero(np.diff(red) > 1) + 1)
            found.append([((r[0] + r[-1] + 1) / 2, round((np.median(line[r]) - GREY) / STEP)) for r in runs])
    return found


def windows(editor: Editor, split: Split) -> list[list[float]]:
    """Return the middles of the windows in pixels, storey by storey."""
    facade = editor.facade
    found: dict[str, list[float]] = {}
    for placed in place(facade.root):
        if "Window" in placed.region.labels:
            box, height = placed.box, facade.root.height
            middle = (box.x0 + box.x1) / 2 if split == "columns" else height - (box.y0 + box.y1) / 2
            found.setdefault(placed.path.split("/")[1], []).append(middle * SCALE)
    return list(found.values())


def edit(action: str, split: Split, source: int, at: int | None = None) -> Edit:
    return Edit(action, split, ("windows",), (source,), None if at is None else (at,))  # type: ignore[arg-type]


SPLITS: list[Split] = ["columns", "rows"]


@pytest.mark.parametrize("fill", ["stretch", "repeat"])
@pytest.mark.parametrize("split", SPLITS)
@pytest.mark.parametrize(
    ("action", "source", "at", "order"),
    [
        ("add", 2, 3, [1, 2, 2, 3]),
        ("add", 1, 4, [1, 2, 3, 1]),
        ("add", 3, 1, [3, 1, 2, 3]),
        ("remove", 2, None, [1, 3]),
        ("remove", 3, None, [1, 2]),
    ],
)
def test_every_window_keeps_its_mark(
    action: str, source: int, at: int | None, order: list[int], split: Split, fill: str
) -> None:
    facade = house(split, fill)
    editor = Editor(facade)
    editor.make(edit(action, split, source, at))
    for strip, storey in zip(marks(editor, photo(facade, split), split), windows(editor, split), strict=True):
        assert [number for _, number in strip] == order
        assert [middle for middle, _ in strip] == pytest.approx(storey, abs=2)


def single(editor: Editor) -> bool:
    return all(len(pieces) == 1 for pieces in editor.moment.origins.values())


def test_what_was_not_edited_is_in_one_piece() -> None:
    facade = house()
    editor = Editor(facade)
    boxes = {placed.path: placed.box for placed in place(facade.root) if placed.region.terminal}
    assert editor.moment.origins == {path: (Piece.whole(box),) for path, box in boxes.items()}
    editor.make(edit("add", "columns", 1, 2))
    assert not single(editor)
    editor.undo()
    assert single(editor)


@given(st.floats(12.0, 30.0))
def test_marks_stay_over_their_windows_whatever_the_width(width: float) -> None:
    facade = house()
    editor = Editor(facade)
    editor.make(Resize(width=width))
    for strip, storey in zip(
        marks(editor, photo(facade, "columns"), "columns"), windows(editor, "columns"), strict=True
    ):
        assert [number for _, number in strip] == [1, 2, 3]
        assert [middle for middle, _ in strip] == pytest.approx(storey, abs=2)


def test_the_storey_that_is_stretched_least_is_the_guide() -> None:
    """A band below the strip, stretched as a whole, says nothing of where the windows above it are."""
    facade = house()
    band = across("columns", "Band", leaf("Left", 8.0, 1.0, "columns"), leaf("Right", 9.0, 1.0, "columns"))
    root = facade.root
    children = (*root.children[:3], band, root.children[3])
    facade = replace(facade, root=replace(root, height=root.height + 1.0, children=children))
    editor = Editor(facade)
    editor.make(edit("add", "columns", 2, 3))
    (_, strip) = marks(editor, photo(facade, "columns"), "columns")
    assert [number for _, number in strip] == [1, 2, 2, 3]
    assert [middle for middle, _ in strip] == pytest.approx(windows(editor, "columns")[0], abs=2)
