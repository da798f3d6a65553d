"""``layoutkit schema``: the XSD of documents, with the constraints and operations of all plugins."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean

EXAMPLES = """
Examples:

- `layoutkit schema -o layoutkit.xsd`
"""


def schema(
    context: typer.Context,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Where to write it, if not to stdout."),
    ] = None,
    namespace: Annotated[
        str | None,
        typer.Option(
            "--namespace",
            metavar="PREFIX",
            help="Instead the part with the constraints and operations of one plugin, by the prefix of its "
            "namespace.",
        ),
    ] = None,
) -> int:
    """Print the XML schema of documents, the constraints and operations of installed plugins included.

    An XML editor that is given it completes names and explains every element and attribute. What plugins add
    stands in namespaces of their own, and so in files of their own: with -o they are written beside the
    schema, which imports them.
    """
    from layoutkit import documents

    session = Session.of(context)
    host, name = session.host, "layoutkit.xsd" if output is None else output.name
    parts = dict(documents.schemas(host.constraints, host.operations, name))
    main = parts.pop(name)
    if namespace is not None:
        main, parts = _part(parts, namespace), {}
    if output is None:
        console.say(main.decode().rstrip("\n"))
        return 0
    for path, text in {output: main, **{output.parent / name: text for name, text in parts.items()}}.items():
        session.write(path, text)
        console.say(str(path))
    return 0


def _part(parts: Mapping[str, bytes], prefix: str) -> bytes:
    """Return the schema of one plugin's constraints and operations."""
    name = f"{prefix}.xsd"
    if name in parts:
        return parts[name]
    known = [file.removesuffix(".xsd") for file in parts]
    message = f"no plugin has constraints or operations of the prefix {prefix!r}"
    hint = did_you_mean(prefix, known) if known else "`layoutkit plugins` lists what is loaded"
    raise Faulty([Diagnostic("LK406", message, hint=hint, topic="plugin")])
