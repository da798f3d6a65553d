"""What a task is, what it needs, and what comes of it: plain data that goes from one process to another."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, Protocol

from layoutkit.diagnostics import Diagnostic, Faulty, blame

Status = Literal["done", "failed"]


class Source(Protocol):
    """Where the inputs that many tasks share come from.

    Attributes
    ----------
    digest
        Says what they are: inputs of one digest are the same.
    """

    @property
    def digest(self) -> str:
        """Say what they are."""

    def load(self) -> Shared:
        """Return them.

        Raises
        ------
        Faulty
            If they cannot be read; their tasks then fail, and no others.
        """


@dataclass(frozen=True, eq=False)
class Shared:
    """Inputs that many tasks have in common: they go to each worker once, and not with each task.

    They are equal, and a key of caches, by their digest: work may keep what it makes of them by
    ``functools.lru_cache``.

    Attributes
    ----------
    files
        Bytes, by a name that the work knows.
    options
        JSON-ready settings.
    """

    files: Mapping[str, bytes] = field(default_factory=dict)
    options: Mapping[str, Any] = field(default_factory=dict)

    @cached_property
    def digest(self) -> str:
        """The SHA-256 of all of it."""
        files = {name: hashlib.sha256(data).hexdigest() for name, data in self.files.items()}
        return digest_of({"files": files, "options": self.options})

    def load(self) -> Shared:
        """Return itself: inputs in memory are a source of their own."""
        return self

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shared) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)


@dataclass(frozen=True)
class Reread:
    """Inputs that are not held in memory: they are read again when a worker needs them.

    Attributes
    ----------
    read
        Reads them.
    digest
        What they were when the run was planned; empty where they could not be read.
    name
        What a user calls them.
    """

    read: Callable[[], Shared]
    digest: str
    name: str

    @classmethod
    def of(cls, read: Callable[[], Shared], name: str) -> Reread:
        """Return the source of inputs as they are now."""
        try:
            return cls(read, read().digest, name)
        except Faulty:  # which is told where they are loaded: other tasks have other inputs
            return cls(read, "", name)

    def load(self) -> Shared:
        """Read them.

        Raises
        ------
        Faulty
            If they cannot be read, or have changed since the run was planned (LK896).
        """
        shared = self.read()
        if shared.digest == self.digest:
            return shared
        message = f"{self.name} has changed since the run began"
        hint = "run the command again, into another folder or with --afresh"
        raise Faulty([Diagnostic("LK896", message, hint=hint, topic="batch")])


@dataclass(frozen=True)
class Elsewhere:
    """Inputs that a worker has from elsewhere than from the task.

    Attributes
    ----------
    digest
        Says which they are.
    """

    digest: str

    def load(self) -> Shared:
        """Raise: they are not to be had so."""
        raise NotImplementedError("a worker is given its inputs")


@dataclass(frozen=True)
class Finished:
    """What came of a task.

    Attributes
    ----------
    key
        The task's.
    files
        Names, relative to the folder of results and with ``/``, and bytes.
    summary
        JSON-ready data for the manifest; no clock in it.
    diagnostics
        What there is to say.
    """

    key: str
    status: Status
    files: tuple[tuple[str, bytes], ...] = ()
    summary: Mapping[str, Any] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True)
class Task:
    """A piece of work that needs nothing but its arguments and what it shares with others.

    Attributes
    ----------
    key
        Its name, which no other task of the run has.
    work
        A function of a module, so that workers find it: of the task, and what is shared.
    arguments
        JSON-ready data of its own.
    source
        What it shares with others.
    """

    key: str
    work: Callable[[Task, Shared], Finished]
    arguments: Mapping[str, Any] = field(default_factory=dict)
    source: Source = field(default_factory=Shared)

    @property
    def alone(self) -> Task:
        """The task without its inputs, for a worker that has them."""
        return replace(self, source=Elsewhere(self.source.digest))


def failed(key: str, diagnostics: Iterable[Diagnostic]) -> Finished:
    """Return what comes of a task that comes to nothing."""
    return Finished(key, "failed", diagnostics=tuple(diagnostics))


def perform(task: Task, shared: Shared) -> Finished:
    """Do a task; whatever is raised in it is its failure, and no other's."""
    try:
        return task.work(task, shared)
    except Faulty as faulty:
        return failed(task.key, faulty.diagnostics)
    except blame.ANYTHING as error:
        return failed(task.key, [blame.unforeseen(error)])


def digest_of(data: Mapping[str, Any]) -> str:
    """Return the SHA-256 of JSON-ready data."""
    text = json.dumps(data, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()
