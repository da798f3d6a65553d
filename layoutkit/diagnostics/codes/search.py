"""The search (LK6)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK601",
        "limit reached",
        "The search gave up before it found a layout or proved that there is none.",
        "Constraints that leave hardly any arrangement.",
        "Raise --node-limit, or relax a constraint.",
    ),
    Code(
        "LK602",
        "constraints inferred",
        "The facade has no constraints: those that its own regularity suggests were used.",
        "A facade fresh from `layoutkit convert`.",
        "Write them into the document with `layoutkit infer`, and edit them there.",
        Severity.NOTE,
    ),
    Code(
        "LK603",
        "soft constraint left out",
        "A soft constraint cannot be kept at the size asked for; the layouts do without it.",
        "Hard constraints, or soft ones of greater weight, that leave no room for it.",
        "Nothing is needed; to insist on it, delete its weight, or raise it.",
        Severity.NOTE,
    ),
    Code(
        "LK604",
        "number not exact",
        "How many arrangements there are is known by bounds only.",
        "Regions coupled by alignments or by frequencies, with too many words to try them all; or an effort "
        "that is too small.",
        "Raise --effort of `layoutkit count`, or count at a smaller size.",
        Severity.NOTE,
    ),
    Code(
        "LK605",
        "no even draw",
        "A variation that is as likely as any other could not be drawn, so none was made.",
        "Arrangements that cannot be counted, or hardly any that exists among those that may.",
        "Vary with --sampling weighted or diverse, or at another size.",
    ),
)
