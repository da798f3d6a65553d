"""The watch over plugins: what hangs is stopped, whatever it does about that, and nothing else is."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from itertools import count, repeat
from pathlib import Path
from typing import Any

import pytest
from odd_kind import FACADE

from layoutkit.constraints import Constraint, Size, answers
from layoutkit.diagnostics import blame
from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.model import Violation

KIND = """
import signal
import time
from dataclasses import dataclass
from layoutkit.constraints import Constraint
from layoutkit.constraints.namespace import Namespace
from layoutkit.hooks import Outcome, Stage, hookimpl

@dataclass(frozen=True, kw_only=True)
class Rule(Constraint):
    kind = "rule"
    namespace = Namespace("odd", "urn:odd:1")
    summary = "Hangs in one way or another."
    def violations(self, view):
        return iter(())
{method}

@hookimpl
def layoutkit_constraints():
    return [Rule]
"""
RULES = "def size_rules(self, arrangement):\n    "
FOREVER = "while True: pass\n    yield"
STAGE = """
@dataclass(frozen=True)
class Options:
    seconds: float = 3.0

class Slow(Stage):
    name = "slow"
    summary = "Takes its time."
    options = Options
    def run(self, facade, options):
{work}

@hookimpl
def layoutkit_stages():
    return [Slow()]
"""
#: A program that runs it as commands do.
RUN_STAGE = """
from pathlib import Path
from layoutkit.cli.session import Session
session = Session()
facade = session.read(Path("facade.xml")).model
print([outcome.status for outcome in session.run("slow", facade)])
"""
BUSY = """until = time.monotonic() + options.seconds
while time.monotonic() < until: pass
"""


class Watched:
    """Runs programs with a plugin installed, and a patience of one second."""

    def __init__(self, install: Any, folder: Path) -> None:
        self._install, self._folder = install, folder
        (folder / "facade.xml").write_text(FACADE)

    def vary(self, method: str) -> subprocess.CompletedProcess[str]:
        command = ["-m", "layoutkit", "vary", "facade.xml", "-n", "1", "-o", "out"]
        return self.run(KIND.replace("{method}", textwrap.indent(method, "    ")), *command)

    def run(self, source: str, *command: str) -> subprocess.CompletedProcess[str]:
        site = self._install("odd_rules", source, package="odd-rules", version="2.5")
        path = os.pathsep.join([str(site), os.environ.get("PYTHONPATH", "")])
        return subprocess.run(
            [sys.executable, *command],
            cwd=self._folder,
            env={**os.environ, "PYTHONPATH": path, "LAYOUTKIT_PLUGIN_PATIENCE": "1"},
            capture_output=True,
            text=True,
            timeout=60,
        )


@pytest.fixture
def watched(install: Any, tmp_path: Path) -> Watched:
    return Watched(install, tmp_path)


def assert_stopped(run: subprocess.CompletedProcess[str]) -> None:
    assert run.returncode == 5, run.stderr
    assert "error LK407" in run.stderr, run.stderr
    assert "plugin 'odd_rules' of odd-rules 2.5 failed: " in run.stderr
    assert "it did not come to an end within 1 s (LAYOUTKIT_PLUGIN_PATIENCE)" in run.stderr
    assert "Traceback" not in run.stderr


#: What a plugin that hangs does to the signal first.
SIGNAL = {
    "nothing": "",
    "ignores it": "signal.signal(signal.SIGUSR1, signal.SIG_IGN)\n    ",
    "restores it": "signal.signal(signal.SIGUSR1, signal.SIG_DFL)\n    ",
    "handles it": "signal.signal(signal.SIGUSR1, lambda *_: None)\n    ",
}


@pytest.mark.skipif(not hasattr(signal, "SIGUSR1"), reason="there is no SIGUSR1 on this system")
@pytest.mark.parametrize("name", SIGNAL)
def test_what_hangs_is_stopped_whatever_it_does_to_the_signal(name: str, watched: Watched) -> None:
    run = watched.vary(RULES + SIGNAL[name] + FOREVER)
    assert_stopped(run)
    assert "cannot be interrupted" not in run.stderr


def test_a_call_that_hangs_in_many_short_ones_is_stopped(watched: Watched) -> None:
    method = """
def ties(self, facade):
    yield from ()
def size_rules(self, arrangement):
    from layoutkit.constraints.answers import ties_of
    while True: list(ties_of(self, None))
    yield
