"""Labels that are nearly those that constraints name, and are named by none.

That no constraint names a label is no fault: labels also say what a picture shows, and annotations have
many. But one that differs from a named one by its case, or by one letter, was likely meant as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from layoutkit.constraints import Constraint
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import Facade
from layoutkit.model.selection import SYMBOL
from layoutkit_relayout.sampling.distances import edit_distance

_LABEL = re.compile(f"@({SYMBOL})")
#: Shorter labels that differ by a letter are other words: Wall and Hall.
_LEAST = 5


def nearly_named(facade: Facade) -> Iterator[Diagnostic]:
    """Yield a note of each label that no constraint names, and that is nearly one that some do."""
    named = _named(facade)
    for label in sorted(facade.labels - named.keys()):
        near = next((other for other in sorted(named) if _nearly(label, other)), None)
        if near is not None:
            path = next(path for path, region in facade.regions.items() if label in region.labels)
            kind = named[near].qualified_name()
            yield Diagnostic(
                "LK231",
                f"no constraint names the label {label!r} (of {path}); this {kind} has {near!r}",
                named[near].place,
                f"write one name for both, if {path} is meant as well; otherwise nothing is needed",
                Severity.NOTE,
                "semantics",
            )


def _named(facade: Facade) -> Mapping[str, Constraint]:
    """Return the labels that constraints name, each with the first that does; the facade's own only."""
    found: dict[str, Constraint] = {}
    for constraint in facade.constraints:
        for attribute in constraint.attributes():
            value = getattr(constraint, attribute.field_name)
            text = "" if value is None else attribute.type.text(value)
            for label in _LABEL.findall(text):
                found.setdefault(label, constraint)
    return {label: constraint for label, constraint in found.items() if label in facade.labels}


def _nearly(one: str, other: str) -> bool:
    """Tell whether two labels differ by their case, or by a letter; by a digit they differ on purpose."""
    a, b = one.casefold(), other.casefold()
    if a == b:
        return True
    if re.sub(r"\d", "", a) == re.sub(r"\d", "", b):
        return False
    return min(len(a), len(b)) >= _LEAST and edit_distance(a, b) == 1
