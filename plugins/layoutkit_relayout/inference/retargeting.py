"""Retargeting: the input's order of bays, in which some repeat (Bao et al. 2013, section 5.2, repetition)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import chain

from layoutkit.constraints import Constraint, Frequency, Repetition, Symmetry
from layoutkit.constraints.generators import framed, names_of, spelled
from layoutkit.constraints.language import Language
from layoutkit.model import Facade, Measure, RegionSet, Word
from layoutkit_relayout.inference.doors import FEW_DOORS
from layoutkit_relayout.inference.edges import Edges, after, matching
from layoutkit_relayout.inference.labels import labels_in
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

_COMMENT = "bays repeat as they do in the input, and in its order"


def retargeted(facade: Facade, lockstep: Lockstep, edges: Edges) -> Iterator[Constraint]:
    """Yield the input's order, in which runs of like bays may have any number of them.

    Where there is no run, bays may repeat, or be left out, that may stand beside themselves, or whose
    neighbours may stand side by side. A word that reads the same backwards goes on doing so. That says more
    than sequences can: on both sides of a gate there are as many bays.
    """
    word = lockstep.word
    spaces = {symbol for symbol in word if edges.space(symbol)}
    once = _doors(facade, lockstep)
    follows = matching(word, edges)
    rhythm = list(runs(word, spaces if spaces < set(word) else (), once))
    found = rhythm or list(units(word, once, lambda one, other: other in follows[one]))
    if word == word[::-1] and (len(found) > 1 or any(run.unit > 1 for run in found)):
        yield from _mirrored(facade, lockstep, found)
        return
    chosen = longest_told_apart(word, found)
    if not rhythm:
        words = framed(word[:1], follows, word[-1:])
        chosen = _optional(facade, lockstep, chosen, covered(facade, lockstep.paths[0], words))
    if chosen:
        yield Repetition(within=lockstep.paths, pattern=repeated(word, chosen), comment=_COMMENT)


def _mirrored(facade: Facade, lockstep: Lockstep, found: Sequence[Run]) -> Iterator[Constraint]:
    pattern = repeated(lockstep.word, found)
    if expressible(pattern):
        yield Repetition(within=lockstep.paths, pattern=pattern, comment=_COMMENT)
    else:
        yield from told(facade, lockstep.paths, _neighbours(lockstep.word), _COMMENT)
        yield from _as_often(lockstep, found)
    yield Symmetry(of=lockstep.paths, comment="left and right mirror each other")


def _optional(facade: Facade, lockstep: Lockstep, chosen: Sequence[Run], allowed: Language) -> list[Run]:
    """Let units be left out, from left to right, as far as the arrangements that result are allowed."""
    names = names_of(facade.regions[lockstep.paths[0]])
    found = list(chosen)
    for place, run in enumerate(chosen):
        some = [*found[:place], replace(run, optional=True), *found[place + 1 :]]
        pattern = repeated(lockstep.word, some)
        if spelled(pattern, names).without(allowed) is None and expressible(pattern):
            found = some
    return found


def _doors(facade: Facade, lockstep: Lockstep) -> Collection[str]:
    """Return the bays with a door in one of their floors, where they are few: doors keep their number."""
    doors = {
        symbol
        for symbol in lockstep.word
        if any("Door" in labels_in(facade.regions[f"{path}/{symbol}"]) for path in lockstep.paths)
    }
    return doors if sum(symbol in doors for symbol in lockstep.word) <= FEW_DOORS else ()


def _neighbours(word: Sequence[str]) -> tuple[Word, ...]:
    """Return the input's neighbours as sequences; its corners stay at the ends."""
    start, end = inner(word)
    core = word[start:end]
    first, *others, last = framed(core[:1], after(core, lambda one, other: False), core[-1:])
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
