"""The console script: its commands, and how every run ends."""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Iterable, Sequence
from typing import Annotated

import typer

from layoutkit import __version__
from layoutkit.cli import console, usage
from layoutkit.cli.convert import convert
from layoutkit.cli.exits import Exit, exit_of
from layoutkit.cli.infer import infer
from layoutkit.cli.inspect import inspect
from layoutkit.cli.plugins import plugins
from layoutkit.cli.render import render
from layoutkit.cli.samples import samples
from layoutkit.cli.schema import schema
from layoutkit.cli.session import Session
from layoutkit.cli.validate import validate
from layoutkit.cli.vary import vary
from layoutkit.diagnostics import Diagnostic, Faulty, Severity

COMMANDS = (samples, convert, infer, vary, inspect, validate, render, plugins, schema)

app = typer.Typer(
    name="layoutkit",
    help="Make many plausible variations of one segmented facade.",
    epilog="First steps: `layoutkit samples plain -o plain`, then `layoutkit vary plain/facade.xml -n 8 -o out`.",
    invoke_without_command=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"]},
)
for command in COMMANDS:
    app.command(epilog=getattr(command, "examples", None))(command)


def _show_version(wanted: bool) -> None:
    if wanted:
        console.say(f"layoutkit {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version.")
    ] = False,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            envvar="LAYOUTKIT_STRICT",
            help="Stop at a plugin that fails, with exit code 5, instead of going on without it.",
        ),
    ] = False,
) -> None:
    if strict:
        Session.of(context).severity = Severity.ERROR
    if context.invoked_subcommand is None:
        typer.echo(context.get_help(), err=True)
        raise typer.Exit(Exit.USAGE)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, and return its exit code; no error leaves as a traceback.

    Parameters
    ----------
    arguments
        Without the program's name; by default those of the process.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    session = Session()
    try:
        try:
            code = _run(given, session)
        except Exception as error:
            if isinstance(error, BrokenPipeError):
                raise
            code = _fail(error, session, "--json" in given)
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        # Whoever read our output has gone: what is still buffered goes nowhere, and without a message.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return Exit.BROKEN_PIPE
    except KeyboardInterrupt:
        return Exit.INTERRUPTED


def _run(arguments: list[str], session: Session) -> int:
    code = app(arguments, prog_name="layoutkit", standalone_mode=False, obj=session)
    session.report()
    return int(code or Exit.DONE)


def _fail(error: Exception, session: Session, as_json: bool) -> int:
    """Report an error that ended a command, and return the exit code."""
    diagnostics = _diagnosed(error, session)
    session.report(diagnostics)
    if as_json:
        console.emit({"diagnostics": [d.as_dict() for d in session.diagnostics]})
    return exit_of(diagnostics)


def _diagnosed(error: Exception, session: Session) -> Iterable[Diagnostic]:
    if isinstance(error, Faulty):
        return error.diagnostics
    if isinstance(error, usage.UsageFault):
        return [usage.diagnosed(error, tuple(command.__name__ for command in COMMANDS))]
    from layoutkit.hooks import blame

    if os.environ.get(blame.DEBUG):
        traceback.print_exception(error)
    origins = session.host.origins.values() if "host" in vars(session) else ()
    return [blame.diagnosed(error, origins)]
