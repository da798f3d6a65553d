"""From labelled boxes to a facade: the part of the picture that counts, its buildings, and the budget.

Regularity costs agreement with the annotation. The most regular hierarchy is taken whose loss stays within a
budget.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from layoutkit.model import Facade, Picture
from layoutkit_formats.boxes import BACKGROUND, LabelBox, hull, in_painting_order, painted
from layoutkit_formats.building import Regularity, building
from layoutkit_formats.hierarchy import Piece, joined
from layoutkit_formats.symbols import region

if TYPE_CHECKING:
    from layoutkit_formats.boxes import Mask

#: From the most regular to the most faithful.
LEVELS = (
    Regularity(lines=0.08, alike=0.25, moves=0.012, terminal=0.0002),
    Regularity(lines=0.04, alike=0.2, moves=0.012, terminal=0.0002),
    Regularity(lines=0.04, alike=0.2, moves=0.006, terminal=0.0002),
    Regularity(lines=0.04, alike=0.15, moves=0.004, terminal=0.0002),
    Regularity(lines=0.04, alike=0.1, moves=0.003, terminal=0.0002),
    Regularity(lines=0.04, alike=0.06, moves=0.003, terminal=0.0001),
    Regularity(lines=0.04, alike=0.03, moves=0.002, terminal=0.00005),
    Regularity(lines=0.02, alike=0.02, moves=0.001, terminal=0.00003),
)

#: The share of the picture's labels that a conversion keeps, if it can.
AGREEMENT = 0.961

#: The number of terminals for each box that is not exceeded, if it can be kept, and what agreement is given
#: for one terminal less.
TERMINALS, SHRED = 4.3, 0.01

#: What falls short by more than this is not mended by the next level, but by the one after it.
FAR = 0.015

#: A side of the picture outside of the facade is left out if it shows no more than this share of it.
OUTSIDE = 0.01


@dataclass(frozen=True)
class Annotation:
    """What a reader found in a file.

    Attributes
    ----------
    name
        Of the facade.
    width, height
        Of the picture, in pixels.
    boxes
        Clipped to the picture; those labelled Wall are the facades.
    picture
        The picture's file, as given; empty if there is none.
    mask
        The label codes of its pixels, where they are known better than from the boxes.
    """

    name: str
    width: int
    height: int
    boxes: tuple[LabelBox, ...]
    picture: str = ""
    mask: Mask | None = None


def facade(annotation: Annotation) -> Facade:
    """Return the hierarchy of an annotation as a facade, without constraints."""
    boxes = in_painting_order(annotation.boxes)
    truth = annotation.mask
    if truth is None:
        truth = painted(boxes, annotation.width, annotation.height)
    frame = _covered(boxes, truth)
    # Sums of sizes differ from the frame by rounding; the root has the frame's own.
    piece = replace(_regular(boxes, frame, truth), width=frame.width, height=frame.height)
    root = region(piece.known_as("Facade", "Facade"), "Facade")
    picture = Picture(annotation.picture, frame[1:]) if annotation.picture else None
    return Facade(annotation.name, "px", root, picture)


def _regular(boxes: Sequence[LabelBox], frame: LabelBox, truth: Mask) -> Piece:
    """Return the most regular hierarchy that keeps the budget, else the one that falls least short of it."""
    found: list[tuple[float, int, Piece]] = []
    at = 0
    while at < len(LEVELS):
        piece = _whole(boxes, frame, truth, LEVELS[at])
        agreement = float((shown(piece, frame, truth.shape) == truth).mean())
        shreds = max(0.0, piece.terminals / len(boxes) - TERMINALS)
        short = max(0.0, AGREEMENT - agreement) + SHRED * shreds
        if not short:
            return piece
        found.append((short, at, piece))
        at += 2 if short > FAR and at + 2 < len(LEVELS) else 1
    return min(found, key=lambda tried: tried[:2])[2]


def _covered(boxes: Sequence[LabelBox], truth: Mask) -> LabelBox:
    """Return the part of the picture that the facade covers, labelled with its ground."""
    import numpy as np

    facades = [box for box in boxes if box.label == "Wall"]
    frame = hull(facades or list(boxes))
    elements = truth != BACKGROUND
    if not elements.any():
        return frame
    xs, ys = np.flatnonzero(elements.any(0)), np.flatnonzero(elements.any(1))
    x0, y0, x1, y1 = (round(v) for v in frame[1:])
    allowed = OUTSIDE * truth.size
    sides = {
        "x0": (elements[:, :x0], float(xs[0])),
        "y0": (elements[:y0], float(ys[0])),
        "x1": (elements[:, x1:], float(xs[-1] + 1)),
        "y1": (elements[y1:], float(ys[-1] + 1)),
    }
    out = {side: end for side, (outside, end) in sides.items() if outside.sum() > allowed}
    return LabelBox(frame.label, *(out.get(s, v) for s, v in zip(sides, frame[1:], strict=True)))


def _whole(boxes: Sequence[LabelBox], frame: LabelBox, truth: Mask, level: Regularity) -> Piece:
    parts = [building(boxes, part, truth, level) for part in _buildings(boxes, frame)]
    if len(parts) == 1:
        return parts[0]
    named = [part.known_as(f"Building{i + 1 if i else ''}", "Building") for i, part in enumerate(parts)]
    return joined(named, "columns")


def _buildings(boxes: Sequence[LabelBox], frame: LabelBox) -> Iterator[LabelBox]:
    """Yield the frames of the buildings that stand side by side."""
    near = 0.015 * frame.width
    facades = [box.clipped(frame) for box in boxes if box.label == "Wall"]
    lines = [frame.x0, frame.x1]
    for value in sorted(v for box in facades for v in box.span(0)):
        inside = any(box.x0 + near < value < box.x1 - near for box in facades)
        if not inside and all(abs(value - line) > near for line in lines):
            lines.append(value)
    lines.sort()
    for x0, x1 in itertools.pairwise(lines):
        middle = 0.5 * (x0 + x1)
        own = [box for box in facades if box.x0 <= middle <= box.x1]
        covered = hull(own) if own else None
        full = covered is not None and covered.y0 - frame.y0 < near and frame.y1 - covered.y1 < near
        yield LabelBox("Wall" if full or not facades else "Background", x0, frame.y0, x1, frame.y1)


def shown(piece: Piece, frame: LabelBox, shape: tuple[int, ...]) -> Mask:
    """Paint the terminals of a hierarchy: a mask of label codes of a picture's shape."""
    return painted(_leaves(piece, frame.x0, frame.y0), shape[1], shape[0])


def _leaves(piece: Piece, x: float, y: float) -> Iterator[LabelBox]:
    if piece.split is None:
        yield LabelBox(piece.label, x, y, x + piece.width, y + piece.height)
        return
    for child in piece.children:
        yield from _leaves(child, x, y)
        if piece.split == "columns":
            x += child.width
        else:
            y += child.height
