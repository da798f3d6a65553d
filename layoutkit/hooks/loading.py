"""Finding and importing plugins; one that cannot be loaded is named and skipped."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from importlib.metadata import EntryPoint, entry_points

import pluggy

from layoutkit.diagnostics import Diagnostic, did_you_mean
from layoutkit.hooks import builtin
from layoutkit.hooks.origin import BUILT_IN, Origin
from layoutkit.hooks.specs import PROJECT, Hooks


def installed() -> tuple[EntryPoint, ...]:
    """Return the entry points of every installed plugin, in the order of their names."""
    return tuple(sorted(entry_points(group=PROJECT), key=lambda point: (point.name, point.value)))


def without(
    points: Iterable[EntryPoint], disabled: Collection[str]
) -> tuple[tuple[EntryPoint, ...], tuple[Diagnostic, ...]]:
    """Return the entry points that are not disabled, and a diagnostic for every name that is none."""
    known = tuple(points)
    names = {point.name for point in known}
    unknown = [
        Diagnostic(
            "LK408",
            f"LAYOUTKIT_DISABLE_PLUGINS names {name!r}, which is no installed plugin",
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
        origin = _origin(point)
        if taken := self.origins.get(point.name):
            self._report("LK405", origin, f"is skipped: its name is taken by the {taken}")
            return
        try:
            plugin = point.load()
        except (Exception, SystemExit) as error:
            self._report("LK401", origin, f"cannot be loaded: {described(error)}")
            return
        if same := self.manager.get_name(plugin):
            self._report("LK405", origin, f"is skipped: it is the {self.origins[same]} under another name")
            return
        try:
            self.manager.register(plugin, point.name)
        except Exception as error:  # pluggy's own checks, and whatever a plugin's attributes raise
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


def described(error: BaseException) -> str:
    """Return an error as a user reads it: its kind and what it says."""
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def _origin(point: EntryPoint) -> Origin:
    if point.dist is None:
        return Origin(point.name, "an unknown package", "", point.module)
    return Origin(point.name, point.dist.name, point.dist.version, point.module)
