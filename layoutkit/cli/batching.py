"""What commands that do many tasks share: where they are done, how that is shown, and how it ends."""

from __future__ import annotations

import os
import sys
import time
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.editing import misused
from layoutkit.cli.exits import EXITS, Exit, exit_of
from layoutkit.cli.meter import Meter, meter
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Place, Severity

if TYPE_CHECKING:
    from layoutkit.batch import Finished, Plan, Report, Runner

#: So many different failures, and so many kinds of remarks, are told on the terminal; the manifest has all.
SHOWN = 20
#: So many remarks of one kind are told.
_OF_A_KIND = 2
#: More seeds than these are a slip.
MOST_SEEDS = 1_000_000

#: What remarks have in common that differ only in what they name.
_Kind = tuple[str, Severity, Place | None]
#: What counts only if all tasks say so: one tile may have nothing to choose where another has.
_UNANIMOUS = frozenset({"LK888"})
#: Remarks of kinds that are not told.
_OTHERS: _Kind = ("", Severity.NOTE, None)

#: Where several apply, the first of these is how the run ends.
_GRAVEST = (Exit.INTERNAL, Exit.PLUGIN, Exit.USAGE, Exit.FAULTS, Exit.INFEASIBLE, Exit.LIMIT)


@dataclass(frozen=True)
class Seeds:
    """Seeds as a user lists them."""

    numbers: tuple[int, ...]

    @classmethod
    def parse(cls, text: str) -> Seeds:
        """Read numbers and ranges, separated by commas: ``0-9``, or ``1,5,7``; each seed counts once.

        Raises
        ------
        ValueError
            If it is no such list, or a very long one.
        """
        found: dict[int, None] = {}
        for part in text.split(","):
            first, dash, last = part.strip().partition("-")
            if not _digits(first) or (dash and not _digits(last)):
                raise ValueError(
                    f"{part.strip() or 'nothing'} is no seed (such as 7) and no range (such as 0-9)"
                )
            start, end = int(first), int(last or first)
            if end < start:
                raise ValueError(f"the range {part.strip()} ends before it begins")
            if end - start >= MOST_SEEDS - len(found):
                raise ValueError(f"{text} are more than {MOST_SEEDS:,} seeds")
            found.update(dict.fromkeys(range(start, end + 1)))
        return cls(tuple(found))

    def __str__(self) -> str:
        return ",".join(map(str, self.numbers))


def read_seeds(text: str | Seeds) -> Seeds:
    """Read seeds; typer also hands defaults in."""
    if isinstance(text, Seeds):
        return text
    try:
        return Seeds.parse(text)
    except ValueError as error:
        raise typer.BadParameter(str(error)) from None


SeedList = Annotated[
    Seeds,
    typer.Option(
        "--seeds",
        parser=read_seeds,
        metavar="SEEDS",
        help="Starts of random choices, such as 0-9 or 1,5,7: the same seed gives the same bytes.",
    ),
]
#: Of commands that are given none.
FIRST_SEED = Seeds((0,))
Workers = Annotated[
    int | None,
    typer.Option(
        min=1,
        show_default=False,
        help="Processes that share the work. By default there is but this one; with a local scheduler, "
        "as many as the machine has processors.",
    ),
]
Scheduler = Annotated[
    str | None,
    typer.Option(
        metavar="WHERE",
        show_default=False,
        help="Hand the work to Dask: `local` starts a cluster on this machine; an address, such as "
        "tcp://10.0.0.1:8786, names a scheduler that runs.",
    ),
]
Afresh = Annotated[
    bool,
    typer.Option("--afresh", help="Begin anew, and delete what an earlier run has written into the folder."),
]


