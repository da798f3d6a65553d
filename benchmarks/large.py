"""Layout documents of any size, in the shapes that matter to a reader.

    python -m benchmarks.large SHAPE BYTES FILE [FACADE]

With a facade's name, the facade is written, too, beside the layout, which names it.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from itertools import count
from pathlib import Path

import numpy as np

#: Children of each row.
COLUMNS = 1000
#: Rows of different symbols, after which they begin anew.
KINDS = 97

_WINDOW = '<region symbol="A" width="1" labels="Window"/>'


def _again(generator: np.random.Generator) -> Iterator[str]:
    yield _WINDOW
    for _ in range(COLUMNS - 1):
        yield '<again symbol="A"/>'


def _written(generator: np.random.Generator) -> Iterator[str]:
    for _ in range(COLUMNS):
        yield _WINDOW


def _different(generator: np.random.Generator) -> Iterator[str]:
    # Sums of few binary digits are exact, so that they add up however they are added.
    parts = generator.integers(1, 2**20, size=COLUMNS) / 2**20
    for index, width in enumerate([*parts[1:], COLUMNS - float(parts[1:].sum())]):
        yield f'<region symbol="C{index}" width="{float(width)!r}" labels="Window"/>'


def _commented(generator: np.random.Generator) -> Iterator[str]:
    for _ in range(COLUMNS):
        yield f"<!-- a window as they all are -->\n      {_WINDOW}"


#: What the rows of each shape hold.
SHAPES: Mapping[str, Callable[[np.random.Generator], Iterator[str]]] = {
    "again": _again,
    "written": _written,
    "different": _different,
    "line": _written,
    "comments": _commented,
}


def write_layout(path: Path, shape: str, size: int, facade: str = "") -> None:
    """Write a layout of about `size` bytes.

    Parameters
    ----------
    shape
        ``again``: replicas; ``written``: like regions in full; ``different``: each of a size of its own;
        ``line``: as written, all in one line; ``comments``: one above each region.
    facade
        The facade's document, which the layout names.
    """
    generator, end = np.random.default_rng(0), "" if shape == "line" else "\n"
    rows = 0
    body = path.with_suffix(".part")
    with body.open("w", encoding="utf-8") as out:
        for rows in count(1):
            lines = "".join(f"      {line}{end}" for line in SHAPES[shape](generator))
            out.write(f'    <region symbol="R{rows % KINDS}" height="3" labels="Row" split="columns">{end}')
            out.write(f"{lines}    </region>{end}")
            if out.tell() >= size:
                break
    named = f' facade="{facade}"' if facade else ""
    with path.open("w", encoding="utf-8") as out:
        out.write(f'<?xml version="1.0" encoding="UTF-8"?>{end}')
        out.write(f'<layout xmlns="urn:layoutkit:1" name="large" units="m"{named}>{end}')
        out.write(f'  <region symbol="F" width="{COLUMNS}" height="{3 * rows}" split="rows">{end}')
        with body.open(encoding="utf-8", newline="") as part:
            while text := part.read(1 << 20):
                out.write(text)
        out.write(f"  </region>{end}</layout>{end}")
    body.unlink()


def write_facade(path: Path) -> None:
    """Write a facade that layouts of the shapes ``again`` and ``written`` are variations of.

    It has one row of each symbol, and they may follow each other as they like.
    """
    columns = _WINDOW + '<again symbol="A"/>' * (COLUMNS - 1)
    words = ("|- @Row", "@Row @Row", "@Row -|")
    with path.open("w", encoding="utf-8") as out:
        out.write('<facade xmlns="urn:layoutkit:1" name="large" units="m">\n')
        out.write(f'<region symbol="F" width="{COLUMNS}" height="{3 * KINDS}" split="rows">\n')
        for row in range(KINDS):
            head = f'<region symbol="R{row}" height="3" labels="Row" split="columns">'
            out.write(f"{head}{columns}</region>\n")
        out.write('</region>\n<constraints>\n<size of="@Window" min="50%" max="150%"/>\n')
        out.writelines(f'<sequence within="F" word="{word}"/>\n' for word in words)
        out.write("</constraints></facade>\n")


def main() -> None:
    shape, size, file, *facade = sys.argv[1:]
    path = Path(file)
    write_layout(path, shape, int(size), *facade)
    for name in facade:
        write_facade(path.with_name(name))


if __name__ == "__main__":
    main()
