"""How far long work has come: a bar where stderr is a terminal, else a plain line now and then."""

from __future__ import annotations

import sys
import threading
import time
from abc import ABC, abstractmethod
from types import TracebackType
from typing import Self

#: Seconds between plain lines.
PAUSE = 30.0


class Meter(ABC):
    """Counts what is done, what has failed, and what is left.

    Attributes
    ----------
    total, done, failed
        How many there are; how many are done, those of earlier runs included; how many have failed.
    """

    def __init__(self) -> None:
        self.total = self.done = self.failed = 0

    def begin(self, total: int, done: int) -> None:
        """Say how many there are, and how many are done already."""
        self.total, self.done = total, done

    def advance(self, failed: bool) -> None:
        """Count another one."""
        self.done += not failed
        self.failed += failed

    @abstractmethod
    def __enter__(self) -> Self:
        """Begin to show it."""

    @abstractmethod
    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Show it no more."""


def meter(what: str) -> Meter:
    """Return a meter of things, such as ``tasks``, that shows itself on stderr."""
    return Bar(what) if sys.stderr.isatty() else Lines(what)


class Bar(Meter):
    """A bar with the time that is left."""

    def __init__(self, what: str) -> None:
        super().__init__()
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

        columns = (
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("{task.fields[failures]}"),
            TimeRemainingColumn(elapsed_when_finished=True),
        )
        # An estimate over ten minutes: tasks differ, and workers may end several at once.
        self._progress = Progress(
            *columns, console=Console(stderr=True), transient=True, speed_estimate_period=600.0
        )
        self._task = self._progress.add_task(what, total=None, failures="")

    def begin(self, total: int, done: int) -> None:
        """Say how many there are, and how many are done already."""
        super().begin(total, done)
        self._progress.update(self._task, total=total, completed=done)

    def advance(self, failed: bool) -> None:
        """Count another one."""
        super().advance(failed)
        failures = f"{self.failed} failed" if self.failed else ""
        self._progress.update(self._task, advance=1, failures=failures)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._progress.stop()


class Lines(Meter):
    """A line every half minute, by a thread: a sign of life also where nothing is done for hours."""

    def __init__(self, what: str, pause: float = PAUSE) -> None:
        super().__init__()
        self._what, self._pause = what, pause
        self._before = 0
        self._start = time.monotonic()
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._tell, name="layoutkit-meter", daemon=True)

    def begin(self, total: int, done: int) -> None:
        """Say how many there are, and how many are done already."""
        super().begin(total, done)
        self._before, self._start = done, time.monotonic()

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._over.set()
        self._thread.join()

    def _tell(self) -> None:
        while not self._over.wait(self._pause):
            print(self.line(time.monotonic() - self._start), file=sys.stderr, flush=True)

    def line(self, seconds: float) -> str:
        """Return how far it has come after so many seconds."""
        parts = [f"{self.done} of {self.total} {self._what} done"]
        if self.failed:
            parts.append(f"{self.failed} failed")
        if now := self.done - self._before + self.failed:
            rest = self.total - self.done - self.failed
            parts.append(f"about {lasting(seconds / now * rest)} left")
        return ", ".join(parts)


def lasting(seconds: float) -> str:
    """Return a time as people say it: in seconds, minutes, or hours."""
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"
