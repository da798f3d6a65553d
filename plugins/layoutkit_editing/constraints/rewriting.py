"""Constraints of an original, rewritten for a facade of copies: by the types of their attributes.

Like `layoutkit.constraints.renaming`, so that kinds of plugins are rewritten as well. There every region is
known to go by some names, step by step; here it goes by the paths of its copies, wherever they stand, and may
go by none.

- Sets and extents become unions over all copies; labels stay as long as some region has them.
- A single path can name one region only: there is one constraint for each copy.
- A symbol in a word becomes the set of all that those children are called now that had the symbol; regions in
  which a word reads otherwise get a constraint of their own.
- A set claimed to be of certain sizes (`Sized`) means sizes along the parent's split. Copies whose parent is
  divided the other way are left out of it; see `Names.instead`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, product
from typing import Any, TypeVar

from layoutkit.constraints import Constraint, SameSize, Symmetry
from layoutkit.constraints.attributes import (
    CONTEXT,
    ENCLOSING,
    EXTENT,
    MEMBERS,
    PATH,
    PATHS,
    REGIONS,
    WORD,
    Attribute,
)
from layoutkit.constraints.claims import sized
from layoutkit.constraints.contexts import parents_of
from layoutkit.constraints.pattern import PATTERN
from layoutkit.constraints.renaming import reduced
from layoutkit.model import Extent, RegionSet
from layoutkit_editing.constraints.mirroring import pairs_of
from layoutkit_editing.constraints.names import Names
from layoutkit_editing.constraints.thinning import pattern_of, word_of

AnyConstraint = TypeVar("AnyConstraint", bound=Constraint)
Same = TypeVar("Same", bound=SameSize)

_ONE_PATH = (PATH, ENCLOSING)
#: What names children of the regions that a constraint lists.
_SPELLED = (WORD, PATTERN)


def rewritten(constraint: AnyConstraint, names: Names) -> tuple[AnyConstraint, ...]:
    """Return what a constraint says of the copies; nothing, if it speaks of none.

    A constraint that says the same as before is returned as the very same object.
    """
    work = _Rewriting(constraint, names)
    found = [values for chosen in work.choices() for values in work.all_values(chosen)]
    if not found and isinstance(constraint, SameSize) and constraint.second is not None:
        first, second = _alone(constraint, constraint.second)
        return rewritten(first, names) or rewritten(second, names)
    return tuple(_changed(constraint, values) for values in found)


def _alone(constraint: Same, own: Extent) -> tuple[Same, Same]:
    """Return what a constraint on two extents says of each: its occurrences equal one another."""
    first = replace(constraint, second=None, second_before=None, second_after=None)
    before, after = constraint.second_before, constraint.second_after
    return first, replace(first, first=own, first_before=before, first_after=after)


def _changed(constraint: AnyConstraint, values: Mapping[str, Any]) -> AnyConstraint:
    new = {name: value for name, value in values.items() if getattr(constraint, name) != value}
    return replace(constraint, **new) if new else constraint


@dataclass(frozen=True)
class _Rewriting:
    """One constraint, and the names to rewrite it by."""

    constraint: Constraint
    names: Names

    def given(self, *types: Any) -> Iterator[tuple[Attribute, Any]]:
        """Yield the attributes of some types that have a value."""
        return ((attribute, value) for attribute, value in self._values if attribute.type in types)

    @cached_property
    def _values(self) -> tuple[tuple[Attribute, Any], ...]:
        own = self.constraint
        values = ((attribute, getattr(own, attribute.field_name)) for attribute in own.attributes())
        return tuple((attribute, value) for attribute, value in values if value is not None)

    def choices(self) -> Iterator[dict[str, Any]]:
        """Yield, by field, what single paths become: each copy once, and what belongs together together."""
        paths = {attribute.field_name: path for attribute, path in self.given(*_ONE_PATH)}
        options = [dict(zip(paths, chosen, strict=True)) for chosen in self._products(paths.values())]
        together = [chosen for chosen in options if self._together(paths, chosen)]
        yield from together or options

    def _products(self, paths: Iterable[str]) -> Iterable[tuple[str, ...]]:
        return product(*(self.names.of(path) for path in paths))

    def _together(self, paths: Mapping[str, str], chosen: Mapping[str, str]) -> bool:
        """Tell whether chosen paths are in the same copy of what was around them both in the original."""
        for one, other in combinations(paths, 2):
            common = _common(paths[one], paths[other])
            around = [self._within(chosen[field], common) for field in (one, other)]
            if None not in around and around[0] != around[1]:
                return False
        return True

    def _within(self, path: str, around: str) -> str | None:
        """Return the copy of a region that a path is, or is in."""
        copies = set(self.names.of(around))
        while path and path not in copies:
            path = path.rpartition("/")[0]
        return path or None

    def all_values(self, chosen: dict[str, Any]) -> Iterator[dict[str, Any]]:
        """Yield the attributes' new values, given those of single paths: once for each way to spell words."""
        listed = {attribute.field_name: self.names.of_all(paths) for attribute, paths in self.given(PATHS)}
        if not all(listed.values()):
            return
        if len(listed) != 1 or not self._spells:
            targets = dict.fromkeys(path for paths in listed.values() for path in paths)
            targets |= dict.fromkeys(chosen.values())
            if (values := self.values({**chosen, **listed}, targets)) is not None:
                yield values
            return
        ((field, paths),) = listed.items()
        groups: dict[tuple[tuple[str, Any], ...], list[str]] = {}
        for path in paths:
            values = self.values({**chosen, field: (path,)}, (path,))
            if values is not None:
                del values[field]
                groups.setdefault(tuple(values.items()), []).append(path)
        yield from ({**dict(spelled), field: tuple(own)} for spelled, own in groups.items())

    @property
    def _spells(self) -> bool:
        return isinstance(self.constraint, Symmetry) or any(True for _ in self.given(*_SPELLED))

    def values(self, known: Mapping[str, Any], targets: Iterable[str]) -> dict[str, Any] | None:
        """Return the attributes' new values; None where nothing is left of one that is needed.

        Parameters
        ----------
        known
            Values of some fields.
        targets
            Paths of the copies whose children words name.
        """
        found = dict(known)
        targets = tuple(targets) or tuple(self.names.letters)

        def spelled(name: str) -> tuple[str, ...]:
            return self.names.spelled(targets, name)

        for attribute, value in self.given(REGIONS, MEMBERS, EXTENT, *_SPELLED):
            field = attribute.field_name
            if attribute.type in _SPELLED:
                found[field] = (word_of if attribute.type is WORD else pattern_of)(value, spelled)
            elif attribute.type is EXTENT:
                found[field] = self._extent(value)
            else:
                found[field] = self._set(value, attribute, known)
            if found[field] is None:
                return None
        if isinstance(self.constraint, Symmetry):
            found["pairs"] = pairs_of(self.constraint, tuple(targets), self.names)
            if found["pairs"] is None:
                return None
        return self._with_contexts(found)

    def _set(self, regions: RegionSet, attribute: Attribute, known: Mapping[str, Any]) -> RegionSet | None:
        context = next((a for a, _ in self.given(*_ONE_PATH) if a.name == "within"), None)
        if attribute.type is not MEMBERS or context is None:
            return self._regions(regions)
        old, new = getattr(self.constraint, context.field_name), known[context.field_name]

        def member(name: str) -> tuple[str, ...]:
            if name.startswith("@") or "/" in name:
                return self._named(name)
            inside = (path for path in self.names.of(f"{old}/{name}") if path.startswith(f"{new}/"))
            return tuple(_called_in(new, path) for path in inside)

        return reduced(regions, member)

    def _regions(self, regions: RegionSet) -> RegionSet | None:
        """Return a set of paths and labels in new names."""
        found = reduced(regions, self._named)
        if found is None or not self._sizes:
            return found
        turned = [path for path in self.names.facade.select(found) if path in self.names.turned]
        if not turned:
            return found
        without = RegionSet(operator="-", left=found, right=RegionSet.union(turned))
        instead = dict.fromkeys(own for path in turned for own in self.names.instead(path))
        if not self.names.facade.select(without):
            return RegionSet.union(instead) if instead else None
        for own in instead:
            without = RegionSet(operator="|", left=without, right=RegionSet(own))
        return without

    @property
    def _sizes(self) -> bool:
        """Whether the constraint claims sizes along the split of parents."""
        return any(True for _ in sized(self.constraint, self.names.original))

    def _named(self, name: str) -> tuple[str, ...]:
        """Return what a name in a set of paths and labels has become."""
        if name.startswith("@"):
            return self.names.labelled(name)
        if name.endswith("/*"):
            return self.names.inside(name.removesuffix("/*"))
        return self.names.of(name)

    def _extent(self, extent: Extent) -> Extent | None:
        if extent.regions is not None:
            regions = self._regions(extent.regions)
            return None if regions is None else replace(extent, regions=regions)
        assert extent.word is not None
        paths = self.names.of_all(extent.paths)
        word = word_of(extent.word, lambda name: self.names.spelled(paths, name))
        return replace(extent, within=" ".join(paths), word=word) if word is not None else None

    def _with_contexts(self, found: dict[str, Any]) -> dict[str, Any] | None:
        """Add the values of contexts: what stands beside the regions that the sets name by now."""
        parents = tuple(self._parents(found))
        for attribute, word in self.given(CONTEXT):
            new = word_of(word, lambda name: self.names.spelled(parents, name))
            if new is None:
                return None
            found[attribute.field_name] = new
        return found

    def _parents(self, found: Mapping[str, Any]) -> Iterable[str]:
        """Return the regions in which neighbours are looked for."""
        if not any(True for _ in self.given(CONTEXT)):
            return ()
        sets = [found[attribute.field_name] for attribute, _ in self.given(REGIONS, EXTENT)]
        paths = dict[str, None]()
        for value in sets:
            extent = value if isinstance(value, Extent) else Extent(value)
            if value is not None and extent.regions is None:
                paths |= dict.fromkeys(extent.paths)
            elif extent.regions is not None:
                paths |= dict.fromkeys(parents_of(self.names.facade.select(extent.regions)))
        return paths


def _common(one: str, other: str) -> str:
    """Return the innermost region around two, which may be one of them."""
    steps = zip(one.split("/"), other.split("/"), strict=False)
    found = list[str]()
    for own, others in steps:
        if own != others:
            break
        found.append(own)
    return "/".join(found)


def _called_in(context: str, path: str) -> str:
    """Return what a region is called in a context: direct children go by their symbols."""
    inner = path.removeprefix(f"{context}/")
    return path if "/" in inner else inner
