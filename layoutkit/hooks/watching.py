"""The watch: a plugin's code that does not come to an end is stopped, and named.

A thread looks at the main one now and then. As long as the same call into a plugin is still there, the time
counts; beyond the patience, `Stuck` is raised in its midst. Nothing has to be wrapped for that, and a plugin
that is not stuck costs nothing.
"""

from __future__ import annotations

import _thread
import os
import signal
import sys
import threading
from collections.abc import Iterable, Sequence
from types import FrameType

from layoutkit.diagnostics import Diagnostic
from layoutkit.diagnostics.blame import Stuck
from layoutkit.diagnostics.origin import Origin, origin_of

#: The environment variable: how many seconds one call into a plugin may take.
PATIENCE = "LAYOUTKIT_PLUGIN_PATIENCE"
#: Without it, so many.
_SECONDS = 60.0
#: How often it is looked, as a share of the patience, and at most so many seconds apart.
_SHARE, _PAUSE = 0.1, 1.0


def watching(origins: Iterable[Origin]) -> tuple[Diagnostic, ...]:
    """Begin to watch the main thread, if there are plugins of others.

    Parameters
    ----------
    origins
        Of these plugins.

    Returns
    -------
    tuple
        What is wrong with the patience that the environment asks for.
    """
    known = tuple(origins)
    if not known or threading.current_thread() is not threading.main_thread():
        return ()
    text = os.environ.get(PATIENCE, "")
    try:
        seconds = float(text) if text else _SECONDS
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        message = f"{PATIENCE} is {text!r}, which is no number of seconds above 0"
        return (Diagnostic("LK707", message, hint="delete it, or write seconds, e.g. 60", topic="usage"),)
    if not any(thread.name == _Watch.__name__ for thread in threading.enumerate()):
        _Watch(known, seconds).start()
    return ()


class _Watch(threading.Thread):
    """Looks at the main thread."""

    def __init__(self, origins: Sequence[Origin], seconds: float) -> None:
        super().__init__(name=type(self).__name__, daemon=True)
        self.origins, self.seconds = origins, seconds
        self._modules: dict[str, bool] = {}
        self._main = threading.main_thread().ident
        _stop_by_signal()

    def run(self) -> None:
        pause = min(_SHARE * self.seconds, _PAUSE)
        call: FrameType | None = None
        spent = 0.0
        waiting = threading.Event()
        while not waiting.wait(pause):
            found = self._call()
            spent = spent + pause if found is not None and found is call else 0.0
            call = found
            if spent > self.seconds:
                _interrupt(self._main)
                spent = 0.0

    def _call(self) -> FrameType | None:
        """Return the outermost call into a plugin under which the main thread is at work."""
        frame = sys._current_frames().get(self._main or 0)
        found = None
        while frame is not None:
            if self._of_plugin(str(frame.f_globals.get("__name__", ""))):
                found = frame
            frame = frame.f_back
        return None if found is None or _of_stage(found) else found

    def _of_plugin(self, module: str) -> bool:
        if module not in self._modules:
            self._modules[module] = origin_of(module, self.origins) is not None
        return self._modules[module]


def _of_stage(call: FrameType) -> bool:
    """Tell whether a call is the run of a stage, which may take as long as its work does."""
    caller = call.f_back
    return caller is not None and caller.f_globals.get("__name__") == "layoutkit.cli.session"


#: On Windows there is but one signal besides that of Ctrl-C that Python handles.
_SIGNAL: signal.Signals = getattr(signal, "SIGUSR1", None) or getattr(signal, "SIGBREAK")  # noqa: B009


def _stop_by_signal() -> None:
    signal.signal(_SIGNAL, _stop)


def _stop(number: int, frame: FrameType | None) -> None:
    raise Stuck("it did not come to an end")


def _interrupt(thread: int | None) -> None:
    """Send the main thread a signal, which also ends its waiting for the system."""
    if hasattr(signal, "pthread_kill") and thread is not None:
        signal.pthread_kill(thread, _SIGNAL)
    else:
        _thread.interrupt_main(_SIGNAL)
