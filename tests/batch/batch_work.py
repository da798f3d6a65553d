"""Work for tests of batches, in a module that worker processes can import."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

from layoutkit.batch import Finished, Shared, Task
from layoutkit.batch.journal import JOURNAL_FILE
from layoutkit.diagnostics import Diagnostic, Faulty


def square(task: Task, shared: Shared) -> Finished:
    """Write a square, and leave a trace where `trace` names a folder: a file for each time it is done."""
    number = task.arguments["number"]
    if "trace" in task.arguments:
        Path(
            task.arguments["trace"], f"{task.key.replace('/', '-')}.{os.getpid()}.{os.urandom(4).hex()}"
        ).touch()
        time.sleep(0.03)  # so that another worker gets something to do
    data = f"{number * number}\n".encode() + shared.files.get("tail", b"")
    return Finished(task.key, "done", ((f"{task.key}.txt", data),), {"number": number})


def killed_once(task: Task, shared: Shared) -> Finished:
    """Kill the own process, unless that has been done."""
    marker = Path(task.arguments["marker"])
    if not marker.exists():
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return square(task, shared)


def deadly(task: Task, shared: Shared) -> Finished:
    """Kill the own process."""
    os.kill(os.getpid(), signal.SIGKILL)
    raise AssertionError("it is dead")


def faulty(task: Task, shared: Shared) -> Finished:
    raise Faulty([Diagnostic("LK203", f"{task.key} cannot be")])


def crashing(task: Task, shared: Shared) -> Finished:
    raise KeyError("seven")


def unspeakable(task: Task, shared: Shared) -> Finished:
    """Return what no other process can be told."""
    return Finished(task.key, "done", (), {"lock": threading.Lock()})


def large(task: Task, shared: Shared) -> Finished:
    return Finished(task.key, "done", ((f"{task.key}.bin", bytes(task.arguments["size"])),))


def outside(task: Task, shared: Shared) -> Finished:
    return Finished(task.key, "done", (("../outside.txt", b""),))


def contents(folder: Path) -> dict[str, bytes]:
    """Return all files of a folder but the journal, by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and path.name != JOURNAL_FILE
    }
