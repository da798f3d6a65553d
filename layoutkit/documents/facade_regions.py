"""The regions of a facade, read from its tree of elements."""

from __future__ import annotations

from dataclasses import dataclass

from layoutkit.diagnostics import Place
from layoutkit.documents.frames import Leaf
from layoutkit.documents.makers import Regions
from layoutkit.documents.reading import Reading
from layoutkit.documents.regions import RegionReader
from layoutkit.documents.tree import Element
from layoutkit.model import Region

#: Regions that a facade may stand for beyond those that are written out: each has a place that is looked at.
REPLICA_LIMIT = 250_000


class FacadeReader(RegionReader[Region]):
    """Reads the regions of a facade from its tree of elements, and compares those of one symbol.

    Attributes
    ----------
    instances
        Elements whose region differs from that of the first sibling of its symbol: a fault in facades, but
        not in layouts.
    """

    def __init__(self, reading: Reading, file: str) -> None:
        self._position = _Position(0, 0)
        super().__init__(reading, Regions(), self._position, lambda line, column: Place(file, line, column))
        self.instances: list[Element] = []

    def root(self, element: Element) -> Region:
        """Return the whole tree.

        Raises
        ------
        Faulty
            If it stands for more than `REPLICA_LIMIT` regions that are not written out (LK006).
        """
        self._read(element)
        assert self.node is not None
        return self.node

    def _read(self, element: Element) -> None:
        self._position.CurrentLineNumber, self._position.CurrentColumnNumber = element.line, element.column
        name = f"{element.namespace} {element.name}" if element.namespace else element.name
        self.start(name, [text for pair in element.attributes.items() for text in pair])
        if element.text is not None:
            self.text(element.text)
        for child in element.children:
            self._read(child)
        self.end()

    def _most_replicas(self) -> int:
        return REPLICA_LIMIT

    def _add(self, leaf: Leaf, node: Region, sound: bool) -> None:
        original, original_sound = self._frame.firsts.setdefault(leaf[3].symbol, (node, sound))
        if sound and original_sound and node != original:
            self.instances.append(self._element(leaf))
        super()._add(leaf, node, sound)


@dataclass(slots=True)
class _Position:
    """Where an element stands, as the parser would say it."""

    CurrentLineNumber: int
    CurrentColumnNumber: int
