"""Soft constraints: which of them are kept at a size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.constraints.defaults import effective_constraints
from layoutkit.model import Facade
from layoutkit.sizing.qp import Backend
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search


@dataclass(frozen=True, eq=False)
class Granted:
    """A search with as many soft constraints as can be kept, and those that cannot.

    Attributes
    ----------
    refused
        Soft constraints that cannot be kept together with the hard ones and the soft ones before them.
    undecided
        Soft constraints left out because nobody found out in time.
    """

    search: Search
    refused: tuple[Constraint, ...] = ()
    undecided: tuple[Constraint, ...] = ()


def granted(
    facade: Facade, size: tuple[float, float], backends: Sequence[Backend], node_limit: int
) -> Granted:
    """Keep soft constraints, the weightier ones first, as long as there is a layout.

    Parameters
    ----------
    size
        Width and height of the layouts, in document units.
    node_limit
        Words tried before a question is given up.
    """
    constraints = effective_constraints(facade)
    hard = [constraint for constraint in constraints if not constraint.soft]
    pending = sorted((c for c in constraints if c.soft), key=lambda c: -(c.weight or 0.0))
    kept: list[Constraint] = []
    refused: list[Constraint] = []
    undecided: list[Constraint] = []

    def search(wishes: Sequence[Constraint]) -> Search:
        return Search(Model(facade, [*hard, *kept, *wishes]), size, backends)

    def status(number: int) -> str:
        """Tell whether there is a layout that keeps the next so many wishes."""
        return search(pending[:number]).variation(0, 0, node_limit).status

    if pending and status(len(pending)) != "found" and status(0) != "found":
        return Granted(search(()))  # with the hard ones alone there is none either
    while pending and status(len(pending)) != "found":
        low, high = 0, len(pending)  # so many can be kept; so many cannot
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if status(middle) == "found" else (low, middle)
        (refused if status(high) == "infeasible" else undecided).append(pending[low])
        kept, pending = kept + pending[:low], pending[high:]
    kept += pending
    return Granted(search(()), tuple(refused), tuple(undecided))
