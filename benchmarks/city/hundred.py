"""What a hundred machines would take: measured on this one, simulated for the others."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from statistics import mean, quantiles

import numpy as np

from benchmarks.city.costs import costs
from benchmarks.city.plots import city
from benchmarks.city.simulation import Costs, Course, Machines, Work, simulated
from benchmarks.city.tasks import Done, Preparation, Timed, carried_out, idle, prepared, replays
from layoutkit.batch import Runner
from layoutkit.batch.cluster import LOCAL, Cluster
from layoutkit.batch.processes import Processes

#: Machines of the cluster, the cores of each, and how much slower and quicker they are than this one.
MACHINES, CORES, SPEEDS = 100, 8, (0.7, 1.3)
#: Lines to the client, in Gbit/s.
LINES = (10, 1)
#: Plots, and how many commands share them, each with its own client and its part of the machines.
CASES = ((4_000, 1), (100_000, 1), (1_000_000, 1), (1_000_000, 10), (1_000_000, 100))
#: Plots a tile.
TILES = (10, 50)
#: Plots of the scenes whose preparation is timed.
PREPARED = (4_000, 16_000)

_HEAD = (
    "    plots commands tile   tasks Gbit/s   seconds  limit      busy  one machine  times  one lost  again\n"
)


@dataclass(frozen=True, slots=True)
class Measured:
    """What the simulation begins with.

    Attributes
    ----------
    work
        Tasks by how many plots their tiles have at most.
    loading
        Seconds until a worker has all loaded.
    preparations
        Of two scenes by the command, the larger one last.
    """

    work: dict[int, list[Done]]
    loading: float
    preparations: tuple[Preparation, Preparation]
    costs: Costs

    def preparation(self, plots: int) -> float:
        """Return the seconds until a scene of so many plots is prepared: each step by a power law."""
        small, large = self.preparations
        grown = math.log(large.plots / small.plots)
        powers = [math.log(b / a) / grown for a, b in zip(small.steps, large.steps, strict=True)]
        return math.fsum(
            seconds * math.pow(plots / large.plots, max(0.0, power))
            for seconds, power in zip(large.steps, powers, strict=True)
        )

    def tasks(self, plots: int, tile: int, random: np.random.Generator) -> list[Work]:
        """Return tasks for so many plots, drawn from those that were measured with tiles of that size."""
        count = tiles(plots, tile)
        own = self.work[tile]
        drawn = (own[number] for number in random.integers(len(own), size=count))
        share = plots / count
        return [Work(done.seconds / done.plots * share, done.size / done.plots * share) for done in drawn]


def tiles(plots: int, most: int) -> int:
    """Return how many tiles so many plots make: they are halved until no half has more than the most."""
    return int(2 ** math.ceil(math.log2(max(1.0, plots / most))))


def lines(
    plots: int, prepare: Sequence[int] = PREPARED, cases: Sequence[tuple[int, int]] = CASES
) -> Iterator[str]:
    """Yield what was measured on cities of so many plots, how far the simulation is off, and what it says."""
    scene = city(plots, np.random.default_rng(0))
    small, large = (prepared(city(n, np.random.default_rng(0)), TILES[0]) for n in prepare)
    for each in (small, large):
        yield _preparation(each)
    runs = {tile: carried_out(replays(scene, tile), Processes(1)) for tile in TILES}
    for tile, run in runs.items():
        yield _work(tile, run)
    start = carried_out(idle(1, 0), Processes(1)).seconds
    size = round(mean(done.size for done in runs[TILES[0]].usual))
    cost = costs(200, size)
    loading = _loading(runs[TILES[0]])
    yield (
        f"a process starts in {start:.2f} s, and loads for {loading:.2f} s at its first task; "
        f"for each task, Dask's scheduler takes {1000 * cost.scheduler:.2f} ms, "
        f"the client {1000 * cost.client:.2f} ms and {1e9 * cost.byte:.1f} ms for each megabyte"
    )
    found = Measured({tile: run.usual for tile, run in runs.items()}, loading, (small, large), cost)
    yield from _validated(plots, found, runs, start)
    yield from table(found, cases)


def _preparation(made: Preparation) -> str:
    read, sites, tiled = made.steps
    return (
        f"a scene of {made.plots} plots ({made.size / 1e6:.1f} MB): read in {read:.2f} s, its sites found in "
        f"{sites:.2f} s, divided into tiles in {tiled:.2f} s, in {made.memory:.0f} MB"
    )


def _work(tile: int, run: Timed) -> str:
    seconds = [done.seconds for done in run.usual]
    low, middle, high = quantiles(seconds, n=4) if len(seconds) > 1 else 3 * seconds
    plots = sum(done.plots for done in run.usual)
    size = sum(done.size for done in run.usual)
    return (
        f"tiles of at most {tile} plots: {len(seconds)} tasks of {plots / len(seconds):.1f} plots, "
        f"{min(seconds):.2f} to {max(seconds):.2f} s (quartiles {low:.2f}, {middle:.2f}, {high:.2f}), "
        f"{1000 * sum(seconds) / plots:.0f} ms and {size / plots / 1000:.0f} kB a plot"
    )


def _loading(run: Timed) -> float:
    """Return what the first task of a worker took longer than others of as many plots."""
    usual = sum(done.seconds for done in run.usual) / sum(done.plots for done in run.usual)
    return max(0.0, mean(done.seconds - usual * done.plots for done in run.done if done.first))


def _validated(plots: int, found: Measured, runs: dict[int, Timed], start: float) -> Iterator[str]:
    """Yield runs of this machine beside what the simulation says of them.

    What a task takes of a processor hangs on what else the machine does: each run is simulated with its own.
    """
    tile = TILES[0]
    scene = city(plots, np.random.default_rng(0))
    yield "the simulation beside runs of this machine:"
    for most, run in runs.items():
        yield _beside(f"one process, tiles of {most}", run, _here(plots, most, run, 1, found, start))
    runners: tuple[tuple[str, Runner, float], ...] = (
        (f"two processes, tiles of {tile}", Processes(2), start),
        (f"Dask, two workers, tiles of {tile}", Cluster(LOCAL, 2), _start_of_dask()),
    )
    for what, runner, own in runners:
        run = carried_out(replays(scene, tile), runner)
        yield _beside(what, run, _here(plots, tile, run, 2, found, own))


def _start_of_dask() -> float:
    return carried_out(idle(1, 0), Cluster(LOCAL, 2)).seconds


def _here(plots: int, tile: int, run: Timed, cores: int, found: Measured, start: float) -> Course:
    machine = Machines((1.0,), cores, (found.loading, start))
    own = replace(found, work={tile: run.usual})
    return simulated(own.tasks(plots, tile, np.random.default_rng(0)), machine, found.costs)


def _beside(what: str, run: Timed, course: Course) -> str:
    """Say how far the simulation is off, and what the run's tasks took."""
    off = course.seconds / run.seconds - 1
    each = 1000 * sum(done.seconds for done in run.usual) / sum(done.plots for done in run.usual)
    return (
        f"  {what}: measured {run.seconds:.1f} s, simulated {course.seconds:.1f} s ({100 * off:+.0f} %); "
        f"{each:.0f} ms of processors a plot"
    )


