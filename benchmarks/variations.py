"""How long a variation takes, and how surely it comes: nine facades, side by side in one run.

    python -m benchmarks.variations [--only corner,hotel] [--seeds 1000] [--against baseline,cpsat]

Each facade is laid out anew at four sizes, the seeds taking turns. Times are of search and sizing; the check
of the finished layout, compiling the facade, and the first variation at each size (whose tables later ones
use) stand in columns of their own; so does the processor's time, which other programs on the machine do not
lengthen. The paper's times are those of its Table II: Intel Core i7 at 2.67 GHz.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from benchmarks.contenders import Contender, Ours, Size, Trial, trial
from benchmarks.designs import DESIGNS
from benchmarks.paper import TABLE, counts
from layoutkit.model import Facade
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.model import Model

#: Width and height as shares of the input's.
SCALES = ((1.0, 1.0), (0.8, 0.8), (1.25, 1.1), (1.5, 1.5))
#: A variation should take this share of the paper's time, and of that of either rival.
AIM = 0.1


@dataclass(frozen=True)
class Measured:
    """All trials of one contender on one facade.

    Attributes
    ----------
    firsts
        Of a contender that keeps something for later variations: the first at each size.
    trials
        All others.
    """

    contender: str
    firsts: tuple[Trial, ...]
    trials: tuple[Trial, ...]

    @property
    def found(self) -> list[Trial]:
        """The trials that ended with a layout that keeps everything."""
        return [t for t in self.trials if t.status == "found"]

    @property
    def success(self) -> float:
        """Share of the trials that found a layout."""
        everything = (*self.firsts, *self.trials)
        return sum(t.status == "found" for t in everything) / len(everything)

    @property
    def mean(self) -> float:
        """Mean milliseconds over the successes; not a number where there is none."""
        return _mean(t.milliseconds for t in self.found)

    @property
    def least(self) -> float:
        """The mean over the successes or, where there is none, the least it can be: that of giving up."""
        return self.mean if self.found else _mean(t.milliseconds for t in self.trials)


def _mean(values: Iterable[float]) -> float:
    """Return the mean; not a number where there is nothing."""
    kept = list(values)
    return statistics.fmean(kept) if kept else math.nan


def main() -> None:
    arguments = _arguments()
    chosen = [name for name in arguments.only.split(",") if name] or list(DESIGNS)
    rivals = [name for name in arguments.against.split(",") if name]
    report = []
    with single_threaded():
        for name in chosen:
            report.append(measured_design(name, arguments, rivals))
            print(_text(report[-1]), flush=True)
    print(table(report))
    if arguments.json:
        text = json.dumps(_without_nan(report), indent=1, allow_nan=False)
        arguments.json.write_text(f"{text}\n", encoding="utf-8")


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="time a variation, and success, of nine facades")
    parser.add_argument("--only", default="", help="designs, e.g. corner,hotel")
    parser.add_argument("--seeds", type=int, default=1000, help="variations of ours, over all sizes")
    parser.add_argument("--against", default="baseline,cpsat", help="rivals to run, of baseline and cpsat")
    parser.add_argument("--rival-seeds", type=int, default=8, help="variations of each rival, over all sizes")
    parser.add_argument("--time-limit", type=float, default=60.0, help="seconds for one variation of a rival")
    parser.add_argument("--node-limit", type=int, default=2000, help="words ours tries for one variation")
    parser.add_argument("--json", type=Path, help="write all figures to this file")
    found = parser.parse_args()
    for name in filter(None, found.only.split(",")):
        if name not in DESIGNS:
            parser.error(f"no design is called {name!r}; known are {', '.join(DESIGNS)}")
    for name in filter(None, found.against.split(",")):
        if name not in RIVALS:
            parser.error(f"no rival is called {name!r}; known are {', '.join(RIVALS)}")
    return found


def _baseline(seconds: float) -> Contender:
    from benchmarks.paper_baseline import PaperBaseline

    return PaperBaseline(seconds)


def _cpsat(seconds: float) -> Contender:
    from benchmarks.cpsat import CpSat

    return CpSat(seconds)


#: Rivals by name, made ready with their seconds for one variation.
RIVALS: Mapping[str, Callable[[float], Contender]] = {"baseline": _baseline, "cpsat": _cpsat}


def measured_design(name: str, arguments: argparse.Namespace, rivals: Sequence[str]) -> dict[str, Any]:
    """Run all contenders on one design; return the figures."""
    facade = DESIGNS[name]()
    ours = measure(facade, Ours(arguments.node_limit), arguments.seeds, len(SCALES))
    others = {
        rival: measure(facade, RIVALS[rival](arguments.time_limit), arguments.rival_seeds, 0)
        for rival in rivals
    }
    paper = TABLE[name].milliseconds
    return {
        "name": name,
        "counts": counts(facade),
        "paper": paper,
        "compile": _compile_milliseconds(facade),
        "ours": _figures(ours),
        "rivals": {rival: _figures(measured) for rival, measured in others.items()},
        "share_of_paper": ours.mean / paper,
        "times_faster": {rival: measured.least / ours.mean for rival, measured in others.items()},
        "met": {
            "paper": ours.mean <= AIM * paper,
            "rivals": all(ours.mean <= AIM * measured.least for measured in others.values()),
            "success": ours.success == 1.0,
        },
    }


def _compile_milliseconds(facade: Facade) -> float:
    start = time.perf_counter()
    Model(facade)
    return 1000 * (time.perf_counter() - start)


def measure(facade: Facade, contender: Contender, seeds: int, apart: int) -> Measured:
    """Make variations at all sizes in turn, of which the first ones may stand apart."""
    sizes: list[Size] = [(facade.root.width * x, facade.root.height * y) for x, y in SCALES]
    makers = [contender.maker(facade, size) for size in sizes]
    turns = ((seed, seed % len(sizes)) for seed in range(seeds))
    trials = [trial(facade, sizes[turn], makers[turn], seed) for seed, turn in turns]
    return Measured(contender.name, tuple(trials[:apart]), tuple(trials[apart:]))


def _figures(measured: Measured) -> dict[str, Any]:
    times = [t.milliseconds for t in measured.found]
    failed = [t for t in (*measured.firsts, *measured.trials) if t.status != "found"]
    return {
        "trials": len(measured.firsts) + len(measured.trials),
        "success": measured.success,
        "statuses": dict(Counter(t.status for t in (*measured.firsts, *measured.trials))),
        "first": _mean(t.milliseconds for t in measured.firsts),
        "mean": measured.mean,
        "median": statistics.median(times) if times else math.nan,
        "max": max(times, default=math.nan),
        "processor": _mean(t.processor for t in measured.found),
        "checking": _mean(t.checking for t in measured.found),
        "terminals": _mean(t.terminals for t in measured.found),
        "failed": [asdict(t) for t in failed],
    }


def _without_nan(data: Any) -> Any:
    """Return data with None for what is not a number: JSON has no word for it."""
    if isinstance(data, Mapping):
        return {key: _without_nan(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [_without_nan(value) for value in data]
    return None if isinstance(data, float) and not math.isfinite(data) else data


def _text(row: Mapping[str, Any]) -> str:
    """Return what is to say of one design, a contender a line."""
    terminals, frequency, sequence, alignment, same_size = row["counts"]
    lines = [
        f"{row['name']}: {terminals} terminals; {frequency} frequency, {sequence} sequence, {alignment} "
        f"alignment, {same_size} same-size constraints; compiled in {row['compile']:.0f} ms; the paper's "
        f"variation takes {row['paper']:g} ms",
        _line("layoutkit", row["ours"], ""),
    ]
    for rival, figures in row["rivals"].items():
        lines.append(_line(rival, figures, f"  {row['times_faster'][rival]:.0f} times slower"))
    return "\n".join(lines)


def _line(name: str, figures: Mapping[str, Any], remark: str) -> str:
    statuses = ", ".join(f"{count} {status}" for status, count in figures["statuses"].items())
    times = "  ".join(
        f"{column} {figures[column]:9.1f}"
        for column in ("mean", "median", "max", "processor", "first", "checking")
    )
    return f"  {name:10} {times} ms  terminals {figures['terminals']:7.0f}  {statuses}{remark}"


def table(report: Sequence[Mapping[str, Any]]) -> str:
    """Return one line a design: the paper's milliseconds beside ours and the rivals', and the aims."""
    rivals = list(report[0]["rivals"]) if report else []
    heads = ["design", "terminals", "paper ms", "ours ms", "of paper", "success"]
    heads += [head for rival in rivals for head in (f"{rival} ms", "success", "ours faster")]
    lines = [[*heads, "tenth of paper", "ten times faster", "no failure"]]
    for row in report:
        cells = [row["name"], str(row["counts"][0]), f"{row['paper']:g}", f"{row['ours']['mean']:.1f}"]
        cells += [f"{row['share_of_paper']:.0%}", f"{row['ours']['success']:.1%}"]
        for rival in rivals:
            figures = row["rivals"][rival]
            cells += [f"{figures['mean']:.0f}", f"{figures['success']:.0%}"]
            cells.append(f"{row['times_faster'][rival]:.0f}×")
        met = row["met"]
        tenfold = met["rivals"] if rivals else None
        lines.append([*cells, *(_met(aim) for aim in (met["paper"], tenfold, met["success"]))])
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]
    padded = ([cell.rjust(width) for cell, width in zip(line, widths, strict=True)] for line in lines)
    return "\n".join("  ".join(line) for line in padded)


def _met(aim: bool | None) -> str:
    return {True: "met", False: "not met", None: "-"}[aim]


if __name__ == "__main__":
    main()
