"""How every run ends: exit codes, diagnostics on stderr, JSON on stdout, and never a traceback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from layoutkit import __version__
from layoutkit.cli import app
from layoutkit.cli.exits import Exit, exit_of
from layoutkit.diagnostics import Diagnostic, Severity

COMMANDS = [command.__name__ for command, _ in app.COMMANDS]
PROGRAM = [sys.executable, "-m", "layoutkit"]


def test_version(layoutkit: Any) -> None:
    run = layoutkit("--version")
    assert (run.code, run.out, run.err) == (0, f"layoutkit {__version__}\n", "")


def test_no_command_shows_the_help_and_is_a_fault_of_use(layoutkit: Any) -> None:
    run = layoutkit()
    assert run.code == 2
    assert all(name in run.out for name in COMMANDS)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help_with_examples_that_name_it(command: str, layoutkit: Any) -> None:
    run = layoutkit(command, "--help")
    assert run.code == 0
    assert "Examples:" in run.out
    assert run.out.count(f"layoutkit {command}") + run.out.count(f"--strict {command}") >= 2


USAGE = {
    "unknown command": (["varry"], "there is no command 'varry'", "did you mean 'vary'?"),
    "unknown option": (["vary", "x.xml", "-o", "out", "--sead", "3"], "there is no option --sead", "--seed"),
    "missing argument": (["inspect"], "Missing argument 'DOC'", "`layoutkit inspect --help`"),
    "missing output": (["vary", "x.xml"], "Missing option '-o' / '--output'", "`layoutkit vary --help`"),
    "no number": (["vary", "x.xml", "-o", "out", "-n", "many"], "many", "`layoutkit vary --help`"),
    "none asked for": (["vary", "x.xml", "-o", "out", "-n", "0"], "0 is not in the range", ""),
    "negative seed": (["vary", "x.xml", "-o", "out", "--seed", "-1"], "-1 is not in the range", ""),
    "no size": (["vary", "x.xml", "-o", "out", "--width", "wide"], "wide is no size above 0", ""),
    "size 0": (["vary", "x.xml", "-o", "out", "--width", "0%"], "0% is no size above 0", ""),
    "size nan": (["vary", "x.xml", "-o", "out", "--height", "nan"], "nan is no size above 0", ""),
    "negative size": (["vary", "x.xml", "-o", "out", "--height", "-3"], "-3 is no size above 0", ""),
    "unknown freedom": (["infer", "x.xml", "-o", "y.xml", "--freedom", "losse"], "losse", ""),
    "unknown kind of picture": (
        ["render", "x.xml", "-o", "x.gif"],
        "as '.gif'",
        "end the file's name in .png, .svg, .glb or .geojson",
    ),
    "no kind of picture": (["render", "x.xml", "-o", "x"], "without a suffix", ".svg, .glb or .geojson"),
}


@pytest.mark.parametrize("name", USAGE)
def test_faults_of_use(name: str, layoutkit: Any) -> None:
    arguments, message, hint = USAGE[name]
    run = layoutkit(*arguments)
    assert run.code == 2
    assert run.out == ""
    assert run.err.startswith("error LK7") or ": error LK7" in run.err
    assert message in run.err
    assert hint in run.err
    again = layoutkit(*arguments, "--json")
    assert again.code == 2
    if arguments[0] != "render":  # which has no JSON to print
        assert message in again.data["diagnostics"][0]["message"]


@pytest.mark.parametrize("command", ["inspect", "vary", "infer", "render", "convert", "validate"])
def test_a_missing_file_is_a_diagnostic_with_the_nearest_name(
    command: str, house: Path, layoutkit: Any
) -> None:
    output = [] if command in ("inspect", "validate") else ["-o", house.with_name("out.png")]
    run = layoutkit(command, house.with_name("hosue.xml"), *output)
    assert run.code == 1
    assert f"{house.with_name('hosue.xml')}: error LK001" in run.err
    assert "did you mean 'house.xml'?" in run.err


def test_a_folder_is_no_document(house: Path, layoutkit: Any) -> None:
    run = layoutkit("inspect", house.parent)
    assert run.code == 1
    assert "error LK001" in run.err
    assert "it is a folder" in run.err


def test_a_folder_that_cannot_be_made(house: Path, layoutkit: Any) -> None:
    run = layoutkit("vary", house, "-n", 1, "-o", house / "inside")
    assert run.code == 1
    assert "error LK008" in run.err


def test_a_faulty_document_is_told_in_both_forms(house: Path, layoutkit: Any) -> None:
    house.write_text(house.read_text().replace('of="Facade/Bay"', 'of="Facade/Bey"'))
    run = layoutkit("inspect", house, "--json")
    assert run.code == 1
    (told,) = run.data["diagnostics"]
    assert (told["code"], told["severity"], told["place"]["line"]) == ("LK201", "error", 18)
    assert f"{house}:18:5: error LK201" in run.err


def test_exit_codes_follow_the_gravest_kind_of_error() -> None:
    def found(*codes: str, severity: Severity = Severity.ERROR) -> Exit:
        return exit_of(Diagnostic(code, "", severity=severity) for code in codes)

    assert found() is Exit.DONE
    assert found("LK901", severity=Severity.WARNING) is Exit.DONE
    assert found("LK001", "LK203") is Exit.FAULTS
    assert found("LK201", "LK701") is Exit.USAGE
    assert found("LK406") is Exit.USAGE
    assert found("LK406", "LK401") is Exit.PLUGIN
    assert found("LK901", "LK407") is Exit.INTERNAL


RAISING = """
    from layoutkit.hooks import Format, hookimpl

    class Toy(Format):
        name = "toy"
        summary = "Reads toys."
        def recognises(self, path, head): return head.startswith(b"toy")
        def read(self, path, picture): raise RuntimeError("no toys today")

    @hookimpl
    def layoutkit_formats():
        return [Toy()]
