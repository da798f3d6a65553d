"""Buildings: one facade design over all faces of a mass."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model.mass import Mass

if TYPE_CHECKING:
    from layoutkit.model.facade import Facade


@dataclass(frozen=True)
class Building:
    """What a building's facade was made from.

    Attributes
    ----------
    mass
        Gives the faces, and the size of each.
    design
        The facade that dresses them all, as its document has it.
    """

    mass: Mass
    design: Facade
