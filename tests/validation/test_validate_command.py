"""`layoutkit validate`: which files are looked at, what is told of them, and how the run ends."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import Install, Run
from tests.validation.conftest import BROKEN, HOUSE, LAYOUT, MISSPELT, Written

Layoutkit = Callable[..., Run]


def verdicts(run: Run) -> dict[str, str]:
    """Return what is said of each document, without the line on all of them."""
    lines = [line for line in run.out.splitlines() if not re.match(r"\d+ documents: ", line)]
    return dict(line.split(": ", 1) for line in lines)


# Which files


def test_folders_patterns_and_files_are_looked_through_once_each(
    written: Written, layoutkit: Layoutkit
) -> None:
    for name in ("a.xml", "in/b.XML", "in/deep/c.xml", "in/.hidden.xml", "in/.git/d.xml", "in/notes.txt"):
        written(name)
    run = layoutkit("validate", "in", "in/deep/c.xml", "./a.xml", "**/*.xml")
    assert run.code == 0
    assert verdicts(run) == dict.fromkeys(
        [os.path.join("in", "b.XML"), os.path.join("in", "deep", "c.xml"), "a.xml"], "valid"
    )


def test_a_file_whose_name_looks_like_a_pattern_is_itself(written: Written, layoutkit: Layoutkit) -> None:
    written("a[1].xml", BROKEN)
    written("a1.xml")
    assert verdicts(layoutkit("validate", "a[1].xml")) == {"a[1].xml": "1 error"}


@pytest.mark.parametrize("name", ["*.xml", "empty"])
def test_nothing_to_look_at_is_a_fault(name: str, written: Written, layoutkit: Layoutkit) -> None:
    written("other/a.xml")
    Path("empty").mkdir()
    run = layoutkit("validate", name)
    assert run.code == 2
    assert f"{name}: error LK711 usage: " in run.err
    assert "hint: " in run.err


def test_documents_of_others_are_left_out_of_folders_with_one_note(
    written: Written, layoutkit: Layoutkit
) -> None:
    written("in/house.xml")
    written("in/pom.xml", '<project xmlns="http://maven.apache.org/POM/4.0.0"/>')
    written("in/voc.xml", "<annotation/>")
    written("in/facad.xml", "<facad/>")
    run = layoutkit("validate", "in")
    assert list(verdicts(run)) == [os.path.join("in", name) for name in ("facad.xml", "house.xml")]
    assert run.err.count("LK712") == 1
    assert "note LK712 usage: 2 files hold no document of layoutkit, and are left out: " in run.err
    assert layoutkit("validate", "in/pom.xml").code == 1, "a file that is named is looked at"
    assert layoutkit("validate", "in/pom.xml", "--skip-foreign").code == 0


def root(namespace: str, name: str = "facade") -> str:
    return (
        f'<{name} xmlns="{namespace}" name="f" units="m"><region symbol="F" width="2" height="1"/></{name}>'
    )


@pytest.mark.parametrize("name", ["facade", "layout", "mass"])
@pytest.mark.parametrize(
    "namespace", ["urn:layoutkt:1", "urn:LayoutKit:1", "urn:layoutkit:1/", "urn:layoutkit:2"]
)
def test_a_namespace_that_is_nearly_ours_is_at_fault_wherever_it_is_found(
    namespace: str, name: str, written: Written, layoutkit: Layoutkit
) -> None:
    written("in/a.xml", root(namespace, name))
    for arguments in (("in",), ("in/*.xml",), ("in/a.xml", "--skip-foreign")):
        run = layoutkit("validate", *arguments)
        assert run.code == 1
        assert f"error LK101 schema: <{name}> is of the namespace {namespace!r}" in run.err
        assert "hint: did you mean 'urn:layoutkit:1'?" in run.err


def test_a_namespace_that_is_not_near_is_of_others(written: Written, layoutkit: Layoutkit) -> None:
    written("in/a.xml", root("urn:layout:facades"))
    assert "LK712" in layoutkit("validate", "in").err
    assert "`layoutkit convert` reads other formats" in layoutkit("validate", "in/a.xml").err


def test_a_text_without_documents_is_at_fault_only_where_it_is_named(
    written: Written, layoutkit: Layoutkit
) -> None:
    written("in/README.md", "# Designs\n\nNone yet.\n")
    written("in/house.md", f"A house:\n\n```xml\n{HOUSE}```\n")
    run = layoutkit("validate", "in/*.md")
    assert (run.code, verdicts(run)) == (0, {"in/house.md": "valid"})
    assert "1 file holds no document of layoutkit, and is left out: in/README.md" in run.err
    run = layoutkit("validate", "in/README.md")
    assert run.code == 1
    assert "in/README.md: error LK101 document: the text holds no document" in run.err
    assert layoutkit("validate", "in/README.md", "--skip-foreign").code == 0


def test_a_text_that_cannot_be_read_is_not_left_out(written: Written, layoutkit: Layoutkit) -> None:
    written("in/notes.md", "Wände", "latin-1")
    assert "error LK003" in layoutkit("validate", "in/*.md").err


def test_a_folder_of_nothing_but_documents_of_others(written: Written, layoutkit: Layoutkit) -> None:
    written("in/voc.xml", "<annotation/>")
    run = layoutkit("validate", "in")
    assert run.code == 2
    assert "LK711" in run.err
    assert "LK712" in run.err


def test_a_folder_that_cannot_be_read_is_told(
    written: Written, layoutkit: Layoutkit, monkeypatch: pytest.MonkeyPatch
) -> None:
    written("in/a.xml")
    written("in/closed/b.xml")
    scandir = os.scandir

    def refused(path: str) -> Any:
        if str(path).endswith("closed"):
            raise PermissionError(13, "Permission denied", path)
        return scandir(path)

    monkeypatch.setattr(os, "scandir", refused)
    run = layoutkit("validate", "in")
    assert run.code == 1
    assert f"{os.path.join('in', 'closed')}: error LK001 file: " in run.err
    assert verdicts(run) == {os.path.join("in", "a.xml"): "valid"}


def test_standard_input_is_looked_at(
    written: Written, layoutkit: Layoutkit, monkeypatch: pytest.MonkeyPatch
) -> None:
    written("facade.xml")
    piped = io.TextIOWrapper(io.BytesIO(LAYOUT.format("facade.xml").replace('"3"', '"2"').encode()))
    monkeypatch.setattr(sys, "stdin", piped)
    run = layoutkit("validate", "-")
    assert run.code == 1
    assert verdicts(run) == {"<stdin>": "2 errors"}
    assert run.err.startswith("<stdin>:2:3: error LK212 ")
    assert '2 |   <region symbol="Facade"' in run.err


def test_a_pipe_is_read_once(written: Written) -> None:
    written("house.xml", BROKEN)
    command = f"'{sys.executable}' -m layoutkit validate <(cat house.xml)"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
    assert done.returncode == 1
    assert "error LK212" in done.stderr
    assert "5 |     <region" in done.stderr


# What is told


def test_the_source_stands_below_what_is_said_of_it(written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml", BROKEN)
    run = layoutkit("validate", "house.xml")
    assert run.err == (
        "house.xml:5:5: error LK212 reference: the heights of the children add up to 3, the parent's is 4\n"
        '  5 |     <region symbol="Bay" width="3" split="rows">\n'
        "    |     ^\n"
        "  hint: add 1 to the children, or make the parent's height 3\n"
    )


def test_colours_on_a_terminal_only(
    written: Written, layoutkit: Layoutkit, monkeypatch: pytest.MonkeyPatch
) -> None:
    written("house.xml", BROKEN)
    assert "\033" not in layoutkit("validate", "house.xml").err
    monkeypatch.setattr("layoutkit.cli.console.coloured", lambda stream: True)
    assert "\033[1;31merror LK212\033[0m" in layoutkit("validate", "house.xml").err


def test_faults_of_a_facade_are_told_once_however_many_layouts_name_it(
    written: Written, layoutkit: Layoutkit
) -> None:
    written("house.xml", BROKEN)
    for number in range(20):
        written(f"out/{number:02}.xml", LAYOUT.format("../house.xml"))
    run = layoutkit("validate", "out")
    assert run.code == 1
    assert run.err.count("LK212") == 1
    assert set(verdicts(run).values()) == {"1 error"}
    assert len(layoutkit("validate", "out", "--json").data["diagnostics"]) == 1


def test_less_is_told_where_less_is_asked_for(written: Written, layoutkit: Layoutkit) -> None:
    written("out.xml", LAYOUT.format("gone.xml"))
    assert "warning LK504" in layoutkit("validate", "out.xml").err
    run = layoutkit("validate", "out.xml", "--severity", "error")
    assert (run.err, verdicts(run)) == ("", {"out.xml": "valid, 1 warning"})
    assert layoutkit("validate", "out.xml", "--severity", "error", "--json").data["diagnostics"] == []


@pytest.mark.parametrize("name", ["json", "sarif", "junit", "text"])
def test_a_report_goes_into_a_file_whole(name: str, written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml", BROKEN)
    run = layoutkit("validate", "house.xml", "--format", name, "-o", "new/report")
    assert (run.code, run.out) == (1, "")
    assert "LK212" in Path("new/report").read_text()
    assert "LK212" in run.err
    if name != "text":
        printed = layoutkit("validate", "house.xml", "--format", name).out
        assert printed == Path("new/report").read_text()


def test_a_report_is_never_written_over_a_document(written: Written, layoutkit: Layoutkit) -> None:
    path = written("house.xml", BROKEN)
    run = layoutkit("validate", ".", "-o", "./house.xml")
    assert run.code == 2
    assert "error LK704 usage: " in run.err
    assert path.read_text() == BROKEN


def test_json_keeps_its_shape(written: Written, layoutkit: Layoutkit) -> None:
    written("a.xml", BROKEN)
    written("b.xml")
    data = layoutkit("validate", "a.xml", "b.xml", "--json").data
    assert data["documents"] == [{"document": "a.xml", "valid": False}, {"document": "b.xml", "valid": True}]
    (fault,) = data["diagnostics"]
    assert fault["place"] == {"file": "a.xml", "line": 5, "column": 5}
    assert (fault["code"], fault["severity"], fault["related"]) == ("LK212", "error", [])
    assert data["repairs"] == []
    assert data == layoutkit("validate", "a.xml", "b.xml", "--format", "json").data


def test_several_documents_end_with_a_line_on_all(written: Written, layoutkit: Layoutkit) -> None:
    written("in/a.xml")
    written("in/b.xml", BROKEN)
    written("in/c.xml", MISSPELT)
    *_, line = layoutkit("validate", "in").out.splitlines()
    assert line == "3 documents: 1 valid, 2 with errors (2 errors); `--fix` may mend some of it"
    *_, line = layoutkit("validate", "in", "--fix").out.splitlines()
    assert line == "3 documents: 2 valid, 1 with errors, 1 mended (1 error)"
    assert layoutkit("validate", "in/a.xml").out == "in/a.xml: valid\n"


def test_thousands_of_unknown_names_are_told_quickly_and_counted(
    written: Written, layoutkit: Layoutkit
) -> None:
    count = 4000
    regions = "".join(f'<region symbol="Bay{n}" width="1"/>' for n in range(count))
    sizes = "".join(f'<size of="F/Window{n}" min="1"/>' for n in range(count))
    head = f'<region symbol="F" width="{count}" height="3" split="columns">'
    written(
        "house.xml",
        f'<facade xmlns="urn:layoutkit:1" name="f" units="m">{head}{regions}</region>'
        f"<constraints>{sizes}</constraints></facade>",
    )
    begin = time.process_time()
    run = layoutkit("validate", "house.xml")
    assert time.process_time() - begin < 6, "half of that on a slow machine"
    assert verdicts(run) == {"house.xml": "4000 errors"}
    assert "and 3,000 more of this kind, from here on: size names the region 'F/Window1000'" in run.err


# How the run ends


AUDIT = """
    import dataclasses
    from layoutkit.diagnostics import Diagnostic, Severity
    from layoutkit.hooks import Outcome, Stage, hookimpl

    @dataclasses.dataclass(frozen=True)
    class Options: pass

    class Audit(Stage):
        name, summary, options = "audit", "Looks closely.", Options

        def run(self, facade, options):
            if facade.name == "sick":
                raise RuntimeError("no more")
            if facade.name == "tight":
                yield Outcome("found", None, (Diagnostic("LK299", "too tight", facade.constraints[0].place),))
            place = facade.constraints[0].place
            yield Outcome("found", None, (Diagnostic("LK298", "idle", place, severity=Severity.WARNING),))

    @hookimpl
    def layoutkit_stages(): return [Audit()]
