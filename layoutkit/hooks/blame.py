"""Whose fault an unexpected error is: a plugin's, or our own."""

from __future__ import annotations

import traceback
from collections.abc import Iterable

from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks.loading import described
from layoutkit.hooks.origin import Origin

#: The environment variable that makes the traceback of an unexpected error appear.
DEBUG = "LAYOUTKIT_DEBUG"


def diagnosed(error: BaseException, origins: Iterable[Origin]) -> Diagnostic:
    """Return a diagnostic for an error that nothing foresaw.

    The innermost frame that belongs to another package's plugin decides; without one it is our own fault.

    Parameters
    ----------
    error
        With its traceback.
    origins
        Of all plugins.
    """
    packages = {origin.module.partition(".")[0]: origin for origin in origins if not origin.ours}
    frames = [str(frame.f_globals.get("__name__", "")) for frame, _ in traceback.walk_tb(error.__traceback__)]
    see = f"run the command again with {DEBUG}=1 in the environment to see the traceback"
    for module in reversed(frames):
        if origin := packages.get(module.partition(".")[0]):
            return Diagnostic(
                "LK407",
                f"the {origin} failed: {described(error)}",
                hint=f"report it to the plugin's author; {see}",
                topic="plugin",
            )
    return Diagnostic(
        "LK901",
        f"layoutkit failed: {described(error)}",
        hint=f"this is a fault of ours, please report it; {see}",
        topic="internal",
    )
