"""What results come to: means over splits, and over operations."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass

import numpy as np

from benchmarks.placement.matching import Judged, Quality, at_threshold, best
from benchmarks.placement.protocol import Result

#: The paper's table is of the mean over these numbers of examples.
TYPICAL = (2, 3, 4, 5)


@dataclass(frozen=True, slots=True)
class Figures:
    """One operation, one method, one number of examples.

    Attributes
    ----------
    f1, spread
        Mean and standard deviation over splits, each at its own best threshold.
    precision, recall
        Means over splits, at the same thresholds.
    common_f1
        F1 at the one threshold that is best for all proposals of all splits together.
    proposals
        How many there are in the mean in a split, whatever their score.
    fitting, proposing
        Median seconds to learn, and to propose in one scene.
    """

    operation: str
    method: str
    examples: int
    splits: int
    f1: float
    spread: float
    precision: float
    recall: float
    common_f1: float
    proposals: float
    fitting: float
    proposing: float


def figures(results: Iterable[Result]) -> tuple[Figures, ...]:
    """Return the figures of each operation, method and number of examples."""
    groups: dict[tuple[str, str, int], list[Result]] = {}
    for result in results:
        groups.setdefault((result.operation, result.method, result.examples), []).append(result)
    return tuple(_figures(group) for group in groups.values())


def _figures(group: Sequence[Result]) -> Figures:
    qualities = [result.quality for result in group]
    every = [quality.f1 for quality in qualities]
    together = Judged.together([result.found for result in group])
    return Figures(
        group[0].operation,
        group[0].method,
        group[0].examples,
        len(group),
        statistics.fmean(every),
        statistics.stdev(every) if len(every) > 1 else 0.0,
        statistics.fmean(quality.precision for quality in qualities),
        statistics.fmean(quality.recall for quality in qualities),
        _common(group, best(together)),
        statistics.fmean(len(result.found.scores) for result in group),
        statistics.median(result.fitting for result in group),
        statistics.median(result.proposing for result in group),
    )


def _common(group: Sequence[Result], at: Quality) -> float:
    return statistics.fmean(at_threshold(result.found, at.threshold).f1 for result in group)


@dataclass(frozen=True, slots=True)
class Column:
    """A column of the table: a method with some numbers of examples, of which the mean is taken."""

    title: str
    method: str
    examples: tuple[int, ...]

    def of(self, operation: str, found: Sequence[Figures]) -> float | None:
        """Return the mean F1 of an operation; None if any number of examples was not measured."""
        by_count = {
            each.examples: each.f1
            for each in found
            if each.operation == operation and each.method == self.method
        }
        if not set(self.examples) <= set(by_count):
            return None
        return statistics.fmean(by_count[count] for count in self.examples)


def columns(found: Sequence[Figures]) -> list[Column]:
    """Return the columns: methods with the typical numbers of examples, and what knows only one."""
    methods = dict.fromkeys(each.method for each in found)
    shown = []
    for method in methods:
        counts = {each.examples for each in found if each.method == method}
        typical = tuple(count for count in TYPICAL if count in counts) or (1,)
        shown.append(Column(method, method, typical))
        if method == "learned" and 1 in counts and typical != (1,):
            shown.append(Column("one example", method, (1,)))
    return shown


def table(found: Sequence[Figures]) -> str:
    """Return the table of F1: operations by methods, the best of each row marked, and the means."""
    shown = columns(found)
    operations = list(dict.fromkeys(each.operation for each in found))
    rows = [[column.of(operation, found) for column in shown] for operation in operations]
    means = [_mean([row[index] for row in rows]) for index in range(len(shown))]
    lines = [_line("F1", [column.title for column in shown])]
    lines += [_line(name, _marked(row)) for name, row in zip(operations, rows, strict=True)]
    return "\n".join([*lines, _line("mean", _marked(means))])


def curves(found: Sequence[Figures]) -> str:
    """Return the mean F1 over operations of each method, by the number of examples."""
    counts = sorted({each.examples for each in found})
    lines = [_line("examples", [str(count) for count in counts])]
    for method in dict.fromkeys(each.method for each in found):
        lines.append(_line(method, [_at(found, method, count, lambda own: own.f1) for count in counts]))
    return "\n".join(lines)


def details(found: Sequence[Figures]) -> str:
    """Return precision, recall, spread and time of each method: means over operations and typical numbers."""
    kinds: Mapping[str, Callable[[Figures], float]] = {
        "precision": lambda own: own.precision,
        "recall": lambda own: own.recall,
        "spread": lambda own: own.spread,
        "common": lambda own: own.common_f1,
        "proposals": lambda own: own.proposals,
        "learn ms": lambda own: 1000 * own.fitting,
        "place ms": lambda own: 1000 * own.proposing,
    }
    lines = [_line("method", list(kinds))]
    for column in columns(found):
        own = [f for f in found if f.method == column.method and f.examples in column.examples]
        values = [statistics.fmean(map(kind, own)) for kind in kinds.values()]
        shown = [f"{value:.2f}" if index < 4 else f"{value:.0f}" for index, value in enumerate(values)]
        lines.append(_line(column.title, shown))
    return "\n".join(lines)


def plain(found: Sequence[Figures]) -> list[dict[str, object]]:
    """Return all figures as JSON has them."""
    return [asdict(each) for each in found]


def _at(found: Sequence[Figures], method: str, count: int, kind: Callable[[Figures], float]) -> str:
    own = [kind(each) for each in found if each.method == method and each.examples == count]
    return f"{statistics.fmean(own):.2f}" if own else "-"


def _mean(values: Sequence[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return statistics.fmean(known) if known and len(known) == len(values) else None


def _marked(row: Sequence[float | None]) -> list[str]:
    highest = max((value for value in row if value is not None), default=np.inf)
    return ["-" if v is None else f"{v:.2f}{'*' if v == highest > 0 else ''}" for v in row]


def _line(name: str, cells: Sequence[str]) -> str:
    return f"{name:<14}" + "".join(f"{cell:>13}" for cell in cells)
