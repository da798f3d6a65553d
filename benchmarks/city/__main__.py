"""Houses on the plots of a city by `layoutkit replay`: how long it takes, and what many machines would take.

    python -m benchmarks.city [--small 400] [--large 4000] [--tile N]
                             [--parts small,one,dask,plain,real,large]
    python -m benchmarks.city cluster [--plots 400]

The first one replays `facades/houses/operations.xml` on cities of our own (`plots.py`) and, where its data is
there, on the plots of a real quarter; each run is a command of its own, whose time, processor time and memory
are measured, and whose results are compared byte by byte. Limits: 120 s for 400 plots on two cores, 11 times
that for 4,000, and 2 GB.

The second one measures single tasks, what Dask costs, and how long workers need to begin; from that a
simulation (`simulation.py`) says how long a hundred machines would take. It is held against runs of this
machine first.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from benchmarks.city import hundred, runs


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.city", description="build houses on plots")
    parser.add_argument("what", nargs="?", choices=("runs", "cluster"), default="runs")
    parser.add_argument("--small", type=int, default=runs.SMALL, help="plots of the smaller city")
    parser.add_argument("--large", type=int, default=runs.LARGE, help="plots of the larger city")
    parser.add_argument("--parts", default=",".join(runs.PARTS), help="which runs are made")
    parser.add_argument("--tile", type=int, help="plots a tile, at most; by default as the command has it")
    parser.add_argument(
        "--plots", type=int, default=runs.SMALL, help="of the city that tasks are measured on"
    )
    arguments = parser.parse_args(given)
    names = arguments.parts.split(",")
    if unknown := set(names) - runs.PARTS.keys():
        parser.error(f"there is no part {', '.join(sorted(unknown))}; there are {', '.join(runs.PARTS)}")
    if arguments.what == "cluster":
        told = hundred.lines(arguments.plots)
    else:
        told = runs.lines(arguments.small, arguments.large, names, arguments.tile)
    for line in told:
        print(line, flush=True)


if __name__ == "__main__":
    main()
