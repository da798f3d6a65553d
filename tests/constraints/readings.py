"""A layout read as the search and sizing read it: by a constraint's rules, on its words and its sizes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from layoutkit.constraints import Constraint
from layoutkit.constraints.word_rules import Admits, Agree, Automaton, Counts, Mirrored, WordRule
from layoutkit.model import Facade, Region, place
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot
from layoutkit.sizing.rules import Aligned, Form, Range, SizeRule

Word = tuple[str, ...]
TOLERANCE = 1e-6


def kept_by_rules(constraint: Constraint, facade: Facade, root: Region) -> bool:
    """Tell whether a layout, whose replicas are alike, keeps every rule that a constraint yields."""
    regions = {placed.symbol_path: placed.region for placed in reversed(list(place(root)))}
    words = {path: region.word for path, region in regions.items() if region.split}
    if not all(
        _reads(rule, words, regions, facade) for rule in type(constraint).word_rules([constraint], facade)
    ):
        return False
    arrangement = Arrangement(facade, words)
    values = [_values(arrangement, regions, axis) for axis in (0, 1)]
    size = max(root.width, root.height)
    return all(_holds(rule, values[rule.axis], size) for rule in constraint.size_rules(arrangement))


def _values(arrangement: Arrangement, regions: Mapping[str, Region], axis: int) -> np.ndarray:
    """Return the variables of an axis that give every region its size."""
    rows = np.zeros((len(arrangement.frames) + 1, arrangement.variables[axis]))
    sizes = np.zeros(len(rows))
    for number, path in enumerate(arrangement.frames):
        region = regions[path]
        sizes[number] = (region.width, region.height)[axis]
        for variable, factor in arrangement.extent(path, axis).items():
            rows[number, variable] = factor
    found = np.linalg.lstsq(rows, sizes, rcond=None)[0]
    assert np.allclose(rows @ found, sizes, atol=1e-9), "the frames do not say all sizes"
    return np.asarray(found)


def _at(form: Form, values: np.ndarray) -> float:
    return float(sum(factor * values[variable] for variable, factor in form.items()))


def _holds(rule: SizeRule, values: np.ndarray, size: float) -> bool:
    if isinstance(rule, Range):
        slack = TOLERANCE * size
        return rule.least - slack <= _at(rule.form, values) <= rule.most + slack
    if isinstance(rule, Aligned):
        return all(_in_line(a, b, rule, values, size) for a in rule.first for b in rule.second if a is not b)
    return True


def _in_line(one: Slot, other: Slot, rule: Aligned, values: np.ndarray, size: float) -> bool:
    ends = [(_at(slot.start, values), _at(slot.end, values)) for slot in (one, other)]
    if min(end for _, end in ends) - max(start for start, _ in ends) <= TOLERANCE * size:
        return True
    lines = [(_at(one.line(share), values), _at(other.line(share), values)) for share in rule.lines]
    return all(abs(a - b) <= TOLERANCE * size for a, b in lines)


def _reads(rule: WordRule, words: Mapping[str, Word], regions: Mapping[str, Region], facade: Facade) -> bool:
    if isinstance(rule, Admits):
        return rule.path not in words or _accepts(rule.automaton, words[rule.path])
    if isinstance(rule, Mirrored):
        word = words.get(rule.path, ())
        return all(a in rule.partners[b] for a, b in zip(word, reversed(word), strict=True))
    if isinstance(rule, Agree):
        return len({words[path] for path in rule.symbols if path in words}) <= 1
    assert isinstance(rule, Counts)
    if rule.path not in regions:
        return True
    source = facade.regions[rule.path]
    axis = AXIS[source.split or "columns"]
    own = regions[rule.path]
    growth = (own.width, own.height)[axis] / (source.width, source.height)[axis]
    count = sum(path in rule.counted for path in _inside(rule.path, own))
    return rule.least.at(growth) - TOLERANCE <= count <= rule.most.at(growth) + TOLERANCE


def _inside(path: str, region: Region) -> Iterator[str]:
    for child in region.children:
        yield f"{path}/{child.symbol}"
        yield from _inside(f"{path}/{child.symbol}", child)


def _accepts(automaton: Automaton, word: Sequence[str]) -> bool:
    state = automaton.start()
    for symbol in word:
        state = automaton.step(state, symbol)
        if state is None:
            return False
    return automaton.accepts(state)
