"""Layouts: a facade laid out anew, every size known, and checked against its constraints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model.facade import Facade, Picture, Units
from layoutkit.model.mass import Mass
from layoutkit.model.region import Region

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint


@dataclass(frozen=True, slots=True)
class Violation:
    """A constraint that a layout does not keep.

    Attributes
    ----------
    constraint
        The one that is broken; None for the rules that every layout keeps (tiling, replicas).
    path
        Where in the layout, e.g. ``Facade/B/C.2``.
    message
        What is wrong, with the figures.
    amount
        By how much, in document units or as a count.
    """

    constraint: Constraint | None
    path: str
    message: str
    amount: float


@dataclass(frozen=True)
class Layout:
    """A variation of a facade: the tree of placed regions.

    Attributes
    ----------
    root
        The regions with their sizes; positions follow.
    facade
        What it is a variation of; None where the document stands alone.
    facade_file
        The facade's document, relative to the layout's.
    seed, index
        What it was made from, so that it can be made again.
    picture
        Its own picture, where one was made.
    mass
        What its faces stand on, if it is a building's.
    """

    name: str
    units: Units
    root: Region
    facade: Facade | None = None
    facade_file: str | None = None
    seed: int | None = None
    index: int | None = None
    picture: Picture | None = None
    mass: Mass | None = None

    def violations(self) -> tuple[Violation, ...]:
        """Check the layout against its facade: every rule and constraint that it does not keep.

        Raises
        ------
        ValueError
            If the layout does not know its facade.
        """
        # The checker is one of the constraints' own parts, above the model: it is looked up where it is used.
        from layoutkit.constraints.checking import violations

        if self.facade is None:
            raise ValueError(f"the layout {self.name!r} does not know its facade")
        return violations(self, self.facade)
