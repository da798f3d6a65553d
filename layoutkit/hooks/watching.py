"""The watch: a plugin's code that does not come to an end is stopped, and named.

A thread looks at the main one now and then. As long as the same call from layoutkit into a plugin is still
there, the time counts; beyond the patience, `Stuck` is raised in its midst, and again if it goes on. What
cannot be stopped so ends the program. Nothing has to be wrapped for that, and a plugin that is not stuck
costs nothing.
"""

from __future__ import annotations

import _thread
import ctypes
import os
import signal
import sys
import threading
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from types import CodeType, FrameType, FunctionType

from layoutkit.diagnostics import Diagnostic
from layoutkit.diagnostics.blame import Stuck
from layoutkit.diagnostics.origin import BUILT_IN, Origin, origin_of
from layoutkit.hooks.specs import Stage

#: The environment variable: how many seconds one call into a plugin may take.
PATIENCE = "LAYOUTKIT_PLUGIN_PATIENCE"
#: Without it, so many.
_SECONDS = 60.0
#: How often it is looked, as a share of the patience, and at most so many seconds apart.
_SHARE, _PAUSE = 0.1, 1.0
#: A call that goes on is interrupted again after so many seconds, or after the patience if that is shorter.
_AGAIN = 3.0
#: A call that goes on after so many interruptions cannot be interrupted.
_MOST = 3
#: The module from which commands run stages, which may take as long as their work does.
_RUNS_STAGES = "layoutkit.hooks.running"

#: What to do with a diagnostic that says which plugin cannot be interrupted: tell it, and end the program.
Ending = Callable[[Diagnostic], None]


def watching(origins: Iterable[Origin], end: Ending) -> tuple[Diagnostic, ...]:
    """Begin to watch the main thread, if there are plugins of others.

    It is for programs, and takes a signal: SIGUSR1, or SIGBREAK where that is missing. One that comes from
    elsewhere is passed on to whoever handled it before.

    Parameters
    ----------
    origins
        Of all plugins.
    end
        Called, in another thread than the main one, where a plugin cannot be interrupted.

    Returns
    -------
    tuple
        What is wrong with the patience that the environment asks for.
    """
    known = tuple(origins)
    if all(origin.ours for origin in known) or threading.current_thread() is not threading.main_thread():
        return ()
    text = os.environ.get(PATIENCE, "")
    try:
        seconds = float(text) if text else _SECONDS
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        message = f"{PATIENCE} is {text!r}, which is no number of seconds above 0"
        return (Diagnostic("LK707", message, hint="delete it, or write seconds, e.g. 60", topic="usage"),)
    if not any(isinstance(thread, _Watch) for thread in threading.enumerate()):
        _Watch(_Calls(known), seconds, end).start()
    return ()


class _Calls:
    """Tells calls into plugins from all other code.

    Only a call that layoutkit makes is one: an application, or tests, may be of the same package as a plugin.
    """

    def __init__(self, origins: Collection[Origin]) -> None:
        self._others = tuple(origin for origin in origins if not origin.ours)
        self._own = {o.module.partition(".")[0] for o in (BUILT_IN, *origins) if o.ours}
        self._origins: dict[str, Origin | None] = {}

    def under(self, frame: FrameType | None) -> Iterator[FrameType]:
        """Yield the calls into plugins under which a frame is at work, the innermost first."""
        call: FrameType | None = None
        for caller in _stack(frame):
            module = _module(caller)
            if self.origin(module) is not None:
                call = caller
            elif call is not None and module.partition(".")[0] in self._own:
                if module != _RUNS_STAGES and call.f_code not in _codes_of_stages():
                    yield call
                call = None

    def origin(self, module: str) -> Origin | None:
        """Return which of the others' plugins a module is part of."""
        if module not in self._origins:
            own = module.partition(".")[0] in self._own
            self._origins[module] = None if own else origin_of(module, self._others)
        return self._origins[module]


def _stack(frame: FrameType | None) -> Iterator[FrameType]:
    while frame is not None:
        yield frame
        frame = frame.f_back


def _module(frame: FrameType) -> str:
    return str(frame.f_globals.get("__name__", ""))


