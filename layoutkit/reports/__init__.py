"""Reports of what was found in documents: as text with the source, JSON, SARIF and JUnit XML."""

from layoutkit.reports.formats import FORMATS
from layoutkit.reports.report import Checked, Report

__all__ = ["FORMATS", "Checked", "Report"]
