"""Parts of what is modelled, each in the box of the whole."""

from __future__ import annotations

from layoutkit_operations.kinds.array import Array
from layoutkit_operations.kinds.shape import Shape
from layoutkit_operations.recording import Step


def part_of(whole: Step, label: str, *shapes: Shape) -> Step:
    """Return a part of something, that begins as a box like its own and is then given other shapes."""
    part = whole.do(Array(label=label))
    for shape in shapes:
        part = part.do(shape)
    return part
