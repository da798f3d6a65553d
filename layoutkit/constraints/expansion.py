"""Generators to the sequences that they stand for, and all sequences of each region together."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from itertools import groupby
from typing import TypeVar

from layoutkit.constraints.claims import permitted
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.generator import Generator, Given
from layoutkit.constraints.sequence import Sequence
from layoutkit.diagnostics import Faulty
from layoutkit.model import Facade, Word

Kind = TypeVar("Kind", bound=Constraint)


def expanded(facade: Facade) -> tuple[Constraint, ...]:
    """Return the facade's constraints, in document order, each generator replaced by its sequences.

    Worked out once a facade. Each sequence has the place and the comment of its generator.

    Raises
    ------
    Faulty
        If a generator cannot say what its sequences are. (A document with such a fault is not read.)
    """
    if "expanded" not in facade.memory:
        facade.memory["expanded"] = _expanded(facade)
    found: tuple[Constraint, ...] = facade.memory["expanded"][0]
    return found


def as_written(facade: Facade, constraint: Constraint) -> Constraint:
    """Return the generator that a sequence comes from; any other constraint as it is."""
    expanded(facade)
    origins: Mapping[int, Constraint] = facade.memory["expanded"][1]
    return origins.get(id(constraint), constraint)


def together(facade: Facade, kind: type[Kind]) -> Mapping[str, tuple[Kind, ...]]:
    """Return the constraints of a kind by the regions whose arrangements they permit together."""
    key = ("together", kind)
    if key not in facade.memory:
        found: defaultdict[str, list[Kind]] = defaultdict(list)
        for constraint in expanded(facade):
            if isinstance(constraint, kind):
                for path in permitted(constraint, facade):
                    found[path].append(constraint)
        facade.memory[key] = {path: tuple(own) for path, own in found.items()}
    known: Mapping[str, tuple[Kind, ...]] = facade.memory[key]
    return known


def sequences_of(facade: Facade) -> Mapping[str, tuple[Sequence, ...]]:
    """Return the sequences of each region that has some, by its path, those of generators among them."""
    return together(facade, Sequence)


def given_sequences(facade: Facade) -> Given:
    """Return the words of all sequences of each region that has some.

    Generators that go by other regions' sequences are asked until nothing new comes of it, so that they may
    go by one another in any order. What a generator at fault would add is missing.
    """
    if "given" not in facade.memory:
        facade.memory["given"] = _given(facade)
    found: Given = facade.memory["given"]
    return found


def _given(facade: Facade) -> Given:
    found = _written(facade)
    generators = [c for c in facade.constraints if isinstance(c, Generator) and not any(c.unknown(facade))]
    changed = True
    while changed:
        changed = False
        for generator in generators:
            for path in generator.targets(facade):
                known = found.get(path, ())
                try:
                    added = generator.words(facade, path, found)
                except Faulty:  # it says so itself, as one of its faults
                    continue
                if new := tuple(word for word in dict.fromkeys(added) if word not in known):
                    found[path] = (*known, *new)
                    changed = True
    return found


def _written(facade: Facade) -> dict[str, tuple[Word, ...]]:
    found: defaultdict[str, dict[Word, None]] = defaultdict(dict)
    for constraint in facade.constraints:
        if isinstance(constraint, Sequence):
            for path in constraint.within:
                found[path][constraint.word] = None
    return {path: tuple(words) for path, words in found.items()}


def _expanded(facade: Facade) -> tuple[tuple[Constraint, ...], Mapping[int, Constraint]]:
    """Return the constraints, and the generator of each sequence by the identity of the sequence."""
    found: list[Constraint] = []
    origins: dict[int, Constraint] = {}
    known = {path: set(words) for path, words in _written(facade).items()}
    for constraint in facade.constraints:
        if not isinstance(constraint, Generator):
            found.append(constraint)
            continue
        for sequence in _sequences(constraint, facade, known):
            origins[id(sequence)] = constraint
            found.append(sequence)
    return tuple(found), origins


def _sequences(generator: Generator, facade: Facade, known: dict[str, set[Word]]) -> list[Sequence]:
    """Return the sequences that a generator adds to what is known; regions with the same ones share them."""
    if faults := tuple(generator.faults(facade)):
        raise Faulty(faults)
    added: list[tuple[tuple[Word, ...], str]] = []
    for path in generator.targets(facade):
        own = known.setdefault(path, set())
        words = dict.fromkeys(generator.words(facade, path, given_sequences(facade)))
        added.append((tuple(word for word in words if word not in own), path))
        own.update(words)
    return [
        Sequence(
            within=tuple(path for _, path in group),
            word=word,
            weight=generator.weight,
            scope=generator.scope,
            place=generator.place,
            comment=generator.comment,
        )
        for words, group in ((words, list(same)) for words, same in groupby(added, key=lambda pair: pair[0]))
        for word in words
    ]
