"""Cross-references of constraints: the names that they use must exist in the facade."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from layoutkit.constraints.constraint import Constraint
from layoutkit.diagnostics import Diagnostic, did_you_mean
from layoutkit.model import Facade, RegionSet, Word


class Missing(NamedTuple):
    """A name that is not there.

    Attributes
    ----------
    what
        What it is a name of.
    known
        The names that there are.
    """

    what: str
    name: str
    known: Iterable[str]

    @property
    def message(self) -> str:
        """What the document does with the name, without its subject."""
        return f"names the {self.what} {self.name!r}, which is not there"


def missing_names(regions: RegionSet, facade: Facade, within: str | None = None) -> Iterator[Missing]:
    """Yield every name in `regions` that the facade, or the region `within`, lacks."""
    for name in regions.names():
        if name.startswith("@"):
            if name[1:] not in facade.labels:
                yield Missing("label", name[1:], facade.labels)
        elif name.endswith("/*"):
            if (path := name.removesuffix("/*")) not in facade.regions:
                yield Missing("region", path, facade.regions)
        elif within is not None and "/" not in name:
            if f"{within}/{name}" not in facade.regions:
                children = {child.symbol for child in facade.regions[within].children}
                yield Missing(f"symbol in {within}", name, children)
        elif name not in facade.regions:
            yield Missing("region", name, facade.regions)


def unknown_names(
    constraint: Constraint, regions: RegionSet, facade: Facade, within: str | None = None
) -> Iterator[Diagnostic]:
    """Yield a diagnostic for every name in `regions` that the facade, or the region `within`, lacks."""
    return (_unknown(constraint, missing) for missing in missing_names(regions, facade, within))


def unknown_path(constraint: Constraint, path: str, facade: Facade) -> Iterator[Diagnostic]:
    """Yield a diagnostic if there is no region of that path."""
    if path not in facade.regions:
        yield _unknown(constraint, Missing("region", path, facade.regions))


def unknown_composite(constraint: Constraint, path: str, facade: Facade) -> Iterator[Diagnostic]:
    """Yield a diagnostic if there is no composite region of that path."""
    yield from unknown_path(constraint, path, facade)
    if path in facade.regions and facade.regions[path].terminal:
        yield Diagnostic(
            "LK205",
            f"{constraint.qualified_name()} speaks of the arrangement of {path}, which is a terminal",
            constraint.place,
            "name a region that has a split",
            topic="reference",
        )


def unknown_in_word(constraint: Constraint, word: Word, within: str, facade: Facade) -> Iterator[Diagnostic]:
    """Yield a diagnostic for every name in a word that no direct child of `within` goes by."""
    children = facade.regions[within].children
    known = {child.symbol for child in children} | {f"@{name}" for child in children for name in child.labels}
    for name in (name for regions in word.sets for name in regions.names()):
        if name not in known:
            yield _unknown(constraint, Missing(f"direct subregion of {within}", name, known))


def unknown_symbols(
    constraint: Constraint, symbols: Iterable[str], within: str, facade: Facade
) -> Iterator[Diagnostic]:
    """Yield a diagnostic for every symbol that no direct child of `within` has."""
    known = {child.symbol for child in facade.regions[within].children}
    for symbol in symbols:
        if symbol not in known:
            yield _unknown(constraint, Missing(f"symbol in {within}", symbol, known))


def unknown_neighbours(
    constraint: Constraint, word: Word, parents: Collection[str], facade: Facade
) -> Iterator[Diagnostic]:
    """Yield a diagnostic for every name in a context that no direct child of any of the parents goes by."""
    children = [
        child for path in parents if path in facade.regions for child in facade.regions[path].children
    ]
    known = {child.symbol for child in children} | {f"@{name}" for child in children for name in child.labels}
    for name in (name for regions in word.sets for name in regions.names()):
        if name not in known:
            yield _unknown(constraint, Missing("neighbour", name, known))


def _unknown(constraint: Constraint, missing: Missing) -> Diagnostic:
    return Diagnostic(
        "LK201",
        f"{constraint.qualified_name()} {missing.message}",
        constraint.place,
        did_you_mean(missing.name, missing.known),
        topic="reference",
    )
