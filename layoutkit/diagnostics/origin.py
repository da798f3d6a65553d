"""Where a plugin comes from, so that whatever goes wrong in it can be laid at its door."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit import __version__

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

#: The name of the plugin system: markers, and the entry point group.
PROJECT = "layoutkit"


@dataclass(frozen=True, slots=True)
class Origin:
    """The package that a plugin was installed with.

    Attributes
    ----------
    name
        The plugin's name: that of its entry point.
    package, version
        The distribution, as ``pip list`` shows it.
    module
        The module that the entry point names.
    """

    name: str
    package: str
    version: str
    module: str

    @classmethod
    def of(cls, point: EntryPoint) -> Origin:
        """Return where an entry point comes from."""
        if point.dist is None:
            return cls(point.name, "an unknown package", "", point.module)
        return cls(point.name, point.dist.name, point.dist.version, point.module)

    @property
    def ours(self) -> bool:
        """Whether the plugin is part of layoutkit itself."""
        return self.package == PROJECT

    def __str__(self) -> str:
        return f"plugin {self.name!r} of {self.package} {self.version}"


#: The core's own plugin.
BUILT_IN = Origin("builtin", PROJECT, __version__, "layoutkit.hooks.builtin")


def installed() -> tuple[EntryPoint, ...]:
    """Return the entry points of every installed plugin, in the order of their names."""
    from importlib.metadata import entry_points

    return tuple(sorted(entry_points(group=PROJECT), key=lambda point: (point.name, point.value)))


def origins() -> tuple[Origin, ...]:
    """Return where all installed plugins come from, those of layoutkit among them."""
    return (BUILT_IN, *map(Origin.of, installed()))


def origin_of(module: str, origins: Iterable[Origin]) -> Origin | None:
    """Return which plugin a module is part of; None for what is no plugin's.

    Packages may share their outermost name: the plugin with the most of the module's name in common is it.
    """
    found, most = None, 0
    for origin in origins:
        shared = _shared(origin.module.split("."), module.split("."))
        if shared > most:
            found, most = origin, shared
    return found


def _shared(one: list[str], other: list[str]) -> int:
    pairs = enumerate(zip(one, other, strict=False))
    return next((number for number, (a, b) in pairs if a != b), min(len(one), len(other)))
