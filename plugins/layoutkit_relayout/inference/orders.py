"""Orders of bays: the input's but for repetitions, any whose edges match, or free.

Each allows what the one before it does, and more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, pairwise

from layoutkit.constraints import Constraint, Frequency, Repetition, Replication, Symmetry, TwoShuffle
from layoutkit.constraints.generators import framed, two_shuffle
from layoutkit.model import Facade, Measure, RegionSet, Word
from layoutkit_relayout.inference.edges import Edges
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.lockstep import Lockstep
from layoutkit_relayout.inference.patterns import covered, told
from layoutkit_relayout.inference.rhythm import (
    Run,
    expressible,
    inner,
    longest_told_apart,
    repeated,
    runs,
    units,
)

#: What may follow each symbol.
After = Mapping[str, Sequence[str]]

_REPEAT = "bays repeat as they do in the input, and in its order"
_NEIGHBOURS = "which bays and piers may be neighbours"


def arrangements(facade: Facade, lockstep: Lockstep, freedom: Freedom) -> Iterator[Constraint]:
    """Yield what the arrangement of a lockstep's bays may be; nothing where only the input's is left."""
    word, edges = lockstep.word, Edges(facade, lockstep)
    if freedom.order == "kept":
        yield from _repeated(facade, lockstep, edges)
        return
    after = _matching(word, edges) if freedom.order == "matching" else _fitting(word, edges)
    if all(len(others) <= 1 for others in after.values()):
        return
    words = framed(word[:1], after, word[-1:])
    if freedom.order == "free" and (shuffled := _shuffled(facade, lockstep, edges, after, words)):
        yield from shuffled
    else:
        yield from told(facade, lockstep.paths, words, _NEIGHBOURS)


def _matching(word: Sequence[str], edges: Edges) -> After:
    """Return what may follow each symbol where edges match; a symbol of its own at an end keeps its place."""
    alone = {symbol for symbol in (word[0], word[-1]) if word.count(symbol) == 1}
    return _after(word, lambda one, other: not alone & {one, other} and edges.match(one, other))


def _fitting(word: Sequence[str], edges: Edges) -> After:
    """Return what may follow each symbol where such neighbours are usual; lone symbols stay at their ends."""
    first = word[0] if word.count(word[0]) == 1 else None
    last = word[-1] if word.count(word[-1]) == 1 else None
    return _after(word, lambda one, other: one != last and other != first and edges.fit(one, other))


def _after(word: Sequence[str], beside: Callable[[str, str], bool]) -> After:
    """Return what may follow each symbol: what does so in the input, and what may stand beside it."""
    seen = set(pairwise(word))
    symbols = dict.fromkeys(word)
    return {one: [s for s in symbols if (one, s) in seen or beside(one, s)] for one in symbols}


def _repeated(facade: Facade, lockstep: Lockstep, edges: Edges) -> Iterator[Constraint]:
    """Yield the input's order, in which runs of like bays may have any number of them.

    A word that reads the same backwards goes on doing so. That says more than sequences can: on both sides of
    a gate there are as many bays.
    """
    word = lockstep.word
    matching = _matching(word, edges)
    spaces = all(map(edges.space, word))
    found = list(runs(word, lambda symbol: spaces or not edges.space(symbol)))
    found = found or list(units(word, lambda one, other: other in matching[one]))
    if not found:
        return
    mirrored = word == word[::-1] and (len(found) > 1 or found[0].unit > 1)
    if not mirrored:
        pattern = repeated(word, longest_told_apart(word, found))
        yield Repetition(within=lockstep.paths, pattern=pattern, comment=_REPEAT)
        return
    if expressible(pattern := repeated(word, found)):
        yield Repetition(within=lockstep.paths, pattern=pattern, comment=_REPEAT)
    else:
        yield from told(facade, lockstep.paths, _neighbours(word), _REPEAT)
        yield from _as_often(lockstep, found)
    yield Symmetry(of=lockstep.paths, comment="left and right mirror each other")


def _neighbours(word: Sequence[str]) -> tuple[Word, ...]:
    """Return the input's neighbours as sequences; its corners stay at the ends."""
    start, end = inner(word)
    core = word[start:end]
    first, *others, last = framed(core[:1], _after(core, lambda one, other: False), core[-1:])
    corners = tuple(map(RegionSet, word[:start])), tuple(map(RegionSet, word[end:]))
    first = Word((*corners[0], *first.sets), at_start=True)
    return first, *others, Word((*last.sets, *corners[1]), at_end=True)


def _as_often(lockstep: Lockstep, found: Sequence[Run]) -> Iterator[Frequency]:
    """Keep the number of what no run has, corners aside, in the lowest floor, which is never left out."""
    word = lockstep.word
    start, end = inner(word)
    running = set(chain.from_iterable(word[run.start : run.end] for run in found))
    comment = "what does not repeat in the input is there as often"
    for symbol in dict.fromkeys(s for s in word[start:end] if s not in running):
        count = Measure(float(word.count(symbol)))
        yield Frequency(
            of=RegionSet(symbol), within=lockstep.paths[-1], min=count, max=count, comment=comment
        )
        comment = ""


def _shuffled(
    facade: Facade, lockstep: Lockstep, edges: Edges, after: After, words: Sequence[Word]
) -> list[Constraint]:
    """Return generators that say the same as sequences: any order between the ends; none if they do not."""
    word, within = lockstep.word, lockstep.paths
    between = dict.fromkeys(word[1:-1])
    bays = [symbol for symbol in between if not edges.space(symbol)]
    spaces = [symbol for symbol in between if edges.space(symbol)] or bays
    before = [symbol for symbol in after if word[-1] in after[symbol]]
    if not bays:
        return []
    first = Word((RegionSet(word[0]), RegionSet.union(after[word[0]])), at_start=True)
    last = Word((RegionSet.union(before), RegionSet(word[-1])), at_end=True)
    order = Word((RegionSet.union(bays), RegionSet.union(spaces)))
    if covered(facade, within[0], (first, *two_shuffle(order), last)) != covered(facade, within[0], words):
        return []
    return [
        Replication(within=within, of=first, comment="what stands at the ends"),
        Replication(within=within, of=last),
        TwoShuffle(within=within, of=order, comment="bays in any order"),
    ]
