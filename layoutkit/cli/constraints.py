"""``layoutkit constraints``: the kinds of constraints that there are, and one of them in full."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.constraints.attributes import Attribute
    from layoutkit.diagnostics.origin import Origin
    from layoutkit.hooks.host import Host

EXAMPLES = """
Examples:

- `layoutkit constraints`

- `layoutkit constraints same-size`
"""

#: For each type of attribute that is built in, a value as documents write it.
_VALUES = {
    "measure": "120%",
    "count": "2",
    "regions": "@Window",
    "members": "@Window",
    "extent": "@Window",
    "word": "|- Pier Bay",
    "context": "|-",
    "pairs": "E:K",
    "weight": "1",
    "bias": "0.5",
    "path": "Facade/Floor",
    "enclosing path": "Facade/Floor",
    "paths": "Facade/Floor",
    "pattern": "Pier (Bay)+[Pier] Pier",
}


def constraints(
    context: typer.Context,
    kind: Annotated[
        str | None, typer.Argument(metavar="[KIND]", help="The kind to explain; without it, all are listed.")
    ] = None,
    as_json: Json = False,
) -> int:
    """List the kinds of constraints, those of plugins among them, or explain one with its attributes.

    A plugin's kind goes by the name of its element with the prefix of its namespace, such as `golden:ratio`.
    """
    session = Session.of(context)
    host = session.host
    givers = _givers(host)
    shown = host.constraints if kind is None else {kind: _find(kind, host)}
    session.report()
    if as_json:
        diagnostics = [d.as_dict() for d in session.diagnostics]
        data = [_as_data(one, givers[name]) for name, one in shown.items()]
        console.emit({"constraints": data, "diagnostics": diagnostics})
        return 0
    width = max(map(len, shown))
    for name, one in shown.items():
        lines = [_line(one, givers[name], width)] if kind is None else _in_full(one, givers[name])
        for line in lines:
            console.say(line)
    return 0


def _find(name: str, host: Host) -> type[Constraint]:
    """Return the kind of a name; whoever leaves out a prefix is told it."""
    prefixed = [known for known in host.constraints if known.partition(":")[2] == name]
    if name in host.constraints or not prefixed:
        return host.constraints.find(name)
    message = f"there is no constraint {name!r} without a prefix"
    hint = f"did you mean {' or '.join(map(repr, prefixed))}?"
    raise Faulty([Diagnostic("LK406", message, hint=hint, topic="plugin")])


def _givers(host: Host) -> dict[str, Origin]:
    """Return which plugin each kind is of."""
    return {
        name: origin
        for plugin, origin in host.origins.items()
        for name in host.added_by(plugin)["constraints"]
    }


def _line(kind: type[Constraint], origin: Origin, width: int) -> str:
    whose = "" if origin.ours else f" ({origin.package} {origin.version})"
    return f"{kind.qualified_name():{width}}  {_first_sentence(kind.summary)}{whose}"


def _first_sentence(text: str) -> str:
    for mark in (". ", ": ", "; "):
        text = text.partition(mark)[0]
    return text.rstrip(".")


def _in_full(kind: type[Constraint], origin: Origin) -> Iterator[str]:
    yield kind.qualified_name() + ("" if origin.ours else f", of the {origin}")
    yield f"  {kind.summary}"
    yield ""
    attributes = kind.attributes()
    width = max(len(a.name) for a in attributes)
    for attribute in attributes:
        yield f"  {attribute.name:{width}}  {attribute.help}"
        yield f"  {'':{width}}  {_type(attribute)}; {_need(attribute)}"
    yield ""
    yield f"  {example(kind)}"


def _type(attribute: Attribute) -> str:
    own = attribute.type
    if not own.choices:
        return own.name
    return f"{'some' if own.many else 'one'} of {', '.join(own.choices)}"


def _need(attribute: Attribute) -> str:
    if attribute.required:
        return "required"
    default = _default(attribute)
    return "optional" if default is None else f"{default} if left out"


def _default(attribute: Attribute) -> str | None:
    if attribute.required or attribute.default is None:
        return None
    return attribute.type.text(attribute.default)


def example(kind: type[Constraint]) -> str:
    """Return an element of a kind with all attributes that it must have."""
    from html import escape

    values = {a.name: _value(a) for a in kind.attributes() if a.required}
    if kind.namespace.prefix:
        values = {f"xmlns:{kind.namespace.prefix}": kind.namespace.uri, **values}
    written = (f'{name}="{escape(value)}"' for name, value in values.items())
    return f"<{' '.join([kind.qualified_name(), *written])}/>"


def _value(attribute: Attribute) -> str:
    own = attribute.type
    return own.choices[0] if own.choices else _VALUES.get(own.name, "...")


def _as_data(kind: type[Constraint], origin: Origin) -> dict[str, Any]:
    return {
        "name": kind.qualified_name(),
        "namespace": kind.namespace.uri,
        "summary": kind.summary,
        "plugin": origin.name,
        "package": origin.package,
        "version": origin.version,
        "attributes": [_attribute(attribute) for attribute in kind.attributes()],
        "example": example(kind),
    }


def _attribute(attribute: Attribute) -> dict[str, Any]:
    return {
        "name": attribute.name,
        "type": attribute.type.name,
        "choices": list(attribute.type.choices),
        "required": attribute.required,
        "default": _default(attribute),
        "help": attribute.help,
    }
