"""What is kept of a task that was done: its line in the journal, and its entry in the manifest."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from layoutkit.batch.task import Finished, Status


@dataclass(frozen=True, slots=True)
class Written:
    """A file as it was written.

    Attributes
    ----------
    name
        Relative to the folder of results, with ``/``.
    size
        In bytes.
    """

    name: str
    size: int
    sha256: str

    @classmethod
    def of(cls, name: str, data: bytes) -> Written:
        """Return what there is to keep of a file."""
        return cls(name, len(data), hashlib.sha256(data).hexdigest())

    @classmethod
    def of_data(cls, data: Mapping[str, Any]) -> Written:
        """Return what `as_data` has made data of.

        Raises
        ------
        KeyError, TypeError
            If it was not made by that.
        """
        return cls(data["name"], data["bytes"], data["sha256"])

    def stands(self, folder: Path) -> bool:
        """Tell whether the file is there, as it was written."""
        path = folder / self.name
        try:
            if path.stat().st_size != self.size:
                return False
            with path.open("rb") as stream:
                return hashlib.file_digest(stream, "sha256").hexdigest() == self.sha256
        except OSError:
            return False

    def as_data(self) -> dict[str, Any]:
        """Return it as JSON-ready data."""
        return {"name": self.name, "bytes": self.size, "sha256": self.sha256}


@dataclass(frozen=True, slots=True)
class Record:
    """What is kept of a task that was done.

    Attributes
    ----------
    diagnostics
        As JSON-ready data.
    """

    key: str
    status: Status
    files: tuple[Written, ...]
    summary: Mapping[str, Any]
    diagnostics: Sequence[Mapping[str, Any]]

    @classmethod
    def of_finished(cls, finished: Finished) -> Record:
        """Return what is to be kept of a task."""
        files = tuple(Written.of(name, data) for name, data in finished.files)
        told = [diagnostic.as_dict() for diagnostic in finished.diagnostics]
        return cls(finished.key, finished.status, files, finished.summary, told)

    @classmethod
    def of(cls, data: Mapping[str, Any]) -> Record:
        """Return what `as_data` has made data of.

        Raises
        ------
        KeyError, TypeError
            If it was not made by that.
        """
        files = tuple(map(Written.of_data, data["files"]))
        return cls(data["key"], data["status"], files, data["summary"], data["diagnostics"])

    def as_data(self) -> dict[str, Any]:
        """Return it as JSON-ready data."""
        return {
            "key": self.key,
            "status": self.status,
            "files": [file.as_data() for file in self.files],
            "summary": self.summary,
            "diagnostics": self.diagnostics,
        }
