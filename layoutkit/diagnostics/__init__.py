"""Diagnostics: what the program says of a fault, with its place and a hint."""

from layoutkit.diagnostics.diagnostic import Diagnostic, Faulty, Place, Severity, worst
from layoutkit.diagnostics.suggestions import did_you_mean, nearest

__all__ = ["Diagnostic", "Faulty", "Place", "Severity", "did_you_mean", "nearest", "worst"]
