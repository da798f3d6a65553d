"""Edited trees as facades: regions with symbols and sizes, and what each node is then called."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from layoutkit.model import Region
from layoutkit_editing.original import Original
from layoutkit_editing.topology.site import Spans
from layoutkit_editing.tree import NEW, Tree

#: What composites that are a copy of nothing are called.
GROUP = "Group"
#: Sizes are those of sources, and siblings are replicas, if all that they are off by, taken together, is no
#: more than this share of their parent: children tile it to a tenth of what they may be off.
ALIKE = 1e-10
#: Sizes are rounded to this share of that: noise of floats is below it.
DIGITS = 1e-2


@dataclass(frozen=True)
class Named:
    """An edited tree as regions.

    Attributes
    ----------
    root
        The whole facade.
    paths
        The unique path of every node, by id.
    symbol_paths
        The same without numbers.
    """

    root: Region
    paths: Mapping[int, str]
    symbol_paths: Mapping[int, str]


def named(original: Original, tree: Tree, spans: Spans) -> Named:
    """Return the regions of a sized tree.

    A region keeps its symbol. Siblings of one symbol that are no replicas of each other any more get numbers:
    the first is called as before, others ``Bay_2``, ``Bay_3``.

    Parameters
    ----------
    spans
        Where nodes stand.
    """
    namer = _Namer(original, tree, spans)
    whole = original.facade.root
    root = namer.region(tree.root, *namer.size(tree.root, ALIKE * max(whole.width, whole.height)))
    paths: dict[int, str] = {tree.root: root.symbol}
    symbol_paths = dict(paths)
    for own in tree.inside(tree.root):
        seen: Counter[str] = Counter()
        for child in tree.nodes[own].children:
            symbol = namer.symbols[child]
            seen[symbol] += 1
            number = f".{seen[symbol]}" if seen[symbol] > 1 else ""
            paths[child] = f"{paths[own]}/{symbol}{number}"
            symbol_paths[child] = f"{symbol_paths[own]}/{symbol}"
    return Named(root, paths, symbol_paths)


@dataclass(frozen=True)
class _Namer:
    """Makes regions from nodes.

    Attributes
    ----------
    symbols
        The symbol of every node that was named.
    """

    original: Original
    tree: Tree
    spans: Spans
    symbols: dict[int, str] = field(default_factory=dict)

    def size(self, own: int, tolerance: float) -> tuple[float, float]:
        """Return a node's width and height: its source's, where they are no others, else rounded."""
        source = self.tree.nodes[own].source
        width, height = (self._size(own, axis, source, tolerance) for axis in (0, 1))
        return width, height

    def _size(self, own: int, axis: int, source: int, tolerance: float) -> float:
        start, end = self.spans(own, axis)
        if source != NEW:
            region = self.original.places[source].region
            known = region.height if axis else region.width
            if abs(end - start - known) <= tolerance:
                return known
        return round(end - start, max(0, -math.floor(math.log10(tolerance * DIGITS))))

    def region(self, own: int, width: float, height: float) -> Region:
        """Return the region of a node, everything inside it named."""
        node = self.tree.nodes[own]
        like = Region(GROUP, width, height) if node.source == NEW else self._like(node.source)
        if own == self.tree.root:
            self.symbols[own] = like.symbol
        tolerance = ALIKE * (width if node.split == "columns" else height) / max(len(node.children), 1)
        children = list[Region]()
        for child in node.children:
            along, across = self.size(child, tolerance)
            size = (along, height) if node.split == "columns" else (width, across)
            children.append(self.region(child, *size))
        symbols = self._symbols(children, tolerance)
        for child, region in zip(node.children, symbols, strict=True):
            self.symbols[child] = region.symbol
        return replace(like, width=width, height=height, split=node.split, children=tuple(symbols))

    def _like(self, source: int) -> Region:
        return self.original.places[source].region

    def _symbols(self, siblings: Sequence[Region], tolerance: float) -> list[Region]:
        """Return siblings with symbols of their own, replicas as one object."""
        different: defaultdict[str, list[Region]] = defaultdict(list)
        taken = {region.symbol for region in siblings}
        found = list[Region]()
        for region in siblings:
            known = different[region.symbol]
            replica = next((other for other in known if _alike(region, other, tolerance)), None)
            if replica is None:
                replica = replace(region, symbol=free_name(region.symbol, taken)) if known else region
                taken.add(replica.symbol)
                known.append(replica)
            found.append(replica)
        return found


def _alike(one: Region, other: Region, tolerance: float) -> bool:
    """Tell whether regions are replicas but for their symbols."""
    return (
        abs(one.width - other.width) <= tolerance
        and abs(one.height - other.height) <= tolerance
        and (one.split, one.labels, one.fill) == (other.split, other.labels, other.fill)
        and (one.depth, one.material, one.word) == (other.depth, other.material, other.word)
        and all(_alike(*pair, tolerance) for pair in zip(one.children, other.children, strict=True))
    )


def free_name(stem: str, taken: Collection[str]) -> str:
    """Return a name that is not taken: the stem with a number, from 2 on."""
    number = 2
    while f"{stem}_{number}" in taken:
        number += 1
    return f"{stem}_{number}"
