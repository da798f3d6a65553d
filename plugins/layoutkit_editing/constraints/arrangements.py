"""Whether constraints forbid the arrangements of a state, whatever its sizes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import word_rules_of
from layoutkit.constraints.expansion import as_written, expanded
from layoutkit.constraints.word_rules import Admits, Agree, Automaton, Counts, Mirrored, WordRule
from layoutkit.model import Facade
from layoutkit_editing.constraints.copies import copies_of, symbol_of
from layoutkit_editing.constraints.reasons import told
from layoutkit_editing.state import State

#: What is broken, where, and how.
Fault = tuple[Constraint, str]


def forbidden(state: State) -> str:
    """Say which hard constraint no sizes of a state could keep, as its arrangements are not what it admits.

    Returns
    -------
    str
        The reason, in the user's words; empty if there is none of the kind.

    Raises
    ------
    Misbehaviour
        If a plugin's kind answers what makes no sense.
    """
    facade, copies = state.original.facade, _Copies(state)
    faults = (fault for rule in _hard_rules(facade) for fault in copies.faults(rule))
    for constraint, what in faults:
        return told(as_written(facade, constraint), what)
    return ""


def _hard_rules(facade: Facade) -> Sequence[WordRule]:
    """Return what hard constraints ask of arrangements; worked out once a facade."""
    if _HARD not in facade.memory:
        hard = [constraint for constraint in expanded(facade) if not constraint.soft]
        facade.memory[_HARD] = word_rules_of(facade, hard)
    found: Sequence[WordRule] = facade.memory[_HARD]
    return found


#: Where a facade remembers them.
_HARD = "word rules of hard constraints"


@dataclass(frozen=True)
class _Copies:
    """The arrangements of copies, in the symbols of the original."""

    state: State

    @cached_property
    def by_path(self) -> Mapping[str, tuple[int, ...]]:
        """The nodes that are copies of each symbol path of the original."""
        return copies_of(self.state)

    def of(self, path: str) -> tuple[int, ...]:
        """Return the copies of a region."""
        return self.by_path.get(path, ())

    def word(self, own: int) -> tuple[str, ...]:
        """Return the arrangement of a node."""
        return tuple(symbol_of(self.state, child) for child in self.state.tree.nodes[own].children)

    def faults(self, rule: WordRule) -> Iterator[Fault]:
        """Yield what breaks a rule on words; whether ranges that grow are kept, sizes tell."""
        if isinstance(rule, Counts):
            yield from self._miscounted(rule)
        elif isinstance(rule, Admits):
            for own in self.of(rule.path):
                if not _accepted(rule.automaton, self.word(own)):
                    yield rule.origin[0], f"{rule.path} would be arranged {self._shown(own)}"
        elif isinstance(rule, Agree):
            yield from self._different(rule)
        elif isinstance(rule, Mirrored):
            for own in self.of(rule.path):
                word = self.word(own)
                pairs = zip(word, reversed(word), strict=True)
                if any(other not in rule.partners.get(one, ()) for one, other in pairs):
                    yield rule.origin[0], f"{rule.path} would be arranged {self._shown(own)}"

    def _miscounted(self, rule: Counts) -> Iterator[Fault]:
        members = (own for path in sorted(rule.counted) for own in self.of(path))
        inside = Counter(above for own in members for above in self.state.tree.ancestors(own)[1:])
        least = 0.0 if rule.least.relative else rule.least.value
        most = float("inf") if rule.most.relative else rule.most.value
        for own in self.of(rule.path):
            if not least <= inside[own] <= most:
                named = next(iter(rule.counted)) if len(rule.counted) == 1 else "them"
                wanted = f"{least:g}" if least == most else f"between {least:g} and {most:g}"
                yield rule.origin[0], f"{rule.path} would have {inside[own]} of {named}, not {wanted}"

    def _different(self, rule: Agree) -> Iterator[Fault]:
        words = [
            (
                path,
                own,
                tuple({name: shared for shared, name in names.items()}.get(s, s) for s in self.word(own)),
            )
            for path, names in rule.symbols.items()
            for own in self.of(path)
        ]
        for path, own, word in words[1:]:
            if word != words[0][2]:
                yield rule.origin[0], f"{path} would be arranged {self._shown(own)}, and {words[0][0]} is not"

    def _shown(self, own: int) -> str:
        return f"{' '.join(self.word(own))!r}"


def _accepted(automaton: Automaton, word: tuple[str, ...]) -> bool:
    state = automaton.start()
    for symbol in word:
        state = automaton.step(state, symbol)
        if state is None:
            return False
    return automaton.accepts(state)
