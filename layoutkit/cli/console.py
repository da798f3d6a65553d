"""What goes to the terminal: results to stdout; diagnostics and progress to stderr."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TextIO, TypeVar

from layoutkit.diagnostics import Diagnostic, Severity

T = TypeVar("T")

#: ANSI colours of the severities.
_COLOURS: Mapping[Severity, str] = {Severity.ERROR: "31", Severity.WARNING: "33", Severity.NOTE: "36"}


def coloured(stream: TextIO) -> bool:
    """Tell whether to write colours to `stream`: only to a terminal, and not where NO_COLOR is set."""
    return stream.isatty() and not os.environ.get("NO_COLOR")


def show(diagnostics: Iterable[Diagnostic]) -> None:
    """Write diagnostics to stderr in their text form."""
    for diagnostic in diagnostics:
        tell(diagnostic, str(diagnostic))


def tell(diagnostic: Diagnostic, text: str) -> None:
    """Write a diagnostic to stderr in a text form of its own."""
    if coloured(sys.stderr):
        label = f"{diagnostic.severity} {diagnostic.code}"
        text = text.replace(label, f"\033[1;{_COLOURS[diagnostic.severity]}m{label}\033[0m", 1)
    print(text, file=sys.stderr)


def say(line: str) -> None:
    """Write a line of the result to stdout."""
    print(line)


def emit(data: Mapping[str, Any]) -> None:
    """Write the result to stdout as JSON, on one line."""
    print(json.dumps(data))


def progress(items: Iterable[T], description: str, total: int) -> Iterator[T]:
    """Pass items on, with a bar on stderr that counts them; no bar where stderr is no terminal."""
    if not sys.stderr.isatty():
        yield from items
        return
    from rich.console import Console
    from rich.progress import track

    console = Console(stderr=True)
    yield from track(items, description, total, console=console, transient=True)
