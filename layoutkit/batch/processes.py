"""Tasks by processes of this machine.

Each has one task at a time, so that it is known which task a process died of; the next one is handed over
before the result of the last is looked at.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import sys
from collections import Counter, deque
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import cast

from layoutkit.batch.interrupts import without_interrupts
from layoutkit.batch.runners import Held
from layoutkit.batch.task import Finished, Shared, Source, Task, failed, perform
from layoutkit.diagnostics import Diagnostic, Faulty, blame
from layoutkit.sizing.threads import begin_single_threaded

#: A task of which so many workers died is not tried again.
MOST_DEATHS = 3
#: How many shared inputs a worker holds.
_HELD = 2
#: What a worker says first.
_READY = b""


@dataclass(frozen=True)
class Processes:
    """Does tasks in processes of their own.

    Attributes
    ----------
    count
        How many processes.
    """

    count: int

    def run(self, tasks: Iterable[Task]) -> Generator[Finished, None, None]:
        """Yield what comes of each task; one whose worker died is given to another.

        Raises
        ------
        Faulty
            If processes cannot be started (LK895).
        """
        queue, workers = _Queue(iter(tasks)), dict[Connection, _Worker]()
        try:
            while True:
                while len(workers) < self.count and queue.suffices(1 + _starting(workers.values())):
                    worker = _Worker.started()
                    workers[worker.connection] = worker
                if not workers:
                    return
                for connection in cast("list[Connection]", wait(list(workers))):
                    finished = _heard(workers[connection], queue)
                    if not workers[connection].goes_on(queue):
                        workers.pop(connection).stop()
                    if finished is not None:
                        yield finished
        finally:
            for worker in workers.values():
                worker.stop()


def _starting(workers: Iterable[_Worker]) -> int:
    """Return how many processes are there that have no task yet."""
    return sum(worker.task is None for worker in workers)


def _heard(worker: _Worker, queue: _Queue) -> Finished | None:
    """Return what a worker has made; None where it has only begun, or died and its task is for another."""
    task, worker.task = worker.task, None
    try:
        said = worker.connection.recv_bytes()
    except (EOFError, OSError):
        return queue.lost(task, worker.ended())
    queue.false_starts = 0
    if task is None:
        return None
    made = pickle.loads(said)
    return made if isinstance(made, Finished) else failed(task.key, made)


@dataclass
class _Queue:
    """The tasks that are still to be done, and what is known of those that workers died of.

    Attributes
    ----------
    false_starts
        How many processes in a row have died before they began.
    """

    tasks: Iterator[Task]
    false_starts: int = 0
    _again: deque[Task] = field(default_factory=deque)
    _deaths: Counter[str] = field(default_factory=Counter)
    _held: Held = field(default_factory=Held)

    @property
    def waiting(self) -> bool:
        """Whether there is another task."""
        return self.suffices(1)

    def suffices(self, workers: int) -> bool:
        """Tell whether there are tasks for so many workers."""
        self._again.extend(islice(self.tasks, max(0, workers - len(self._again))))
        return len(self._again) >= workers

    def next(self) -> Task:
        """Return the next task; there has to be one."""
        return self._again.popleft()

    def back(self, task: Task) -> None:
        """Take back a task that was not begun."""
        self._again.appendleft(task)

    def load(self, source: Source) -> Shared | Faulty:
        """Return the inputs of a task; or why they cannot be had."""
        return self._held.load(source)

    def lost(self, task: Task | None, how: str) -> Finished | None:
        """Take back a task whose worker has died; return its failure if that was once too often.

        Raises
        ------
        Faulty
            If there was no task, and that was once too often.
        """
        if task is None:
            self.false_starts += 1
            if self.false_starts < MOST_DEATHS:
                return None
            message = f"worker processes end before they have begun: {how}"
            hint = "run without --workers to see what is wrong"
            raise Faulty([Diagnostic("LK895", message, hint=hint, topic="batch")])
        self._deaths[task.key] += 1
        if self._deaths[task.key] < MOST_DEATHS:
            self.back(task)
            return None
        return failed(task.key, [deadly(task.key, how)])


def deadly(key: str, how: str) -> Diagnostic:
    """Return the diagnostic of a task that workers die of."""
    message = f"{MOST_DEATHS} workers died of the task {key}: {how}"
    hint = "it may need more memory than there is: try fewer workers, or a smaller task"
    return Diagnostic("LK892", message, hint=hint, topic="batch")


@dataclass
class _Worker:
    """A process, as the one that started it sees it.

    Attributes
    ----------
    task
        What it is doing.
    holds
        Digests of the inputs that it was given last.
    """

    process: SpawnProcess
    connection: Connection
    task: Task | None = None
    holds: deque[str] = field(default_factory=lambda: deque(maxlen=_HELD))

    @classmethod
    def started(cls) -> _Worker:
        # Not forked: a copy of a process with threads may hang, and a new one is the same everywhere.
        context = get_context("spawn")
        connection, other = context.Pipe()
        process = context.Process(target=_serve, args=(other,), daemon=True)
        with without_interrupts():
            process.start()
        other.close()  # else the end of the process would not be the end of the connection
        return cls(process, connection)

    def goes_on(self, queue: _Queue) -> bool:
        """Give it the next task; tell whether there is one, and the process to do it."""
        if self.process.exitcode is not None or not queue.waiting:
            return False
        task = self.task = queue.next()
        given: Shared | tuple[Diagnostic, ...] | None = None
        if task.source.digest not in self.holds:
            loaded = queue.load(task.source)
            given = loaded.diagnostics if isinstance(loaded, Faulty) else loaded
        if isinstance(given, Shared):
            self.holds.append(given.digest)
        with contextlib.suppress(OSError):  # it has died just now, which is heard next
            self.connection.send_bytes(pickle.dumps((pickle.dumps(task.alone), given)))
        return True

    def ended(self) -> str:
        """Return how the process ended."""
        self.process.join()
        code = self.process.exitcode or 0
        return f"killed by {signal.Signals(-code).name}" if code < 0 else f"it ended with exit code {code}"

    def stop(self) -> None:
        """End it, whatever it is doing."""
        self.connection.close()
        self.process.kill()
        self.process.join()
        self.process.close()


def _serve(connection: Connection) -> None:
    """Do tasks until the connection ends: that is what a worker process runs."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    begin_single_threaded()
    os.dup2(sys.__stderr__.fileno() if sys.__stderr__ else 2, 1)  # stdout is for results of the command
    held: dict[str, Shared] = {}
    with contextlib.suppress(EOFError, OSError):
        connection.send_bytes(_READY)
        while True:
            connection.send_bytes(_answer(connection.recv_bytes(), held))


def _answer(message: bytes, held: dict[str, Shared]) -> bytes:
    """Return what came of a task, pickled; of one that cannot be read or told, only diagnostics."""
    packed, given = pickle.loads(message)
    if isinstance(given, Shared):
        held[given.digest] = given
        while len(held) > _HELD:
            del held[next(iter(held))]  # in the order in which `_Worker.holds` forgets them
    try:
        task: Task = pickle.loads(packed)
        if isinstance(given, tuple):
            return pickle.dumps(failed(task.key, given))
        return pickle.dumps(perform(task, held[task.source.digest]))
    except blame.ANYTHING as error:
        return pickle.dumps((blame.unforeseen(error),))
