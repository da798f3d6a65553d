"""Tasks by Dask (``dask.distributed``): a cluster on this machine, or any that runs."""

from __future__ import annotations

import contextlib
import enum
import logging
import pydoc
import socket
import sys
import threading
import time
import warnings
from collections import Counter, OrderedDict
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from layoutkit import __version__
from layoutkit.batch.interrupts import without_interrupts
from layoutkit.batch.processes import deadly
from layoutkit.batch.runners import Held
from layoutkit.batch.survey import differences, survey
from layoutkit.batch.task import Finished, Shared, Source, Task, failed, perform
from layoutkit.diagnostics import Diagnostic, Faulty, Severity, blame, worst

if TYPE_CHECKING:
    from distributed import Client, Future

#: Stands for a cluster of this machine's own.
LOCAL = "local"
#: Tasks handed over for each thread of a worker: one at work, one that waits.
_EACH = 2
#: Seconds until a scheduler has to answer, and until workers have to be there.
_ANSWER, _WORKERS = 10.0, 60.0
#: How many shared inputs the workers hold, and how often a task that Dask itself gave up is sent anew.
_HELD, _AGAIN = 2, 5
#: Seconds between looks at how many workers there are.
_LOOK = 5.0
#: Dask's setting for the environment of new workers, and what silences their logs, restarted or not.
_BEFORE_START = "distributed.nanny.pre-spawn-environ.DASK_LOGGING__DISTRIBUTED"
_SILENT = "critical"
_ANY_PORT = "127.0.0.1:0"
#: Whose log goes to stderr by default.
_LOGS = ("distributed", "distributed.client", "distributed.scheduler", "distributed.nanny")


@dataclass(frozen=True)
class Cluster:
    """Does tasks on the workers of a Dask scheduler.

    Attributes
    ----------
    address
        Of a scheduler that runs, such as ``tcp://10.0.0.1:8786``; or `LOCAL`.
    workers
        Of a cluster on this machine: how many processes.
    without
        Plugins that take no part: workers need not have them.
    tell
        Is given remarks on the workers.
    """

    address: str
    workers: int
    without: frozenset[str] = frozenset()
    tell: Callable[[Iterable[Diagnostic]], None] = lambda _: None

    def run(self, tasks: Iterable[Task]) -> Generator[Finished, None, None]:
        """Yield what comes of each task; Dask does again what is lost with a worker.

        Raises
        ------
        Faulty
            If there is no such cluster, or it is gone (LK893); or its workers have other releases (LK894).
        """
        _require_dask()
        with _quiet(), contextlib.ExitStack() as open_ones:
            client = open_ones.enter_context(
                _local(self.workers) if self.address == LOCAL else self._joined()
            )
            yield from _Work(client).run(tasks)

    @contextlib.contextmanager
    def _joined(self) -> Iterator[Client]:
        """Connect to the scheduler, and look at its workers."""
        from distributed import Client

        _knock(self.address)
        try:
            client = Client(self.address, timeout=_ANSWER, set_as_default=False)
        except (OSError, ValueError) as error:
            raise _none(f"no scheduler answers at {self.address}: {blame.described(error)}") from error
        with client:
            try:
                client.wait_for_workers(1, timeout=_WORKERS)
            except TimeoutError as error:
                message = f"the scheduler at {self.address} has no workers"
                raise _none(message, f"start some: `dask worker {self.address}`") from error
            self._compare(client)
            yield client

    def _compare(self, client: Client) -> None:
        found = client.run(pydoc.locate, "layoutkit.__version__", on_error="return")
        bare: dict[str, Mapping[str, str]] = {
            worker: {} for worker, version in found.items() if not isinstance(version, str)
        }
        told = list(differences({"layoutkit": __version__}, bare))
        if not told:
            theirs = client.run(survey, on_error="return")
            told = list(differences(survey(), theirs, self.without))
        if worst(told) is Severity.ERROR:
            raise Faulty(told)
        self.tell(told)


@contextlib.contextmanager
def _local(workers: int) -> Iterator[Client]:
    """Start a cluster on this machine, which nobody else can reach."""
    import dask.config
    from distributed import Client, LocalCluster

    # What holds here also does for the threads and processes that are started.
    with without_interrupts(), dask.config.set({_BEFORE_START: _SILENT}):
        cluster = LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address=None,
            scheduler_kwargs={"dashboard_address": _ANY_PORT},  # of what remains without a dashboard
            silence_logs=logging.CRITICAL,
        )
    with cluster, Client(cluster, set_as_default=False) as client:
        yield client
        # Who ends while another takes the place of a worker that died, has it cry out.
        with contextlib.suppress(TimeoutError):
            client.wait_for_workers(workers, timeout=_ANSWER)


class _Fate(enum.Enum):
    """Why nothing came of a task."""

    #: Several workers died of it, or beside it.
    DEAD = enum.auto()
    #: Dask has given it up: for the workers that held its inputs, or for a connection.
    LOST = enum.auto()


