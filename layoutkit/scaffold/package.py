"""The files of a new plugin package, made from templates, and written whole or not at all."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from string import Template

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.scaffold.naming import Naming

#: Templates by the file that each becomes; names in braces are filled in.
_FILES: Mapping[str, str] = {
    "pyproject.toml": "pyproject.toml.txt",
    "README.md": "readme.md.txt",
    ".gitignore": "gitignore.txt",
    "example.xml": "example.xml.txt",
    "src/{module}/__init__.py": "plugin.py.txt",
    "src/{module}/constraint.py": "constraint.py.txt",
    "src/{module}/py.typed": "py.typed.txt",
    "tests/test_{module}.py": "tests.py.txt",
}


def constraint_package(naming: Naming) -> dict[str, str]:
    """Return the files of a package with one constraint kind: text by path."""
    names = {
        "prefix": naming.prefix,
        "kind": naming.kind,
        "module": naming.module,
        "class_name": naming.class_name,
        "element": naming.element,
        "uri": naming.uri,
    }
    folder = files("layoutkit.scaffold") / "templates"
    return {
        path.format_map(names): Template((folder / name).read_text(encoding="utf-8")).substitute(names)
        for path, name in _FILES.items()
    }


def write_package(folder: Path, package: Mapping[str, str]) -> None:
    """Write the files of a package into a new folder.

    Raises
    ------
    Faulty
        If there is something of that name (LK704), or it cannot be written (LK008).
    """
    if folder.exists() or folder.is_symlink():
        message = "is there already, and is not written over"
        hint = "name another folder with -o, or move this one away"
        raise Faulty([Diagnostic("LK704", message, Place(str(folder)), hint, topic="usage")])
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as beside:
            made = Path(beside) / folder.name
            for path, text in package.items():
                (made / path).parent.mkdir(parents=True, exist_ok=True)
                (made / path).write_text(text, encoding="utf-8", newline="\n")
            shutil.move(made, folder)
    except OSError as error:
        message = f"cannot be written: {error.strerror or error}"
        hint = "name another place with -o, or make room and permissions for this one"
        raise Faulty([Diagnostic("LK008", message, Place(str(folder)), hint, topic="file")]) from error
