"""The constraints of a facade's document, as the document of the edited facade has them.

A name of the original stands for all copies of what it named, wherever they stand now. What is gone is not
named any more, and a constraint that speaks of nothing that is left is left out. So is one that documents
cannot say of the edited facade (`Carried.left_out`): that two floors have the same arrangement, for one,
where their windows have come to be of different sizes, and so of different symbols.

An edited facade is a new input. Percentages in its constraints, and what locks keep, refer to it from then
on; while a facade is edited, they refer to the original (`layoutkit_editing.constraints.checks`).
Generators that go by the input, such as a replication, give way to their sequences where they would say
something else.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import faults_of
from layoutkit.constraints.generator import Generator
from layoutkit.diagnostics import Severity
from layoutkit.model import Facade
from layoutkit_editing.constraints.generating import Generators
from layoutkit_editing.constraints.names import Called, DocumentNames, Names
from layoutkit_editing.constraints.rewriting import rewritten
from layoutkit_editing.naming import Named
from layoutkit_editing.state import State


@dataclass(frozen=True)
class Carried:
    """The constraints of an edited facade.

    Attributes
    ----------
    constraints
        In document order; the very objects of the original, where they say the same as before.
    left_out
        Those of the original of which nothing is left, or which cannot be said of the edited facade.
    """

    constraints: tuple[Constraint, ...]
    left_out: tuple[Constraint, ...] = ()


def carried(state: State, named: Named) -> tuple[Constraint, ...]:
    """Return the constraints of an edited facade's document: see `carry`."""
    return carry(state, named).constraints


def carry(state: State, named: Named) -> Carried:
    """Return the constraints of an edited facade's document, and those that it cannot have.

    Parameters
    ----------
    named
        The state's regions, and what its nodes are called.

    Raises
    ------
    Misbehaviour
        If a plugin's kind answers what makes no sense.
    """
    original = state.original.facade
    if not original.constraints:
        return Carried(())
    called = Called(state, named.symbol_paths)
    bare = replace(original, root=named.root, constraints=(), grids=())
    names = DocumentNames(original, bare, called.copies, called.letters, called.turned)
    written = [(constraint, rewritten(constraint, names)) for constraint in original.constraints]
    said = _said(written, names)
    left_out = tuple(constraint for constraint, new in said if not new)
    constraints = tuple(each for _, new in said for each in new)
    same = len(constraints) == len(original.constraints) and all(
        one is other for one, other in zip(constraints, original.constraints, strict=True)
    )
    return Carried(original.constraints if same else constraints, left_out)


#: Constraints of the original, each with what it has become.
Rewritten = list[tuple[Constraint, tuple[Constraint, ...]]]


def _said(written: Rewritten, names: Names) -> Rewritten:
    """Replace generators by sequences where they would say something else, and leave out what is at fault."""
    generators = Generators(names)
    found = [(own, generators.said(own, new) if isinstance(own, Generator) else new) for own, new in written]
    while faulty := _faulty(_with(names.facade, found)):
        found = [(own, tuple(each for each in new if id(each) not in faulty)) for own, new in found]
    return found


def _with(bare: Facade, written: Rewritten) -> Facade:
    return replace(bare, constraints=tuple(each for _, new in written for each in new))


def _faulty(facade: Facade) -> frozenset[int]:
    """Return the identities of the constraints that their own kinds find at fault."""
    return frozenset(
        id(constraint)
        for constraint in facade.constraints
        if any(fault.severity is Severity.ERROR for fault in faults_of(constraint, facade))
    )
