"""Arrangements in the words in which one would tell them: a pattern, where it says the same as sequences."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from layoutkit.constraints import Constraint, Repetition, Replication
from layoutkit.constraints.covering import Covering
from layoutkit.constraints.generators import names_of, sequences
from layoutkit.constraints.language import DEAD, Language, language
from layoutkit.constraints.pattern import Either, Marked, One, Pattern, Row, either, row
from layoutkit.model import Facade, RegionSet, Word

#: Parts one after the other: a transition between two states; none where nothing is read.
Parts = tuple[Pattern, ...]
Edges = dict[tuple[int, int], Parts]
#: A start of its own, from which nothing is read up to the automaton's.
_START = -1


def told(facade: Facade, within: Sequence[str], words: Sequence[Word], comment: str) -> Iterator[Constraint]:
    """Yield what admits the arrangements that sequences cover.

    That is a repetition, where a pattern without alternatives says it in fewer names than the sequences; a
    replication, where it is the input's arrangement only; else the sequences themselves.

    Parameters
    ----------
    within
        Paths of regions with the same symbols.
    """
    found = covered(facade, within[0], words)
    pattern = pattern_of(found)
    if not _marks(pattern) and facade.regions[within[0]].word in found:
        yield Replication(within=tuple(within), comment="the arrangement stays as it is")
    elif not _alternatives_in(pattern) and _size(pattern) < sum(map(_names, words)):
        yield Repetition(within=tuple(within), pattern=pattern, comment=comment)
    else:
        yield from sequences(within, words, comment)


def covered(facade: Facade, path: str, words: Sequence[Word]) -> Language:
    """Return the arrangements of a region that sequences cover."""
    region = facade.regions[path]
    pieces = tuple(sequence.piece(region) for sequence in sequences([path], words))
    return language(Covering(pieces), tuple(names_of(region)))


def pattern_of(words: Language) -> Pattern:
    """Return a pattern for a set of words, not empty: its automaton's states eliminated one by one.

    The state that makes the shortest pattern goes first. What results is written with the marks that
    patterns have: ``A (S A)*`` as ``A+[S]``, ``A | A B`` as ``A B?``.
    """
    last = len(words.following)
    edges = _edges(words, last)
    left = set(range(last))
    while left:
        state = min(left, key=lambda s: (_growth(edges, s), s))
        left.remove(state)
        edges = _without(edges, state)
    return _ordered(_one(edges[_START, last]), words.letters)


def _size(pattern: Pattern) -> int:
    """Return how many names and marks a pattern has."""
    return sum(len(regions.names()) for regions in pattern.sets()) + _marks(pattern)


def _names(word: Word) -> int:
    return sum(len(regions.names()) for regions in word.sets)


def _alternatives_in(pattern: Pattern) -> bool:
    match pattern:
        case Either():
            return True
        case Row(parts):
            return any(map(_alternatives_in, parts))
        case Marked(part, _, between):
            return _alternatives_in(part) or (between is not None and _alternatives_in(between))
    return False


def _marks(pattern: Pattern) -> int:
    match pattern:
        case Row(parts) | Either(parts):
            return sum(map(_marks, parts))
        case Marked(part, _, between):
            return 1 + _marks(part) + (_marks(between) if between is not None else 0)
    return 0


def _edges(words: Language, last: int) -> Edges:
    together: dict[tuple[int, int], list[str]] = {}
    for state, following in enumerate(words.following):
        for letter, after in zip(words.letters, following, strict=True):
            if after != DEAD:
                together.setdefault((state, after), []).append(letter)
    edges: Edges = {pair: (One(RegionSet.union(letters)),) for pair, letters in together.items()}
    edges.update({(state, last): () for state, ends in enumerate(words.accepting) if ends})
    edges[_START, 0] = ()
    return edges


def _growth(edges: Edges, state: int) -> int:
    """Return how much longer the edges get when a state goes."""
    into = [_length(parts) for (a, b), parts in edges.items() if b == state != a]
    out = [_length(parts) for (a, b), parts in edges.items() if a == state != b]
    loop = _length(edges.get((state, state), ()))
    return sum(into) * (len(out) - 1) + sum(out) * (len(into) - 1) + loop * (len(into) * len(out) - 1)


def _length(parts: Parts) -> int:
    return sum(map(_size, parts))


def _without(edges: Edges, state: int) -> Edges:
    found = {pair: parts for pair, parts in edges.items() if state not in pair}
    loop = edges.get((state, state))
    for (a, b), before in edges.items():
        for (c, d), behind in edges.items():
            if b == c == state and state not in (a, d):
                way = _repeated(before, loop, behind) if loop is not None else (*before, *behind)
                found[a, d] = _either(found[a, d], way) if (a, d) in found else way
    return found


def _repeated(before: Parts, loop: Parts, behind: Parts) -> Parts:
    """Return ``before loop* behind``, repetitions of what stands beside the loop written as such."""
    if shared := _shared(before[::-1], loop[::-1]):
        part, between = loop[len(loop) - shared :], loop[: len(loop) - shared]
        return (*before[: len(before) - shared], _many(part, between), *behind)
    if shared := _shared(behind, loop):
        part, between = loop[:shared], loop[shared:]
        return (*before, _many(part, between), *behind[shared:])
    inner = loop[0] if len(loop) == 1 else None
    if isinstance(inner, Marked) and inner.between is None:
        return (*before, Marked(inner.part, "*"), *behind)
    return (*before, Marked(_one(loop), "*"), *behind)


def _shared(one: Sequence[Pattern], other: Sequence[Pattern]) -> int:
    """Return how many parts two rows begin with together."""
    count = 0
    while count < min(len(one), len(other)) and one[count] == other[count]:
        count += 1
    return count


def _many(part: Parts, between: Parts) -> Pattern:
    return Marked(_one(part), "+", _one(between) if between else None)


def _either(one: Parts, other: Parts) -> Parts:
    """Return either of two ways, what they share at either end written once."""
    if one == other:
        return one
    first = _shared(one, other)
    one, other, head = one[first:], other[first:], one[:first]
    last = _shared(one[::-1], other[::-1])
    tail = one[len(one) - last :]
    one, other = one[: len(one) - last], other[: len(other) - last]
    if not one or not other:
        return (*head, _optional(one or other), *tail)
    return (*head, _alternatives(_one(one), _one(other)), *tail)


def _alternatives(one: Pattern, other: Pattern) -> Pattern:
    """Return either of two patterns; of single regions, a set."""
    ways = either(one, other)
    ones = [
        way.regions for way in (ways.ways if isinstance(ways, Either) else (ways,)) if isinstance(way, One)
    ]
    if not isinstance(ways, Either) or len(ones) < 2:
        return ways
    names = dict.fromkeys(name for regions in ones for name in regions.names())
    others = [way for way in ways.ways if not isinstance(way, One)]
    return either(One(RegionSet.union(names)), *others)


def _optional(parts: Parts) -> Pattern:
    part = _one(parts)
    if isinstance(part, Marked):
        return part if part.mark in "?*" else Marked(part.part, "*", part.between)
    return Marked(part, "?")


def _one(parts: Parts) -> Pattern:
    return row(*parts)


def _ordered(pattern: Pattern, letters: Sequence[str]) -> Pattern:
    """Return the pattern with the names of each set in the order of the letters."""
    match pattern:
        case One(regions):
            return One(RegionSet.union(sorted(regions.names(), key=letters.index)))
        case Row(parts):
            return Row(tuple(_ordered(part, letters) for part in parts))
        case Either(ways):
            return Either(tuple(_ordered(way, letters) for way in ways))
        case Marked(part, mark, between):
            inner = _ordered(between, letters) if between is not None else None
            return Marked(_ordered(part, letters), mark, inner)
    raise TypeError(f"{type(pattern).__name__} is no part of a pattern")
