"""Where a plugin comes from, so that whatever goes wrong in it can be laid at its door."""

from __future__ import annotations

from dataclasses import dataclass

from layoutkit import __version__
from layoutkit.hooks.specs import PROJECT


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

    @property
    def ours(self) -> bool:
        """Whether the plugin is part of layoutkit itself."""
        return self.package == PROJECT

    def __str__(self) -> str:
        return f"plugin {self.name!r} of {self.package} {self.version}"


#: The core's own plugin.
BUILT_IN = Origin("builtin", PROJECT, __version__, "layoutkit.hooks.builtin")