def _codes_of_stages() -> set[CodeType]:
    """Return the code of every stage's `run`, and of what decorators have wrapped in it."""
    codes: set[CodeType] = set()
    kinds: list[type] = [Stage]
    while kinds:
        kind = kinds.pop()
        kinds += kind.__subclasses__()
        for base in kind.__mro__:
            function = vars(base).get("run")
            while isinstance(function, FunctionType):
                codes.add(function.__code__)
                function = vars(function).get("__wrapped__")
    return codes


@dataclass
class _Patience:
    """How many seconds a call has until it is interrupted, and how often that has been done."""

    left: float
    interrupted: int = 0


class _Watch(threading.Thread):
    """Looks at the main thread."""

    def __init__(self, calls: _Calls, seconds: float, end: Ending) -> None:
        super().__init__(name="layoutkit-watch", daemon=True)
        self._calls, self._seconds, self._end = calls, seconds, end
        self._again = min(seconds, _AGAIN)
        self._message = f"it did not come to an end within {seconds:g} s ({PATIENCE})"
        self._main = threading.main_thread().ident or 0
        self._stopping = _Stopping(self._main, self._message)

    def run(self) -> None:
        pause = min(_SHARE * self._seconds, _PAUSE)
        known: dict[FrameType, _Patience] = {}
        waiting = threading.Event()
        while not waiting.wait(pause):
            calls = self._calls.under(sys._current_frames().get(self._main))
            known = {call: known.get(call) or _Patience(self._seconds + pause) for call in calls}
            for patience in known.values():
                patience.left -= pause
            overdue = {call: patience for call, patience in known.items() if patience.left < 0}
            if overdue:
                self._stop(overdue)

    def _stop(self, overdue: dict[FrameType, _Patience]) -> None:
        for call, patience in overdue.items():
            if patience.interrupted == _MOST:
                self._end(self._diagnostic(call))
            patience.interrupted += 1
            patience.left = self._again
        self._stopping.stop(overdue)

    def _diagnostic(self, call: FrameType) -> Diagnostic:
        origin = self._calls.origin(_module(call))
        message = f"the {origin} failed: {self._message}, and cannot be interrupted"
        hint = "if the plugin is not yours, report it to its author"
        if origin is not None:
            hint += f"; `--without {origin.name}`, before the command, leaves it out"
        at = f"in {call.f_code.co_name}(), {call.f_code.co_filename}:{call.f_lineno}"
        return Diagnostic("LK407", message, hint=hint, topic="plugin", details=(at,))


#: On Windows there is but one signal besides that of Ctrl-C that Python handles.
_SIGNAL: signal.Signals = getattr(signal, "SIGUSR1", None) or getattr(signal, "SIGBREAK")  # noqa: B009


class _Stopping:
    """Raises `Stuck` in a thread, by a signal: that also ends its waiting for the system.

    Made in the main thread.
    """

    def __init__(self, thread: int, message: str) -> None:
        self._thread = thread
        # The interpreter makes the instance, where there is no signal to do so: it has to know what to say.
        self._stuck = type(Stuck.__name__, (Stuck,), {"__str__": lambda _: message})
        self._wanted: frozenset[FrameType] = frozenset()
        self._before = signal.signal(_SIGNAL, self._handle)

    def stop(self, calls: Iterable[FrameType]) -> None:
        """Raise it, if one of these calls still goes on."""
        if signal.getsignal(_SIGNAL) != self._handle:  # a plugin, or its library, has taken the signal
            ctypes.pythonapi.PyThreadState_SetAsyncExc(
                ctypes.c_ulong(self._thread), ctypes.py_object(self._stuck)
            )
            return
        self._wanted = frozenset(calls)
        if hasattr(signal, "pthread_kill"):
            signal.pthread_kill(self._thread, _SIGNAL)
        else:
            _thread.interrupt_main(_SIGNAL)

    def _handle(self, number: int, frame: FrameType | None) -> None:
        wanted, self._wanted = self._wanted, frozenset()
        if not wanted:
            self._pass_on(number, frame)
        elif not wanted.isdisjoint(_stack(frame)):
            raise self._stuck

    def _pass_on(self, number: int, frame: FrameType | None) -> None:
        """Do with a signal of others what would have been done without the watch."""
        if callable(self._before):
            self._before(number, frame)
        elif self._before == signal.SIG_DFL:
            signal.signal(number, signal.SIG_DFL)
            signal.raise_signal(number)
