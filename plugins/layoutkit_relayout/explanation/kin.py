"""What many searches have alike is made once: groups of regions, their machines, tables of their words."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from layoutkit.constraints import Constraint
from layoutkit.constraints.covering import Covering
from layoutkit.constraints.word_rules import Anything, Automaton, Exactly
from layoutkit.model import Facade
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.candidates import MOST_TABLES
from layoutkit_relayout.search.search import Search
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine
from layoutkit_relayout.words.table import CompletionTable

#: Letters of words that read the same backwards; there are as many pairs of them as that squared.
_MOST_MIRRORED = 24


class Kin:
    """What the searches of one facade have in common, whichever of its constraints they keep."""

    def __init__(self, backends: Sequence[Backend] = BACKENDS) -> None:
        self._backends = tuple(backends)
        self._groups: dict[Hashable, WordGroup] = {}
        self._tables: Kept[object, CompletionTable] = Kept(MOST_TABLES)
        self._machines: Kept[object, Machine] = Kept(MOST_TABLES)

    def search(self, facade: Facade, constraints: Sequence[Constraint], size: tuple[float, float]) -> Search:
        """Return a search for layouts that keep some constraints."""
        model = Model(facade, constraints)
        model.groups = tuple(self._groups.setdefault(_key(group), group) for group in model.groups)
        model.group_of = {path: group for group in model.groups for path in group.members}
        search = Search(model, size, self._backends)
        search.candidates.tables, search.candidates.machines = self._tables, self._machines
        return search


def unwieldy(model: Model) -> bool:
    """Tell whether machines would take minutes to build: words that are mirrored have pairs for letters.

    That happens where regions that may differ from place to place lose the least sizes that keep them few.
    """
    return any(any(group.partners.values()) and len(group.letters) > _MOST_MIRRORED for group in model.groups)


def _key(group: WordGroup) -> Hashable:
    """Return what makes up a group."""
    return (
        tuple((member, *own.items()) for member, own in group.symbols.items()),
        tuple(tuple(map(_told, group.rules[member])) for member in group.members),
        tuple(tuple(tuple(m.items()) for m in group.partners[member]) for member in group.members),
        group.unequal,
    )


def _told(automaton: Automaton) -> Hashable:
    """Return what tells an automaton from those that accept something else."""
    if isinstance(automaton, Exactly):
        return automaton.word
    if isinstance(automaton, Covering):
        return automaton.pieces
    return "anything" if isinstance(automaton, Anything) else id(automaton)  # the group keeps it
