"""`layoutkit batch`: the bytes of `vary`, whoever makes them, and whatever happens meanwhile."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from batch_work import contents

from layoutkit.batch.journal import JOURNAL_FILE
from layoutkit.documents import check, read
from layoutkit.hooks.host import Host
from layoutkit.samples import sample_path

Same = Callable[[Path, Path], None]


@pytest.fixture
def plain(tmp_path: Path) -> Path:
    """Return a facade in a folder of its own, with its photo."""
    shutil.copytree(sample_path("plain").parent, tmp_path / "plain")
    return tmp_path / "plain" / "facade.xml"


@pytest.fixture
def bare(plain: Path) -> Path:
    """Return the same without constraints."""
    text = plain.read_text(encoding="utf-8")
    start, end = text.index("<constraints>"), text.index("</constraints>") + len("</constraints>")
    file = plain.with_name("bare.xml")
    file.write_text(text[:start] + text[end:], encoding="utf-8")
    return file


def journalled(folder: Path) -> list[str]:
    """Return the tasks of a journal, as often as they are there."""
    journal = folder / JOURNAL_FILE
    lines = journal.read_bytes().split(b"\n")[1:-1] if journal.exists() else []
    return [json.loads(line)["key"] for line in lines]


def test_the_files_are_those_of_vary(plain: Path, bare: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "out"
    done = layoutkit("batch", plain, bare, "--width", "100%,13.5", "--seeds", "3", "-n", 2, "-o", out)
    assert done.code == 0
    assert done.out == f"4 of 4 tasks done; {out}/manifest.json lists them\n"
    assert done.err.count("LK602") == 1, "inferred constraints are told once"
    for name, file in (("plain", plain), ("bare", bare)):
        layoutkit("vary", file, "--width", 13.5, "--seed", 3, "-n", 2, "-o", tmp_path / "varied" / name)
        own = contents(out / name / "w13.5-h100pct-s3")
        varied = contents(tmp_path / "varied" / name)
        assert set(varied) - set(own) == {"sheet.png", "facade.png"}
        assert {file for file in own if own[file] != varied[file]} == {"facade.xml"}
        assert own["facade.xml"].replace(b'"../facade.png"', b'"facade.png"') == varied["facade.xml"]
        assert (out / name / "facade.png").read_bytes() == varied["facade.png"]
        layout = out / name / "w13.5-h100pct-s3" / "variation-01.xml"
        host = Host.load()
        assert list(check(layout, host.constraints)) == []
        assert read(layout, host.constraints).model.facade is not None


@pytest.mark.parametrize(
    "way",
    [["--workers", 2], ["--scheduler", "local", "--workers", 2]],
    ids=["processes", "dask"],
)
def test_the_bytes_are_the_same_whoever_makes_them(
    way: list[Any], plain: Path, bare: Path, tmp_path: Path, layoutkit: Any, same: Same
) -> None:
    arguments = ["batch", plain, bare, "--width", "20%,110%", "--seeds", "0-1", "-n", 1, "--json"]
    one = layoutkit(*arguments, "-o", tmp_path / "one")
    many = layoutkit(*arguments, "-o", tmp_path / "many", *way)
    assert one.code == many.code
    assert one.data["failures"], "there are failures among them"
    assert sorted(f["task"] for f in one.data["failures"]) == sorted(f["task"] for f in many.data["failures"])
    same(tmp_path / "one", tmp_path / "many")


@pytest.mark.parametrize(
    "way", [pytest.param([], id="one", marks=pytest.mark.nightly), pytest.param(["--workers", "2"], id="two")]
)
def test_a_run_that_is_killed_goes_on(way: list[str], plain: Path, tmp_path: Path, same: Same) -> None:
    def command(folder: str) -> list[str]:
        options = ["--seeds", "0-11", "-n", "1", "-o", str(tmp_path / folder)]
        return [sys.executable, "-m", "layoutkit", "batch", str(plain), *options]

    running = subprocess.Popen(
        [*command("killed"), *way],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    deadline = time.monotonic() + 60
    while len(journalled(tmp_path / "killed")) < 3 and time.monotonic() < deadline:
        time.sleep(0.01)
    running.send_signal(signal.SIGKILL)
    running.wait()
    before = journalled(tmp_path / "killed")
    assert 3 <= len(before) < 12
    assert not (tmp_path / "killed" / "manifest.json").exists()
    gone_on = subprocess.run([*command("killed"), *way], capture_output=True, text=True)
    assert gone_on.returncode == 0, gone_on.stderr
    assert f"{len(before)} of them before" in gone_on.stdout
    after = journalled(tmp_path / "killed")
    assert len(after) == len(set(after)) == 12, "none that was in the journal was done again"
    subprocess.run(command("whole"), check=True, capture_output=True)
    same(tmp_path / "killed", tmp_path / "whole")


@pytest.mark.skipif(os.name == "nt", reason="a terminal's Ctrl-C is another thing there")
def test_an_interrupt_says_how_to_go_on(plain: Path, tmp_path: Path) -> None:
    options = ["--seeds", "0-99", "-n", "1", "-o", str(tmp_path / "out"), "--workers", "2"]
    running = subprocess.Popen(
        [sys.executable, "-m", "layoutkit", "batch", str(plain), *options],
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    deadline = time.monotonic() + 60
    while not journalled(tmp_path / "out") and time.monotonic() < deadline:
        time.sleep(0.01)
    os.killpg(running.pid, signal.SIGINT)  # as a terminal does: to all of them
    _, told = running.communicate(timeout=60)
    assert running.returncode == 130
    assert told.startswith("interrupted: ")
    assert told.endswith(" of 100 tasks are done; the same command goes on from there\n")
    assert told.count("\n") == 1, "workers say nothing"


def test_failures_are_listed_and_not_fatal(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    broken = plain.with_name("broken.xml")
    broken.write_text(plain.read_text(encoding="utf-8").replace("width=", "widht="), encoding="utf-8")
    blind = tmp_path / "blind.xml"
    shutil.copy(plain, blind)
    absent = tmp_path / "absent.xml"
    files = (plain, broken, blind, absent)
    done = layoutkit("batch", *files, "--width", "20%,100%", "-n", 1, "-o", tmp_path / "out", "--json")
    assert done.code == 1
    assert (done.data["done"], done.data["failed"]) == (1, 7)
    failures = {f["task"]: (f["status"], f["codes"]) for f in done.data["failures"]}
    assert failures["plain/w20pct-h100pct-s0"] == ("infeasible", ["LK203"])
    assert failures["broken/w20pct-h100pct-s0"] == ("failed", ["LK103"])
    assert failures["blind/w100pct-h100pct-s0"] == ("failed", ["LK010"])
    assert failures["absent/w100pct-h100pct-s0"] == ("failed", ["LK001"])
    assert "failed: broken/w20pct-h100pct-s0, broken/w100pct-h100pct-s0\n" in done.err
    entries = json.loads((tmp_path / "out" / "manifest.json").read_text())["entries"]
    assert [entry["status"] for entry in entries].count("failed") == 7
    assert entries[0]["diagnostics"][0]["code"] == "LK203"
    again = layoutkit("batch", *files, "--width", "20%,100%", "-n", 1, "-o", tmp_path / "out", "--json")
    assert (again.code, again.data["kept"], again.data["failed"]) == (1, 1, 7)


def test_exit_codes_are_those_of_the_gravest(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    assert layoutkit("batch", plain, "--width", "20%", "-n", 1, "-o", tmp_path / "a").code == 3
    absent = tmp_path / "absent.xml"
    assert layoutkit("batch", plain, absent, "--width", "20%", "-n", 1, "-o", tmp_path / "b").code == 1


def test_what_fails_in_many_ways_is_told_in_part(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    absent = [tmp_path / f"absent-{number}.xml" for number in range(30)]
    done = layoutkit("batch", *absent, plain, "-n", 1, "--no-picture", "-o", tmp_path / "out")
    assert done.code == 1
    assert done.out.startswith("1 of 31 tasks done, 30 failed; ")
    assert done.err.count("failed: ") == 20
    assert "and 10 more failed; the manifest has all" in done.err


def test_without_pictures_there_are_documents_alone(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    assert layoutkit("batch", plain, "-n", 1, "--no-picture", "-o", tmp_path / "out").code == 0
    folder = tmp_path / "out" / "plain" / "w100pct-h100pct-s0"
    assert {path.name for path in folder.iterdir()} == {"facade.xml", "variation-01.xml"}
    assert b"variation-01.png" not in (folder / "variation-01.xml").read_bytes()


def test_another_run_needs_another_folder(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "out"
    assert layoutkit("batch", plain, "-n", 1, "-o", out).code == 0
    refused = layoutkit("batch", plain, "-n", 1, "--seeds", 4, "-o", out)
    assert refused.code == 2
    assert "LK890" in refused.err
    assert layoutkit("batch", plain, "-n", 1, "--seeds", 4, "-o", out, "--afresh").code == 0
    assert [path.name for path in (out / "plain").iterdir() if path.is_dir()] == ["w100pct-h100pct-s4"]


def test_a_plugin_that_fails_in_a_task_fails_that_alone(
    plain: Path, tmp_path: Path, layoutkit: Any, install: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    install(
        "brittle",
        """
        from dataclasses import dataclass
        from layoutkit.hooks import Outcome, Stage, hookimpl
        from layoutkit.model import Layout, Measure

        @dataclass(frozen=True)
        class Options:
            count: int = 1
            width: Measure = Measure(1.0, True)
            height: Measure = Measure(1.0, True)
            seed: int = 0

        class Relayout(Stage):
            name, summary, options = "relayout", "Fails at odd seeds.", Options

            def run(self, facade, options):
                for index in range(options.count):
                    if options.seed % 2 and index:
                        raise KeyError("odd")
                    yield Outcome("found", Layout("x", facade.units, facade.root, facade, index=index))

        @hookimpl
        def layoutkit_stages():
            return [Relayout()]
        """,
    )
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", "relayout")
    arguments = ["batch", plain, "--seeds", "0-3", "-n", 2, "--no-picture", "--json"]
    done = layoutkit(*arguments, "-o", tmp_path / "one")
    assert done.code == 5
    assert [f["codes"] for f in done.data["failures"]] == [["LK407"], ["LK407"]]
    partly = json.loads((tmp_path / "one" / "manifest.json").read_text())["entries"][1]
    assert [Path(file["name"]).name for file in partly["files"]] == ["facade.xml", "variation-01.xml"]
    layoutkit(*arguments, "-o", tmp_path / "two", "--workers", 2)
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (["--seeds", "3-1"], "LK701"),
        (["--width", "x"], "LK701"),
        (["--scheduler", "tcp://127.0.0.1:1"], "LK893"),
        (["--scheduler", "tcp://127.0.0.1:1", "--workers", "2"], "LK701"),
    ],
)
def test_options_that_make_no_sense_are_told(
    options: list[str], code: str, plain: Path, tmp_path: Path, layoutkit: Any
) -> None:
    done = layoutkit("batch", plain, "-n", 1, "-o", tmp_path / "out", *options)
    assert done.code == 2
    assert code in done.err


def test_an_input_is_not_overwritten(plain: Path, tmp_path: Path, layoutkit: Any) -> None:
    own = tmp_path / "out" / "house" / "w100pct-h100pct-s0"
    shutil.copytree(plain.parent, own)
    before = contents(own)
    (tmp_path / "house.xml").symlink_to(own / "facade.xml")
    done = layoutkit("batch", tmp_path / "house.xml", "-n", 1, "-o", tmp_path / "out")
    assert done.code == 2
    assert "LK704" in done.err
    assert contents(own) == before
