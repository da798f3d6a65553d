"""Word groups: composite regions whose arrangements agree share one word, chosen once."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from layoutkit.constraints.word_rules import Admits, Agree, Anything, Automaton, Exactly, Mirrored, WordRule
from layoutkit.model import Facade
from layoutkit_relayout.words.machine import Machine, build, chain
from layoutkit_relayout.words.mirrored import mirrored
from layoutkit_relayout.words.preferences import Floats, preferences


@dataclass(frozen=True, eq=False)
class WordGroup:
    """Composite regions that share one word: a single region, or several whose arrangements agree.

    Attributes
    ----------
    members
        Their symbol paths.
    symbols
        For each member, its own symbol by letter.
    letters
        The shared alphabet.
    rules
        For each member, the rules on its word: they count where the layout reaches that member.
    partners
        For each member whose word reads the same backwards, the partners of each letter.
    unequal
        Those of them in which what mirrors each other need not be equally large.
    """

    members: tuple[str, ...]
    symbols: Mapping[str, Mapping[str, str]]
    letters: tuple[str, ...]
    rules: Mapping[str, Sequence[Automaton]]
    partners: Mapping[str, Sequence[Mapping[str, tuple[str, ...]]]]
    unequal: frozenset[str] = frozenset()

    @cached_property
    def _machines(self) -> dict[object, Machine]:
        return {}

    def _automata(self, members: Iterable[str]) -> list[tuple[Automaton, Mapping[str, str]]]:
        """Return the rules on some members' word, each once, with the symbols by which it knows letters."""
        found = {}
        for member in members:
            symbols = self.symbols[member]
            for automaton in self.rules[member]:
                found[id(automaton), tuple(symbols.items())] = automaton, symbols
        return list(found.values())

    def _mirror(self, members: Iterable[str]) -> Mapping[str, tuple[str, ...]] | None:
        """Return the partners that all mirrored members agree on; None where there is none mirrored."""
        mirrors = [partners for member in members for partners in self.partners[member]]
        if not mirrors:
            return None
        return {
            letter: tuple(b for b in others if all(b in mirror.get(letter, ()) for mirror in mirrors))
            for letter, others in mirrors[0].items()
        }

    def machine(self, members: Sequence[str]) -> Machine:
        """Return the words that the rules of some members accept, counts aside."""
        automata, mirror = self._automata(members), self._mirror(members)
        key = (
            tuple((id(automaton), tuple(symbols.items())) for automaton, symbols in automata),
            None if mirror is None else tuple(mirror.items()),
        )
        if key not in self._machines:
            first, symbols = automata[0]
            if len(automata) == 1 and isinstance(first, Exactly):  # most regions: there is nothing to search
                own = {symbol: letter for letter, symbol in symbols.items()}
                machine = chain(self.letters, [own[s] for s in first.word])
            else:
                machine = build(self.letters, automata)
            self._machines[key] = machine if mirror is None else mirrored(machine, mirror)
        return self._machines[key]

    def preferences(self, machine: Machine) -> Floats:
        """Return the weight of each letter in each state of a machine of the group, by sequences alone."""
        if machine not in self._preferences:
            self._preferences[machine] = preferences(machine, self._automata(self.members))
        return self._preferences[machine]

    @cached_property
    def _preferences(self) -> dict[Machine, Floats]:
        return {}

    @cached_property
    def forced(self) -> tuple[str, ...] | None:
        """The word, if there is only one, whichever members a layout reaches."""
        words = {self.machine((member,)).only_word() for member in self.members}
        return words.pop() if len(words) == 1 else None

    def always(self, member: str) -> tuple[str, ...]:
        """Return the letters that every word of a member has."""
        return tuple(letter for letter in self.letters if self.machine((member,)).needs(letter))

    def letters_of(self, member: str, word: Sequence[str]) -> tuple[str, ...]:
        """Return a member's word in the group's letters."""
        own = {symbol: letter for letter, symbol in self.symbols[member].items()}
        return tuple(own[symbol] for symbol in word)

    def word_of(self, member: str, word: Sequence[str]) -> tuple[str, ...]:
        """Return the group's word in the symbols of one member."""
        symbols = self.symbols[member]
        return tuple(symbols[letter] for letter in word)


def word_groups(facade: Facade, rules: Sequence[WordRule]) -> list[WordGroup]:
    """Return the groups of all composite regions, in document order."""
    admitted: defaultdict[str, list[Automaton]] = defaultdict(list)
    mirrors: defaultdict[str, list[Mirrored]] = defaultdict(list)
    for rule in rules:
        if isinstance(rule, Admits):
            admitted[rule.path].append(rule.automaton)
        elif isinstance(rule, Mirrored):
            mirrors[rule.path].append(rule)
    composites = [path for path, region in facade.regions.items() if region.split is not None]
    leader = {path: path for path in composites}
    letters = {path: {c.symbol: c.symbol for c in facade.regions[path].children} for path in composites}
    for rule in rules:
        if isinstance(rule, Agree):
            _join(rule, leader, letters)
    together: defaultdict[str, list[str]] = defaultdict(list)
    for path in composites:
        together[leader[path]].append(path)
    return [_group(tuple(members), letters, admitted, mirrors) for members in together.values()]


def _join(rule: Agree, leader: dict[str, str], letters: dict[str, dict[str, str]]) -> None:
    """Unite regions whose words agree; their letters are those of the first."""
    first, *others = rule.symbols
    for other in others:
        if leader[first] == leader[other]:
            continue
        # Letters of the first's leader, by the name that this rule gives them.
        named = {symbol: name for name, symbol in rule.symbols[first].items()}
        own = {named[symbol]: letter for letter, symbol in letters[first].items() if symbol in named}
        theirs = {symbol: name for name, symbol in rule.symbols[other].items()}
        renamed = {
            letter: own[theirs[symbol]]
            for letter, symbol in letters[other].items()
            if theirs.get(symbol) in own
        }
        old = leader[other]
        for path in [p for p, first_of in leader.items() if first_of == old]:
            leader[path] = leader[first]
            letters[path] = {renamed[a]: symbol for a, symbol in letters[path].items() if a in renamed}


def _group(
    members: tuple[str, ...],
    letters: Mapping[str, Mapping[str, str]],
    admitted: Mapping[str, Sequence[Automaton]],
    mirrors: Mapping[str, Sequence[Mirrored]],
) -> WordGroup:
    symbols = {member: letters[member] for member in members}
    shared = tuple(letter for letter in symbols[members[0]] if all(letter in symbols[m] for m in members))
    partners = {}
    for member in members:
        own = {symbol: letter for letter, symbol in symbols[member].items()}
        partners[member] = [
            {
                own[a]: tuple(own[b] for b in others if b in own)
                for a, others in rule.partners.items()
                if a in own
            }
            for rule in mirrors.get(member, ())
        ]
    rules = {member: admitted.get(member) or [Anything()] for member in members}
    unequal = frozenset(m for m in members if not all(rule.equal for rule in mirrors.get(m, ())))
    return WordGroup(members, symbols, shared, rules, partners, unequal)
