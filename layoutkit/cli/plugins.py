"""``layoutkit plugins``: what is loaded, from where, what it adds, and what failed; and new ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics.origin import Origin, installed

EXAMPLES = """
Examples:

- `layoutkit plugins`

- `layoutkit --strict plugins --json`

- `layoutkit plugins new constraint slender`
"""

NEW_EXAMPLES = """
Examples:

- `layoutkit plugins new constraint slender`

- `layoutkit plugins new constraint slender:wide -o packages/slender`
"""


class New(StrEnum):
    """What a new plugin may add."""

    CONSTRAINT = "constraint"


def plugins(context: typer.Context, as_json: Json = False) -> int:
    """List the plugins: from which package and version each comes, what it adds, and which ones failed.

    A plugin can be left out by naming it in the environment variable LAYOUTKIT_DISABLE_PLUGINS (several:
    separated by commas). With `layoutkit --strict plugins` a failure ends with exit code 5.
    """
    if context.invoked_subcommand is not None:
        return 0
    session = Session.of(context)
    host = session.host
    added = {origin: host.added_by(name) for name, origin in host.origins.items()}
    session.report()
    if as_json:
        console.emit(
            {
                "plugins": [_as_data(origin, adds) for origin, adds in added.items()],
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
        return 0
    for origin, adds in added.items():
        for line in _lines(origin, adds):
            console.say(line)
    return 0


def new(
    context: typer.Context,
    what: Annotated[New, typer.Argument(metavar="KIND", help="What it adds: constraint.")],
    name: Annotated[
        str,
        typer.Argument(
            metavar="NAME",
            help="Its name, which is also that of its constraint; or PREFIX:ELEMENT, to name each by itself.",
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="The folder to make; by default its name."),
    ] = None,
    as_json: Json = False,
) -> int:
    """Write the beginning of a plugin: a package with a constraint that works, and tests that pass.

    It consists of a pyproject with the entry point, the module, its tests with the conformance suite, a
    readme, and a facade to try it with. Nothing is written over.
    """
    from layoutkit.scaffold import Naming, constraint_package, write_package

    session = Session.of(context)
    naming = Naming.parse(name)
    prefixes = {kind.namespace.prefix for kind in session.host.constraints.values()}
    naming.check({point.name for point in installed()}, prefixes)
    folder = output or Path(naming.prefix)
    package = constraint_package(naming)
    write_package(folder, package)
    if as_json:
        files = [str(folder / path) for path in package]
        console.emit(
            {
                "folder": str(folder),
                "element": naming.element,
                "files": files,
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
        return 0
    for line in _next_steps(folder, naming.module, naming.element):
        console.say(line)
    return 0


def _next_steps(folder: Path, module: str, element: str) -> Iterator[str]:
    yield f"{folder}: a package with the constraint {element}"
    yield f"  cd {folder}"
    yield "  pip install -e '.[test]'"
    yield "  pytest"
    yield "  layoutkit vary example.xml -n 4 --width 130% -o out"
    yield f"then change {Path('src', module, 'constraint.py')}"


def _as_data(origin: Origin, adds: Mapping[str, tuple[str, ...]]) -> dict[str, object]:
    return {
        "name": origin.name,
        "package": origin.package,
        "version": origin.version,
        "adds": {what: list(names) for what, names in adds.items() if names},
    }


def _lines(origin: Origin, adds: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
    yield f"{origin.name} ({origin.package} {origin.version})"
    for what, names in adds.items():
        if names:
            yield f"  {what}: {', '.join(names)}"
