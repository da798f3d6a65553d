"""Packages with plugins, installed by pip as any package is."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "plugins" / "examples"
NAMES = sorted(folder.parent.name for folder in EXAMPLES.glob("*/pyproject.toml"))

Program = Callable[..., "subprocess.CompletedProcess[str]"]


def pip_install(target: Path, *folders: Path) -> None:
    """Install packages into a folder; what they are built with, and depend on, is here already."""
    command = [sys.executable, "-m", "pip", "install", "--no-deps", "--no-build-isolation", "--quiet"]
    options = ["--disable-pip-version-check", "--no-index", "--target", str(target)]
    done = subprocess.run([*command, *options, *map(str, folders)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def environment(*folders: Path) -> dict[str, str]:
    """Return an environment with folders on the path of modules, the program under test among them."""
    paths = [*map(str, folders), str(ROOT), str(ROOT / "plugins"), os.environ.get("PYTHONPATH", "")]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths)), "PYTHONDONTWRITEBYTECODE": "1"}
