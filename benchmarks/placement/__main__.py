"""How well placements are learned, beside simpler ways, by the protocol of Guerrero et al. 2015, section 5.

    python -m benchmarks.placement [--operations sills,beds] [--methods learned,closest] [--splits 25]
                                   [--half tuning|report|all] [--jobs 2] [--smoke] [--results STEM]

In each of 25 splits an example is drawn from each of five scenes. What is learned from the first, the
first two, and so on proposes placements in other scenes (`--tests` of them). A proposal that overlaps a
shape by at least half of what both cover is right, one for each shape. F1 is taken at the threshold that is
best for these proposals, for every method alike. The table has the mean over splits and over two to five
examples.

`facades.py` and `rooms.py` say what the scenes are, `operations.py` what stands in them before
each operation, `methods.py` what is compared.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Sequence
from pathlib import Path

from benchmarks.placement import summary
from benchmarks.placement.methods import METHODS
from benchmarks.placement.operations import OPERATIONS
from benchmarks.placement.running import Plan, run

DATA = Path(__file__).parents[3] / "shared" / "data"


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.placement", description="measure placement")
    parser.add_argument("--operations", help=", ".join(each.name for each in OPERATIONS))
    parser.add_argument("--methods", help=", ".join(METHODS))
    parser.add_argument("--splits", type=int, default=25)
    parser.add_argument("--examples", default="1,2,3,4,5", help="numbers of examples")
    parser.add_argument("--tests", default="1,1", help="scenes of each split: facades, rooms")
    parser.add_argument("--half", choices=("tuning", "report", "all"), default="report", help="of the scenes")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--seed", type=int, default=0, help="of the splits")
    parser.add_argument("--smoke", action="store_true", help="one split, one scene, two numbers of examples")
    parser.add_argument("--data", type=Path, default=DATA, help="the folder of cmp/ and floorplans/")
    parser.add_argument("--results", type=Path, metavar="STEM", help="write STEM.txt and STEM.json")
    arguments = parser.parse_args(given)
    if not arguments.data.is_dir():
        parser.error(f"{arguments.data} is not a folder; name that of the real data with --data")
    plan = _plan(parser, arguments)
    start = time.monotonic()
    found = summary.figures(run(plan, arguments.jobs))
    told = _told(plan, found, time.monotonic() - start)
    print(told)
    if arguments.results:
        arguments.results.with_suffix(".txt").write_text(told + "\n", encoding="utf-8")
        figures = json.dumps(summary.plain(found), indent=1)
        arguments.results.with_suffix(".json").write_text(figures + "\n", encoding="utf-8")


def _plan(parser: argparse.ArgumentParser, arguments: argparse.Namespace) -> Plan:
    operations = _chosen(parser, "operation", arguments.operations, [each.name for each in OPERATIONS])
    methods = _chosen(parser, "method", arguments.methods, list(METHODS))
    try:
        examples = tuple(int(each) for each in arguments.examples.split(","))
        facades, rooms = (int(each) for each in arguments.tests.split(","))
    except ValueError:
        parser.error("--examples takes numbers, and --tests two, with commas between")
    if arguments.smoke:
        return Plan(operations, methods, 1, (1, 2), (1, 1), arguments.half, arguments.seed, arguments.data)
    return Plan(
        operations,
        methods,
        arguments.splits,
        examples,
        (facades, rooms),
        arguments.half,
        arguments.seed,
        arguments.data,
    )


def _chosen(
    parser: argparse.ArgumentParser, kind: str, given: str | None, known: list[str]
) -> tuple[str, ...]:
    asked = tuple(given.split(",")) if given else tuple(known)
    for name in asked:
        if name not in known:
            parser.error(f"no {kind} is called {name!r}; there are: {', '.join(known)}")
    return asked


def _command(plan: Plan) -> str:
    """Return what measures the same anywhere, whatever was left to defaults."""
    numbers = ",".join(map(str, plan.examples))
    tests = ",".join(map(str, plan.tests))
    chosen = f"--splits {plan.splits} --examples {numbers} --tests {tests}"
    methods = f" --methods '{','.join(plan.methods)}'" if plan.methods != tuple(METHODS) else ""
    every = tuple(each.name for each in OPERATIONS)
    operations = f" --operations '{','.join(plan.operations)}'" if plan.operations != every else ""
    drawn = f"--half {plan.half} --seed {plan.seed}"
    return f"python -m benchmarks.placement {chosen} {drawn}{operations}{methods}"


def _told(plan: Plan, found: tuple[summary.Figures, ...], seconds: float) -> str:
    facades, rooms = plan.tests
    heading = (
        f"{plan.splits} splits, scenes of half '{plan.half}', tried on {facades} facades or {rooms} rooms "
        f"each (seed {plan.seed}); {seconds / 60:.1f} min"
    )
    return "\n\n".join(
        [
            _command(plan),
            heading,
            "F1, mean over splits and over 2 to 5 examples (* the best):\n" + summary.table(found),
            "F1, mean over operations, by the number of examples:\n" + summary.curves(found),
            "means over operations ('common': F1 with one threshold for all splits):\n"
            + summary.details(found),
        ]
    )


if __name__ == "__main__":
    main()
