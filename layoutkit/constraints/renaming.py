"""Constraints under other names: where a region comes to go by another name, or by several.

A building's faces are copies of one facade; regions that may be laid out in several ways are copies of one
region. In both cases the constraints were written for the original. They are rewritten here by the types of
their attributes, as `attribute` declares them, so that plugins' kinds are carried over as well.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import product
from typing import Any, TypeVar

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
from layoutkit.constraints.constraint import Constraint
from layoutkit.model import Extent, RegionSet, Word

#: What the last step of a path becomes: ``{"Facade/Top/M": ("M", "M~2")}`` for a region with two names,
#: ``{"Facade": ("Building/South", "Building/East")}`` for one that moves as well. Paths not in it stay.
Aliases = Mapping[str, tuple[str, ...]]

AnyConstraint = TypeVar("AnyConstraint", bound=Constraint)

_ONE_PATH = (PATH, ENCLOSING)


def aliases_of(path: str, aliases: Aliases) -> tuple[str, ...]:
    """Return every path that a path has become, in the aliases' order; the path itself if none of it changed.

    Steps are looked up by the path as it was: those inside a renamed region need no entries of their own,
    and entries inside one another multiply.
    """
    steps = path.split("/")
    found = [""]
    for number, step in enumerate(steps, 1):
        options = aliases.get("/".join(steps[:number]), (step,))
        found = [f"{start}/{option}".lstrip("/") for start in found for option in options]
    return tuple(found)


def spread(constraint: AnyConstraint, aliases: Aliases) -> tuple[AnyConstraint, ...]:
    """Return what a constraint says once regions go by several names: it speaks of all of them.

    - Sets and extents become unions, lists of paths become longer; labels stay as they are.
    - A symbol in a word becomes the set of all that it, or any namesake of it elsewhere, has become.
    - A single path can name one region only: there is one constraint for each of its aliases. Two such paths
      inside the same aliased region go together, they are not mixed.

    A constraint that names nothing of all this is returned as the very same object. Attributes of other types
    (among them ``pairs`` and ``pattern``, whose symbols have no aliases of their own) are left alone.
    """
    single = {
        prefix: aliases[prefix]
        for attribute, value in _values(constraint)
        if attribute.type in _ONE_PATH
        for prefix in _prefixes(value)
        if prefix in aliases
    }
    choices = (dict(zip(single, options, strict=True)) for options in product(*single.values()))
    return tuple(
        _rewritten(constraint, aliases, {prefix: (option,) for prefix, option in choice.items()})
        for choice in choices
    )


def confined(constraint: AnyConstraint, path: str) -> AnyConstraint:
    """Return the constraint with the labels in its sets, and what else they name, held to one region.

    Parameters
    ----------
    path
        The region: what is inside it still counts, and so does it.
    """
    place = RegionSet.union((path, f"{path}/*"))

    def held(regions: RegionSet) -> RegionSet:
        if not any(name.startswith("@") for name in regions.names()):
            return regions
        return RegionSet(operator="&", left=regions, right=place)

    return _with_sets(constraint, held)


def lifted(constraint: AnyConstraint, to: str) -> AnyConstraint:
    """Return the constraint with what encloses it replaced by a larger region, and its meaning else kept.

    Its sets then only mean what is inside the former enclosing region. Once that goes by several names
    (`spread`), all of them together count as one region.

    Parameters
    ----------
    to
        Path of the larger region.
    """
    for attribute, path in list(_values(constraint)):
        if attribute.type is ENCLOSING:
            constraint = _lifted(constraint, attribute, path, to)
    return constraint


def joins(kind: type[Constraint]) -> bool:
    """Tell whether constraints of a kind can speak of several regions at once, and so tie faces together."""
    return any(a.type in (REGIONS, MEMBERS, EXTENT, PATHS, ENCLOSING) for a in kind.attributes())


def _values(constraint: Constraint) -> Iterator[tuple[Attribute, Any]]:
    for attribute in constraint.attributes():
        if (value := getattr(constraint, attribute.field_name)) is not None:
            yield attribute, value


def _prefixes(path: str) -> Iterator[str]:
    steps = path.split("/")
    return ("/".join(steps[: number + 1]) for number in range(len(steps)))


def _changed(constraint: AnyConstraint, values: Mapping[str, Any]) -> AnyConstraint:
    """Return the constraint with other values, or itself if they are no others."""
    new = {name: value for name, value in values.items() if getattr(constraint, name) != value}
    return replace(constraint, **new) if new else constraint


def _rewritten(constraint: AnyConstraint, aliases: Aliases, chosen: Aliases) -> AnyConstraint:
    """Rewrite every attribute; single paths by the aliases that are `chosen` for them."""
    context = _context(constraint)

    def of_regions(regions: RegionSet) -> RegionSet:
        return mapped(regions, lambda name: _named(name, aliases))

    def of_members(regions: RegionSet) -> RegionSet:
        return mapped(regions, lambda name: _member(name, context, aliases))

    def of_word(word: Word) -> Word:
        symbols = _symbols(aliases)
        sets = (mapped(s, lambda name: symbols.get(name, (name,))) for s in word.sets)
        return replace(word, sets=tuple(sets))

    def of_extent(extent: Extent) -> Extent:
        if extent.regions is not None:
            return replace(extent, regions=of_regions(extent.regions))
        assert extent.word is not None
        paths = _all(extent.paths, aliases)
        return replace(extent, within=" ".join(paths), word=of_word(extent.word))

    by_type: dict[Any, Callable[[Any], Any]] = {
        REGIONS: of_regions,
        MEMBERS: of_regions if context is None else of_members,
        WORD: of_word,
        CONTEXT: of_word,
        EXTENT: of_extent,
        PATHS: lambda paths: _all(paths, aliases),
        PATH: lambda path: aliases_of(path, chosen)[0],
        ENCLOSING: lambda path: aliases_of(path, chosen)[0],
    }
    values = {a.field_name: by_type[a.type](value) for a, value in _values(constraint) if a.type in by_type}
    return _changed(constraint, values)


def _context(constraint: Constraint) -> str | None:
    """Return the path whose direct subregions the symbols in sets of the type `MEMBERS` mean."""
    return next((v for a, v in _values(constraint) if a.name == "within" and a.type in _ONE_PATH), None)


def _all(paths: Iterable[str], aliases: Aliases) -> tuple[str, ...]:
    return tuple(dict.fromkeys(alias for path in paths for alias in aliases_of(path, aliases)))


def _named(name: str, aliases: Aliases) -> tuple[str, ...]:
    """Return what a name in a set of paths and labels has become."""
    if name.startswith("@"):
        return (name,)
    path, star = (name[:-2], "/*") if name.endswith("/*") else (name, "")
    return tuple(f"{alias}{star}" for alias in aliases_of(path, aliases))


def _member(name: str, context: str | None, aliases: Aliases) -> tuple[str, ...]:
    """Return what a name has become that may be the symbol of a direct subregion of the context."""
    if name.startswith("@") or "/" in name:
        return _named(name, aliases)
    return aliases.get(f"{context}/{name}", (name,))


def _symbols(aliases: Aliases) -> dict[str, tuple[str, ...]]:
    """Return what each symbol has become, wherever it stands; the root's is in no word."""
    found: dict[str, tuple[str, ...]] = {}
    for path, options in aliases.items():
        parent, _, symbol = path.rpartition("/")
        if parent:
            found[symbol] = tuple(dict.fromkeys((*found.get(symbol, ()), *options)))
    return found


