"""SARIF, JUnit XML, JSON and text: what other programs are given to read."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import check
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending import proposals
from layoutkit.reports import FORMATS, Checked, Report
from layoutkit.reports.text import verdicts
from tests.validation.conftest import HOUSE, Written

BROKEN = (
    HOUSE.replace('width="6"', 'widht="6"')
    .replace('height="3"', 'height="2"')
    .replace("</constraints>", "<foo/><foo/></constraints>")
)


@pytest.fixture
def report(written: Written, kinds: Kinds) -> Report:
    """Return a report of two documents, the second one with faults and remarks of all severities."""
    from layoutkit.diagnostics.ranking import ranked

    file = written("a b/häuser #1.xml", BROKEN)
    found = check(file, kinds)
    remarks = [
        Diagnostic("LK802", "half is hidden", Place(str(file), 4, 5), severity=Severity.NOTE),
        Diagnostic("XY1", "odd", Place(str(file)), "hint\x00 of a plugin", Severity.WARNING, "acme"),
    ]
    failed = Diagnostic("LK403", "the plugin 'acme' fails", severity=Severity.WARNING, topic="plugin")
    fixes = proposals(file.read_bytes(), str(file), found, kinds)
    faulty = Checked(str(file), ranked([*found, *remarks]), tuple(found), fixes=fixes)
    return Report((Checked(str(written("house.xml")), ()), faulty), (failed,))


def sarif(report: Report) -> dict[str, Any]:
    log: dict[str, Any] = json.loads(FORMATS["sarif"](report))
    return log


def allowed(value: dict[str, Any], required: set[str], optional: set[str]) -> None:
    assert required <= value.keys() <= required | optional, value.keys()


def check_message(message: dict[str, Any]) -> None:
    allowed(message, {"text"}, {"markdown", "id", "arguments"})
    assert isinstance(message["text"], str)
    assert message["text"]


def check_location(location: dict[str, Any]) -> None:
    allowed(location, {"physicalLocation"}, {"id", "message", "logicalLocations"})
    physical = location["physicalLocation"]
    allowed(physical, {"artifactLocation"}, {"region", "contextRegion"})
    check_artifact(physical["artifactLocation"])
    if "region" in physical:
        check_region(physical["region"])


def check_artifact(location: dict[str, Any]) -> None:
    allowed(location, {"uri"}, {"uriBaseId", "index"})
    uri = location["uri"]
    assert not set(uri) & set(' "<>\\^`{|}#'), "a URI reference"
    assert uri.isascii()
    assert ("uriBaseId" in location) is not uri.startswith("file:")


def check_region(region: dict[str, Any]) -> None:
    allowed(region, {"startLine"}, {"startColumn", "endLine", "endColumn", "snippet"})
    assert all(isinstance(number, int) and number >= 1 for number in region.values())


def test_sarif_has_the_form_of_the_standard(report: Report) -> None:
    # By the schema of SARIF 2.1.0: required and allowed properties, kinds of values, and references.
    log = sarif(report)
    allowed(log, {"version", "runs"}, {"$schema"})
    assert log["version"] == "2.1.0"
    assert log["$schema"].endswith("sarif-schema-2.1.0.json")
    (run,) = log["runs"]
    allowed(run, {"tool", "results"}, {"columnKind", "artifacts", "invocations"})
    assert run["columnKind"] in ("utf16CodeUnits", "unicodeCodePoints")
    driver = run["tool"]["driver"]
    allowed(driver, {"name"}, {"version", "semanticVersion", "rules", "informationUri"})
    for rule in driver["rules"]:
        allowed(rule, {"id"}, {"name", "shortDescription", "fullDescription", "help", "defaultConfiguration"})
        for part in ("shortDescription", "fullDescription", "help"):
            if part in rule:
                check_message(rule[part])
    for artifact in run["artifacts"]:
        check_artifact(artifact["location"])
    for invocation in run["invocations"]:
        allowed(invocation, {"executionSuccessful"}, {"toolExecutionNotifications", "exitCode"})
        for notification in invocation["toolExecutionNotifications"]:
            allowed(notification, {"message"}, {"level", "descriptor", "locations"})
            check_message(notification["message"])
    for result in run["results"]:
        allowed(
            result, {"message"}, {"ruleId", "ruleIndex", "level", "locations", "relatedLocations", "fixes"}
        )
        check_message(result["message"])
        assert driver["rules"][result["ruleIndex"]]["id"] == result["ruleId"]
        assert result["level"] in ("none", "note", "warning", "error")
        for location in (*result["locations"], *result.get("relatedLocations", ())):
            check_location(location)
        for fix in result.get("fixes", ()):
            allowed(fix, {"artifactChanges"}, {"description"})
            for change in fix["artifactChanges"]:
                allowed(change, {"artifactLocation", "replacements"}, set())
                check_artifact(change["artifactLocation"])
                assert change["replacements"]
                for replacement in change["replacements"]:
                    allowed(replacement, {"deletedRegion"}, {"insertedContent"})
                    check_region(replacement["deletedRegion"])


def test_sarif_says_what_was_found_and_where(report: Report) -> None:
    (run,) = sarif(report)["runs"]
    results = {result["ruleId"]: result for result in run["results"]}
    assert [(r["ruleId"], r["level"]) for r in run["results"]] == [
        ("LK103", "error"),
        ("LK212", "error"),
        ("LK102", "error"),
        ("XY1", "warning"),
        ("LK802", "note"),
    ]
    place = results["LK103"]["locations"][0]["physicalLocation"]
    assert place["region"] == {"startLine": 3, "startColumn": 3}
    assert unquote(place["artifactLocation"]["uri"]) == "a b/häuser #1.xml"
    assert place["artifactLocation"]["uri"] == "a%20b/h%C3%A4user%20%231.xml"
    (other,) = results["LK102"]["relatedLocations"]
    assert other["physicalLocation"]["region"]["startLine"] == 14
    assert "region" not in results["XY1"]["locations"][0]["physicalLocation"]
    assert run["invocations"][0]["toolExecutionNotifications"][0]["descriptor"] == {"id": "LK403"}


def test_sarif_rules_help_as_the_reference_does(report: Report) -> None:
    rules = {rule["id"]: rule for rule in sarif(report)["runs"][0]["tool"]["driver"]["rules"]}
    assert rules["XY1"] == {"id": "XY1"}, "a code of a plugin's own"
    assert rules["LK212"]["shortDescription"]["text"] == CODES["LK212"].title
    assert CODES["LK212"].remedy in rules["LK212"]["help"]["text"]
    example = CODES["LK212"].example
    assert example is not None
    assert example.mended.rstrip() in rules["LK212"]["help"]["markdown"]
    assert rules["LK802"]["defaultConfiguration"] == {"level": "note"}


def test_a_fix_in_sarif_does_what_fix_does(report: Report) -> None:
    results = {result["ruleId"]: result for result in sarif(report)["runs"][0]["results"]}
    (fix,) = results["LK103"]["fixes"]
    (change,) = fix["artifactChanges"]
    (replacement,) = change["replacements"]
    region = replacement["deletedRegion"]
    lines = BROKEN.split("\n")
    line = lines[region["startLine"] - 1]
    start, end = region["startColumn"] - 1, region["endColumn"] - 1
    assert line[:start] + replacement["insertedContent"]["text"] + line[end:] == HOUSE.split("\n")[2]
    assert "fixes" not in results["LK212"]


def test_files_elsewhere_have_whole_addresses_in_sarif(tmp_path: Path, monkeypatch: Any) -> None:
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    files = (str(tmp_path / "there.xml"), str(tmp_path / "here" / "a.xml"), "../b:c.xml")
    report = Report(tuple(Checked(file, ()) for file in files))
    uris = [artifact["location"]["uri"] for artifact in sarif(report)["runs"][0]["artifacts"]]
    assert uris == [(tmp_path / "there.xml").as_uri(), "a.xml", "../b%3Ac.xml"]


def test_junit_has_a_test_case_for_each_document(report: Report) -> None:
    root = ET.fromstring(FORMATS["junit"](report))
    assert root.tag == "testsuites"
    (suite,) = root
    assert [suite.get(name) for name in ("tests", "failures", "errors", "skipped")] == ["2", "1", "0", "0"]
    good, bad = suite.findall("testcase")
    assert (good.get("name"), len(good)) == ("house.xml", 0)
    assert bad.get("name") == bad.get("file") == "a b/häuser #1.xml"
    (failure,) = bad.findall("failure")
    assert failure.get("type") == "LK103"
    assert failure.get("message") == "LK103: <region> has no attribute 'widht' (and 2 more)"
    assert failure.text is not None
    assert failure.text.count(" error LK") == 3
    assert '  3 |   <region symbol="Facade" widht="6"' in failure.text
    out = bad.findtext("system-out", "")
    assert "note LK802" in out
    assert "hint\N{REPLACEMENT CHARACTER} of a plugin" in out
    assert "LK403" in suite.findtext("system-err", "")


def test_warnings_fail_in_junit_where_they_are_to(report: Report) -> None:
    strict = Report(report.documents, report.general, failing_from=Severity.WARNING)
    failure = ET.fromstring(FORMATS["junit"](strict)).find(".//failure")
    assert failure is not None
    assert "warning XY1" in str(failure.text)


def test_a_failing_plugin_is_an_error_in_junit_and_not_a_failure() -> None:
    failed = Diagnostic("LK407", "the plugin failed", Place("a.xml", 1, 1))
    case = ET.fromstring(FORMATS["junit"](Report((Checked("a.xml", (failed,)),)))).find(".//testcase")
    assert case is not None
    assert [part.tag for part in case] == ["error"]


def test_less_is_told_where_less_is_asked_for(report: Report) -> None:
    errors = Report(report.documents, report.general, shown_from=Severity.ERROR)
    assert len(sarif(errors)["runs"][0]["results"]) == 3
    assert "LK802" not in FORMATS["junit"](errors)
    assert {d["severity"] for d in json.loads(FORMATS["json"](errors))["diagnostics"]} == {"error"}
    assert "warning" not in FORMATS["text"](errors).partition("häuser #1.xml: 3 errors")[0]


def test_text_shows_the_source_and_ends_with_a_line_for_each_document(report: Report) -> None:
    text = FORMATS["text"](report)
    assert text.startswith("warning LK403 plugin: the plugin 'acme' fails\n")
    assert (
        "a b/häuser #1.xml:3:3: error LK103 schema: <region> has no attribute 'widht'\n"
        '  3 |   <region symbol="Facade" widht="6" height="4" split="columns">\n'
        "    |   ^\n"
        "  hint: did you mean 'width'?\n"
    ) in text
    assert text.endswith(
        "house.xml: valid\n"
        "a b/häuser #1.xml: 3 errors, 1 warning, 1 note\n"
        "2 documents: 1 valid, 1 with errors (3 errors, 1 warning, 1 note); `--fix` may mend some of it\n"
    )


def test_one_document_needs_no_total(report: Report) -> None:
    text = FORMATS["text"](replace(report, documents=report.documents[:1]))
    assert text.endswith("\nhouse.xml: valid\n")


def test_what_was_left_unmended_is_not_promised_to_be_mended(report: Report) -> None:
    assert "`--fix`" not in FORMATS["text"](replace(report, unmended=False))


def test_what_several_documents_share_counts_once_in_the_total() -> None:
    shared = Diagnostic("LK201", "gone", Place("house.xml", 1, 1))
    cut = Diagnostic("LK105", "and 4,000 more of this kind", Place("a.xml", 9, 1), count=4000)
    of_two = Report((Checked("a.xml", (shared, cut)), Checked("b.xml", (shared,))))
    assert verdicts(of_two)[:2] == ["a.xml: 4001 errors", "b.xml: 1 error"]
    assert verdicts(of_two)[2].startswith("2 documents: 2 with errors (4001 errors)")


def test_reports_are_the_same_each_time(report: Report) -> None:
    for write in FORMATS.values():
        assert write(report) == write(report)
