"""What is installed on a machine, as far as results hang on it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from importlib.metadata import PackageNotFoundError, version

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.diagnostics.origin import BUILT_IN, Origin, installed

#: Libraries whose releases may differ in the last digit, or in a picture's bytes.
_LIBRARIES = (
    "numpy",
    "scipy",
    "daqp",
    "clarabel",
    "pillow",
    "shapely",
    "manifold3d",
    "trimesh",
    "mapbox-earcut",
)


def survey() -> Mapping[str, str]:
    """Return versions: of layoutkit as it is imported, of its plugins' packages, and of libraries."""
    others = (origin for origin in map(Origin.of, installed()) if not origin.ours)
    plugins = {_plugin(origin.name): f"{origin.package} {origin.version}" for origin in others}
    return {BUILT_IN.package: BUILT_IN.version, **plugins, **libraries()}


def libraries() -> dict[str, str]:
    """Return the releases of libraries that results hang on."""
    return {name: found for name in _LIBRARIES if (found := _version(name))}


def differences(
    own: Mapping[str, str], others: Mapping[str, Mapping[str, str]], without: Collection[str] = ()
) -> Iterator[Diagnostic]:
    """Yield what differs between this machine and workers (LK894).

    Another layoutkit, or another plugin, is an error; another release of a library a warning.

    Parameters
    ----------
    own, others
        What `survey` says here; and there, by the workers' names.
    without
        Plugins that do not take part.
    """
    left_out = set(map(_plugin, without))
    for worker, theirs in others.items():
        for name in sorted({*own, *theirs}):
            if own.get(name) == theirs.get(name) or name in left_out:
                continue
            here, there = own.get(name) or "none", theirs.get(name) or "none"
            yield Diagnostic(
                "LK894",
                f"the worker {worker} has another {name}: {there}, and {here} here",
                hint="install the same releases on all machines: results are to be the same bytes on each",
                severity=Severity.WARNING if name in _LIBRARIES else Severity.ERROR,
                topic="batch",
            )


def _plugin(name: str) -> str:
    return f"plugin {name!r}"


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
