"""Symbols: names for regions, the same one for identical regions of a parent."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from layoutkit.model import Region
from layoutkit_formats.hierarchy import Piece


def region(piece: Piece, symbol: str) -> Region:
    """Return a piece as a region, named, with everything inside named too."""
    terminal = piece.split is None
    labels = ((piece.label,) if terminal else ()) + piece.roles
    names = symbols(piece.children)
    children = tuple(region(c, name) for c, name in zip(piece.children, names, strict=True))
    return Region(
        symbol, piece.width, piece.height, piece.split, children, tuple(dict.fromkeys(labels)), piece.fill
    )


def symbols(pieces: Sequence[Piece]) -> list[str]:
    """Return a symbol for each of the pieces of one parent.

    Settled names stay. Others are named after what they show; different pieces of one name are numbered.
    """
    taken = {piece.name for piece in pieces if piece.name}
    known: dict[Piece, str] = {}
    for piece in pieces:
        if not piece.name and piece not in known:
            name = free_name(_base(piece), taken)
            taken.add(name)
            known[piece] = name
    return [piece.name or known[piece] for piece in pieces]


def _base(piece: Piece) -> str:
    if piece.split is None:
        return piece.label
    return f"{piece.label}{'Columns' if piece.split == 'columns' else 'Rows'}"


def free_name(base: str, taken: set[str]) -> str:
    """Return `base`, or the first of `base2`, `base3` … that is not taken."""
    number, name = 1, base
    while name in taken:
        number += 1
        name = f"{base}{number}"
    return name


def evened(pieces: Sequence[Piece], along: str, tolerance: float) -> list[Piece]:
    """Give leaves of one label whose sizes differ by less than the tolerance their mean size."""
    found = list(pieces)
    pending = [i for i, p in enumerate(found) if p.split is None and not p.name]
    while pending:
        first = found[pending[0]]
        near = [
            i
            for i in pending
            if (found[i].label, found[i].roles) == (first.label, first.roles)
            and abs(getattr(found[i], along) - getattr(first, along)) <= tolerance
        ]
        mean = sum(getattr(found[i], along) for i in near) / len(near)
        for i in near:
            found[i] = replace(found[i], **{along: mean})
        pending = [i for i in pending if i not in near]
    return found
