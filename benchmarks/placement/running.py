"""Runs the evaluation in several processes, and tells how long it still takes."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from benchmarks.placement.data import Half, operation_of, scenes, stages_of
from benchmarks.placement.methods import METHODS
from benchmarks.placement.protocol import Result, Split, results, splits
from layoutkit.sizing.threads import single_threaded


@dataclass(frozen=True, slots=True)
class Plan:
    """What is measured.

    Attributes
    ----------
    operations, methods
        By their names.
    splits
        How many of each operation.
    examples
        Numbers of examples.
    tests
        How many scenes of each split placements are proposed in: facades, rooms.
    half
        Of the scenes.
    data
        The folder of real data.
    """

    operations: tuple[str, ...]
    methods: tuple[str, ...]
    splits: int
    examples: tuple[int, ...]
    tests: tuple[int, int]
    half: Half
    seed: int
    data: Path


@dataclass(frozen=True, slots=True)
class Task:
    """One method in one split of one operation."""

    operation: str
    method: str
    split: int


def tasks(plan: Plan) -> list[Task]:
    """Return all tasks, in the order in which results are told."""
    return [
        Task(operation, method, split)
        for operation in plan.operations
        for method in plan.methods
        for split in range(plan.splits)
    ]


def run(plan: Plan, jobs: int) -> Iterator[Result]:
    """Yield all results, in the order of the tasks whatever the number of processes."""
    for domain in dict.fromkeys(operation_of(name).domain for name in plan.operations):
        scenes(domain, plan.data)  # read once: processes that are forked have them
    every = tasks(plan)
    progress = Progress(len(every))
    if jobs == 1:
        for task in every:
            yield from done(plan, task)
            progress.step(task)
        return
    with ProcessPoolExecutor(jobs) as pool:
        futures: dict[Future[list[Result]], Task] = {pool.submit(done, plan, task): task for task in every}
        try:
            for future in as_completed(futures):
                future.result()
                progress.step(futures[future])
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        for future in futures:
            yield from future.result()


def done(plan: Plan, task: Task) -> list[Result]:
    """Carry out one task."""
    operation = operation_of(task.operation)
    stages = stages_of(task.operation, plan.data, plan.half)
    split = _splits(plan, task.operation)[task.split]
    with single_threaded():
        found = results(operation, METHODS[task.method], stages, split, task.split, plan.examples)
        return list(found)


@cache
def _splits(plan: Plan, name: str) -> list[Split]:
    operation = operation_of(name)
    tests = plan.tests[0] if operation.domain == "facades" else plan.tests[1]
    return splits(operation, stages_of(name, plan.data, plan.half), plan.splits, tests, plan.seed)


class Progress:
    """Tells on the terminal how far a run has come; says nothing elsewhere."""

    def __init__(self, count: int) -> None:
        self.count, self.done, self.start = count, 0, time.monotonic()

    def step(self, task: Task) -> None:
        """Count one task."""
        self.done += 1
        if sys.stderr.isatty():
            left = (time.monotonic() - self.start) / self.done * (self.count - self.done)
            at = f"{task.operation}, {task.method}"
            told = f"{self.done} of {self.count}, about {left / 60:.1f} min left: {at}"
            end = "\n" if self.done == self.count else ""
            print(f"\r{told:<78.78}", end=end, file=sys.stderr, flush=True)
