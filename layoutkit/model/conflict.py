"""Conflicts: why a facade has no layout at a size, in the user's own constraints, and what would help."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model.layout import Layout

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint


@dataclass(frozen=True, slots=True)
class Amount:
    """How much something misses.

    Attributes
    ----------
    value
        Greater than 0.
    units
        The document's, or ``regions`` for a count of them.
    """

    value: float
    units: str


@dataclass(frozen=True)
class Member:
    """What takes part in a conflict: a constraint, or all sequences of one region together.

    Attributes
    ----------
    constraints
        As the document has them; those that hold by default are in no document.
    regions
        Symbol paths of the regions in question, where the constraint speaks of more than these.
    subject, demand
        What it speaks of and what it asks, in the user's names: ``size of Facade/B``, ``at most 3.00 m``.
    by_default
        Whether it holds because no constraint says otherwise.
    needed
        Whether a layout was found that keeps all other members: without it, there is no conflict.
    """

    constraints: tuple[Constraint, ...]
    regions: tuple[str, ...]
    subject: str
    demand: str
    by_default: bool
    needed: bool


@dataclass(frozen=True)
class Remedy:
    """A change after which there is a layout: one was found.

    Attributes
    ----------
    text
        What to do, as an imperative.
    member
        Number of the conflict's member that it changes; None where it is the facade's size.
    removed, added
        The change: constraints of the facade that go, and such as take their place.
    size
        Width and height to ask for instead, where that is the change.
    amount
        By how much the member misses: the least change of this kind that helps, rounded up to what one would
        write; None where it is not one of degree.
    """

    text: str
    member: int | None
    removed: tuple[Constraint, ...] = ()
    added: tuple[Constraint, ...] = ()
    size: tuple[float, float] | None = None
    amount: Amount | None = None


@dataclass(frozen=True)
class Conflict:
    """Constraints that cannot hold together at a size.

    Attributes
    ----------
    members
        In document order, those that hold by default last.
    short
        By how much they miss, in sizes and in counts; empty where it is no question of degree.
    remedies
        The mildest first. Each settles this conflict; where there are several, it was tried with those
        members left out that the others can best do without.
    spared
        Number of the member that this conflict can best do without: what the best effort is made without.
    """

    members: tuple[Member, ...]
    short: tuple[Amount, ...] = ()
    remedies: tuple[Remedy, ...] = ()
    spared: int = 0

    @property
    def minimal(self) -> bool:
        """Whether it is proved that no member can be spared."""
        return all(member.needed for member in self.members)


@dataclass(frozen=True)
class Explanation:
    """Why there is no layout of a facade at a size.

    Attributes
    ----------
    size
        Width and height that were asked for.
    conflicts
        Each is proved. Settling all of them leaves no other where `complete` is true.
    complete
        Whether all conflicts were looked for.
    best_effort
        A layout of that size that breaks as little as could be managed; None where none was found.
    """

    size: tuple[float, float]
    conflicts: tuple[Conflict, ...]
    complete: bool
    best_effort: Layout | None = None
