"""The formats of reports, by the name that users give."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from layoutkit.reports.json_report import json_report
from layoutkit.reports.junit import junit_report
from layoutkit.reports.report import Report
from layoutkit.reports.sarif import sarif_report
from layoutkit.reports.text import text_report

FORMATS: Mapping[str, Callable[[Report], str]] = {
    "text": text_report,
    "json": json_report,
    "sarif": sarif_report,
    "junit": junit_report,
}
