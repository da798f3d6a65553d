"""A small house by hand, and its layouts with one thing changed."""

from __future__ import annotations

from dataclasses import replace

from layoutkit.constraints import Constraint
from layoutkit.model import Facade, Layout, Region, Violation

#: Widths and heights of the symbols below.
WIDTHS = {"P": 1.0, "B": 2.0, "D": 2.5, "Q": 1.25}
LABELS = {"P": ("Pier",), "B": ("Bay", "Window"), "D": ("Bay", "Door"), "Q": ("Pier",), "C": ("Cornice",)}


def floor(symbol: str, word: str, height: float = 3.0, widths: dict[str, float] | None = None) -> Region:
    """A floor of terminal columns, one for each letter of the word."""
    sizes = {**WIDTHS, **(widths or {})}
    children = tuple(Region(s, sizes[s], height, labels=LABELS[s]) for s in word)
    return Region(symbol, sum(c.width for c in children), height, "columns", children, ("Floor",))


def stacked(*rows: Region) -> Region:
    """Rows, from the top down; all as wide as the first."""
    return Region("H", rows[0].width, sum(r.height for r in rows), "rows", rows)


def house(*constraints: Constraint) -> Facade:
    """A cornice, two upper floors P B P B P, and a ground floor Q D Q B Q... as wide as they are (7 m)."""
    cornice = Region("C", 7.0, 0.5, labels=("Cornice",))
    root = stacked(cornice, floor("F", "PBPBP"), floor("F", "PBPBP"), floor("G", "PBPBP", 3.5))
    return Facade("house", "m", root, constraints=constraints)


def laid_out(facade: Facade, root: Region) -> Layout:
    """Return a layout of the facade."""
    return Layout("changed", facade.units, root, facade)


def broken(facade: Facade, root: Region | None = None) -> list[Violation]:
    """Return the violations of the facade's own constraints, in the input or in another layout."""
    found = laid_out(facade, root or facade.root).violations()
    return [v for v in found if v.constraint in facade.constraints]


def with_rows(facade: Facade, *rows: Region) -> Region:
    """Return the facade's root with other rows."""
    return replace(stacked(*rows), symbol=facade.root.symbol)
