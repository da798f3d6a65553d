"""An edited facade as constraints of the original look at it: regions go by the names that they had there."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property

from layoutkit.constraints.view import LayoutView
from layoutkit.model import Box, Layout, PlacedRegion, Region
from layoutkit_editing.naming import GROUP
from layoutkit_editing.state import State
from layoutkit_editing.topology.site import Spans
from layoutkit_editing.tree import NEW


class EditedView(LayoutView):
    """The regions of a sized state by the symbol paths of the original: copies go by those of their sources.

    A region's unique path is made of symbols of the original as well, and tells where it stands now. What
    editing made new is called `GROUP`, and found under its path alone.

    Parameters
    ----------
    spans
        Where the state's nodes stand.
    """

    def __init__(self, state: State, spans: Spans) -> None:
        self._state, self._spans = state, spans
        facade = state.original.facade
        super().__init__(Layout(facade.name, facade.units, self._region(state.tree.root)), facade)

    def _region(self, own: int) -> Region:
        node = self._state.tree.nodes[own]
        (left, right), (top, bottom) = (self._spans(own, axis) for axis in (0, 1))
        children = tuple(self._region(child) for child in node.children)
        width, height = right - left, bottom - top
        if node.source == NEW:
            return Region(GROUP, width, height, node.split, children)
        source = self._state.original.places[node.source].region
        return replace(source, width=width, height=height, split=node.split, children=children)

    @cached_property
    def by_path(self) -> dict[str, PlacedRegion]:
        """Every region by its unique path, in document order."""
        nodes, places = self._state.tree.nodes, self._state.original.places
        height, found = self.layout.root.height, dict[str, PlacedRegion]()
        pending = [(self._state.tree.root, self.layout.root, "", self.layout.root.symbol)]
        while pending:
            own, region, above, called = pending.pop()
            path = f"{above}/{called}" if above else called
            source = nodes[own].source
            # No symbol of a document contains a tilde.
            symbol_path = f"~{path}" if source == NEW else places[source].symbol_path
            (left, right), (top, bottom) = (self._spans(own, axis) for axis in (0, 1))
            box = Box(left, height - bottom, right, height - top)
            found[path] = PlacedRegion(path, symbol_path, region, box)
            inner = zip(nodes[own].children, region.children, _numbered(region.word), strict=True)
            pending += reversed([(child, inside, path, name) for child, inside, name in inner])
        return found

    @cached_property
    def _places(self) -> dict[str, list[PlacedRegion]]:
        found: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
        for placed in self.by_path.values():
            found[placed.symbol_path].append(placed)
        return found

    def grouped(
        self, regions: Iterable[PlacedRegion], within: str | None
    ) -> Mapping[str, list[PlacedRegion]]:
        """Return regions by the path of the copy of `within` that they stand in; all where it is None."""
        if within is None:
            return {"": list(regions)}
        groups: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
        for placed in regions:
            around = placed.path.rpartition("/")[0]
            while around and self.by_path[around].symbol_path != within:
                around = around.rpartition("/")[0]
            if around:
                groups[around].append(placed)
        return groups

    def _names(self, parent: str) -> Mapping[str, frozenset[str]]:
        """Return what words may call the children of all regions of a symbol path: what was inserted, too."""
        return self._all_names[parent]

    @cached_property
    def _all_names(self) -> Mapping[str, Mapping[str, frozenset[str]]]:
        found: defaultdict[str, dict[str, frozenset[str]]] = defaultdict(dict)
        for placed in self.by_path.values():
            for child in placed.region.children:
                names = {child.symbol, *(f"@{label}" for label in child.labels)}
                known = found[placed.symbol_path].get(child.symbol, frozenset())
                found[placed.symbol_path][child.symbol] = known | names
        return found


def _numbered(word: Iterable[str]) -> list[str]:
    """Return symbols as unique paths have them: repeats with their number."""
    seen: Counter[str] = Counter()
    found = list[str]()
    for symbol in word:
        seen[symbol] += 1
        found.append(f"{symbol}.{seen[symbol]}" if seen[symbol] > 1 else symbol)
    return found
