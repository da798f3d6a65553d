"""Claims: what a constraint says of itself in forms that other parts know what to do with.

Rules say what a constraint demands, once words are chosen, and are all that is needed. Claims are made
before: they let a search rule out words sooner, a count be exact, an explanation go region by region. Each
has to follow from the rules; what is not claimed is found out from them, later.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, isnan
from typing import TYPE_CHECKING

from layoutkit.diagnostics.blame import Misbehaviour, bounded
from layoutkit.model import Extent, Facade

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint

#: A region's symbol path and an axis: its size along that axis.
Frame = tuple[str, int]


@dataclass(frozen=True, slots=True)
class Sized:
    """The region at `path` has a size from `least` to `most` along its parent's split.

    Regions of which that is claimed by a hard constraint have no default size.

    Attributes
    ----------
    centre, deviation
        Mean and standard deviation of its initial sizes, truncation aside.
    """

    path: str
    least: float
    most: float
    centre: float
    deviation: float


@dataclass(frozen=True, slots=True)
class Permits:
    """The region at `path` may have the arrangements that the constraint's rules on words admit.

    All constraints of a kind that permit arrangements of one region do so together, each further one more of
    them. Such a region does not keep the input's arrangement.
    """

    path: str


@dataclass(frozen=True, slots=True)
class Varies:
    """The occurrences of the region at `path` within one parent need not be replicas of one another."""

    path: str


@dataclass(frozen=True, slots=True)
class InLine:
    """Wherever a region of `first` and one of `second` overlap along an axis, their lines coincide.

    Attributes
    ----------
    first, second
        Symbol paths.
    shares
        The lines, as shares of the regions' extents: 0 the start, 0.5 the centre, 1 the end.
    within
        The path of an encompassing region, if only pairs in the same one have to be in line.
    """

    axis: int
    first: tuple[str, ...]
    second: tuple[str, ...]
    shares: tuple[float, ...]
    within: str | None = None


@dataclass(frozen=True, slots=True)
class EquallyLarge:
    """All occurrences of some extents are equally large along an axis.

    Attributes
    ----------
    within
        The path of a region, if only occurrences inside it are.
    """

    axis: int
    extents: tuple[Extent, ...]
    within: str | None = None


@dataclass(frozen=True, slots=True)
class Even:
    """Two regions which, divided at the same places, make the order of letters matter no more.

    Attributes
    ----------
    heads
        The two regions' paths.
    ordered
        The regions in whose words the order would matter otherwise.
    """

    heads: tuple[str, str]
    ordered: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Relates:
    """What some rules on sizes hang on.

    Attributes
    ----------
    frames
        The sizes that they relate to each other.
    words
        Paths of composite regions on whose words the rules hang, if only on how often each letter occurs.
    ordered
        Those of them where the order of letters matters.
    evens
        For each two regions of which the order matters: what would make it matter no more; None where there
        is nothing of the kind.
    paths
        Further regions spoken of: where a layout has none of them, nothing is demanded.
    whole
        Whether these are all the rules that the constraint puts on sizes.
    apart
        Whether the rules leave the choice to stand in line or apart.
    """

    frames: frozenset[Frame] = frozenset()
    words: tuple[str, ...] = ()
    ordered: tuple[str, ...] = ()
    evens: tuple[Even | None, ...] = (None,)
    paths: frozenset[str] = frozenset()
    whole: bool = True
    apart: bool = False


@dataclass(frozen=True, slots=True)
class Counted:
    """The rules on sizes say no more than the counts among the rules on words do."""


Claim = Sized | Permits | Varies | InLine | EquallyLarge | Counted


def claims_of(constraint: Constraint, facade: Facade) -> tuple[Claim, ...]:
    """Return what a constraint claims; it is asked once.

    Raises
    ------
    Misbehaviour
        If it claims what is no claim, or speaks of regions that are not there.
    """
    key = (id(constraint), "claims")
    if key not in facade.memory:
        found = tuple(bounded(constraint.claims(facade), constraint, "claims"))
        for claim in found:
            if wrong := _wrong(claim, facade):
                raise Misbehaviour(constraint, f"claims what {wrong}")
        facade.memory[key] = constraint, found
    known: tuple[Claim, ...] = facade.memory[key][1]
    return known


def relations_of(constraint: Constraint, facade: Facade) -> tuple[Relates, ...] | None:
    """Return what a constraint's rules on sizes relate; None where it does not say.

    Raises
    ------
    Misbehaviour
        If it says what is no relation, or speaks of regions that are not there.
    """
    given = constraint.relations(facade)
    if given is None:
        return None
    found = tuple(given)
    for relation in found:
        if not isinstance(relation, Relates):
            raise Misbehaviour(constraint, f"says that it relates {relation!r}, which is no Relates")
        named = (*(path for path, _ in relation.frames), *relation.words, *relation.ordered, *relation.paths)
        if unknown := [path for path in named if path not in facade.regions]:
            raise Misbehaviour(constraint, f"says that it relates {unknown[0]!r}, which is not there")
        if undivided := [p for p in (*relation.words, *relation.ordered) if facade.regions[p].split is None]:
            raise Misbehaviour(constraint, f"says that it hangs on words of {undivided[0]}, which has none")
    return found


def sized(constraint: Constraint, facade: Facade) -> Iterator[Sized]:
    """Yield the regions of which a constraint claims sizes."""
    return (claim for claim in claims_of(constraint, facade) if isinstance(claim, Sized))


def permitted(constraint: Constraint, facade: Facade) -> tuple[str, ...]:
    """Return the paths of the regions whose arrangements a constraint permits."""
    return tuple(claim.path for claim in claims_of(constraint, facade) if isinstance(claim, Permits))


def counted(constraint: Constraint, facade: Facade) -> bool:
    """Tell whether all that a constraint asks of sizes is said by its counts."""
    return any(isinstance(claim, Counted) for claim in claims_of(constraint, facade))


def varying(constraint: Constraint, facade: Facade) -> tuple[str, ...]:
    """Return the paths of the regions that a constraint lets vary."""
    return tuple(claim.path for claim in claims_of(constraint, facade) if isinstance(claim, Varies))


def _no_axis(axis: object) -> str:
    return "" if axis in (0, 1) else f"is along no axis: {axis!r}"


def _wrong(claim: object, facade: Facade) -> str:
    """Say what is wrong with a claim; empty if nothing is."""
    if not isinstance(claim, Claim):
        return f"is no claim: {claim!r}"
    if isinstance(claim, Sized | Permits | Varies) and claim.path not in facade.regions:
        return f"is not there: {claim.path!r}"
    if isinstance(claim, InLine):
        unknown = [path for path in (*claim.first, *claim.second) if path not in facade.regions]
        return f"is not there: {unknown[0]!r}" if unknown else _no_axis(claim.axis)
    if isinstance(claim, EquallyLarge):
        odd = [extent for extent in claim.extents if not isinstance(extent, Extent)]
        return f"is no extent: {odd[0]!r}" if odd else _no_axis(claim.axis)
    if isinstance(claim, Permits) and facade.regions[claim.path].split is None:
        return f"has no arrangement: {claim.path}"
    if isinstance(claim, Sized):
        ends = (claim.least, claim.most, claim.centre, claim.deviation)
        if any(map(isnan, ends)) or inf in (abs(claim.centre), claim.deviation):
            return f"is no number: {claim}"
    return ""
