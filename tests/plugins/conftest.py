"""The example plugins, installed by pip as any package is, once a session."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from installing import EXAMPLES, NAMES, Program, environment, pip_install


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with all example plugins installed in it, from copies: builds leave nothing behind."""
    copies = tmp_path_factory.mktemp("examples")
    for name in NAMES:
        shutil.copytree(EXAMPLES / name, copies / name)
    target = tmp_path_factory.mktemp("site")
    pip_install(target, *(copies / name for name in NAMES))
    return target


@pytest.fixture
def program(site: Path, tmp_path: Path) -> Program:
    """Run the command line with the example plugins installed, in a folder of its own."""

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "layoutkit", *map(str, arguments)]
        done = subprocess.run(command, cwd=tmp_path, env=environment(site), capture_output=True, text=True)
        assert "Traceback" not in done.stderr
        return done

    return run
