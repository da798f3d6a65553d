"""``layoutkit plugins``: what is loaded, from where, what it adds, and what failed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.hooks.origin import Origin

EXAMPLES = """
Examples:

- `layoutkit plugins`

- `layoutkit --strict plugins --json`
"""


def plugins(context: typer.Context, as_json: Json = False) -> int:
    """List the plugins: from which package and version each comes, what it adds, and which ones failed.

    A plugin can be left out by naming it in the environment variable LAYOUTKIT_DISABLE_PLUGINS (several:
    separated by commas). With `layoutkit --strict plugins` a failure ends with exit code 5.
    """
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