"""


def test_a_plugin_that_fails_at_work_is_named(install: Any, tmp_path: Path, layoutkit: Any) -> None:
    install("toys", RAISING)
    (tmp_path / "a.toy").write_text("toy")
    run = layoutkit("convert", tmp_path / "a.toy", "-o", tmp_path / "a.xml")
    assert run.code == 5
    assert (
        "error LK407 plugin: the plugin 'toys' of acme-plugin 1.2 failed: RuntimeError: no toys today"
        in run.err
    )
    assert "LAYOUTKIT_DEBUG=1" in run.err
    assert not (tmp_path / "a.xml").exists()


def test_a_plugin_that_cannot_be_loaded_is_named_and_the_work_is_done_without_it(
    install: Any, house: Path, layoutkit: Any
) -> None:
    install("broken", "import a_module_that_is_not_there")
    run = layoutkit("inspect", house, "--json")
    assert run.code == 5
    assert run.data["name"] == "house"
    assert "warning LK401 plugin: the plugin 'broken' of acme-plugin 1.2 cannot be loaded" in run.err
    strict = layoutkit("--strict", "inspect", house)
    assert strict.code == 5
    assert strict.out == ""
    assert "error LK401" in strict.err


def test_an_unforeseen_error_is_our_own_fault(
    house: Path, layoutkit: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr("layoutkit.documents.read", fail)
    run = layoutkit("inspect", house)
    assert run.code == 70
    assert run.err.startswith("error LK901 internal: layoutkit failed: ZeroDivisionError: oh\n  hint: ")
    assert "LAYOUTKIT_DEBUG=1" in run.err
    assert run.err.count("\n") == 2


def test_debug_shows_the_traceback(house: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    def fail(*_: object) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr("layoutkit.documents.read", fail)
    monkeypatch.setenv("LAYOUTKIT_DEBUG", "1")
    assert app.main(["inspect", str(house)]) == 70
    assert "Traceback" in capsys.readouterr().err


def test_an_interrupt_ends_quietly(house: Path, monkeypatch: pytest.MonkeyPatch, layoutkit: Any) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("layoutkit.documents.read", interrupt)
    run = layoutkit("inspect", house)
    assert (run.code, run.out, run.err) == (130, "", "")


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_an_interrupted_process_leaves_no_traceback(install: Any, house: Path) -> None:
    folder = install(
        "sleepy",
        """
        import sys, time
        print("asleep", file=sys.stderr, flush=True)
        time.sleep(30)
        """,
    )
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([str(folder), os.environ.get("PYTHONPATH", "")]),
    }
    process = subprocess.Popen(
        [*PROGRAM, "inspect", str(house)], env=environment, stderr=subprocess.PIPE, text=True
    )
    assert process.stderr is not None
    assert process.stderr.readline() == "asleep\n"
    time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    assert process.stderr.read().strip() == ""
    process.stderr.close()
    assert process.wait() == 130


@pytest.mark.skipif(os.name == "nt", reason="pipes of POSIX")
@pytest.mark.parametrize("arguments", [["schema"], ["inspect", "--json"]])
def test_a_broken_pipe_is_quiet(arguments: list[str], house: Path) -> None:
    command = [*PROGRAM, *arguments] + ([str(house)] if "inspect" in arguments else [])
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    assert process.stderr.read() == b""
    process.stderr.close()
    assert process.wait() == 141


def test_colours_only_on_a_terminal_and_without_no_color(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from layoutkit.cli import console

    diagnostic = Diagnostic("LK001", "gone")
    console.show([diagnostic])
    assert capsys.readouterr().err == "error LK001 document: gone\n"
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.delenv("NO_COLOR", raising=False)
    console.show([diagnostic])
    assert capsys.readouterr().err == "\033[1;31merror LK001\033[0m document: gone\n"
    monkeypatch.setenv("NO_COLOR", "1")
    console.show([diagnostic])
    assert capsys.readouterr().err == "error LK001 document: gone\n"


def test_the_version_is_quick_and_imports_nothing_heavy() -> None:
    program = (
        "import sys; from layoutkit.cli.app import main; main(['--version']);"
        "heavy = ('numpy', 'scipy', 'lxml', 'PIL', 'rich', 'layoutkit.constraints');"
        "print([name for name in heavy if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"
