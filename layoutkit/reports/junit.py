"""Reports as JUnit XML, which build servers show: a test case for each document."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence

from layoutkit.diagnostics import Diagnostic
from layoutkit.reports.report import Checked, Report
from layoutkit.reports.text import mending, with_source

#: What XML 1.0 has no way to write.
_UNWRITABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
#: Codes of what is no fault of a document.
_NOT_THEIRS = ("LK4", "LK9")


def junit_report(report: Report) -> str:
    """Return one test suite: documents fail by their errors, or by warnings if these are to count.

    What is told and does not count is in ``system-out``; what is said of no document, in the suite's
    ``system-err``.
    """
    cases = [_case(checked, report) for checked in report.documents]
    counts = {
        "tests": str(len(cases)),
        "failures": str(sum(case.find("failure") is not None for case in cases)),
        "errors": str(sum(case.find("error") is not None for case in cases)),
        "skipped": "0",
    }
    root = ET.Element("testsuites", {"name": "layoutkit validate", **counts})
    suite = ET.SubElement(root, "testsuite", {"name": "layoutkit validate", **counts})
    suite.extend(cases)
    if general := [d for d in report.general if d in set(report.diagnostics)]:
        ET.SubElement(suite, "system-err").text = _safe("\n".join(map(str, general)))
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _case(checked: Checked, report: Report) -> ET.Element:
    name = _safe(checked.document)
    case = ET.Element("testcase", {"classname": "layoutkit.validate", "name": name, "file": name})
    failures = [d for d in checked.diagnostics if d.severity >= report.failing_from]
    # Many readers take only the first element: it holds everything of its kind.
    theirs = [d for d in failures if not d.code.startswith(_NOT_THEIRS)]
    others = [d for d in failures if d.code.startswith(_NOT_THEIRS)]
    for tag, found in (("error", others), ("failure", theirs)):
        if found:
            _add(case, tag, found, report)
    told = [d for d in checked.diagnostics if report.shown_from <= d.severity < report.failing_from]
    out = [*mending("mended", checked.repairs), *with_source(told, report.piped)]
    if out:
        ET.SubElement(case, "system-out").text = _safe("\n".join(out))
    return case


def _add(case: ET.Element, tag: str, found: Sequence[Diagnostic], report: Report) -> None:
    first, more = found[0], len(found) - 1
    message = f"{first.code}: {first.message}" + (f" (and {more} more)" if more else "")
    added = ET.SubElement(case, tag, {"message": _safe(message), "type": first.code})
    added.text = _safe("\n".join(with_source(found, report.piped)))


def _safe(text: str) -> str:
    return _UNWRITABLE.sub("\N{REPLACEMENT CHARACTER}", text)
