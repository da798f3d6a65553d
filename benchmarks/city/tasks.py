"""The tasks of a replay, timed where they are done; and others that give as much and do nothing."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.city.runs import OPERATIONS
from benchmarks.memory import Peak
from layoutkit.batch import Finished, Plan, Runner, Shared, Task, Watching, carry_out
from layoutkit.cli.replayed import replay_tile
from layoutkit.cli.tiles import tiles_of
from layoutkit.documents import Source, read_scene, scene_bytes
from layoutkit.documents.operations import read_operations
from layoutkit.hooks.host import Host
from layoutkit.model import Scene
from layoutkit.operations.sites import sites_of

#: What `layoutkit replay` gives its tasks, if it is asked for nothing else.
_OPTIONS = {
    "formats": ["glb"],
    "views": ["south-west", "north-east"],
    "elevation": 33.0,
    "width": 1200,
    "session": {"strict": False, "without": [], "backend": None},
    "operations": OPERATIONS.name,
}
_PLOTS = ("Plot",)


@dataclass(frozen=True, slots=True)
class Done:
    """A task as it was done.

    Attributes
    ----------
    seconds
        Of the worker's processor: what else the machine does is left out.
    plots
        How many it was for.
    size
        Of its results, in bytes.
    first
        Whether it was the first one of its worker, which also had everything to load.
    """

    seconds: float
    plots: int
    size: int
    first: bool


@dataclass
class Timed:
    """Tasks as they were done.

    Attributes
    ----------
    seconds
        Of the whole run, the start of workers included.
    between
        Seconds from the first result to the last.
    done
        Of each task.
    """

    seconds: float = 0.0
    between: float = 0.0
    done: list[Done] = field(default_factory=list)

    @property
    def usual(self) -> list[Done]:
        """Tasks but for the first ones; all, if there are no others."""
        return [done for done in self.done if not done.first] or self.done


@dataclass(frozen=True, slots=True)
class Preparation:
    """What the command does with a whole scene before it hands over the first task.

    Attributes
    ----------
    size
        Of the scene's document, in bytes.
    steps
        Seconds of each step: reading, finding sites, dividing them into the scenes of tiles.
    memory
        By how much the memory has grown, in megabytes.
    """

    plots: int
    size: int
    steps: tuple[float, float, float]
    memory: float


def replays(scene: Scene, tile: int) -> list[Task]:
    """Return the tasks of a replay, each of which says how long it took."""
    host = Host.load()
    document = read_operations(OPERATIONS, host.operations, host.constraints)
    shared = Shared(document.files, {**_OPTIONS, "tile": tile})
    return [
        Task(f"t{number}", _timed, _arguments(text, names, f"t{number}"), shared)
        for number, (text, names) in enumerate(_parts(scene, sites_of(scene, _PLOTS), tile))
    ]


def _parts(scene: Scene, sites: Sequence[Scene], tile: int) -> list[tuple[str, Sequence[str]]]:
    return [(scene_bytes(part).decode(), names) for part, names in tiles_of(scene, sites, tile)]


def _arguments(text: str, names: Sequence[str], stem: str) -> dict[str, Any]:
    return {"scene": text, "sites": list(names), "seed": 0, "stem": stem, "plots": len(names)}


def idle(count: int, size: int) -> list[Task]:
    """Return tasks that do nothing, and give so many bytes each."""
    return [Task(f"i{number}", _idle, {"size": size, "plots": 0}) for number in range(count)]


def carried_out(tasks: Sequence[Task], runner: Runner) -> Timed:
    """Do tasks, and return how long they took."""
    timed, at = Timed(), list[float]()

    def finish(finished: Finished) -> None:
        at.append(time.perf_counter())
        if finished.status != "done":
            raise RuntimeError(f"{finished.key} failed: {finished.diagnostics}")
        told = finished.summary
        size = sum(len(data) for _, data in finished.files)
        timed.done.append(Done(told["seconds"], told["plots"], size, told["first"]))

    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        carry_out(Plan("city", tasks), Path(folder), runner, Watching(finish=finish))
        timed.seconds = time.perf_counter() - start
    timed.between = at[-1] - at[0]
    return timed


def prepared(scene: Scene, tile: int) -> Preparation:
    """Prepare a scene as the command does, and return how long it took."""
    data = scene_bytes(scene)
    peak = Peak()
    before = peak.megabytes()
    times = [time.perf_counter()]
    for _ in _steps(data, tile):
        times.append(time.perf_counter())
    read, sites, tiles = np.diff(times).tolist()
    return Preparation(_count(scene), len(data), (read, sites, tiles), peak.megabytes() - before)


def _steps(data: bytes, tile: int) -> Iterator[None]:
    scene = read_scene(Source("scene.xml", data)).scene
    yield
    sites = sites_of(scene, _PLOTS)
    yield
    _parts(scene, sites, tile)
    yield


def _count(scene: Scene) -> int:
    return sum(polygon.labels == _PLOTS for polygon in scene.polygons)


#: Of this process: whether it has done a task.
_BEGUN: list[bool] = []


def _timed(task: Task, shared: Shared) -> Finished:
    return _with_seconds(task, shared, replay_tile)


def _idle(task: Task, shared: Shared) -> Finished:
    return _with_seconds(task, shared, _nothing)


def _with_seconds(task: Task, shared: Shared, work: Any) -> Finished:
    start, first = time.process_time(), not _BEGUN
    _BEGUN.append(True)
    finished: Finished = work(task, shared)
    told = {"seconds": time.process_time() - start, "first": first, "plots": task.arguments["plots"]}
    return replace(finished, summary={**finished.summary, **told})


def _nothing(task: Task, _: Shared) -> Finished:
    return Finished(task.key, "done", ((f"{task.key}.bin", _noise(task.arguments["size"])),))


@cache
def _noise(size: int) -> bytes:
    # Models and pictures are packed already: like them, this cannot be packed any further.
    return np.random.default_rng(0).bytes(size)
