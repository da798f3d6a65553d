"""What does tasks: here, one after the other; `processes` and `cluster` have the others."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Generator, Iterable
from dataclasses import dataclass, field
from typing import Protocol

from layoutkit.batch.task import Finished, Shared, Source, Task, failed, perform
from layoutkit.diagnostics import Faulty


class Runner(Protocol):
    """Does tasks, somewhere."""

    def run(self, tasks: Iterable[Task]) -> Generator[Finished, None, None]:
        """Yield what comes of each task, once for each, in any order.

        No more tasks are taken than workers need next, so that memory does not grow with their number.
        Closing the generator stops the work at once.

        Raises
        ------
        Faulty
            If there is nothing that could do them.
        """


@dataclass(frozen=True)
class InProcess:
    """Does tasks in this process, in their order."""

    def run(self, tasks: Iterable[Task]) -> Generator[Finished, None, None]:
        """Yield what comes of each task."""
        held = Held()
        for task in tasks:
            shared = held.load(task.source)
            yield (
                perform(task, shared) if isinstance(shared, Shared) else failed(task.key, shared.diagnostics)
            )


@dataclass
class Held:
    """The inputs that were needed last, so that they are not read again for each task.

    Attributes
    ----------
    most
        How many.
    """

    most: int = 2
    _held: OrderedDict[str, Shared] = field(default_factory=OrderedDict)

    def load(self, source: Source) -> Shared | Faulty:
        """Return inputs; or why they cannot be had."""
        if source.digest not in self._held:
            try:
                shared = source.load()
            except Faulty as faulty:
                return faulty
            self._held[shared.digest] = shared
            while len(self._held) > self.most:
                self._held.popitem(last=False)
        self._held.move_to_end(source.digest)
        return self._held[source.digest]
