"""All the names of a new plugin, from the one that its author gives."""

from __future__ import annotations

import importlib.util
import keyword
import re
import sys
from collections.abc import Collection
from dataclasses import dataclass

from layoutkit.diagnostics import Diagnostic, Faulty

_PART = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_FORM = "small letters, digits and hyphens, a letter first"


@dataclass(frozen=True, slots=True)
class Naming:
    """The names of a plugin with one constraint kind.

    Attributes
    ----------
    prefix
        That of its namespace, and the name of the plugin and its package.
    kind
        The name of the element.
    """

    prefix: str
    kind: str

    @classmethod
    def parse(cls, text: str) -> Naming:
        """Read ``slender``, or ``slender:wide``: a prefix and an element of another name.

        Raises
        ------
        Faulty
            If it is of neither form, or no name that a package can have (LK701).
        """
        prefix, colon, kind = text.partition(":")
        naming = cls(prefix, kind if colon else prefix)
        for part in (naming.prefix, naming.kind):
            if not _PART.fullmatch(part):
                shown = re.sub(r"[^a-z0-9]+", "-", part.lower()).strip("-")
                example = shown if _PART.fullmatch(shown) else "slender"
                raise _refused(f"{part!r} is no name for a plugin", f"take {_FORM}, e.g. {example!r}")
        if naming.prefix.startswith(("xml", "xs", "layoutkit")) or keyword.iskeyword(naming.module):
            raise _refused(f"{naming.prefix!r} is a name that has a meaning already", "take another name")
        return naming

    @property
    def module(self) -> str:
        """The name of the module."""
        return self.prefix.replace("-", "_")

    @property
    def class_name(self) -> str:
        """The name of the constraint's class."""
        return "".join(part.capitalize() for part in self.kind.split("-"))

    @property
    def element(self) -> str:
        """The name of the element, as documents commonly write it."""
        return f"{self.prefix}:{self.kind}"

    @property
    def uri(self) -> str:
        """The URI of the namespace."""
        return f"urn:{self.prefix}:1"

    def check(self, plugins: Collection[str], prefixes: Collection[str]) -> None:
        """See that no one else goes by these names.

        Parameters
        ----------
        plugins
            Names of the plugins that are installed.
        prefixes
            Prefixes of namespaces in use.

        Raises
        ------
        Faulty
            If someone does (LK701).
        """
        if self.prefix in plugins:
            raise _refused(f"a plugin {self.prefix!r} is installed already", "take another name")
        if self.prefix in prefixes:
            raise _refused(
                f"the prefix {self.prefix!r} is that of constraints which are installed already",
                "take another name",
            )
        known = self.module in sys.stdlib_module_names or importlib.util.find_spec(self.module) is not None
        if known:
            message = f"there is a module {self.module!r} already, which the plugin's would hide"
            raise _refused(message, f"take another name, e.g. {self.prefix + '-rules'!r}")


def _refused(message: str, hint: str) -> Faulty:
    return Faulty([Diagnostic("LK701", message, hint=hint, topic="usage")])
