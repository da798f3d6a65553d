"""Options of commands that the fields of a dataclass declare: each is written down once, with its help.

typer makes options of a function's parameters. `declared_by` gives a command one for each field, and hands it
all of them as one value. Where the dataclass is that of a stage, which the core knows by its hook alone,
`declared_by_stage` looks it up once the command is asked for.
"""

from __future__ import annotations

import functools
import inspect
import typing
from collections.abc import Callable, Iterator
from dataclasses import MISSING, Field, fields
from typing import Annotated, Any

import typer
from typer.core import TyperCommand
from typer.main import get_params_convertors_ctx_param_name_from_function

from layoutkit.cli.options import finite
from layoutkit.cli.session import Session

Command = Callable[..., int]


def declared_by(cls: type, parameter: str) -> Callable[[Command], Command]:
    """Return a decorator that makes options of the fields of a dataclass.

    A field has its help in its metadata; a number is at least `least`, 0 unless the metadata say otherwise.
    What may be true or false is ``--name`` or ``--no-name``; of what there may be many, each is given by
    itself. `metavar` in the metadata is what stands for a word, such as ``LABEL``.

    Parameters
    ----------
    cls
        A frozen dataclass, every field with a default.
    parameter
        The command's parameter that takes an instance of it.
    """
    types = typing.get_type_hints(cls)

    def decorated(command: Command) -> Command:
        own = inspect.signature(command, eval_str=True)

        @functools.wraps(command)
        def called(**given: Any) -> int:
            values = {field.name: _value(field, given.pop(field.name)) for field in fields(cls)}
            return command(**given, **{parameter: cls(**values)})

        called.__signature__ = own.replace(  # type: ignore[attr-defined]  # which typer goes by
            parameters=list(_parameters(own, parameter, [_option(f, types[f.name]) for f in fields(cls)]))
        )
        return called

    return decorated


def declared_by_stage(stage: str, parameter: str) -> Callable[[Command], Command]:
    """Return a decorator that makes options of the settings of a stage: the field `settings` of its options.

    The command is to be of the class that `command_class` returns for it.

    Parameters
    ----------
    stage
        The stage's name.
    parameter
        The command's parameter that takes the settings.
    """

    def decorated(command: Command) -> Command:
        own = inspect.signature(command, eval_str=True)

        @functools.wraps(command)
        def called(context: typer.Context, **given: Any) -> int:
            cls = type(_settings_of(context, stage))
            values = {field.name: _value(field, given.pop(field.name)) for field in fields(cls)}
            return command(context=context, **given, **{parameter: cls(**values)})

        parameters = list(_parameters(own, parameter, []))
        called.__signature__ = own.replace(parameters=parameters)  # type: ignore[attr-defined]  # for typer
        called.settings_of = stage  # type: ignore[attr-defined]  # which `command_class` goes by
        return called

    return decorated


def command_class(command: Command) -> type[TyperCommand]:
    """Return what a command is of: one that has the options of a stage's settings, or an ordinary one."""
    stage: str = getattr(command, "settings_of", "")
    if not stage:
        return TyperCommand

    class StageCommand(TyperCommand):
        """A command with options that a stage declares."""

        def get_params(self, ctx: Any) -> list[Any]:
            return [*self.params, *_stage_options(ctx, stage), *super().get_params(ctx)[len(self.params) :]]

    return StageCommand


def given(context: typer.Context, cls: type) -> list[str]:
    """Return the options of a dataclass's fields that the command line names, as it writes them."""
    sources = {field.name: context.get_parameter_source(field.name) for field in fields(cls)}
    return [f"--{_written(name)}" for name, source in sources.items() if source and source.name != "DEFAULT"]


def _settings_of(context: Any, stage: str) -> Any:
    """Return the default settings of a stage.

    Raises
    ------
    Faulty
        If no plugin has the stage.
    """
    return Session.of(context).host.stages.find(stage).options().settings


def _stage_options(context: Any, stage: str) -> list[Any]:
    """Return the options of a stage's settings, as typer makes them of a function's parameters."""
    cls = type(_settings_of(context, stage))
    types = typing.get_type_hints(cls)

    def bearer() -> None:
        """Bear the parameters."""

    options = [_option(field, types[field.name]) for field in fields(cls)]
    bearer.__signature__ = inspect.Signature(options)  # type: ignore[attr-defined]  # for typer
    return list(get_params_convertors_ctx_param_name_from_function(bearer)[0])


def _parameters(
    own: inspect.Signature, replaced: str, options: list[inspect.Parameter]
) -> Iterator[inspect.Parameter]:
    """Yield a command's parameters, options in the place of one of them; all are handed over by name."""
    for parameter in own.parameters.values():
        if parameter.name == replaced:
            yield from options
        else:
            yield parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)


def _option(field: Field[Any], kind: Any) -> inspect.Parameter:
    """Return a field as the parameter that typer makes an option of."""
    default = field.default if field.default is not MISSING else None
    name, told = f"--{_written(field.name)}", field.metadata["help"]
    if kind is bool:
        annotation: Any = Annotated[bool, typer.Option(f"{name}/--no-{_written(field.name)}", help=told)]
    elif typing.get_origin(kind) is tuple:
        told = f"{told} May be given several times."
        metavar = field.metadata.get("metavar", "NAME")
        option = typer.Option(name, metavar=metavar, show_default=False, help=told)
        annotation, default = Annotated[list[str] | None, option], None
    elif _numeric(kind):
        option = typer.Option(
            name,
            min=field.metadata.get("least", 0),
            callback=_finite,
            show_default=default is not None,
            help=told,
        )
        annotation = Annotated[kind, option]
    else:
        metavar, shown = field.metadata.get("metavar"), default not in (None, "")
        annotation = Annotated[kind, typer.Option(name, metavar=metavar, show_default=shown, help=told)]
    return inspect.Parameter(
        field.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation
    )


def _numeric(kind: Any) -> bool:
    return bool({int, float} & {kind, *typing.get_args(kind)})


def _finite(value: float | None) -> float | None:
    return None if value is None else finite(value)


def _value(field: Field[Any], given: Any) -> Any:
    """Return an option's value as the field has it."""
    if given is None and field.default is not MISSING:
        return field.default
    return tuple(given) if isinstance(given, (list, tuple)) else given


def _written(name: str) -> str:
    return name.replace("_", "-")
