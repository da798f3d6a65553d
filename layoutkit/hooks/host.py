"""The host: loads plugins, asks their hooks when an answer is first needed, and says what failed."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from importlib.metadata import EntryPoint
from operator import attrgetter, methodcaller
from typing import TYPE_CHECKING, Any

from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.diagnostics.blame import ANYTHING, described
from layoutkit.diagnostics.origin import Origin, installed
from layoutkit.hooks import checks
from layoutkit.hooks.loading import Loaded, remaining
from layoutkit.hooks.lookup import Lookup

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.hooks.specs import Format, SceneFormat, Stage
    from layoutkit.operations import Operation
    from layoutkit.scenes.relationship import Relationship
    from layoutkit.sizing.qp import Backend

#: Environment variable: names of plugins that are not to be loaded, separated by commas.
DISABLE = "LAYOUTKIT_DISABLE_PLUGINS"


@dataclass(frozen=True, slots=True)
class _Kind:
    """What one hook returns: what users call it, how it is checked, and its name.

    Attributes
    ----------
    fault
        Says what is wrong with an item, whoever gives it; empty if nothing is.
    claim
        Says what an item takes for itself that is not its plugin's; empty if nothing.
    """

    what: str
    hook: str
    fault: Callable[[object], str]
    name: Callable[[Any], str] = attrgetter("name")
    claim: Callable[[Any, Origin], str] = lambda item, origin: ""


_KINDS: Mapping[str, _Kind] = {
    "constraints": _Kind(
        "constraint", "layoutkit_constraints", checks.constraint_fault, methodcaller("qualified_name")
    ),
    "stages": _Kind("stage", "layoutkit_stages", checks.stage_fault),
    "formats": _Kind("format", "layoutkit_formats", checks.format_fault),
    "scene_formats": _Kind("format of scenes", "layoutkit_scene_formats", checks.scene_format_fault),
    "relationships": _Kind("relationship function", "layoutkit_relationships", checks.relationship_fault),
    "backends": _Kind("QP backend", "layoutkit_qp_backends", checks.backend_fault),
    "operations": _Kind(
        "operation",
        "layoutkit_operations",
        checks.operation_fault,
        methodcaller("qualified_name"),
        checks.core_claim,
    ),
}


class Host:
    """Plugins, and what they add. A hook is called when its lookup is first used.

    Parameters
    ----------
    loaded
        The plugins.
    severity
        How grave a failing plugin is: a warning, after which the program goes on without it; or an error,
        raised as `Faulty` from wherever it shows.
    diagnostics
        What was wrong before any was loaded.
    """

    def __init__(
        self,
        loaded: Loaded,
        severity: Severity = Severity.WARNING,
        diagnostics: Iterable[Diagnostic] = (),
    ) -> None:
        self._manager, self._severity = loaded.manager, severity
        self.origins: Mapping[str, Origin] = loaded.origins
        self._diagnostics: list[Diagnostic] = []
        self._added: dict[tuple[str, str], tuple[str, ...]] = {}
        self._report([*diagnostics, *loaded.diagnostics])

    @classmethod
    def load(
        cls,
        severity: Severity = Severity.WARNING,
        points: Iterable[EntryPoint] | None = None,
        without: Collection[str] = (),
        diagnostics: Iterable[Diagnostic] = (),
    ) -> Host:
        """Load the installed plugins, less those that ``LAYOUTKIT_DISABLE_PLUGINS`` or `without` names.

        Parameters
        ----------
        severity
            How grave a failing plugin is.
        points
            Entry points to load instead of the installed ones.
        without
            Names of plugins that are not to be loaded.
        diagnostics
            What was wrong before any was loaded.

        Raises
        ------
        Faulty
            If one fails, and that is an error.
        """
        disabled = {*(name.strip() for name in os.environ.get(DISABLE, "").split(",")), *without} - {""}
        kept, unknown = remaining(installed() if points is None else points, disabled)
        return cls(Loaded(kept), severity, [*unknown, *diagnostics])

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What has failed so far."""
        return tuple(self._diagnostics)

    @cached_property
    def constraints(self) -> Lookup[type[Constraint]]:
        """Constraint kinds by the name of their element."""
        return self._lookup("constraints")

    @cached_property
    def stages(self) -> Lookup[Stage]:
        """Stages by name."""
        return self._lookup("stages")

    @cached_property
    def formats(self) -> Lookup[Format]:
        """Formats that ``convert`` reads, by name."""
        return self._lookup("formats")

    @cached_property
    def scene_formats(self) -> Lookup[SceneFormat]:
        """Formats of scenes, by name."""
        return self._lookup("scene_formats")

    @cached_property
    def relationships(self) -> Lookup[Relationship]:
        """Relationship functions, by name."""
        return self._lookup("relationships")

    @cached_property
    def backends(self) -> Lookup[Backend]:
        """Solvers of quadratic programs, by name, in the order in which they are tried."""
        return self._lookup("backends")

    @cached_property
    def operations(self) -> Lookup[type[Operation]]:
        """Kinds of operations by the name of their element."""
        return self._lookup("operations")

    def added_by(self, plugin: str) -> Mapping[str, tuple[str, ...]]:
        """Call every hook, and return what the plugin of that name has added, by lookup."""
        for attribute in _KINDS:
            getattr(self, attribute)
        return {attribute: self._added.get((plugin, attribute), ()) for attribute in _KINDS}

    def _lookup(self, attribute: str) -> Lookup[Any]:
        kind = _KINDS[attribute]
        found: dict[str, Any] = {}
        givers: dict[str, Origin] = {}
        for plugin, origin in self.origins.items():
            for item in self._answers(plugin, origin, kind):
                name = kind.name(item)
                if clash := self._clash(kind, item, found, givers):
                    self._blame("LK405", origin, clash, "the first is used; rename or disable one of the two")
                    continue
                found[name], givers[name] = item, origin
                self._added[plugin, attribute] = (*self._added.get((plugin, attribute), ()), name)
        return Lookup(kind.what, found, self._diagnostics)

    @staticmethod
    def _clash(kind: _Kind, item: Any, found: Mapping[str, Any], givers: Mapping[str, Origin]) -> str:
        """Say which name of an item is taken; empty if none is."""
        name = kind.name(item)
        if name in found:
            return f"adds the {kind.what} {name!r}, which the {givers[name]} has added already"
        if (own := getattr(item, "namespace", None)) is None:
            return ""
        alike = (n for n, o in found.items() if o.namespace.prefix == own.prefix and o.namespace != own)
        if other := next(alike, None):
            return f"has a namespace of the prefix {own.prefix!r}, which is that of the {givers[other]}"
        return ""

    def _answers(self, plugin: str, origin: Origin, kind: _Kind) -> list[Any]:
        """Return what a plugin's hook gives, less what is unusable."""
        caller = getattr(self._manager.hook, kind.hook)
        if plugin not in {implementation.plugin_name for implementation in caller.get_hookimpls()}:
            return []
        others = [p for name, p in self._manager.list_name_plugin() if name != plugin]
        try:
            answers = self._manager.subset_hook_caller(kind.hook, others)()
            given = None if not answers else list(answers[0])
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            self._blame("LK403", origin, f"fails in {kind.hook}: {described(error)}")
            return []
        if given is None:
            self._blame("LK404", origin, f"returns nothing from {kind.hook}", "return a list, if only []")
            return []
        return [item for item in given if self._usable(item, origin, kind)]

    def _usable(self, item: object, origin: Origin, kind: _Kind) -> bool:
        try:
            fault = kind.fault(item) or kind.claim(item, origin)
        except ANYTHING as error:  # attributes of the item may do anything
            fault = described(error)
        if fault:
            self._blame("LK404", origin, f"returns something unusable from {kind.hook}: {fault}")
        return not fault

    def _blame(self, code: str, origin: Origin, what: str, hint: str = "") -> None:
        self._report([Diagnostic(code, f"the {origin} {what}", hint=hint, topic="plugin")])

    def _report(self, diagnostics: Iterable[Diagnostic]) -> None:
        new = [replace(d, severity=self._severity) for d in diagnostics]
        self._diagnostics += new
        if new and self._severity is Severity.ERROR:
            raise Faulty(new)
