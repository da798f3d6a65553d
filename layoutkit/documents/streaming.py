"""A document to a tree of elements, the regions of a layout apart: these are read as they come, and let go.

Facades are small, and their constraints name regions in any order; layouts may have millions of regions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from layoutkit.documents.blanks import Blanks
from layoutkit.documents.grammar import FACADE, LAYOUT, MASS, NAMESPACE, PICTURE, REGION
from layoutkit.documents.makers import Maker
from layoutkit.documents.parsing import DEPTH_LIMIT, Pass
from layoutkit.documents.reading import Reading
from layoutkit.documents.regions import RegionReader
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element, TreeBuilder, text_place

#: What may stand in a layout, in this order.
LAYOUT_PARTS = ("picture", "mass", "region")
_BLANK = " \t\r\n"

#: Says what is to be made of a layout's regions, given the layout's element and the root region's.
Making = Callable[[Element, Element], Maker[Any]]


@dataclass(frozen=True)
class Streamed:
    """A document that was gone through.

    Attributes
    ----------
    root
        Its elements; of the regions of a layout, the root alone.
    reading
        Holds the faults of a layout's regions.
    tree
        What was made of a layout's regions; None for what is no layout, or has none.
    """

    root: Element
    reading: Reading
    tree: Any


def stream(source: Source, making: Making) -> Streamed:
    """Go through a document.

    Raises
    ------
    Faulty
        As `layoutkit.documents.tree.parse`; if a layout stands for too many replicas (LK006).
    """
    builder = _Streamer(Pass(source), making)
    root = builder.build()
    return Streamed(
        root, builder.reading or Reading(root.namespace), builder.regions and builder.regions.node
    )


class _Streamer(TreeBuilder):
    """Builds the tree of a document, and hands the regions of a layout to their reader."""

    def __init__(self, pass_: Pass, making: Making) -> None:
        super().__init__(pass_)
        self.reading: Reading | None = None
        self.regions: RegionReader[Any] | None = None
        self._making = making
        self._kept = DEPTH_LIMIT

    def start(self, name: str, given: list[str]) -> None:
        super().start(name, given)
        root, depth = self.open[0], len(self.open)
        if depth == 1 and not _is_document(root):
            self._kept = 1
        elif depth == 2 and root.name == LAYOUT.name and _is_document(root):
            part = Reading(root.namespace).name_of(self.open[1], root, LAYOUT_PARTS)
            self._kept = DEPTH_LIMIT if part in (PICTURE.name, MASS.name) else 2
            if part == REGION.name and self.regions is None:
                self._begin(root, name, given)

    def end(self, name: str) -> None:
        super().end(name)
        if len(self.open) >= self._kept:  # nobody is to look at it
            self.open[-1].children.pop()

    def _begin(self, root: Element, name: str, given: list[str]) -> None:
        """Hand over to the reader of regions until the root region ends."""
        self.reading, parser = Reading(root.namespace), self.pass_.expat
        maker = self._making(root, self.open[1])
        blanks = Blanks("utf-16" if self.pass_.wide else self.pass_.encoding)
        self.regions = regions = RegionReader(self.reading, maker, parser, self.pass_.at)

        def characters(text: str) -> None:
            if text.strip(_BLANK) and (place := text_place(text, self.pass_.place())):
                regions.text(place)

        def feeding(chunk: bytes) -> None:
            parser.CharacterDataHandler = characters if blanks.may_hold_text(chunk) else None

        def ended() -> None:
            self.listen()
            self.end(name)

        # A document type stands before all elements, and comments on regions are not kept.
        parser.DefaultHandler = parser.CommentHandler = None
        parser.StartElementHandler, parser.EndElementHandler = regions.start, regions.end
        parser.CharacterDataHandler, self.pass_.feeding = characters, feeding
        self.pass_.innermost, regions.ended = regions.innermost, ended
        regions.start(name, given)


def _is_document(root: Element) -> bool:
    return root.name in (FACADE.name, LAYOUT.name, MASS.name) and root.namespace in ("", NAMESPACE)
