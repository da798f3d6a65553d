"""What the regions of an original are called in a facade that was made of copies of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from layoutkit.model import Facade, RegionSet
from layoutkit_editing.constraints.copies import copied, divided
from layoutkit_editing.state import State

#: By a name of the original, what goes by it now.
Renamed = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Names:
    """Regions of an original by their names in a facade of copies.

    Attributes
    ----------
    original
        The facade that constraints were written for.
    facade
        The facade of copies, without constraints.
    copies
        For each symbol path of the original those of its copies, in document order.
    letters
        For each composite region of copies: by symbols of the original, those of the children that had them.
    turned
        Copies whose parent is not divided along the axis that the original's is, by symbol path: what is as
        large as they are along that axis, and stands in a parent that is divided so; nothing, if only the
        whole facade is.
    """

    original: Facade
    facade: Facade
    copies: Renamed
    letters: Mapping[str, Renamed]
    turned: Renamed

    def of(self, path: str) -> tuple[str, ...]:
        """Return the copies of a region of the original."""
        return self.copies.get(path, ())

    def inside(self, path: str) -> tuple[str, ...]:
        """Return names for all copies of what is inside a region of the original."""
        return self.of_all(self.original.select(RegionSet(f"{path}/*")))

    def of_all(self, paths: Iterable[str]) -> tuple[str, ...]:
        """Return the copies of some regions of the original, each once."""
        return tuple(dict.fromkeys(copy for path in paths for copy in self.of(path)))

    def labelled(self, name: str) -> tuple[str, ...]:
        """Return a label, with its ``@``, if some region still has it."""
        return (name,) if name[1:] in self.facade.labels else ()

    def instead(self, path: str) -> tuple[str, ...]:
        """Return what is to be named where a size of a turned copy is meant."""
        return ()

    def spelled(self, parents: Iterable[str], name: str) -> tuple[str, ...]:
        """Return what a name in a word has become, a symbol or a label, among the children of some copies."""
        if name.startswith("@"):
            known = (child for path in parents for child in self.facade.regions[path].children)
            return (name,) if any(name[1:] in child.labels for child in known) else ()
        found = (self.letters.get(path, {}).get(name, ()) for path in parents)
        return tuple(dict.fromkeys(symbol for symbols in found for symbol in symbols))


class DocumentNames(Names):
    """Names as documents write them: what is inside a region is called so, whatever it is."""

    def inside(self, path: str) -> tuple[str, ...]:
        """Return the insides of a region's copies, and copies of what is inside it that stand elsewhere."""
        around = tuple(own for own in self.of(path) if self.facade.regions[own].split)
        inner = self.of_all(self.original.select(RegionSet(f"{path}/*")))
        strays = (own for own in inner if not any(own.startswith(f"{each}/") for each in around))
        return (*(f"{own}/*" for own in around), *strays)

    def instead(self, path: str) -> tuple[str, ...]:
        """Return what is as large."""
        return self.turned[path]


@dataclass(frozen=True, eq=False)
class Called:
    """What each node is called: its symbol path, which others may share."""

    state: State
    paths: Mapping[int, str]

    @cached_property
    def copies(self) -> Renamed:
        """The copies of each symbol path of the original."""
        found: defaultdict[str, dict[str, None]] = defaultdict(dict)
        for own, source in copied(self.state):
            found[self.state.original.places[source].symbol_path][self.paths[own]] = None
        return {path: tuple(own) for path, own in found.items()}

    @cached_property
    def letters(self) -> Mapping[str, Renamed]:
        """What the symbols of the original have become among the children of each composite."""
        found: defaultdict[str, defaultdict[str, dict[str, None]]]
        found = defaultdict(lambda: defaultdict(dict))
        for own, source in copied(self.state):
            parent, _, symbol = self.paths[own].rpartition("/")
            found[parent][self.state.original.places[source].region.symbol][symbol] = None
        return {
            parent: {known: tuple(new) for known, new in symbols.items()} for parent, symbols in found.items()
        }

    @cached_property
    def turned(self) -> Renamed:
        """Copies whose parents are divided another way than in the original."""
        tree, found = self.state.tree, dict[str, tuple[str, ...]]()
        for own, source in copied(self.state):
            wanted = divided(self.state, source)
            if own == tree.root or not wanted or tree.nodes[tree.parents[own]].split == wanted:
                continue
            across = own
            while across != tree.root and tree.nodes[tree.parents[across]].split != wanted:
                across = tree.parents[across]
            found[self.paths[own]] = () if across == tree.root else (self.paths[across],)
        return found
