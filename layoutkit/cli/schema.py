"""``layoutkit schema``: the XSD of documents, with the constraints of all plugins."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.session import Session

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
) -> int:
    """Print the XML schema of documents, the constraints of installed plugins included.

    An XML editor that is given it completes names and explains every element and attribute.
    """
    from layoutkit import documents

    session = Session.of(context)
    text = documents.schema(session.host.constraints)
    if output is None:
        console.say(text.decode().rstrip("\n"))
    else:
        session.write(output, text)
        console.say(str(output))
    return 0
