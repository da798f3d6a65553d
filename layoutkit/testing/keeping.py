"""Whether a layout keeps rules on words and on sizes: told from their definitions, without a solver."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints.word_rules import (
    Admits,
    Agree,
    Automaton,
    Counts,
    Mirrored,
    Variants,
    WordRule,
)
from layoutkit.model import Facade, PlacedRegion, Region, place
from layoutkit.sizing.arrangement import value
from layoutkit.sizing.convex import Bend
from layoutkit.sizing.rules import Aligned, Convex, Range, Rows, SizeRule, Target
from layoutkit.testing.sampling import Sample

#: How near to an end a count may be and still keep it: relative ends are products of floats.
_COUNT = 1e-6
#: Regions overlap from this share of the size on, as sizing has it.
_OVERLAP = 2e-7


@dataclass(frozen=True)
class Miss:
    """A rule that a layout does not keep: which, and by how much, in document units or as a count."""

    rule: str
    amount: float


def word_misses(rules: Sequence[WordRule], facade: Facade, root: Region) -> Iterator[Miss]:
    """Yield the rules on words that a layout does not keep."""
    places: dict[str, list[PlacedRegion]] = {}
    for own in place(root):
        places.setdefault(own.symbol_path, []).append(own)
    for rule in rules:
        if isinstance(rule, Agree):
            yield from _disagreeing(rule, places)
            continue
        path = rule.path if not isinstance(rule, Variants) else rule.path.rpartition("/")[0]
        for placed in places.get(path, ()):
            if amount := _missed(rule, placed, facade.regions[path], places):
                yield Miss(f"{type(rule).__name__} of {rule.path}", amount)
                break


def _missed(
    rule: WordRule, placed: PlacedRegion, source: Region, places: dict[str, list[PlacedRegion]]
) -> float:
    word = placed.region.word
    if isinstance(rule, Admits):
        return 0.0 if accepted(rule.automaton, word) else 1.0
    if isinstance(rule, Mirrored):
        pairs = zip(word, reversed(word), strict=True)
        return 0.0 if all(b in rule.partners.get(a, ()) for a, b in pairs) else 1.0
    growth = placed.region.extent(source.split or "columns") / source.extent(source.split or "columns")
    if isinstance(rule, Counts):
        inside = f"{placed.path}/"
        count = sum(p.path.startswith(inside) for path in rule.counted for p in places.get(path, ()))
        amount = max(rule.least.at(growth) - count, count - rule.most.at(growth))
        return amount if amount > _COUNT * max(1.0, count) else 0.0
    if isinstance(rule, Variants) and rule.path.rpartition("/")[2] in word:
        # All that is tried are replicas: one way, which is always allowed where no more are asked for.
        return max(0.0, rule.least.at(growth) - 1 - _COUNT)
    return 0.0


def accepted(automaton: Automaton, word: Sequence[str]) -> bool:
    """Tell whether an automaton accepts a word."""
    state = automaton.start()
    for symbol in word:
        state = automaton.step(state, symbol)
        if state is None:
            return False
    return bool(automaton.accepts(state))


def _disagreeing(rule: Agree, places: dict[str, list[PlacedRegion]]) -> Iterator[Miss]:
    words = set()
    for path, symbols in rule.symbols.items():
        names = {symbol: name for name, symbol in symbols.items()}
        words |= {tuple(names.get(s, "") for s in p.region.word) for p in places.get(path, ())}
    if len(words) > 1:
        yield Miss(f"Agree of {', '.join(rule.symbols)}", 1.0)


def size_misses(rules: Sequence[SizeRule], sample: Sample) -> Iterator[Miss]:
    """Yield the rules on sizes that a layout does not keep, by the distance to what they ask for.

    A row is missed by its excess over the sum of its factors: by how much sizes have to change at least.
    """
    for rule in rules:
        for row, amount in enumerate(_excesses(rule, sample)):
            if amount > 0:
                name = f"{type(rule).__name__}" if row == 0 else f"row {row + 1} of {type(rule).__name__}"
                yield Miss(name, amount)


def _excesses(rule: SizeRule, sample: Sample) -> Iterator[float]:
    if isinstance(rule, Range):
        form, own = rule.form, sample.values[rule.axis]
        yield _beyond(value(form, own), rule.least, rule.most, sum(map(abs, form.values())))
    elif isinstance(rule, Rows):
        quantities = np.array([value(q.form, sample.values[q.axis]) for q in rule.quantities])
        sums = np.asarray(rule.matrix) @ quantities
        for found, least, most, factors in zip(sums, rule.least, rule.most, rule.matrix, strict=True):
            yield _beyond(float(found), float(least), float(most), float(np.abs(factors).sum()))
    elif isinstance(rule, Convex):
        quantities = np.array([value(q.form, sample.values[q.axis]) for q in rule.quantities])
        bend = Bend(rule)
        slopes = bend.slopes(quantities)
        for row, excess in enumerate(bend.excess(quantities)):
            steepness = 1.0 if slopes is None else max(float(np.abs(slopes[row]).sum()), 1e-9)
            yield float(excess) / steepness if np.isfinite(excess) else np.inf
    elif isinstance(rule, Aligned):
        yield _out_of_line(rule, sample)
    else:
        assert isinstance(rule, Target)


def _beyond(found: float, least: float, most: float, factors: float) -> float:
    return max(least - found, found - most) / max(factors, 1e-9)


def _out_of_line(rule: Aligned, sample: Sample) -> float:
    """Return by how much lines of regions that overlap are apart, at most."""
    values, most = sample.values[rule.axis], 0.0
    for one in rule.first:
        for other in rule.second:
            start = max(value(one.start, values), value(other.start, values))
            end = min(value(one.end, values), value(other.end, values))
            if one is not other and end - start > _OVERLAP * values[0]:
                gaps = (value(one.line(s), values) - value(other.line(s), values) for s in rule.lines)
                most = max(most, *map(abs, gaps))
    return most
