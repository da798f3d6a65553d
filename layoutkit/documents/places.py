"""Where in a layout's document the regions stand that are spoken of."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from layoutkit.diagnostics import Place
from layoutkit.documents.grammar import REGION
from layoutkit.documents.parsing import Pass
from layoutkit.documents.source import Source

#: A step of a path: a symbol, and the how many-th of its siblings of that symbol.
_Step = tuple[str, int]


@dataclass(eq=False)
class _Wanted:
    """A region that is looked for, or one above it; `place` is known once it was met."""

    inside: dict[_Step, _Wanted] = field(default_factory=dict)
    place: Place | None = None

    def forget(self) -> None:
        for wanted in self.inside.values():
            wanted.place = None
            wanted.forget()


def places(paths: Iterable[str], source: Source) -> Mapping[str, Place]:
    """Return where each region stands, or the nearest one above it that is there.

    What is inside a replica is written in the nearest earlier sibling of its symbol.

    Parameters
    ----------
    paths
        Such as ``Facade/B/C.2``; the first step is the root region, whatever its name.
    source
        A document that can be read: it is gone through once more.
    """
    wanted = {path: [_step(step) for step in path.rstrip("/").split("/")[1:]] for path in paths}
    root = _Wanted()
    for steps in wanted.values():
        node = root
        for step in steps:
            node = node.inside.setdefault(step, _Wanted())
    _Search(Pass(source), root).run()
    root.place = root.place or Place(source.file)  # the file was changed meanwhile
    return {path: _nearest(root, root.place, steps) for path, steps in wanted.items()}


def _step(text: str) -> _Step:
    symbol, _, number = text.partition(".")
    return symbol, int(number) if number.isdecimal() else 1


def _nearest(node: _Wanted, place: Place, steps: Iterable[_Step]) -> Place:
    for step in steps:
        node = node.inside[step]
        if node.place is None:
            break
        place = node.place
    return place


class _Search:
    """Goes through a document, along the wanted regions only.

    For each open element there are the wanted regions whose inside it holds (several where it is repeated),
    and how often each symbol was met among its children.
    """

    def __init__(self, pass_: Pass, root: _Wanted) -> None:
        self._pass, self._root = pass_, root
        self._open: list[tuple[list[_Wanted], Counter[str]]] = []

    def run(self) -> None:
        parser = self._pass.expat
        parser.DefaultHandler = None
        parser.StartElementHandler, parser.EndElementHandler = self._start, self._end
        self._pass.run()

    def _start(self, name: str, given: list[str]) -> None:
        inside: list[_Wanted] = []
        if len(self._open) == 1:
            if name.endswith(REGION.name) and self._root.place is None:
                self._root.place = self._pass.place()
                inside = [self._root]
        elif self._open and self._open[-1][0]:
            inside = self._child(name, given)
        self._open.append((inside, Counter()))

    def _end(self, name: str) -> None:
        self._open.pop()

    def _child(self, name: str, given: list[str]) -> list[_Wanted]:
        """Note the place of a child, and return the wanted regions that it holds the inside of."""
        around, counts = self._open[-1]
        symbol = dict(zip(given[::2], given[1::2], strict=True)).get("symbol", "")
        counts[symbol] += 1
        number, found = counts[symbol], []
        for parent in around:
            for (wanted, index), node in parent.inside.items():
                if wanted == symbol and index == number:
                    node.place = self._pass.place()
                if wanted == symbol and index >= number and name.endswith(REGION.name):
                    node.forget()
                    found.append(node)
        return found