"""


@pytest.fixture
def audited(install: Install, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a plugin look for what constraints contradict, and no other one."""
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", "relayout")
    install("closely", AUDIT)


@pytest.mark.usefixtures("audited")
def test_what_constraints_contradict_is_told_of_facades_without_other_errors(
    written: Written, layoutkit: Layoutkit
) -> None:
    written("house.xml")
    written("tight.xml", HOUSE.replace('"house"', '"tight"'))
    written("broken.xml", BROKEN)
    run = layoutkit("validate", "house.xml", "tight.xml", "broken.xml")
    assert run.code == 1
    assert verdicts(run) == {
        "house.xml": "valid, 1 warning",
        "tight.xml": "1 error, 1 warning",
        "broken.xml": "1 error",
    }
    assert "tight.xml:12:5: error LK299" in run.err
    run = layoutkit("validate", "house.xml", "tight.xml", "--no-semantics")
    assert (run.code, run.err) == (0, "")


@pytest.mark.usefixtures("audited")
def test_warnings_count_where_they_are_to(written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml")
    assert layoutkit("validate", "house.xml").code == 0
    run = layoutkit("validate", "house.xml", "--fail-on", "warning", "--severity", "error")
    assert run.code == 1
    assert "warning LK298" in run.err, "what a run fails by is told"


@pytest.mark.usefixtures("audited")
def test_a_plugin_that_fails_ends_with_5_and_hides_no_other_fault(
    written: Written, layoutkit: Layoutkit
) -> None:
    written("a.xml", HOUSE.replace('"house"', '"sick"'))
    written("b.xml", BROKEN)
    run = layoutkit("validate", "a.xml", "b.xml", "--json")
    assert run.code == 5
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK407", "LK212"]
    assert "acme-plugin" in run.data["diagnostics"][0]["message"]
    assert "RuntimeError: no more" in run.data["diagnostics"][0]["message"]


@pytest.mark.usefixtures("audited")
def test_where_plugins_must_not_fail_the_run_stops_at_once(written: Written, layoutkit: Layoutkit) -> None:
    written("a.xml", HOUSE.replace('"house"', '"sick"'))
    written("b.xml", BROKEN)
    run = layoutkit("--strict", "validate", "a.xml", "b.xml")
    assert run.code == 5
    assert "error LK407" in run.err
    assert (run.out, "LK212" in run.err) == ("", False)


@pytest.mark.parametrize(
    "arguments",
    [
        ("--dry-run",),
        ("--json", "--format", "sarif"),
        ("--format", "yaml"),
        ("--severity", "fatal"),
        ("--fail-on", "note"),
    ],
)
def test_misuse_is_a_fault_of_usage(
    arguments: tuple[str, ...], written: Written, layoutkit: Layoutkit
) -> None:
    written("house.xml")
    run = layoutkit("validate", "house.xml", *arguments)
    assert run.code == 2
    assert "error LK701 usage: " in run.err


def test_a_report_is_one_line_of_json(written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml")
    out: Any = layoutkit("validate", "house.xml", "--json").out
    assert json.loads(out)
    assert out.count("\n") == 1
