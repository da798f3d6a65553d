"""What plugins have added, by name; an unknown name is a diagnostic that suggests the nearest known one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Generic, TypeVar

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean

T = TypeVar("T")


class Lookup(Mapping[str, T], Generic[T]):
    """A mapping from names to what goes by them, in the order of registration.

    Parameters
    ----------
    what
        What a user calls one of them, e.g. ``format``.
    found
        The mapping.
    failed
        Diagnostics of the plugins that failed: a name that is missing may have been theirs.
    """

    def __init__(self, what: str, found: Mapping[str, T], failed: Sequence[Diagnostic] = ()) -> None:
        self.what, self._found, self._failed = what, dict(found), tuple(failed)

    def __getitem__(self, name: str) -> T:
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def find(self, name: str) -> T:
        """Return what goes by `name`.

        Raises
        ------
        Faulty
            If nothing does; with the plugins that failed, if any.
        """
        if name in self._found:
            return self._found[name]
        unknown = Diagnostic(
            "LK406", f"there is no {self.what} {name!r}", hint=did_you_mean(name, self), topic="plugin"
        )
        raise Faulty([*(replace(d, severity=Severity.ERROR) for d in self._failed), unknown])
