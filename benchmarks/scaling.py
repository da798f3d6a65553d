"""How time and memory grow with the number of terminals: facades of one style, from 100 to 100,000.

    python -m benchmarks.scaling [--terminals 100,1000,10000,100000] [--seeds 8] [--json FILE]

Each facade is laid out anew at its own size, in a process of its own whose greatest memory is read at the
end. Storeys, columns and the number of distinct symbols grow together. The last line is the slope of a line
through the logarithms of terminals and milliseconds: 1 is linear.
"""

from __future__ import annotations

import argparse
import json
import math
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from benchmarks.contenders import Ours, trial
from benchmarks.designs.front import front
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.model import Model

TERMINALS = (100, 300, 1000, 3000, 10_000, 30_000, 100_000)


def main() -> None:
    parser = argparse.ArgumentParser(description="time and memory of a variation, by terminals")
    parser.add_argument(
        "--terminals", default=",".join(map(str, TERMINALS)), help="about how many, at least 100"
    )
    parser.add_argument("--seeds", type=int, default=8, help="variations of each facade after the first")
    parser.add_argument("--json", type=Path, help="write all figures to this file")
    parser.add_argument("--alone", type=int, help=argparse.SUPPRESS)  # what each process is asked for
    arguments = parser.parse_args()
    if arguments.alone:
        print(json.dumps(measured(arguments.alone, arguments.seeds)))
        return
    report = []
    for count in map(int, arguments.terminals.split(",")):
        report.append(_apart(count, arguments.seeds))
        print(_line(report[-1]), flush=True)
    print(f"slope over all sizes: {slope(report):.2f} (1 is linear)")
    if arguments.json:
        arguments.json.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def _apart(terminals: int, seeds: int) -> dict[str, Any]:
    command = [sys.executable, "-m", "benchmarks.scaling", "--alone", str(terminals), "--seeds", str(seeds)]
    ended = subprocess.run(command, check=True, capture_output=True, text=True)
    found: dict[str, Any] = json.loads(ended.stdout)
    return found


def measured(terminals: int, seeds: int) -> dict[str, Any]:
    """Return the figures of one facade."""
    facade = front(terminals)
    size = (facade.root.width, facade.root.height)
    start = time.perf_counter()
    Model(facade)
    compiled = time.perf_counter() - start
    with single_threaded():
        maker = Ours().maker(facade, size)
        first = trial(facade, size, maker, 0)
        trials = [trial(facade, size, maker, seed) for seed in range(1, seeds + 1)]
    found = [t for t in trials if t.status == "found"]
    return {
        "asked": terminals,
        "regions": len(facade.regions),
        "compile": 1000 * compiled,
        "first": first.milliseconds,
        "success": len(found) / len(trials),
        "terminals": statistics.fmean(t.terminals for t in found) if found else 0.0,
        "milliseconds": statistics.fmean(t.milliseconds for t in found) if found else math.inf,
        "checking": statistics.fmean(t.checking for t in found) if found else math.inf,
        "megabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }


def _line(row: Mapping[str, Any]) -> str:
    share = 1000 * row["milliseconds"] / max(1.0, row["terminals"])
    return (
        f"{row['terminals']:9.0f} terminals  {row['regions']:4d} distinct regions  "
        f"compile {row['compile']:7.1f} ms  first {row['first']:9.1f} ms  "
        f"variation {row['milliseconds']:9.1f} ms ({share:.2f} ms a thousand)  "
        f"check {row['checking']:8.1f} ms  memory {row['megabytes']:6.0f} MB  success {row['success']:.0%}"
    )


def slope(report: Sequence[Mapping[str, Any]]) -> float:
    """Return the slope of the least-squares line through the logarithms of terminals and milliseconds."""
    points = [(r["terminals"], r["milliseconds"]) for r in report if math.isfinite(r["milliseconds"])]
    if len(points) < 2:
        return math.nan
    x, y = ([math.log(point[i]) for point in points] for i in (0, 1))
    return statistics.linear_regression(x, y).slope


if __name__ == "__main__":
    main()
