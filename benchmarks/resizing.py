"""How long a step takes when a facade is dragged to another size, its words kept.

    python -m benchmarks.resizing [--steps 200] [--json FILE]

Ninety-six windows stand in eight storeys, in line from storey to storey. The width goes from the input's up
to 130 % and down to 85 %, the height along with it; each step sizes the whole facade anew, and every layout
is checked (which is no part of the step's time). Aim: 5 ms a step.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from benchmarks.designs.storeys import storeys
from layoutkit.model import Facade, Layout, place
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.sizes.resizing import Resizer

#: Milliseconds that a step should take at most.
AIM = 5.0


@dataclass(frozen=True, slots=True)
class Dragged:
    """What was measured, in milliseconds.

    Attributes
    ----------
    failed
        Steps without a layout, with one that breaks a constraint, or with other words.
    """

    windows: int
    steps: int
    failed: int
    first: float
    mean: float
    median: float
    slowest: float

    @property
    def met(self) -> bool:
        """Whether every step kept everything, in the time aimed at."""
        return self.failed == 0 and self.slowest <= AIM


def main() -> None:
    parser = argparse.ArgumentParser(description="time a step of resizing")
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    arguments = parser.parse_args()
    with single_threaded():
        found = dragged(storeys(), arguments.steps)
    print(
        f"{found.windows} windows, {found.steps} steps: first {found.first:.2f}, mean {found.mean:.2f}, "
        f"median {found.median:.2f}, slowest {found.slowest:.2f} ms; {found.failed} failed; "
        f"aim of {AIM:g} ms {'met' if found.met else 'not met'}"
    )
    if arguments.json:
        arguments.json.write_text(json.dumps(asdict(found), indent=1) + "\n", encoding="utf-8")


def dragged(facade: Facade, steps: int) -> Dragged:
    """Drag a facade to and fro."""
    resizer = Resizer(facade)
    times, failed = [], 0
    for step in range(steps):
        share = 1.075 + 0.225 * math.sin(2 * math.pi * step / steps - 0.34)
        size = (facade.root.width * share, facade.root.height * (1 + (share - 1) / 2))
        start = time.perf_counter()
        layout = resizer.at(*size)
        times.append(1000 * (time.perf_counter() - start))
        failed += not isinstance(layout, Layout) or not _kept(layout, resizer.words)
    windows = sum("Window" in placed.region.labels for placed in place(facade.root))
    rest = times[1:]
    return Dragged(
        windows, steps, failed, times[0], statistics.fmean(rest), statistics.median(rest), max(rest)
    )


def _kept(layout: Layout, words: Mapping[str, tuple[str, ...]]) -> bool:
    same = all(p.region.word == words[p.symbol_path] for p in place(layout.root) if p.region.split)
    return same and not layout.violations()


if __name__ == "__main__":
    main()
