"""What a command takes: time, processor time, and the memory of all its processes."""

from __future__ import annotations

import contextlib
import hashlib
import os
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

#: Seconds between two looks at the memory.
_LOOK = 0.05
_MEGABYTE = 1024 * 1024


@dataclass(frozen=True, slots=True)
class Taken:
    """What a command took.

    Attributes
    ----------
    seconds, processor
        By the clock, and of all processors together.
    memory
        The greatest sum of the resident memory of its processes that was seen, in megabytes: what they share
        counts for each of them.
    greatest
        The greatest resident memory of one process, in megabytes.
    code
        How it ended.
    """

    seconds: float
    processor: float
    memory: float
    greatest: float
    code: int


def taken(command: Sequence[str], log: Path) -> Taken:
    """Run a command, and return what it took; what it says goes into a file."""
    start = time.perf_counter()
    with log.open("wb") as out:
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
        with _watched(process.pid) as seen:
            # Unlike `wait`, this tells what the process and those that it waited for have used.
            _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return Taken(
        time.perf_counter() - start,
        used.ru_utime + used.ru_stime,
        max(seen) / _MEGABYTE,
        used.ru_maxrss / 1024,
        process.returncode,
    )


def digest(folder: Path) -> str:
    """Return the SHA-256 of all files of a folder and their names, but for hidden ones."""
    whole = hashlib.sha256()
    for path in sorted(_files(folder)):
        whole.update(f"{path.relative_to(folder)}\0".encode())
        whole.update(hashlib.sha256(path.read_bytes()).digest())
    return whole.hexdigest()


def size(folder: Path) -> int:
    """Return how many bytes the same files have."""
    return sum(path.stat().st_size for path in _files(folder))


def _files(folder: Path) -> Iterator[Path]:
    return (path for path in folder.rglob("*") if path.is_file() and not path.name.startswith("."))


@contextlib.contextmanager
def _watched(pid: int) -> Iterator[list[int]]:
    """Look at the resident memory of a process and its descendants, until the block ends."""
    seen, ended = [0], threading.Event()

    def look() -> None:
        while not ended.wait(_LOOK):
            seen.append(_resident(pid))

    thread = threading.Thread(target=look)
    thread.start()
    try:
        yield seen
    finally:
        ended.set()
        thread.join()


def _resident(pid: int) -> int:
    """Return the resident memory of a process and its descendants, in bytes."""
    import psutil  # type: ignore[import-untyped]

    total = 0
    with contextlib.suppress(psutil.NoSuchProcess):
        root = psutil.Process(pid)
        for process in (root, *root.children(recursive=True)):
            with contextlib.suppress(psutil.NoSuchProcess, psutil.AccessDenied):
                total += process.memory_info().rss
    return total
