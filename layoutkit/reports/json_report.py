"""Reports as JSON, for other programs."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

from layoutkit.documents.mending import Repair
from layoutkit.reports.report import Report


def json_report(report: Report) -> str:
    """Return one line: whether each document is valid, all diagnostics, and what was mended."""
    data: dict[str, Any] = {
        "documents": [{"document": c.document, "valid": c.valid} for c in report.documents],
        "diagnostics": [d.as_dict() for d in report.diagnostics],
        "repairs": [
            {"document": c.document, **_repair(repair)} for c in report.documents for repair in c.repairs
        ],
    }
    return json.dumps(data) + "\n"


def _repair(repair: Repair) -> dict[str, Any]:
    return {
        "code": repair.code,
        "place": asdict(repair.place),
        "was": repair.was,
        "becomes": repair.becomes,
    }
