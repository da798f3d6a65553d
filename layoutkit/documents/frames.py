"""What the reader of regions knows of an element that is open."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic

from layoutkit.documents.makers import Node
from layoutkit.documents.tags import Met, Tag, Tags
from layoutkit.model import Split

#: An element that holds nothing so far: its tag, the parser's line and column, and what the tag says.
Leaf = tuple[Tag, int, int, Met]


@dataclass(slots=True, eq=False)
class Frame(Generic[Node]):
    """An element that is open, and holds something.

    Attributes
    ----------
    leaf
        The element itself.
    allowed
        The elements that may stand inside.
    split, judged
        How it is split, and whether the document says so: else no size inside can contradict it.
    tags
        Sound tags that were met inside elements like it.
    found
        How many faults there were when it began.
    known, firsts
        The children so far by symbol: extent and node of the last one; node of the first one, and whether it
        is sound.
    children, extent, top
        All of them; their sum along the split; the highest upper edge of faces.
    written
        How many regions and replicas are written out inside its children.
    whole
        Whether each of its children could be read.
    text
        Whether it holds text.
    """

    leaf: Leaf
    size: tuple[float, float]
    allowed: tuple[str, ...]
    split: Split | None
    judged: bool
    tags: Tags
    found: int
    known: dict[str, tuple[float, Node]] = field(default_factory=dict)
    firsts: dict[str, tuple[Node, bool]] = field(default_factory=dict)
    children: list[Node] = field(default_factory=list)
    extent: float = 0.0
    top: float = 0.0
    written: int = 0
    whole: bool = True
    text: bool = False