def mapped(regions: RegionSet, change: Callable[[str], tuple[str, ...]]) -> RegionSet:
    """Return a set with every name in it replaced by the union of others.

    Parameters
    ----------
    change
        Gives the names, at least one, that stand for a name.
    """
    found = reduced(regions, change)
    assert found is not None  # there is a name for each
    return found


def reduced(regions: RegionSet, change: Callable[[str], tuple[str, ...]]) -> RegionSet | None:
    """Return a set with every name in it replaced by the union of others, or left out where there is none.

    Parameters
    ----------
    change
        Gives the names that stand for a name; none if nothing goes by it any more.

    Returns
    -------
    RegionSet or None
        None where no name is left that could be in the set.
    """
    spine = []
    while regions.left is not None:  # as long as a union has names: no recursion along it
        spine.append(regions)
        regions = regions.left
    found = _union(change(regions.name))
    for node in reversed(spine):
        assert node.right is not None
        right = reduced(node.right, change)
        if found is None or right is None:
            found = _left_of(found, right, node.operator)
        elif node.operator == "|" and node.right.operator is None:  # a longer union, without parentheses
            for name in right.names():
                found = RegionSet(operator="|", left=found, right=RegionSet(name))
        else:
            found = RegionSet(operator=node.operator, left=found, right=right)
    return found


def _left_of(left: RegionSet | None, right: RegionSet | None, operator: str | None) -> RegionSet | None:
    """Return what remains of an operation of whose operands one, or both, are empty."""
    if operator == "&":
        return None
    return right if left is None and operator == "|" else left


def _union(names: Iterable[str]) -> RegionSet | None:
    """Return the union of names, which need not be of the form that documents ask for; None of none."""
    found = None
    for name in names:
        one = RegionSet(name)
        found = one if found is None else RegionSet(operator="|", left=found, right=one)
    return found


def _with_sets(constraint: AnyConstraint, change: Callable[[RegionSet], RegionSet]) -> AnyConstraint:
    """Return the constraint with its sets of paths and labels changed."""
    values: dict[str, Any] = {}
    for attribute, value in _values(constraint):
        if attribute.type is REGIONS:
            values[attribute.field_name] = change(value)
        elif attribute.type is EXTENT and value.regions is not None:
            values[attribute.field_name] = replace(value, regions=change(value.regions))
    return _changed(constraint, values)


def _lifted(constraint: AnyConstraint, enclosing: Attribute, path: str, to: str) -> AnyConstraint:
    whole = "/" not in path

    def held(regions: RegionSet) -> RegionSet:
        if whole and path not in regions.names():
            return regions  # everything is inside the root
        return RegionSet(operator="&", left=regions, right=RegionSet(f"{path}/*"))

    def in_scope(extent: Extent) -> Extent:
        """Keep of a run's regions those that lie in the enclosing one, or are it."""
        paths = [p for p in extent.paths if p == path or p.startswith(f"{path}/")]
        if paths:
            return replace(extent, within=" ".join(paths))
        return Extent(RegionSet(operator="-", left=RegionSet(path), right=RegionSet(path)))  # nothing

    values: dict[str, Any] = {enclosing.field_name: to}
    for attribute, value in _values(constraint):
        if attribute.type is MEMBERS and enclosing.name == "within":
            values[attribute.field_name] = held(mapped(value, lambda name: (_absolute(name, path),)))
        elif attribute.type is EXTENT and value.word is not None:
            values[attribute.field_name] = in_scope(value)
    return _changed(_with_sets(constraint, held), values)


def _absolute(name: str, context: str) -> str:
    """Return the path that a name means which may be the symbol of a direct subregion of the context."""
    return name if name.startswith("@") or "/" in name else f"{context}/{name}"