"""
    assert_stopped(watched.vary(method))


UNSTOPPABLE = {
    "swallows every error": RULES
    + """def work():
        while True: pass
    while True:
        try: work()
        except: pass
    yield""",
    "blocks the signal, and waits": RULES
    + """signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGUSR1])
    while True: time.sleep(1e6)
    yield""",
}


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="signals cannot be blocked on this system")
@pytest.mark.parametrize("name", UNSTOPPABLE)
def test_what_cannot_be_interrupted_ends_the_program(name: str, watched: Watched) -> None:
    run = watched.vary(UNSTOPPABLE[name])
    assert_stopped(run)
    assert "and cannot be interrupted" in run.stderr
    assert "in size_rules(), " in run.stderr
    assert "`--without odd_rules`" in run.stderr


def stage(work: str, method: str = "") -> str:
    source = KIND.replace("{method}", textwrap.indent(method, "    "))
    return source + STAGE.replace("{work}", textwrap.indent(textwrap.dedent(work), " " * 8))


@pytest.mark.parametrize(
    "work",
    [
        BUSY + 'yield Outcome("limit", None)',
        "def work():\n" + textwrap.indent(BUSY, "    ") + '    yield Outcome("limit", None)\nreturn work()',
    ],
    ids=["itself", "by what it calls"],
)
def test_a_stage_takes_as_long_as_it_does(work: str, watched: Watched) -> None:
    run = watched.run(stage(work), "-c", RUN_STAGE)
    assert run.stdout == "['limit']\n", run.stderr
    assert run.returncode == 0


def test_a_constraint_that_hangs_in_a_stage_of_another_is_stopped(watched: Watched) -> None:
    work = """
    from layoutkit.constraints.answers import ties_of
    try:
        list(ties_of(facade.constraints[-1], facade))
    except BaseException as error:
        print(type(error).__name__, error)
    yield Outcome("limit", None)
    """
    run = watched.run(stage(work, "def ties(self, facade):\n    " + FOREVER), "-c", RUN_STAGE)
    assert run.stdout.splitlines() == [
        "Stuck it did not come to an end within 1 s (LAYOUTKIT_PLUGIN_PATIENCE)",
        "['limit']",
    ], run.stderr


APPLICATION = """
import time
from layoutkit.hooks import hookimpl

@hookimpl
def layoutkit_constraints():
    return []

def work():
    until = time.monotonic() + 2.5
    while time.monotonic() < until: pass
    print("done")
"""


def test_an_application_of_the_same_package_is_left_alone(watched: Watched) -> None:
    program = (
        "import odd_rules\nfrom layoutkit.cli.app import main\n"
        "assert main(['plugins', '--json']) == 0\nodd_rules.work()"
    )
    run = watched.run(APPLICATION, "-c", program)
    assert run.returncode == 0, run.stderr
    assert run.stdout.endswith("done\n")


@pytest.mark.skipif(not hasattr(signal, "SIGUSR1"), reason="there is no SIGUSR1 on this system")
@pytest.mark.parametrize(
    "start",
    ["from layoutkit.hooks.host import Host; Host.load().constraints", "Session().host"],
    ids=["a library", "the command line"],
)
def test_a_signal_of_others_reaches_who_handled_it_before(start: str, watched: Watched) -> None:
    program = (
        "import os, signal\nfrom layoutkit.cli.session import Session\n"
        f"signal.signal(signal.SIGUSR1, lambda *_: print('mine'))\n{start}\n"
        "os.kill(os.getpid(), signal.SIGUSR1)"
    )
    run = watched.run(KIND.replace("{method}", ""), "-c", program)
    assert (run.returncode, run.stdout) == (0, "mine\n"), run.stderr


@pytest.mark.skipif(not hasattr(signal, "SIGUSR1"), reason="there is no SIGUSR1 on this system")
def test_a_library_takes_no_signal(watched: Watched) -> None:
    program = (
        "import signal\nfrom layoutkit.hooks.host import Host\nHost.load().constraints\n"
        "print(signal.getsignal(signal.SIGUSR1) is signal.SIG_DFL)"
    )
    assert watched.run(KIND.replace("{method}", ""), "-c", program).stdout == "True\n"


class Endless(Constraint):
    """A kind whose answers do not come to an end."""

    kind = "endless"
    summary = "Never stops."

    def ties(self, facade: Any) -> Iterator[Any]:
        return repeat((0, ()))

    def violations(self, view: Any) -> Iterator[Any]:
        return repeat(Violation(self, "R", "is off", 1.0))


def test_answers_without_end_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(blame, "MOST", 50)
    endless: Any = Endless()
    with pytest.raises(Misbehaviour, match="Endless gives more than 50 ties"):
        list(answers.ties_of(endless, endless))
    with pytest.raises(Misbehaviour, match="Endless gives more than 50 violations"):
        list(answers.violations_of(endless, endless))
    assert list(blame.bounded(range(50), endless, "ties")) == list(range(50))
    own: Any = object.__new__(Size)
    assert next(iter(blame.bounded(count(), own, "ties"))) == 0
    assert len(list(blame.bounded(range(51), own, "ties"))) == 51, "our own kinds are not bounded"


def test_rules_on_words_without_end_are_refused(watched: Watched) -> None:
    method = """
@classmethod
def word_rules(cls, constraints, facade):
    from layoutkit.constraints.word_rules import Mirrored
    rule = Mirrored("R", {}, constraints)
    while True: yield rule
"""
    run = watched.vary(method)
    assert run.returncode == 5, run.stderr
    assert "more than 1,000,000 rules on words" in run.stderr or "did not come to an end" in run.stderr
