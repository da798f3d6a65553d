"""How long sizes take in editing, beside the same program stated plainly in cvxpy; and how long a drag step.

    python -m benchmarks.editing_sizing [--leaves 3000,12000] [--repeats 21] [--plain 1] [--json FILE]

Facades of `designs.front` are sized at 105 % and at 92 % of their width and height: with one grid, of all
windows, and with eight, one for each label, so that grids stand inside the elements of others. The program
over leaf sizes (`plain_sizing`, as in section 5 of Dang et al. 2014) goes to cvxpy, and by that to clarabel;
both have to come to the same sizes. Aims, for both axes together: 15 ms at 3,000 leaves, 60 ms at 12,000.

Then the right edge of a facade of 600 leaves is dragged to 130 %, down to 50 %, and back; and a window in the
midst of one that keeps its size, from side to side, farther than it can go. Aim: 5 ms a step.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from benchmarks.designs.front import front
from benchmarks.plain_sizing import PlainSizing
from layoutkit.model import Facade, Grid
from layoutkit.model.selection import RegionSet
from layoutkit.sizing.threads import single_threaded
from layoutkit_editing.grids.lattices import lattice_of
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.dragging import Dragged, Handle, Workspace
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State, Targets
from layoutkit_editing.tree import Tree

#: Milliseconds that sizing may take, by leaves, and a drag step.
AIMS, STEP_AIM = {3000: 15.0, 12000: 60.0}, 5.0
#: Solvers agree to this share of the facade.
SAME = 1e-4


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured of one state, in milliseconds, both axes together.

    Attributes
    ----------
    grids
        How many; `elements` in all.
    median, slowest, processor
        Of ours; of the processor's time the median, which does not hang on what else runs.
    stating, compiling, solving
        Of the plain program: making its rows, what cvxpy does with them, and the solver; None if not asked.
    difference
        By how much sizes differ, as a share of the facade's.
    """

    leaves: int
    grids: int
    elements: int
    size: float
    median: float
    slowest: float
    processor: float
    stating: float | None = None
    compiling: float | None = None
    solving: float | None = None
    difference: float | None = None


@dataclass(frozen=True, slots=True)
class Steps:
    """What was measured of a drag, in milliseconds; `stopped` steps went as far as they could.

    `processor` is the slowest by the processor's time.
    """

    what: str
    steps: int
    stopped: int
    first: float
    median: float
    slowest: float
    processor: float


def main() -> None:
    parser = argparse.ArgumentParser(description="time sizing and dragging")
    parser.add_argument("--leaves", default="3000,12000", help="about how many, at least 100")
    parser.add_argument("--repeats", type=int, default=21, help="of ours, for each state")
    parser.add_argument("--plain", type=int, default=1, help="1: beside cvxpy; 0: ours alone")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    arguments = parser.parse_args()
    found: list[Figures | Steps] = []
    with single_threaded():
        for figures in measured(
            map(int, arguments.leaves.split(",")), arguments.repeats, bool(arguments.plain)
        ):
            found.append(figures)
            print(_line(figures), flush=True)
        for steps in dragged():
            found.append(steps)
            print(_step_line(steps), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(f) for f in found], indent=1) + "\n", encoding="utf-8")


def measured(leaves: Iterator[int] | Sequence[int], repeats: int, plain: bool) -> Iterator[Figures]:
    """Yield the figures of every state."""
    for count in leaves:
        facade = front(count)
        for labels in (["Window"], sorted(facade.labels)):
            state = state_of(facade, labels)
            for share in (1.05, 0.92):
                extents = (facade.root.width * share, facade.root.height * share)
                yield compared(replace(state, targets=Targets(extents=extents)), share, repeats, plain)


def state_of(facade: Facade, labels: Sequence[str]) -> State:
    """Return a facade with a grid for each of some labels."""
    original = Original(facade)
    grids = [Grid(label, RegionSet(f"@{label}")) for label in labels]
    return State(original, Tree.of(original), tuple(lattice_of(original, grid) for grid in grids))


def compared(state: State, share: float, repeats: int, plain: bool) -> Figures:
    """Time a state."""
    found = sized(state)  # what is known of the original is kept, as in a session
    if not isinstance(found, Sized):
        raise RuntimeError(found.reason)
    times, processor = [], []
    for _ in range(repeats):
        start, began = time.perf_counter(), time.process_time()
        sized(state)
        times.append(1000 * (time.perf_counter() - start))
        processor.append(1000 * (time.process_time() - began))
    leaves = sum(node.split is None for node in state.tree.nodes.values())
    elements = sum(1 for lattice in state.lattices for _ in lattice.elements)
    ours = statistics.median(times), max(times), statistics.median(processor)
    figures = Figures(leaves, len(state.lattices), elements, share, *ours)
    return _beside(figures, state, found) if plain else figures


