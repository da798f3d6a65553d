"""How well CMP annotations are converted: a row a facade, then the figures.

    python benchmarks/conversion.py [FOLDER] [--only b0012,b0033]

FOLDER holds cmp_*.xml with their pictures (by default ../shared/data/cmp). Agreement is the share of pixels
on which the facade's terminals show what the boxes show, painted in the database's order; background counts.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model import Facade, place
from layoutkit_formats.boxes import CODES, in_painting_order, painted
from layoutkit_formats.cmp import CmpFormat, boxes_of
from layoutkit_formats.pictures import picture_size

if TYPE_CHECKING:
    from layoutkit_formats.boxes import Mask

DATA = Path(__file__).parents[1] / ".." / "shared" / "data" / "cmp"


@dataclass(frozen=True)
class Row:
    """What was measured of one facade."""

    name: str
    agreement: float
    boxes: int
    terminals: int
    symbols: int
    groups: tuple[int, ...]
    distinct: float
    seconds: float

    def __str__(self) -> str:
        groups = "+".join(map(str, self.groups))
        return (
            f"{self.name}  agreement {self.agreement:.3f}  boxes {self.boxes:3d}  "
            f"terminals {self.terminals:4d} ({self.terminals / self.boxes:.2f} a box)  "
            f"paths {self.symbols:4d}  floors in line {groups:12}  distinct strips {self.distinct:4.0%}  "
            f"{self.seconds:.2f} s"
        )


def shown(facade: Facade, shape: tuple[int, ...]) -> Mask:
    mask = np.full(shape, CODES["Background"], np.uint8)
    left, _, _, bottom = facade.picture.box if facade.picture else (0.0, 0.0, 0.0, float(shape[0]))
    for placed in place(facade.root):
        if placed.region.terminal:
            x0, y0, x1, y1 = placed.box
            rows = slice(max(0, round(bottom - y1)), max(0, round(bottom - y0)))
            mask[rows, max(0, round(left + x0)) : max(0, round(left + x1))] = CODES[placed.region.labels[0]]
    return mask


def floors_in_line(facade: Facade) -> tuple[tuple[int, ...], float]:
    """Return how many floors share each word of at least three strips, and the share of distinct symbols."""
    floors: defaultdict[tuple[str, ...], int] = defaultdict(int)
    for placed in place(facade.root):
        if "Floor" in placed.region.labels and len(placed.region.word) > 2:
            floors[(placed.symbol_path.rpartition("/")[0], *placed.region.word)] += 1
    shares = [len(set(word[1:])) / len(word[1:]) for word in floors]
    return tuple(sorted(floors.values(), reverse=True)), statistics.mean(shares or [1.0])


def measure(file: Path) -> Row:
    start = time.perf_counter()
    facade, _ = CmpFormat().read(file, None)
    seconds = time.perf_counter() - start
    width, height = picture_size(file.with_suffix(".jpg"))
    truth = painted(in_painting_order(boxes_of(file, width, height, [])), width, height)
    groups, distinct = floors_in_line(facade)
    return Row(
        file.stem,
        float((shown(facade, truth.shape) == truth).mean()),
        file.read_text().count("<object>"),
        sum(placed.region.terminal for placed in place(facade.root)),
        len(facade.regions),
        groups,
        distinct,
        seconds,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description="how well CMP annotations are converted")
    parser.add_argument("folder", nargs="?", type=Path, default=DATA)
    parser.add_argument("--only", default="", help="names, e.g. b0012,b0033")
    arguments = parser.parse_args()
    chosen = [name for name in arguments.only.split(",") if name]
    rows = []
    for file in sorted(arguments.folder.glob("*.xml")):
        if not chosen or any(name in file.stem for name in chosen):
            rows.append(measure(file))
            print(rows[-1], flush=True)
    if not rows:
        raise SystemExit(f"no annotation is in {arguments.folder}")
    agreements = [row.agreement for row in rows]
    ratios = [row.terminals / row.boxes for row in rows]
    seconds = [row.seconds for row in rows]
    in_line = sum(max(row.groups, default=0) > 1 for row in rows)
    print(f"agreement: mean {statistics.mean(agreements):.4f}, least {min(agreements):.3f}")
    print(f"terminals a box: mean {statistics.mean(ratios):.2f}, greatest {max(ratios):.2f}")
    print(f"seconds: median {statistics.median(seconds):.2f}, greatest {max(seconds):.2f}")
    print(f"facades with two or more floors in line: {in_line} of {len(rows)}")
    print(f"distinct strips among strips: mean {statistics.mean(row.distinct for row in rows):.2f}")


if __name__ == "__main__":
    main()
