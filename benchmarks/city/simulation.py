"""A cluster at work, simulated event by event: list scheduling, one client that takes all results in."""

from __future__ import annotations

import heapq
import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import count
from typing import NamedTuple

#: Tasks under way for each core, as `layoutkit.batch.cluster` has it.
EACH = 2
#: Seconds until Dask takes a silent machine for lost: its setting ``distributed.comm.timeouts.tcp``.
NOTICE = 30.0


class Work(NamedTuple):
    """A task: seconds of a core of speed 1, and bytes of its results."""

    seconds: float
    size: float


@dataclass(frozen=True, slots=True)
class Costs:
    """What comes to the work itself.

    Attributes
    ----------
    scheduler
        Seconds of the scheduler for each task.
    client
        Seconds of the client for each task: until it has the result, has kept it, and hands over the next.
    byte
        Seconds of the client for each byte of a result.
    """

    scheduler: float
    client: float
    byte: float


@dataclass(frozen=True, slots=True)
class Machines:
    """What does the work.

    Attributes
    ----------
    speeds
        Of each machine: 1 is the one on which tasks were measured.
    cores
        Of each machine.
    begin
        Seconds until a core of speed 1 can begin, and those of the client before.
    line
        Bytes a second that reach the client.
    lost
        How many machines are lost half-way between the first task and the last: the first ones.
    """

    speeds: tuple[float, ...]
    cores: int
    begin: tuple[float, float] = (0.0, 0.0)
    line: float = math.inf
    lost: int = 0


@dataclass(frozen=True, slots=True)
class Course:
    """How it went.

    Attributes
    ----------
    seconds
        Until the last result is kept.
    begun
        Until the first core has begun.
    shares
        What part of this time cores, client and scheduler were at work, and how much of it was beginning.
    repeated
        How many tasks were done again.
    """

    seconds: float
    begun: float
    shares: dict[str, float]
    repeated: int

    @property
    def limit(self) -> str:
        """What it would have to be quicker to end earlier."""
        return max(self.shares, key=lambda name: self.shares[name])


def simulated(tasks: Sequence[Work], machines: Machines, costs: Costs) -> Course:
    """Return how tasks go, in their order, on machines; those that are lost are lost while it is done."""
    if not machines.lost:
        return _Cluster(tasks, machines, costs).course()
    whole = _Cluster(tasks, replace(machines, lost=0), costs).course()
    return _Cluster(tasks, machines, costs, (whole.begun + whole.seconds) / 2).course()


@dataclass
class _Cluster:
    """The state between two events."""

    tasks: Sequence[Work]
    machines: Machines
    costs: Costs
    death: float = math.inf
    _events: list[tuple[float, int, Callable[[], None]]] = field(default_factory=list)
    _order: count[int] = field(default_factory=count)
    _waiting: deque[int] = field(default_factory=deque)
    _idle: deque[int] = field(default_factory=deque)
    _made: deque[tuple[int, int]] = field(default_factory=deque)
    _running: dict[int, int] = field(default_factory=dict)
    _kept: set[int] = field(default_factory=set)
    _handed: int = 0
    _collecting: bool = False
    _scheduler: float = 0.0
    _now: float = 0.0
    _worked: float = 0.0
    _taken: float = 0.0
    _repeated: int = 0

    def course(self) -> Course:
        """Run until all results are kept."""
        cores = len(self.machines.speeds) * self.machines.cores
        begin, before = self.machines.begin
        self._scheduler = before
        for _ in range(min(len(self.tasks), EACH * cores)):
            self._hand_over(before)
        for core in range(cores):
            self._at(before + begin / self._speed(core), partial(self._free, core))
        for machine in range(self.machines.lost):
            self._at(max(self.death, before) + NOTICE, partial(self._do_again, machine))
        while len(self._kept) < len(self.tasks):
            self._now, _, happen = heapq.heappop(self._events)
            happen()
        begun = before + begin / max(self.machines.speeds)
        shares = {
            "cores": self._worked / (cores * self._now),
            "client": self._taken / self._now,
            "scheduler": (len(self.tasks) + self._repeated) * self.costs.scheduler / self._now,
            "beginning": begun / self._now,
        }
        return Course(self._now, begun, shares, self._repeated)

    def _at(self, when: float, happen: Callable[[], None]) -> None:
        heapq.heappush(self._events, (when, next(self._order), happen))

    def _speed(self, core: int) -> float:
        return self.machines.speeds[core // self.machines.cores]

    def _dead(self, core: int) -> bool:
        return core // self.machines.cores < self.machines.lost and self._now >= self.death

    def _hand_over(self, when: float) -> None:
        """Let the client give the next task to the scheduler."""
        if self._handed < len(self.tasks):
            self._schedule(self._handed, when)
            self._handed += 1

    def _schedule(self, task: int, when: float) -> None:
        self._scheduler = max(self._scheduler, when) + self.costs.scheduler
        self._at(self._scheduler, partial(self._wait, task))

    def _wait(self, task: int) -> None:
        self._waiting.append(task)
        self._assign()

    def _free(self, core: int) -> None:
        self._idle.append(core)
        self._assign()

    def _assign(self) -> None:
        while self._waiting and self._idle:
            core = self._idle.popleft()
            if self._dead(core):
                continue
            task = self._waiting.popleft()
            seconds = self.tasks[task].seconds / self._speed(core)
            self._running[core] = task
            self._worked += seconds
            self._at(self._now + seconds, partial(self._done, core, task))

    def _done(self, core: int, task: int) -> None:
        if self._dead(core):
            return
        del self._running[core]
        self._made.append((task, core))
        self._free(core)
        self._collect()

    def _collect(self) -> None:
        """Let the client take the next result, if it has time."""
        if self._collecting or not self._made:
            return
        task, core = self._made.popleft()
        if self._dead(core):  # nobody answers until the machine is known to be gone
            self._repeated += 1
            self._schedule(task, max(self._now, self.death + NOTICE))
            self._collect()
            return
        self._collecting = True
        size = self.tasks[task].size
        seconds = self.costs.client + size * (self.costs.byte + 1 / self.machines.line)
        self._taken += seconds
        self._at(self._now + seconds, partial(self._keep, task))

    def _keep(self, task: int) -> None:
        self._collecting = False
        self._kept.add(task)
        self._hand_over(self._now)
        self._collect()

    def _do_again(self, machine: int) -> None:
        """Do again what a lost machine was at."""
        first = machine * self.machines.cores
        for core in range(first, first + self.machines.cores):
            if (task := self._running.pop(core, None)) is not None:
                self._repeated += 1
                self._schedule(task, self._now)
