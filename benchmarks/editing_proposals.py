"""How long all proposals of one edit take, sized and ordered, beside the same sizes by a plain program.

    python -m benchmarks.editing_proposals [--leaves 600] [--repeats 9] [--plain 1] [--json FILE]

Two facades: `designs.front`, where columns of windows are the outermost parts, and `designs.bays`, where
each storey has bays of three kinds. Rows and columns of the grid of all windows are added and removed: every
proposal there is, without pictures. Beside it, sizes of the proposals of the first edit by the program over
leaf sizes (`plain_sizing`, as in section 5 of Dang et al. 2014) in cvxpy with clarabel. Aim: 100 ms in the
median.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from benchmarks.designs.bays import bays
from benchmarks.designs.front import front
from benchmarks.plain_sizing import PlainSizing
from layoutkit.model import Facade, Grid, RegionSet, place
from layoutkit.model.session import Action, Axis
from layoutkit_editing.editor import Editor
from layoutkit_editing.natural import with_extents
from layoutkit_editing.proposing.proposals import Proposal

AIM = 100.0
EDITS: tuple[tuple[Action, Axis], ...] = (
    ("add", "columns"),
    ("add", "rows"),
    ("remove", "columns"),
    ("remove", "rows"),
)


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured of one edit, in milliseconds.

    Attributes
    ----------
    proposals
        How many there are.
    median, processor
        Of all of them together, by the clock and by the processor.
    plain
        Of their sizes by the plain program: stating, compiling and solving.
    """

    facade: str
    terminals: int
    edit: str
    proposals: int
    median: float
    processor: float
    plain: float | None = None


def main() -> None:
    parser = argparse.ArgumentParser(description="time all proposals of an edit")
    parser.add_argument("--leaves", type=int, default=600, help="about how many, at least 100")
    parser.add_argument("--repeats", type=int, default=9, help="for each edit")
    parser.add_argument("--plain", type=int, default=1, help="1: beside cvxpy; 0: ours alone")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    arguments = parser.parse_args()
    found = []
    for facade in (front(arguments.leaves), bays(arguments.leaves)):
        bare = replace(facade, constraints=(), grids=(Grid("windows", RegionSet.parse("@Window")),))
        for figures in measured(bare, arguments.repeats, bool(arguments.plain)):
            found.append(figures)
            print(_line(figures), flush=True)
    for each in found:
        if each.median > AIM:
            print(f"over the aim of {AIM:.0f} ms: {each.facade}, {each.edit}")
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(f) for f in found], indent=1) + "\n", encoding="utf-8")


def measured(facade: Facade, repeats: int, plain: bool) -> Iterator[Figures]:
    """Yield the figures of every edit of a facade."""
    editor = Editor(facade)
    terminals = sum(placed.region.terminal for placed in place(facade.root))
    for number, (action, axis) in enumerate(EDITS):
        made = editor.proposals(action, axis, ["windows"])
        times, processor = [], []
        for _ in range(repeats):
            start, began = time.perf_counter(), time.process_time()
            editor.proposals(action, axis, ["windows"])
            times.append(1000 * (time.perf_counter() - start))
            processor.append(1000 * (time.process_time() - began))
        found = [each for each in made if isinstance(each, Proposal)]
        figures = Figures(
            facade.name,
            terminals,
            f"{action} {axis}",
            len(found),
            statistics.median(times),
            statistics.median(processor),
        )
        yield replace(figures, plain=_plain(found)) if plain and not number else figures


def _plain(found: list[Proposal]) -> float:
    """Return how long the plain program takes for the sizes of all proposals."""
    import cvxpy as cp

    start = time.perf_counter()
    for each in found:
        for axis in (0, 1):
            problem, _ = PlainSizing(with_extents(each.state), axis).problem()
            problem.solve(solver=cp.CLARABEL)
    return 1000 * (time.perf_counter() - start)


def _line(own: Figures) -> str:
    beside = "" if own.plain is None else f"; plain program {own.plain / 1000:.1f} s"
    return (
        f"{own.facade:12s} {own.terminals} terminals, {own.edit:14s}: {own.proposals:3d} proposals, "
        f"median {own.median:6.1f} ms, processor {own.processor:6.1f} ms{beside}"
    )


if __name__ == "__main__":
    main()
