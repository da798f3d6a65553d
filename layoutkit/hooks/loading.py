"""Finding and importing plugins; one that cannot be loaded is named and skipped."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from importlib.metadata import EntryPoint

import pluggy

from layoutkit.diagnostics import Diagnostic, did_you_mean
from layoutkit.diagnostics.blame import ANYTHING, described
from layoutkit.diagnostics.origin import BUILT_IN, PROJECT, Origin
from layoutkit.hooks import builtin
from layoutkit.hooks.specs import API, API_VERSION, Hooks


def remaining(
    points: Iterable[EntryPoint], disabled: Collection[str]
) -> tuple[tuple[EntryPoint, ...], tuple[Diagnostic, ...]]:
    """Return the entry points that are not disabled, and a diagnostic for every name that is none."""
    known = tuple(points)
    names = {point.name for point in known}
    unknown = [
        Diagnostic(
            "LK408",
            f"{name!r} is to be left out, and is no installed plugin",
            hint=did_you_mean(name, names),
            topic="plugin",
        )
        for name in sorted(set(disabled) - names)
    ]
    return tuple(point for point in known if point.name not in disabled), tuple(unknown)


class Loaded:
    """The plugins that could be loaded, registered with a manager, and what was wrong with the others.

    Attributes
    ----------
    origins
        By the plugin's name, in the order of registration, the built-in one first.
    diagnostics
        All of them errors; the host decides how grave they are.
    """

    def __init__(self, points: Iterable[EntryPoint]) -> None:
        self.manager = pluggy.PluginManager(PROJECT)
        self.manager.add_hookspecs(Hooks)
        self.manager.register(builtin, BUILT_IN.name)
        self.origins: dict[str, Origin] = {BUILT_IN.name: BUILT_IN}
        self.diagnostics: list[Diagnostic] = []
        for point in points:
            self._load(point)

    def _load(self, point: EntryPoint) -> None:
        origin = Origin.of(point)
        if taken := self.origins.get(point.name):
            self._report("LK405", origin, f"is skipped: its name is taken by the {taken}")
            return
        try:
            plugin = point.load()
        except ANYTHING as error:
            self._report("LK401", origin, f"cannot be loaded: {described(error)}")
            return
        if (wanted := getattr(plugin, API, API_VERSION)) != API_VERSION:
            what = f"is for version {wanted!r} of the plugin interface; this layoutkit has {API_VERSION}"
            older = isinstance(wanted, int) and wanted < API_VERSION
            hint = (
                f"upgrade {origin.package}"
                if older
                else f"upgrade layoutkit, or install another {origin.package}"
            )
            self._report("LK409", origin, what, hint)
            return
        if same := self.manager.get_name(plugin):
            self._report("LK405", origin, f"is skipped: it is the {self.origins[same]} under another name")
            return
        try:
            self.manager.register(plugin, point.name)
        except ANYTHING as error:  # pluggy's own checks, and whatever a plugin's attributes raise
            self.manager.unregister(plugin, point.name)
            self._report("LK402", origin, f"does not fit the hooks: {described(error)}")
            return
        self.origins[point.name] = origin
        self._check_hooks(plugin, origin)

    def _check_hooks(self, plugin: object, origin: Origin) -> None:
        """Report hooks that are not there: pluggy would leave them silently inactive."""
        callers = self.manager.get_hookcallers(plugin) or []
        known = [name for name in vars(Hooks) if name.startswith(f"{PROJECT}_")]
        for caller in callers:
            if not caller.has_spec():
                self._report(
                    "LK402",
                    origin,
                    f"implements {caller.name!r}, which is no hook",
                    did_you_mean(caller.name, known),
                )
        if not callers:
            self._report("LK402", origin, "implements no hook", "mark its functions with @hookimpl")

    def _report(self, code: str, origin: Origin, what: str, hint: str = "") -> None:
        self.diagnostics.append(Diagnostic(code, f"the {origin} {what}", hint=hint, topic="plugin"))
