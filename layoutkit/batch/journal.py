"""The journal of a run: which tasks are done, for whoever goes on with it.

One line for each task, written once its files are whole. It is locked while a run goes on, by the system: a
lock ends with its process, however that ends.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

from layoutkit import __version__
from layoutkit.batch.locking import locked
from layoutkit.batch.plan import Plan
from layoutkit.batch.record import Record, Written
from layoutkit.diagnostics import Diagnostic, Faulty, Place

#: Hidden: its lines stand in the order in which tasks were done, so it is no result.
JOURNAL_FILE = ".layoutkit-journal.jsonl"


@dataclass
class Journal:
    """The journal of a folder, open and locked.

    Attributes
    ----------
    stream
        The file, which ends with a whole line.
    """

    stream: BinaryIO
    _places: dict[str, int] = field(default_factory=dict)

    @classmethod
    def opened(cls, folder: Path) -> Journal:
        """Open the journal of a folder, or begin one.

        Raises
        ------
        Faulty
            If another run is at work there (LK891), or the journal cannot be opened (LK008).
        """
        path = folder / JOURNAL_FILE
        try:
            folder.mkdir(parents=True, exist_ok=True)
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o644)
        except OSError as error:
            raise Faulty([_unwritable(path, error)]) from error
        stream = os.fdopen(descriptor, "r+b")
        try:
            free = locked(stream)
        except OSError as error:  # of a file system without locks
            stream.close()
            raise Faulty([_unwritable(path, error)]) from error
        if not free:
            stream.close()
            message, hint = "another run is writing into this folder", "wait for it, or name another folder"
            raise Faulty([Diagnostic("LK891", message, Place(str(folder)), hint, topic="batch")])
        return cls(stream)

    def records(self) -> Iterator[Record]:
        """Yield what the journal has, the last of each task; a line that was not finished is cut off."""
        self._places.clear()
        whole = 0
        self.stream.seek(0)
        for number, line in enumerate(iter(self.stream.readline, b"")):
            if not line.endswith(b"\n"):
                break
            if number and (key := _key(line)) is not None:
                self._places[key] = whole
            whole += len(line)
        self.stream.truncate(whole)
        yield from map(self.record, list(self._places))

    def header(self) -> Mapping[str, Any]:
        """Return the first line; empty where there is none that can be read."""
        self.stream.seek(0)
        line = self.stream.readline()
        return (_read(line) if line.endswith(b"\n") else None) or {}

    def copies(self) -> tuple[Written, ...]:
        """Return what was copied into the folder when the journal began."""
        return tuple(map(Written.of_data, self.header().get("copies", ())))

    def begin(self, plan: Plan, copies: Sequence[Written] = ()) -> None:
        """Forget all, and write the first line."""
        self._places.clear()
        self.stream.seek(0)
        self.stream.truncate()
        self._append(
            {
                "command": plan.command,
                "layoutkit": __version__,
                "fingerprint": plan.fingerprint,
                "copies": [copy.as_data() for copy in copies],
            }
        )

    def add(self, record: Record) -> None:
        """Write a line, and see that it is on the disk."""
        self._places[record.key] = self._append(record.as_data())

    def record(self, key: str) -> Record:
        """Return what there is of a task that the journal has."""
        self.stream.seek(self._places[key])
        return Record.of(json.loads(self.stream.readline()))

    def close(self) -> None:
        """Close it, and so unlock it."""
        self.stream.close()

    def _append(self, data: Mapping[str, Any]) -> int:
        place = self.stream.seek(0, os.SEEK_END)
        self.stream.write(json.dumps(data, separators=(",", ":")).encode() + b"\n")
        self.stream.flush()
        os.fsync(self.stream.fileno())
        return place


def _key(line: bytes) -> str | None:
    """Return the task of a line; None where that is damaged."""
    data = _read(line)
    try:
        return None if data is None else Record.of(data).key
    except (KeyError, TypeError):
        return None


def _read(line: bytes) -> dict[str, Any] | None:
    try:
        data = json.loads(line)
    except ValueError:
        return None
    return data if isinstance(data, dict) else None


def _unwritable(path: Path, error: OSError) -> Diagnostic:
    message = f"the folder of results cannot be written: {error.strerror or error}"
    return Diagnostic("LK008", message, Place(str(path.parent)), "name another with -o", topic="file")
