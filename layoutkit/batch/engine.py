"""A run from its plan to its manifest: what is done already is left, all else is done and kept."""

from __future__ import annotations

import contextlib
import json
import re
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from layoutkit import __version__
from layoutkit.batch.journal import Journal
from layoutkit.batch.plan import Plan
from layoutkit.batch.record import Record, Written
from layoutkit.batch.runners import Runner
from layoutkit.batch.task import Finished, Task
from layoutkit.diagnostics import Diagnostic, Faulty, Place

MANIFEST_FILE = "manifest.json"
#: What `layoutkit.documents.save` calls a file that is not yet whole.
_PART = re.compile(r"\..+\.\d+-\d+\.part")


@dataclass(frozen=True)
class Report:
    """How a run ended.

    Attributes
    ----------
    done, failed
        How many tasks, those of earlier runs included.
    kept
        How many of them had been done by earlier runs.
    """

    done: int
    failed: int
    kept: int
    manifest: Path


@dataclass(frozen=True)
class Watching:
    """What is called while a run goes on, in the process that began it.

    Attributes
    ----------
    begin
        With the numbers of all tasks, and of those that earlier runs have done.
    finish
        With what came of each task, once it is kept.
    """

    begin: Callable[[int, int], None] = lambda total, kept: None
    finish: Callable[[Finished], None] = lambda finished: None


def carry_out(
    plan: Plan, folder: Path, runner: Runner, watching: Watching = Watching(), *, afresh: bool = False
) -> Report:
    """Do what a plan says, and write the results into a folder.

    If the folder has the journal of an earlier run of the same plan, what it lists as done, and what is still
    there, is not done again; tasks that failed are. The same plan gives the same bytes, however often the
    run is interrupted, and whatever runs it; but for the journal, the folder is the same.

    Parameters
    ----------
    watching
        Is told how it goes on.
    afresh
        Whether to begin anew: what an earlier run of any plan has written there is deleted.

    Raises
    ------
    Faulty
        If the folder has results of another plan (LK890), another run is at work there (LK891), something
        cannot be written (LK008), or the runner has nothing that could do the tasks.
    """
    journal = Journal.opened(folder)
    try:
        done = _earlier(journal, plan, folder, afresh)
        copies = [copied for name, path in plan.copies.items() for copied in _copied(name, path, folder)]
        if done is None:
            journal.begin(plan, copies)
            done = set()
        kept = len(done)
        watching.begin(len(plan.tasks), kept)
        waiting = [task for task in plan.tasks if task.key not in done]
        with contextlib.closing(_finished(runner, waiting)) as finished_ones:
            for finished in finished_ones:
                _write(finished, folder)
                journal.add(Record.of_finished(finished))
                if finished.status == "done":
                    done.add(finished.key)
                watching.finish(finished)
        manifest = folder / MANIFEST_FILE
        _save(manifest, b"".join(_manifest(plan, copies, journal)))
    finally:
        journal.close()
    return Report(len(done), len(plan.tasks) - len(done), kept, manifest)


def _finished(runner: Runner, tasks: Sequence[Task]) -> Generator[Finished, None, None]:
    """Yield what comes of tasks; where there are none, no worker is started."""
    if tasks:
        yield from runner.run(iter(tasks))


def _earlier(journal: Journal, plan: Plan, folder: Path, afresh: bool) -> set[str] | None:
    """Return the keys of tasks that an earlier run has done; None where the journal is to begin.

    Raises
    ------
    Faulty
        If the folder has results of another plan (LK890).
    """
    header, records = journal.header(), list(journal.records())
    if header.get("fingerprint") == plan.fingerprint and not afresh:
        _sweep(folder)
        done = (record for record in records if record.status == "done")
        return {record.key for record in done if all(file.stands(folder) for file in record.files)}
    if not afresh and any(record.status == "done" for record in records):
        command = header.get("command", "another program")
        what = "inputs, options or releases of libraries"
        message = f"the folder has results of another run: of `{command}`, with other {what}"
        hint = "name another folder with -o; or begin anew in this one with --afresh, which deletes them"
        raise Faulty([Diagnostic("LK890", message, Place(str(folder)), hint, topic="batch")])
    if afresh or records:  # of what failed, nobody needs what there is
        _clear(journal, folder)
    return None


def _sweep(folder: Path) -> None:
    """Delete what a run that was killed has half written."""
    for path in folder.rglob(".*.part"):
        if _PART.fullmatch(path.name):
            path.unlink(missing_ok=True)


def _clear(journal: Journal, folder: Path) -> None:
    """Delete what an earlier run has written, and nobody has changed since."""
    written = [file for record in journal.records() for file in record.files]
    for file in (*journal.copies(), *written):
        if file.stands(folder):
            path = folder / file.name
            path.unlink(missing_ok=True)
            _prune(path.parent, folder)
    (folder / MANIFEST_FILE).unlink(missing_ok=True)


def _prune(inner: Path, folder: Path) -> None:
    """Delete folders that are empty, from an inner one outwards."""
    with contextlib.suppress(OSError):  # there is something left in it
        while inner != folder:
            inner.rmdir()
            inner = inner.parent


def _write(finished: Finished, folder: Path) -> None:
    for name, data in finished.files:
        path = PurePosixPath(name)
        if path.is_absolute() or ".." in path.parts:
            raise ValueError(f"the task {finished.key} would write outside of the folder of results: {name}")
        _save(folder / path, data)


def _save(path: Path, data: bytes) -> None:
    from layoutkit.documents.files import save

    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        message = f"the folder cannot be made: {error.strerror or error}"
        hint = "name another folder with -o, or make room and permissions for this one"
        raise Faulty([Diagnostic("LK008", message, Place(str(path.parent)), hint, topic="file")]) from error
    save(path, data)


def _copied(name: str, path: Path, folder: Path) -> Iterator[Written]:
    """Copy a file, unless the same is there; yield what was written, nothing if it cannot be read."""
    from layoutkit.documents.files import load

    with contextlib.suppress(Faulty):
        data = load(path)
        written = Written.of(name, data)
        if not written.stands(folder):
            _save(folder / name, data)
        yield written


def _manifest(plan: Plan, copies: list[Written], journal: Journal) -> Iterator[bytes]:
    """Yield the manifest in parts: an entry a line, in the order of tasks."""
    head = {
        "command": plan.command,
        "layoutkit": __version__,
        "fingerprint": plan.fingerprint,
        "options": plan.options,
        "copies": [written.as_data() for written in copies],
    }
    yield json.dumps(head, indent=1).removesuffix("\n}").encode() + b',\n "entries": ['
    for number, task in enumerate(plan.tasks):
        entry = json.dumps(journal.record(task.key).as_data(), ensure_ascii=False)
        # A file's name may have what is no text: escaped as JSON escapes it.
        yield (b",\n  " if number else b"\n  ") + entry.encode(errors="backslashreplace")
    yield b"\n ]\n}\n"