@dataclass
class _Work:
    """Tasks on their way through a client.

    Attributes
    ----------
    held
        Inputs as they were read last.
    sent
        The same on the workers, by digest.
    """

    client: Client
    held: Held = field(default_factory=Held)
    sent: OrderedDict[str, Future[Shared]] = field(default_factory=OrderedDict)
    _losses: Counter[str] = field(default_factory=Counter)
    _threads: int = 1
    _looked: float = -_LOOK

    def run(self, tasks: Iterable[Task]) -> Iterator[Finished]:
        """Yield what comes of each task."""
        suspects: list[Task] = []
        for task, finished in self._each(tasks, self._window):
            if finished is None:
                suspects.append(task)
            else:
                yield finished
        # Dask suspects all that a dead worker had before it. Alone, it shows which of them it was.
        for suspect in suspects:
            for task, finished in self._each([suspect], lambda: 1):
                yield finished or failed(task.key, [deadly(task.key, "each time, the process was gone")])

    def _each(
        self, tasks: Iterable[Task], window: Callable[[], int]
    ) -> Iterator[tuple[Task, Finished | None]]:
        """Yield tasks with what comes of them; with None where several workers died."""
        from distributed import as_completed

        waiting, busy = iter(tasks), dict[Any, Task]()
        completed = as_completed(loop=self.client.loop)
        while True:
            for task in waiting:
                refused = self._submit(task, busy, completed)
                if refused is not None:
                    yield task, refused
                if len(busy) >= window():
                    break
            if not busy:
                return
            future = next(completed)
            task = busy.pop(future.key)
            answer = self._answer(task, future)
            future.release()
            del future  # else its result stays where it is until the next one comes
            if answer is not _Fate.LOST:
                yield task, None if answer is _Fate.DEAD else answer
            elif (refused := self._submit(task, busy, completed)) is not None:
                yield task, refused

    def _submit(self, task: Task, busy: dict[Any, Task], completed: Any) -> Finished | None:
        """Hand a task over; return its failure where its inputs cannot be had."""
        shared = self._shared(task.source)
        if isinstance(shared, Faulty):
            return failed(task.key, shared.diagnostics)
        future = self.client.submit(_perform, task.alone, shared, pure=False)
        busy[future.key] = task
        completed.add(future)
        return None

    def _shared(self, source: Source) -> Future[Shared] | Faulty:
        """Return inputs on the workers, sent there if they are not; or why they cannot be had."""
        if source.digest not in self.sent:
            shared = self.held.load(source)
            if isinstance(shared, Faulty):
                return shared
            self.sent[source.digest] = self._send(shared)
            while len(self.sent) > _HELD:  # tasks under way keep what they need
                self.sent.popitem(last=False)
        self.sent.move_to_end(source.digest)
        return self.sent[source.digest]

    def _send(self, shared: Shared) -> Future[Shared]:
        """Give inputs to the scheduler: one worker takes them from there, others from each other.

        They are what comes of a task: unlike data that is scattered, that is made again where it is lost.
        """
        with warnings.catch_warnings():
            # That a task is large: it is handed over once.
            warnings.filterwarnings("ignore", "Sending large graph", UserWarning)
            return self.client.submit(_as_they_are, shared, pure=False)

    def _answer(self, task: Task, future: Future[Finished]) -> Finished | _Fate:
        """Return what came of a task, or why nothing did."""
        from concurrent.futures import CancelledError

        from distributed import KilledWorker

        try:
            return future.result()
        except KilledWorker:
            self.sent.pop(task.source.digest, None)
            return _Fate.DEAD
        except CancelledError as error:
            self._losses[task.key] += 1
            if self.client.status != "running" or self._losses[task.key] > _AGAIN:
                raise _gone(error) from error
            self.sent.pop(task.source.digest, None)
            return _Fate.LOST
        except OSError as error:
            raise _gone(error) from error
        except Exception as error:  # what a worker cannot even read
            return failed(task.key, [blame.unforeseen(error)])

    def _window(self) -> int:
        """Return how many tasks may be under way."""
        if time.monotonic() - self._looked > _LOOK:
            self._threads = sum(self.client.nthreads().values())
            self._looked = time.monotonic()
        return _EACH * max(1, self._threads)


#: A worker may have several threads, and the libraries below have one setting for all of them.
_ONE_AT_A_TIME = threading.Lock()


def _as_they_are(shared: Shared) -> Shared:
    return shared


def _perform(task: Task, shared: Shared) -> Finished:
    """Do a task on a worker."""
    with _ONE_AT_A_TIME, contextlib.redirect_stdout(sys.stderr):
        return perform(task, shared)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Let Dask log nothing but the end: workers come and go, and errors that concern us are raised."""
    loggers = [logging.getLogger(name) for name in _LOGS]
    before = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, before, strict=True):
            logger.setLevel(level)


def _require_dask() -> None:
    try:
        import distributed  # noqa: F401 - whether it is there
    except ImportError as error:
        raise _none("Dask is not installed", "install it: `pip install 'dask[distributed]'`") from error


def _knock(address: str) -> None:
    """See whether anyone answers at an address: Dask itself would try for long.

    Raises
    ------
    Faulty
        If nobody does.
    """
    try:
        split = urlsplit(address)
        if not (split.scheme and split.hostname and split.port):
            raise _none(f"{address} is no address of a scheduler", "it is such as tcp://10.0.0.1:8786")
        with socket.create_connection((split.hostname, split.port), timeout=_ANSWER):
            pass
    except (OSError, ValueError) as error:
        raise _none(f"no scheduler answers at {address}: {error}") from error


def _none(message: str, hint: str = "start one: `dask scheduler`, or use --scheduler local") -> Faulty:
    return Faulty([Diagnostic("LK893", message, hint=hint, topic="batch")])


def _gone(error: BaseException) -> Faulty:
    message = f"the cluster is gone: {blame.described(error)}"
    return _none(message, "run the command again: it goes on from here")
