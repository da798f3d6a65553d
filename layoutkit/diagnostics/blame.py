"""Whose fault an unexpected error is: a plugin's, or our own."""

from __future__ import annotations

import os
import traceback
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from types import FrameType
from typing import Any, TypeVar

from layoutkit.diagnostics.diagnostic import Diagnostic, Place
from layoutkit.diagnostics.origin import PROJECT, origin_of, origins

T = TypeVar("T")

#: The environment variable that makes the traceback of an unexpected error appear.
DEBUG = "LAYOUTKIT_DEBUG"
_SEE = f"run the command again with {DEBUG}=1 in the environment to see the traceback"


class Misbehaviour(Exception):  # noqa: N818 - it is a fault of what it names, and no error of ours
    """Raised where a plugin's part returned what makes no sense, so that nothing can be made of it.

    Parameters
    ----------
    culprit
        The class, or an instance of it, that returned it.
    what
        What it returned, and what is wrong with that.
    """

    def __init__(self, culprit: object, what: str) -> None:
        kind = culprit if isinstance(culprit, type) else type(culprit)
        self.module, self.what = kind.__module__, what
        self.place: Place | None = getattr(culprit, "place", None)
        super().__init__(f"{kind.__qualname__} {what}")


#: Nobody who is not layoutkit's own gives more answers than this to one question.
MOST = 1_000_000


def bounded(answers: Iterable[T], culprit: object, what: str) -> Iterable[T]:
    """Return answers that come to an end; those of layoutkit's own classes as they are.

    Parameters
    ----------
    answers
        As `culprit` gives them, maybe one by one.
    culprit
        Whose they are.
    what
        What they are, in the plural: ``violations``.

    Raises
    ------
    Misbehaviour
        Once there are more than `MOST`.
    """
    return answers if is_ours(type(culprit)) else _bounded(answers, culprit, what)


def _bounded(answers: Iterable[T], culprit: object, what: str) -> Iterator[T]:
    given = iter(answers)
    yield from islice(given, MOST)
    for _ in given:
        raise Misbehaviour(culprit, f"gives more than {MOST:,} {what}")


#: What users call parts of plugins that have a place in a document, by the class that they derive from.
_CALLED = {"Constraint": "the constraint kind", "Operation": "the operation"}

#: Which classes are layoutkit's own, as far as that has been asked.
_OURS: dict[type, bool] = {}


def is_ours(kind: type) -> bool:
    """Tell whether a class is of the core: our tests look over what those answer, so that no run has to."""
    if kind not in _OURS:
        _OURS[kind] = kind.__module__.partition(".")[0] == PROJECT
    return _OURS[kind]


class Stuck(BaseException):
    """Raised in the midst of a plugin's code that does not come to an end.

    It is no `Exception`, so that the code that is stuck does not catch it by the way.
    """


#: All that a plugin's code may end in, where the work goes on without it.
ANYTHING = (Exception, Stuck, SystemExit)


def unforeseen(error: BaseException, place: Place | None = None) -> Diagnostic:
    """Return the diagnostic of an error that ended some work; its traceback is printed if that is asked."""
    if os.environ.get(DEBUG):
        traceback.print_exception(error)
    return diagnosed(error, place=place)


def diagnosed(
    error: BaseException, culprit: type | None = None, what: str = "", place: Place | None = None
) -> Diagnostic:
    """Return a diagnostic for an error that nothing foresaw.

    The innermost frame that belongs to another package's plugin decides; without one it is our own fault,
    unless the culprit is known, and none of ours.

    Parameters
    ----------
    error
        With its traceback.
    culprit
        The class that was asked when it arose, where that is known.
    what
        What users call that: ``the constraint kind 'golden:ratio'``.
    place
        Where in a document that stands.
    """
    if isinstance(error, Misbehaviour):
        place = place or error.place
    frames = [frame for frame, _ in traceback.walk_tb(error.__traceback__)]
    whose, own = _blamed(error, culprit.__module__ if culprit is not None else "", frames)
    if not whose:
        message = f"{what or 'layoutkit'} failed: {described(error)}"
        hint = f"this is a fault of ours, please report it; {_SEE}"
        return Diagnostic("LK901", message, place, hint, topic="internal")
    asked: Any = own.f_locals.get("self") if own is not None else None
    called = next((_CALLED[base.__name__] for base in type(asked).__mro__ if base.__name__ in _CALLED), "")
    if not what and called:
        what, place = f"{called} {asked.qualified_name()!r}", place or asked.place
    who = f"{what} of {whose}" if what else whose
    line = next((n for frame, n in traceback.walk_tb(error.__traceback__) if frame is own), 0)
    at = () if own is None else (f"in {own.f_code.co_name}(), {own.f_code.co_filename}:{line}",)
    hint = f"if the plugin is not yours, report it to its author; {_SEE}"
    return Diagnostic("LK407", f"{who} failed: {described(error)}", place, hint, topic="plugin", details=at)


def described(error: BaseException) -> str:
    """Return an error as a user reads it: its kind and what it says."""
    if isinstance(error, Misbehaviour):
        return str(error)
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def _blamed(error: BaseException, culprit: str, frames: Sequence[FrameType]) -> tuple[str, FrameType | None]:
    """Return whose plugin had to do with an error, and its innermost frame; empty for our own."""
    known = origins()
    if isinstance(error, Misbehaviour):
        origin = origin_of(error.module, known)
        if origin is not None and not origin.ours:
            return f"the {origin}", None
    for frame in reversed(frames):
        origin = origin_of(str(frame.f_globals.get("__name__", "")), known)
        if origin is not None and not origin.ours:
            return f"the {origin}", frame
    origin = origin_of(culprit, known) if culprit else None
    if origin is not None and not origin.ours:
        return f"the {origin}", None
    return (f"the module {culprit}" if culprit and origin is None else ""), None
