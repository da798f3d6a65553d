"""Orders of bays: the input's but for repetitions, any whose edges match, or free.

Each allows what the one before it does, and more.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from layoutkit.constraints import Constraint, Replication, TwoShuffle
from layoutkit.constraints.generators import framed, two_shuffle
from layoutkit.model import Facade, RegionSet, Word
from layoutkit_relayout.inference.edges import After, Edges, fitting, matching
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.lockstep import Lockstep
from layoutkit_relayout.inference.patterns import covered, told
from layoutkit_relayout.inference.retargeting import retargeted

_NEIGHBOURS = "which bays and piers may be neighbours"


def arrangements(facade: Facade, lockstep: Lockstep, freedom: Freedom) -> Iterator[Constraint]:
    """Yield what the arrangement of a lockstep's bays may be; nothing where only the input's is left."""
    word, edges = lockstep.word, Edges(facade, lockstep)
    if freedom.order == "kept":
        yield from retargeted(facade, lockstep, edges)
        return
    follows = matching(word, edges) if freedom.order == "matching" else fitting(word, edges)
    if all(len(others) <= 1 for others in follows.values()):
        return
    words = framed(word[:1], follows, word[-1:])
    if freedom.order == "free" and (shuffled := _shuffled(facade, lockstep, edges, follows, words)):
        yield from shuffled
    else:
        yield from told(facade, lockstep.paths, words, _NEIGHBOURS)


def _shuffled(
    facade: Facade, lockstep: Lockstep, edges: Edges, follows: After, words: Sequence[Word]
) -> list[Constraint]:
    """Return generators that say the same as sequences: any order between the ends; none if they do not."""
    word, within = lockstep.word, lockstep.paths
    between = dict.fromkeys(word[1:-1])
    bays = [symbol for symbol in between if not edges.space(symbol)]
    spaces = [symbol for symbol in between if edges.space(symbol)] or bays
    before = [symbol for symbol in follows if word[-1] in follows[symbol]]
    if not bays:
        return []
    first = Word((RegionSet(word[0]), RegionSet.union(follows[word[0]])), at_start=True)
    last = Word((RegionSet.union(before), RegionSet(word[-1])), at_end=True)
    order = Word((RegionSet.union(bays), RegionSet.union(spaces)))
    if covered(facade, within[0], (first, *two_shuffle(order), last)) != covered(facade, within[0], words):
        return []
    return [
        Replication(within=within, of=first, comment="what stands at the ends"),
        Replication(within=within, of=last),
        TwoShuffle(within=within, of=order, comment="bays in any order"),
    ]
