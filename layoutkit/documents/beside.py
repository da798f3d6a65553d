"""Where documents find the files that they name: beside them in folders, or among files that were sent."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from layoutkit.diagnostics import nearest
from layoutkit.documents.files import like_one_beside
from layoutkit.documents.source import Source


class Files(Protocol):
    """Files that documents may name."""

    def source(self, path: Path) -> Source | None:
        """Return a file; None where there is none. A device or a pipe is none.

        Raises
        ------
        Faulty
            If it cannot be read.
        OSError
            If its name can be none.
        """

    def near(self, path: Path) -> Path | None:
        """Return the XML file whose name is most like that of one that is not there; None if none is near."""


class Disk:
    """The files of this machine."""

    def source(self, path: Path) -> Source | None:
        """Return a file, if it is one."""
        return Source.of(path) if path.is_file() else None

    def near(self, path: Path) -> Path | None:
        """Return the nearest file in the same folder."""
        return like_one_beside(path)


class Sent:
    """Files that are held in memory, by their paths with slashes."""

    def __init__(self, files: Mapping[str, bytes]) -> None:
        self._files = files

    def source(self, path: Path) -> Source | None:
        """Return a file, if it was sent."""
        data = self._files.get(normal(path))
        return None if data is None else Source(str(path), data)

    def near(self, path: Path) -> Path | None:
        """Return the nearest file of the same folder."""
        beside = (Path(name) for name in self._files if posixpath.dirname(name) == normal(path.parent))
        names = {other.stem: other.name for other in beside if other.suffix.lower() == ".xml"}
        near = nearest(path.stem, names)
        return None if near is None else path.with_name(names[near])


class Kept:
    """Files that are read once, and kept.

    Attributes
    ----------
    found
        Those that were read, by their paths from the folder, with slashes; what lies outside of the folder
        is named by way of ``..``.
    """

    def __init__(self, files: Files, folder: Path) -> None:
        self._files, self._folder = files, folder
        self.found: dict[str, bytes] = {}

    def source(self, path: Path) -> Source | None:
        """Return a file, which is read if it was not before."""
        inside = path.is_relative_to(self._folder)
        name = normal(path.relative_to(self._folder) if inside else path)
        if name not in self.found:
            source = self._files.source(path)
            if source is None:
                return None
            self.found[name] = source.whole()
        return Source(str(path), self.found[name])

    def near(self, path: Path) -> Path | None:
        """Return the nearest file of the same folder."""
        return self._files.near(path)


def normal(path: Path) -> str:
    """Return a path with slashes, and without detours; the folder itself is empty."""
    name = posixpath.normpath(path.as_posix())
    return "" if name == "." else name


DISK = Disk()