def runner_of(session: Session, workers: int | None, scheduler: str | None) -> Runner:
    """Return what does the work, as the options name it.

    Raises
    ------
    Faulty
        If they do not go together.
    """
    if scheduler is not None:
        from layoutkit.batch.cluster import LOCAL, Cluster

        if workers is not None and scheduler != LOCAL:
            message = "--workers is for this machine, and the scheduler has workers of its own"
            raise misused(message, "leave --workers away; `dask worker` starts more of them")
        from layoutkit.cli.remote import options_of

        without = frozenset(options_of(session)["without"])
        return Cluster(scheduler, workers or os.cpu_count() or 1, without, session.report)
    if workers is not None:
        from layoutkit.batch.processes import Processes

        return Processes(workers)
    from layoutkit.batch import InProcess

    return InProcess()


def plugins_of(session: Session) -> dict[str, str]:
    """Return the plugins of others that take part, with their releases, for the manifest."""
    others = ((name, origin) for name, origin in session.host.origins.items() if not origin.ours)
    return {name: f"{origin.package} {origin.version}" for name, origin in others}


def carried_out(
    session: Session,
    plan: Plan,
    folder: Path,
    runner: Runner,
    *,
    afresh: bool = False,
    as_json: bool = False,
    what: str = "tasks",
    files: Mapping[str, str] | None = None,
) -> int:
    """Do what a plan says, show how far it is, and tell how it ended; return the exit code.

    Parameters
    ----------
    what
        What users call the tasks, in the plural.
    files
        What the user calls files that tasks know by other names.

    Raises
    ------
    Faulty
        As `layoutkit.batch.carry_out` does.
    KeyboardInterrupt
        Once it is told how to go on.
    """
    from layoutkit.batch import Watching, carry_out

    outcome, shown, start = _Outcome(files or {}), meter(what), time.monotonic()

    def finish(finished: Finished) -> None:
        shown.advance(finished.status == "failed")
        outcome.add(finished)

    try:
        with shown:
            report = carry_out(plan, folder, runner, Watching(shown.begin, finish), afresh=afresh)
    except KeyboardInterrupt:
        _tell_how_to_go_on(shown, what)
        raise
    outcome.sort([task.key for task in plan.tasks])
    outcome.tell(session)
    if as_json:
        console.emit(_as_data(session, report, folder, outcome, time.monotonic() - start))
    else:
        console.say(_sentence(report, what))
    return outcome.exit


