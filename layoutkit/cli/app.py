"""The console script: its commands, and how every run ends."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Annotated

import typer

from layoutkit import __version__
from layoutkit.cli import (
    apply,
    batch,
    console,
    constraints,
    convert,
    count,
    explain,
    grids,
    infer,
    inspect,
    learn,
    place,
    plugins,
    propagate,
    propose,
    render,
    replay,
    samples,
    schema,
    usage,
    validate,
    vary,
)
from layoutkit.cli.declared import command_class
from layoutkit.cli.exits import Exit, exit_of
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Severity, blame
from layoutkit.sizing.threads import begin_single_threaded

#: Every command and its examples, in the order in which a newcomer meets them.
COMMANDS: tuple[tuple[Callable[..., int], str], ...] = (
    (samples.samples, samples.EXAMPLES),
    (vary.vary, vary.EXAMPLES),
    (batch.batch, batch.EXAMPLES),
    (count.count, count.EXAMPLES),
    (explain.explain, explain.EXAMPLES),
    (grids.grids, grids.EXAMPLES),
    (propose.propose, propose.EXAMPLES),
    (apply.apply, apply.EXAMPLES),
    (place.place, place.EXAMPLES),
    (propagate.propagate, propagate.EXAMPLES),
    (learn.learn, learn.EXAMPLES),
    (replay.replay, replay.EXAMPLES),
    (convert.convert, convert.EXAMPLES),
    (infer.infer, infer.EXAMPLES),
    (inspect.inspect, inspect.EXAMPLES),
    (validate.validate, validate.EXAMPLES),
    (render.render, render.EXAMPLES),
    (constraints.constraints, constraints.EXAMPLES),
    (plugins.plugins, plugins.EXAMPLES),
    (schema.schema, schema.EXAMPLES),
)

#: Commands that have others below them, each with its examples.
GROUPS: Mapping[str, tuple[tuple[Callable[..., int], str], ...]] = {
    "plugins": ((plugins.new, plugins.NEW_EXAMPLES),),
}

app = typer.Typer(
    name="layoutkit",
    help="Make many plausible variations of one segmented facade.",
    epilog="First: `layoutkit samples plain -o plain`, then `layoutkit vary plain/facade.xml -n 8 -o out`.",
    invoke_without_command=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _add(command: Callable[..., int], examples: str) -> None:
    """Add a command, with those below it if there are some."""
    name = command.__name__
    if name not in GROUPS:
        app.command(cls=command_class(command), epilog=examples)(command)
        return
    group = typer.Typer(name=name, invoke_without_command=True, rich_markup_mode="markdown")
    group.callback(epilog=examples)(command)
    for inner, inner_examples in GROUPS[name]:
        group.command(epilog=inner_examples)(inner)
    app.add_typer(group)


for command, examples in COMMANDS:
    _add(command, examples)


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
            help="Stop at once at a plugin that fails, instead of going on without it.",
        ),
    ] = False,
    without: Annotated[
        list[str] | None,
        typer.Option(
            "--without",
            metavar="PLUGIN",
            help="A plugin to leave out of this run; may be given several times.",
        ),
    ] = None,
    backend: Annotated[
        str | None,
        typer.Option(
            "--backend",
            metavar="NAME",
            help="The solver of quadratic programs to ask first; `layoutkit plugins` lists those there are.",
        ),
    ] = None,
) -> None:
    session = Session.of(context)
    session.backend = backend
    session.without = frozenset(without or ())
    if strict:
        session.severity = Severity.ERROR
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())
        raise typer.Exit(Exit.USAGE)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, and return its exit code; no error leaves as a traceback.

    Parameters
    ----------
    arguments
        Without the program's name; by default those of the process.
    """
    begin_single_threaded()
    given = list(sys.argv[1:] if arguments is None else arguments)
    session = Session()
    try:
        code = _run(given, session)
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        # Whoever read our output has gone: what is still buffered goes nowhere, and without a message.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return Exit.BROKEN_PIPE
    except (KeyboardInterrupt, typer.Abort):
        return Exit.INTERRUPTED


def _run(arguments: list[str], session: Session) -> int:
    try:
        code = app(arguments, prog_name="layoutkit", standalone_mode=False, obj=session)
        session.report()
        return Exit.PLUGIN if session.plugin_failed else int(code or Exit.DONE)
    except (BrokenPipeError, KeyboardInterrupt, typer.Abort):
        raise
    except BaseException as error:  # no traceback reaches a user, but whose fault it is
        if isinstance(error.__context__, BrokenPipeError):  # typer's own way to end where a pipe is broken
            raise BrokenPipeError from error
        return _fail(error, session, "--json" in arguments)


def _fail(error: BaseException, session: Session, as_json: bool) -> int:
    """Report an error that ended a command, and return the exit code."""
    diagnostics = _diagnosed(error)
    session.report(diagnostics)
    if as_json:
        console.emit({"diagnostics": [d.as_dict() for d in session.diagnostics]})
    code = exit_of(diagnostics)
    return Exit.PLUGIN if session.plugin_failed and code is not Exit.INTERNAL else code


def _diagnosed(error: BaseException) -> Iterable[Diagnostic]:
    if isinstance(error, Faulty):
        return error.diagnostics
    if isinstance(error, usage.UsageFault):
        return [usage.diagnosed(error, [command.__name__ for command, _ in COMMANDS])]
    return [blame.unforeseen(error)]
