"""Runs of `layoutkit replay` on cities, each a command in processes of its own."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.city.measuring import Taken, digest, size, taken
from benchmarks.city.outcomes import Outcome
from benchmarks.city.plots import city
from layoutkit.documents import scene_bytes

ROOT = Path(__file__).parents[2]
OPERATIONS = ROOT / "facades" / "houses" / "operations.xml"
#: The plots of a quarter as a survey has them.
REAL = ROOT.parent / "shared" / "data" / "city" / "bubenec.gpkg"
#: What is asked for: seconds for the smaller city on two cores, how many times that for the larger one, which
#: has ten times as many plots, and megabytes.
SECONDS, TIMES, MEGABYTES = 120.0, 11.0, 2048.0
#: Plots of the smaller city, and of the larger one.
SMALL, LARGE = 400, 4000


@dataclass(frozen=True, slots=True)
class Part:
    """One of the runs.

    Attributes
    ----------
    what
        In words.
    options
        Of the command.
    """

    what: str
    options: tuple[str, ...]


#: By name, in the order in which they are made. The same city in other ways gives the same bytes as `small`.
PARTS: Mapping[str, Part] = {
    "small": Part("two processes", ("--workers", "2")),
    "one": Part("in this process", ()),
    "dask": Part("Dask, two workers", ("--scheduler", "local", "--workers", "2")),
    "plain": Part("two processes, no views", ("--workers", "2", "--no-views")),
    "real": Part("two processes, real plots", ("--workers", "2", "--part", "plots")),
    "large": Part("two processes", ("--workers", "2")),
}
#: Which of them are to have the same bytes.
_ALIKE = ("small", "one", "dask")


@dataclass(frozen=True, slots=True)
class Run:
    """What a run took, and what came of it.

    Attributes
    ----------
    outcome
        None where it broke off.
    size
        Of all that it has written, in bytes.
    digest
        Of the same.
    """

    taken: Taken
    outcome: Outcome | None
    size: int
    digest: str

    @property
    def plots(self) -> int:
        """How many plots there were."""
        return self.outcome.plots if self.outcome is not None else 0


def lines(small: int, large: int, names: Sequence[str], tile: int | None = None) -> Iterator[str]:
    """Yield what was measured, run by run, then what is to be compared."""
    runs: dict[str, Run] = {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part in (part for part in PARTS if part in names):
            scene = _scene(part, small, large, folder)
            if scene is None:
                yield f"{part}: left out, for want of the plots of a survey"
                continue
            own = () if tile is None else ("--tile", str(tile))
            runs[part] = run(scene, (*PARTS[part].options, *own), folder / part)
            yield _told(part, runs[part])
    yield from _compared(runs)


def run(scene: Path, options: Sequence[str], folder: Path) -> Run:
    """Replay the houses on the plots of a scene."""
    replay = ("replay", OPERATIONS, scene, "-o", folder, *options)
    log = folder.with_suffix(".log")
    used = taken([sys.executable, "-m", "layoutkit", *map(str, replay)], log)
    if not (folder / "manifest.json").exists():
        print(log.read_text(encoding="utf-8"), file=sys.stderr)
        return Run(used, None, 0, "")
    return Run(used, Outcome.of(folder), size(folder), digest(folder))


def write_city(plots: int, path: Path) -> Path:
    """Write a city of so many plots."""
    path.write_bytes(scene_bytes(city(plots, np.random.default_rng(0))))
    return path


def _scene(part: str, small: int, large: int, folder: Path) -> Path | None:
    if part == "real":
        return REAL if REAL.exists() else None
    return write_city(large if part == "large" else small, folder / "city.xml")


def _told(part: str, made: Run) -> str:
    used, what = made.taken, PARTS[part].what
    if made.outcome is None:
        return f"{part}: {what}: broke off with exit code {used.code}"
    plots = max(1, made.plots)
    return (
        f"{part}: {made.plots} plots, {what}: {used.seconds:.1f} s, {used.processor:.1f} s of processors "
        f"({1000 * used.processor / plots:.0f} ms a plot), at most {used.memory:.0f} MB together "
        f"and {used.greatest:.0f} MB in one process, {made.size / 1e6:.1f} MB written\n"
        f"  {made.outcome}"
    )


def _compared(runs: Mapping[str, Run]) -> Iterator[str]:
    """Yield how runs keep to what is asked for, and whether those that should be are the same."""
    if "small" in runs:
        yield _limit("seconds for the smaller city", runs["small"].taken.seconds, SECONDS)
    if {"small", "large"} <= runs.keys():
        ratio = runs["large"].taken.seconds / runs["small"].taken.seconds
        share = runs["large"].plots / max(1, runs["small"].plots)
        yield _limit(f"times as long for {share:.1f} times as many plots", ratio, TIMES)
    if runs:
        yield _limit("megabytes together, at most", max(r.taken.memory for r in runs.values()), MEGABYTES)
    alike = {name: runs[name].digest for name in _ALIKE if name in runs}
    if len(alike) > 1:
        same = "the same bytes" if len(set(alike.values())) == 1 else "DIFFERENT BYTES"
        yield f"{', '.join(alike)}: {same}"


def _limit(what: str, figure: float, limit: float) -> str:
    return f"{what}: {figure:.1f} (limit {limit:.0f}, {'met' if figure <= limit else 'not met'})"