def _beside(figures: Figures, state: State, found: Sized) -> Figures:
    """Time the plain program."""
    import cvxpy as cp

    stating = compiling = solving = difference = 0.0
    for axis in (0, 1):
        start = time.perf_counter()
        plain = PlainSizing(state, axis)
        problem, sizes = plain.problem()
        stated = time.perf_counter()
        problem.solve(solver=cp.CLARABEL)
        ended = time.perf_counter()
        inside = float(problem.solver_stats.solve_time)
        stating += 1000 * (stated - start)
        compiling += 1000 * (ended - stated - inside)
        solving += 1000 * inside
        spans = np.array([found.span(own, axis) for own in plain.leaves])
        expected = np.asarray(sizes.value) * float(state.original.sizes[axis, 0])
        off = np.abs(spans[:, 1] - spans[:, 0] - expected).max() / state.original.sizes[axis, 0]
        difference = max(difference, float(off))
    return replace(figures, stating=stating, compiling=compiling, solving=solving, difference=difference)


def dragged(leaves: int = 600, steps: int = 200) -> Iterator[Steps]:
    """Drag the right edge of a facade, then a window inside it whose facade keeps its size."""
    facade = front(leaves)
    state = state_of(facade, ["Window"])
    width, height = facade.root.width, facade.root.height
    shares = np.concatenate([np.linspace(1.0, 1.3, steps // 4), np.linspace(1.3, 0.5, steps // 2),
                             np.linspace(0.5, 1.0, steps // 4)])  # fmt: skip
    yield _stepped("the right edge", state, Handle(state.tree.root, 0), (width * shares).tolist())
    state = replace(state, targets=Targets(extents=(width, height)))
    (lattice,) = state.lattices
    row = lattice.cells[len(lattice.cells) // 2]
    window = next(own for own in row[len(row) // 2 :] if own is not None)
    home = float(state.original.spans[0, window, 0])
    places = home + 0.7 * width * np.sin(np.linspace(0.0, 2 * np.pi, steps))
    yield _stepped("a window", state, Handle(window, 0, 0), places.tolist())


def _stepped(what: str, state: State, handle: Handle, places: Sequence[float]) -> Steps:
    workspace = Workspace(state)
    times, processor, stopped = [], [], 0
    for place in places:
        start, began = time.perf_counter(), time.process_time()
        found = workspace.drag(handle, place)
        times.append(1000 * (time.perf_counter() - start))
        processor.append(1000 * (time.process_time() - began))
        if not isinstance(found, Dragged):
            raise RuntimeError(found.reason)
        stopped += bool(found.obstacle)
    rest = times[1:]
    return Steps(what, len(times), stopped, times[0], statistics.median(rest), max(rest), max(processor[1:]))


def _line(own: Figures) -> str:
    aim = next((ms for leaves, ms in sorted(AIMS.items(), reverse=True) if own.leaves > 0.9 * leaves), None)
    told = (
        f"{own.leaves:6d} leaves, {own.grids} grid(s) of {own.elements:5d} elements, {own.size:.0%}: "
        f"median {own.median:6.2f}, slowest {own.slowest:6.2f}, processor {own.processor:6.2f} ms"
    )
    if aim is not None:
        told += f" (aim of {aim:g} ms {'met' if own.median <= aim else 'not met'})"
    if own.solving is not None and own.stating is not None and own.compiling is not None:
        told += (
            f"; plainly: stating {own.stating:.0f}, compiling {own.compiling:.0f}, "
            f"solving {own.solving:.0f} ms; sizes differ by {own.difference:.0e}"
        )
    return told


def _step_line(own: Steps) -> str:
    met = "met" if own.slowest <= STEP_AIM else "not met"
    return (
        f"dragging {own.what}, {own.steps} steps, {own.stopped} of them stopped: first {own.first:.2f}, "
        f"median {own.median:.2f}, slowest {own.slowest:.2f}, processor at most {own.processor:.2f} ms "
        f"(aim of {STEP_AIM:g} ms {met})"
    )


if __name__ == "__main__":
    main()
