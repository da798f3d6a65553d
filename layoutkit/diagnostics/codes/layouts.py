"""Layouts against their facades (LK5)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK501",
        "layout does not fit its facade",
        "The layout breaks a rule that every layout keeps: known regions, exact tiling, identical replicas.",
        "A layout edited by hand, or a facade edited after the layout was made.",
        "Make the layout again from the facade.",
    ),
    Code(
        "LK502",
        "layout breaks a constraint",
        "A constraint of the facade does not hold in the layout.",
        "A layout edited by hand, or a constraint added after the layout was made.",
        "Change the layout by the amount named, or loosen the constraint.",
    ),
    Code(
        "LK503",
        "units differ",
        "Layout and facade, or facade and mass, state different units: their sizes cannot be compared.",
        "A layout scaled by another program; a mass in metres for a facade in pixels.",
        "Write both in the same units.",
    ),
    Code(
        "LK504",
        "facade not found",
        "The facade that a layout or session names is not there. Of a layout, nothing that the facade asks "
        "for was checked; a session means nothing without it, so there it is an error.",
        "A document moved without its facade, or a misspelt name.",
        "Put the facade where the document names it, or correct its facade attribute.",
        Severity.WARNING,
    ),
    Code(
        "LK505",
        "not a facade",
        "The file that a layout or session names as its facade is another kind of document.",
        "The document's own file named instead.",
        "Name the facade's document.",
    ),
    Code(
        "LK506",
        "soft constraint not kept",
        "A soft constraint of the facade does not hold in the layout, which is valid all the same.",
        "Hard constraints, or soft ones of greater weight, that leave no room for it.",
        "Nothing is needed; to insist on it, delete its weight, or raise it.",
        Severity.NOTE,
    ),
)
