"""What readers say of faults in annotations."""

from __future__ import annotations

from layoutkit.diagnostics import Diagnostic, Place, Severity


def conversion(
    code: str, message: str, place: Place, hint: str = "", severity: Severity = Severity.ERROR
) -> Diagnostic:
    """Return a diagnostic of the topic `conversion`."""
    return Diagnostic(code, message, place, hint, severity, "conversion")
