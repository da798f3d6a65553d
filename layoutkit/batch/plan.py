"""What a run is to do, and the fingerprint by which it is known again."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from layoutkit import __version__
from layoutkit.batch.survey import libraries
from layoutkit.batch.task import Task, digest_of


@dataclass(frozen=True)
class Plan:
    """Everything that a run is to do.

    Attributes
    ----------
    command
        Which command it is.
    tasks
        In the order of the manifest; their keys differ.
    options
        JSON-ready settings, for the manifest: all that decides on results, and is in no task.
    copies
        Files that are copied into the folder as they are, by their name there: such as photos that many
        results refer to. What cannot be read is left out; it is for the tasks that need it to say so.
    """

    command: str
    tasks: Sequence[Task]
    options: Mapping[str, Any] = field(default_factory=dict)
    copies: Mapping[str, Path] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if len({task.key for task in self.tasks}) < len(self.tasks):
            raise ValueError("two tasks have the same key")

    @cached_property
    def fingerprint(self) -> str:
        """The same for all runs that give the same bytes: the digest of all that goes into results."""
        installed = {"layoutkit": __version__, **libraries()}
        whole = hashlib.sha256(
            digest_of({"command": self.command, "installed": installed, "options": self.options}).encode()
        )
        for task in self.tasks:  # one by one: their arguments may be large, and shared
            own = {"key": task.key, "source": task.source.digest, "arguments": task.arguments}
            whole.update(digest_of(own).encode())
        return whole.hexdigest()
