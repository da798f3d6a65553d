"""Faults in the use of commands as diagnostics like all others, instead of typer's own boxes."""

from __future__ import annotations

from collections.abc import Sequence

import typer

from layoutkit.diagnostics import Diagnostic, did_you_mean

#: The class of all that is wrong with a command line. Some releases of typer use click, some a copy of it of
#: their own: this is the one that the installed release raises.
UsageFault: type[Exception] = next(c for c in typer.BadParameter.__mro__ if c.__name__ == "ClickException")


def diagnosed(error: Exception, commands: Sequence[str]) -> Diagnostic:
    """Return the diagnostic of a fault in the command line.

    Parameters
    ----------
    error
        What typer raised, a `UsageFault`.
    commands
        The names of all commands.
    """
    context = getattr(error, "ctx", None)
    command = context.command_path if context is not None else "layoutkit"
    return Diagnostic(
        "LK701",
        _message(error),
        hint=_suggestion(error, _known(context) or commands) or f"`{command} --help` tells how it is used",
        topic="usage",
    )


def _known(context: object) -> Sequence[str]:
    """Return the commands below the one that was called, if it has some."""
    return tuple(getattr(getattr(context, "command", None), "commands", ()))


def _message(error: Exception) -> str:
    if name := getattr(error, "option_name", None):
        return f"there is no option {name}"
    text = str(getattr(error, "message", "") or getattr(error, "format_message", error.__str__)())
    if text.startswith("No such command"):
        return f"there is no command {_unknown_command(text)}"
    shown = str(getattr(error, "format_message", error.__str__)())
    return " ".join(shown.split()).rstrip(".")


def _suggestion(error: Exception, commands: Sequence[str]) -> str:
    possible = getattr(error, "possibilities", None)
    if possible:
        return f"did you mean {' or '.join(sorted(possible))}?"
    text = str(getattr(error, "message", ""))
    if text.startswith("No such command"):
        return did_you_mean(_unknown_command(text).strip("'"), commands)
    return ""


def _unknown_command(text: str) -> str:
    return "'" + text.split("'")[1] + "'" if "'" in text else ""