@dataclass
class _Outcome:
    """What is kept in memory of finished tasks: what there is to tell at the end, and no more.

    Attributes
    ----------
    files
        What the user calls files that tasks know by other names.
    remarks
        Of tasks that were done, the first different ones of each kind.
    more
        How many others there were of each kind.
    done
        How many tasks were done.
    unanimous
        Remarks that count if all tasks have them, and how many have.
    failures
        The tasks that failed with the same diagnostics, of the first different ones.
    failed
        Of all that failed: the task, how its search ended if it did, and codes.
    """

    files: Mapping[str, str] = field(default_factory=dict)
    remarks: dict[_Kind, list[Diagnostic]] = field(default_factory=dict)
    more: Counter[_Kind] = field(default_factory=Counter)
    done: int = 0
    unanimous: dict[_Kind, tuple[Diagnostic, int]] = field(default_factory=dict)
    failures: dict[tuple[Diagnostic, ...], list[str]] = field(default_factory=dict)
    failed: list[dict[str, Any]] = field(default_factory=list)
    _exits: set[Exit] = field(default_factory=set)

    def add(self, finished: Finished) -> None:
        """Take note of a task."""
        if finished.status == "done":
            self.done += 1
            for remark in finished.diagnostics:
                self._add_remark(remark)
            return
        told = tuple(d for d in finished.diagnostics if d.severity is not Severity.NOTE)
        if told in self.failures or len(self.failures) < SHOWN:
            self.failures.setdefault(told, []).append(finished.key)
        status = finished.summary.get("status", "failed")
        codes = sorted({d.code for d in told})
        self.failed.append({"task": finished.key, "status": status, "codes": codes})
        self._exits.add(_exit(status, told))

    def _add_remark(self, remark: Diagnostic) -> None:
        """Take note of a remark: on one task, or on many that are alike already."""
        kind = remark.code, remark.severity, remark.place
        if remark.code in _UNANIMOUS:
            first, count = self.unanimous.get(kind, (remark, 0))
            self.unanimous[kind] = first, count + 1
            return
        if kind not in self.remarks and len(self.remarks) == SHOWN:
            self.more[_OTHERS] += remark.count
            return
        known = self.remarks.setdefault(kind, [])
        if known and (remark.count > 1 or (remark not in known and len(known) == _OF_A_KIND)):
            self.more[kind] += remark.count
        elif remark not in known:
            known.append(remark)

    def sort(self, keys: Sequence[str]) -> None:
        """Bring failures into the order of tasks: they came as workers were done."""
        order = {key: number for number, key in enumerate(keys)}
        self.failed.sort(key=lambda failure: order[failure["task"]])
        for alike in self.failures.values():
            alike.sort(key=order.__getitem__)
        self.failures = dict(sorted(self.failures.items(), key=lambda item: order[item[1][0]]))

    @property
    def exit(self) -> Exit:
        """How the run ends: as the gravest failure does."""
        return next((code for code in _GRAVEST if code in self._exits), Exit.DONE)

    def tell(self, session: Session) -> None:
        """Tell what was remarked, which tasks failed, and why; those that failed alike together."""
        for kind, known in self.remarks.items():
            self._report(session, known)
            if more := self.more[kind]:
                message = f"and {more:,} more of this kind"
                self._report(session, [replace(known[0], message=message, count=more)])
        self._report(session, [first for first, count in self.unanimous.values() if count == self.done])
        if more := self.more[_OTHERS]:
            print(f"and {more:,} more remarks of other kinds; the manifest has all", file=sys.stderr)
        for diagnostics, keys in self.failures.items():
            print(f"failed: {_some(keys)}", file=sys.stderr)
            self._report(session, diagnostics)
        told = sum(map(len, self.failures.values()))
        if told < len(self.failed):
            print(f"and {len(self.failed) - told} more failed; the manifest has all", file=sys.stderr)

    def _report(self, session: Session, diagnostics: Iterable[Diagnostic]) -> None:
        """Report diagnostics, their files named as the user does."""
        session.report(
            replace(d, place=replace(d.place, file=self.files.get(d.place.file, d.place.file)))
            if d.place is not None
            else d
            for d in diagnostics
        )


def _exit(status: str, diagnostics: Iterable[Diagnostic]) -> Exit:
    """Return how a task that failed would have ended a run of its own."""
    code = exit_of(diagnostics)
    if code in (Exit.DONE, Exit.FAULTS):
        return next((own for name, own in EXITS.items() if name == status), Exit.FAULTS)
    return code


def _some(keys: list[str]) -> str:
    rest = len(keys) - 3
    return ", ".join(keys[:3]) + (f" and {rest:,} more" if rest > 0 else "")


def _sentence(report: Report, what: str) -> str:
    total = report.done + report.failed
    parts = [f"{report.done} of {total} {what} done"]
    if report.kept:
        parts.append(f"{report.kept} of them before")
    if report.failed:
        parts.append(f"{report.failed} failed")
    return f"{', '.join(parts)}; {report.manifest} lists them"


def _tell_how_to_go_on(shown: Meter, what: str) -> None:
    done = f": {shown.done} of {shown.total} {what} are done" if shown.total else ""
    print(f"interrupted{done}; the same command goes on from there", file=sys.stderr)


def _as_data(
    session: Session, report: Report, folder: Path, outcome: _Outcome, seconds: float
) -> dict[str, Any]:
    return {
        "folder": str(folder),
        "manifest": str(report.manifest),
        "done": report.done,
        "failed": report.failed,
        "kept": report.kept,
        "seconds": round(seconds, 3),
        "failures": outcome.failed,
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }


def _digits(text: str) -> bool:
    return text.isascii() and text.isdigit()
