"""Annotations that the tests make: CMP files with their pictures, and masks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from PIL import Image

from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Region, place
from layoutkit_formats.boxes import CODES, LabelBox, in_painting_order, painted
from layoutkit_formats.cmp import CmpFormat

#: Class, then left, top, right and bottom as shares of the picture.
Shares = tuple[str, float, float, float, float]

DATA = Path(__file__).parents[3] / "shared" / "data"

WHOLE: Shares = ("facade", 0.0, 0.0, 1.0, 1.0)


def write(folder: Path, boxes: Iterable[Shares], size: tuple[int, int] = (600, 800)) -> Path:
    """Write boxes the way the database does: no root, bare CR, rows in `<x>`; a picture beside them."""
    objects = [
        f"<object>\r<points>\r<x>\r{y0}\r</x>\r<x>\r{y1}\r</x>\r<y>\r{x0}\r</y>\r<y>\r{x1}\r</y>\r</points>\r"
        f"<label>\r2\r</label>\r<labelname>\r{name}\r</labelname>\r</object>\r"
        for name, x0, y0, x1, y1 in boxes
    ]
    file = folder / "house.xml"
    file.write_bytes("".join(objects).encode())
    Image.new("RGB", size).save(folder / "house.jpg")
    return file


def converted(folder: Path, boxes: Iterable[Shares], size: tuple[int, int] = (600, 800)) -> Facade:
    """Return the facade of boxes."""
    return CmpFormat().read(write(folder, boxes, size), None)[0]


def remarks(folder: Path, boxes: Iterable[Shares]) -> Sequence[Diagnostic]:
    """Return what is said of boxes."""
    return CmpFormat().read(write(folder, boxes), None)[1]


def grid(columns: int, rows: int, jitter: float = 0.0, seed: int = 0, sill: bool = False) -> list[Shares]:
    """A wall with windows (and sills) in rows and columns, each edge off by up to `jitter` of the picture."""
    random = np.random.default_rng(seed)
    boxes = [WHOLE]
    for i in range(columns):
        for j in range(rows):
            x, y = (i + 0.3) / columns, (j + 0.3) / rows
            w, h = 0.4 / columns, 0.4 / rows
            off = random.uniform(-jitter, jitter, 4)
            boxes.append(("window", x + off[0], y + off[1], x + w + off[2], y + h + off[3]))
            if sill:
                bottom = y + h + off[3]
                boxes.append(("sill", x - 0.2 * w, bottom, x + 1.2 * w, bottom + 0.25 * h))
    return boxes


def agreement(facade: Facade, boxes: Iterable[Shares], size: tuple[int, int] = (600, 800)) -> float:
    """Return the share of pixels that the facade shows as the boxes do, painted one over the other."""
    width, height = size
    labels = {"facade": "Wall"}
    truth = painted(
        in_painting_order(
            LabelBox(labels.get(n, n.title()), x0 * width, y0 * height, x1 * width, y1 * height)
            for n, x0, y0, x1, y1 in boxes
        ),
        width,
        height,
    )
    return float((shown(facade, truth.shape) == truth).mean())


def shown(facade: Facade, shape: tuple[int, ...]) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    """Paint a facade's terminals into its picture's pixels; background where it has none."""
    assert facade.picture is not None
    left, _, _, bottom = facade.picture.box
    mask = np.full(shape, CODES["Background"], np.uint8)
    for placed in place(facade.root):
        if placed.region.terminal:
            x0, y0, x1, y1 = placed.box
            rows = slice(max(0, round(bottom - y1)), max(0, round(bottom - y0)))
            columns = slice(max(0, round(left + x0)), max(0, round(left + x1)))
            mask[rows, columns] = CODES[placed.region.labels[0]]
    return mask


def composites(facade: Facade, label: str = "") -> list[Region]:
    """Return the composite regions (with a label), each once."""
    regions = facade.regions.values()
    return [r for r in regions if r.children and (not label or label in r.labels)]


def check_exact(facade: Facade) -> None:
    """Check that children tile their parents to 1e-9, and that one symbol means one region."""
    for region in composites(facade):
        along = region.extent(region.split or "rows")
        sizes = [child.extent(region.split or "rows") for child in region.children]
        assert min(sizes) > 0
        assert abs(sum(sizes) - along) <= 1e-9 * along
        across = "rows" if region.split == "columns" else "columns"
        for child in region.children:
            assert abs(child.extent(across) - region.extent(across)) <= 1e-9 * region.extent(across)
        known: dict[str, Region] = {}
        for child in region.children:
            assert known.setdefault(child.symbol, child) == child