def table(found: Measured, cases: Sequence[tuple[int, int]]) -> Iterator[str]:
    """Yield what a cluster would take, by plots and the commands that share them."""
    yield (
        f"simulated: {MACHINES} machines of {CORES} cores, from {SPEEDS[0]} to {SPEEDS[1]} times as fast as "
        "this one, the results of each command taken in over one line"
    )
    yield _HEAD.rstrip()
    for plots, commands in cases:
        for line in LINES:
            for tile in TILES:
                yield _row(plots, commands, tile, line, found)


def _row(plots: int, commands: int, tile: int, line: float, found: Measured) -> str:
    """Return what the slowest of the commands takes: all have as much to do, and as many machines."""
    random = np.random.default_rng(0)
    own, machines = plots // commands, MACHINES // commands
    tasks = found.tasks(own, tile, random)
    groups = random.uniform(*SPEEDS, size=(commands, machines)).tolist()
    speeds = tuple(min(groups, key=sum))
    rate = line * 1e9 / 8
    begin = found.loading, found.preparation(own)
    cluster = Machines(speeds, CORES, begin, rate)
    course = simulated(tasks, cluster, found.costs)
    single = Machines((1.0,), CORES, begin, rate)
    alone = commands * simulated(tasks, single, found.costs).seconds
    # Of a hundred machines, one is lost: where commands have one each, that one begins anew elsewhere.
    lost = simulated(tasks, replace(cluster, lost=1), found.costs) if machines > 1 else None
    after = (f"{lost.seconds:9.0f} {lost.repeated:6d}") if lost is not None else f"{'-':>9} {'-':>6}"
    return (
        f"{plots:9d} {commands:8d} {tile:4d} {commands * len(tasks):7d} {line:6g} {course.seconds:9.0f}  "
        f"{course.limit:<9} {100 * course.shares[course.limit]:4.0f} % {alone:12.0f} "
        f"{alone / course.seconds:6.1f} {after}"
    )
