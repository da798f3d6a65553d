"""Why a state cannot be sized, in the user's words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, islice

import numpy as np

from layoutkit_editing.sizing.axis import Axis
from layoutkit_editing.sizing.relations import (
    ALIGNED,
    EXTENT_ASKED,
    LIKE,
    SIZE_ASKED,
    START_ASKED,
    Relations,
)
from layoutkit_editing.tree import NEW

#: Of longer lists than this, the rest is counted.
_MOST_TOLD = 4
_SIZES = ("wide", "high")


@dataclass(frozen=True, slots=True)
class Unsizable:
    """That no sizes keep everything.

    Attributes
    ----------
    reason
        Which targets, sizes and alignments are at odds.
    axis
        Along which: 0 for x, 1 for y.
    """

    reason: str
    axis: int


@dataclass(frozen=True, slots=True)
class Proof:
    """What contradicts itself: relations, terminals that keep a least size, and rules, by their numbers."""

    relations: tuple[int, ...]
    squeezed: tuple[int, ...] = ()
    rules: tuple[int, ...] = ()


def at_odds(axis: Axis, relations: Relations, culprits: Sequence[int], gap: float) -> Unsizable:
    """Tell of relations that contradict each other."""
    told = [*_asked(axis, relations, culprits), *_structure(axis, relations, culprits)]
    return Unsizable(f"{_head(axis)}: {'; '.join(told)}; they are {_measure(axis, gap)} at odds", axis.number)


def no_room(axis: Axis, relations: Relations, proof: Proof) -> Unsizable:
    """Tell of least sizes and rules that contradict each other, given relations."""
    told = [*_asked(axis, relations, proof.relations)]
    origins = dict.fromkeys(str(axis.rules[number].origin or "a rule") for number in proof.rules)
    told += list(islice(origins, _MOST_TOLD))
    if len(origins) > _MOST_TOLD:
        told.append(f"and {len(origins) - _MOST_TOLD} more constraints")
    if proof.squeezed:
        names = _listed(name(axis, node) for node in proof.squeezed)
        least = float(axis.springs.least[list(proof.squeezed)].min())
        told.append(f"at least {_measure(axis, least)} is left of {names}")
    told += _structure(axis, relations, proof.relations)
    return Unsizable(f"{_head(axis)}: {'; '.join(told)}", axis.number)


def undecided(axis: Axis) -> Unsizable:
    """Tell that no solver could tell."""
    along = "xy"[axis.number]
    return Unsizable(f"along {along}, it could not be decided whether anything keeps everything", axis.number)


def name(axis: Axis, node: int) -> str:
    """Return what users call a node: the path of its source."""
    source = int(axis.flat.sources[node])
    if source == NEW:
        return "a new part"
    path = axis.state.original.places[source].path
    return path if axis.flat.ids[node] == source else f"a copy of {path}"


def _head(axis: Axis) -> str:
    return f"along {'xy'[axis.number]}, these cannot hold together"


def _asked(axis: Axis, relations: Relations, culprits: Sequence[int]) -> Iterator[str]:
    """Yield what the user asked for."""
    for number in sorted(n for n in culprits if relations.why[n] > LIKE):  # as they were stated
        whose = name(axis, int(relations.nodes[number, 0]))
        size = _measure(axis, float(relations.distances[number]))
        why = relations.why[number]
        if why == EXTENT_ASKED:
            yield f"the facade is {size} {_SIZES[axis.number]}"
        elif why == SIZE_ASKED:
            yield f"{whose} is {size} {_SIZES[axis.number]}"
        else:
            yield f"{whose} {'starts' if why == START_ASKED else 'ends'} at {size}"


def _structure(axis: Axis, relations: Relations, culprits: Sequence[int]) -> Iterator[str]:
    """Yield which elements stay in line, and which stay of one size."""
    groups = _chained([sorted(relations.nodes[n].tolist()) for n in culprits if relations.why[n] == ALIGNED])
    if groups:
        told = [_listed(name(axis, node) for node in sorted(group)) for group in sorted(groups)]
        yield f"{_listed(told, ', and ')} stay in line"
    alike = [n for n in culprits if relations.why[n] == LIKE]
    classes = [sorted(int(relations.nodes[n, 0]) for n in alike if relations.plus[n] == number)
               for number in dict.fromkeys(relations.plus[alike].tolist())]  # fmt: skip
    names = [[name(axis, node) for node in nodes] for nodes in sorted(classes)]
    told = [f"{_listed(own)} stay of one size" for own in names if len(set(own)) > 1]
    yield from told[:_MOST_TOLD]
    if len(told) > _MOST_TOLD:
        yield f"so do {len(told) - _MOST_TOLD} more sets of like elements"


def _chained(groups: Iterable[list[int]]) -> list[list[int]]:
    """Join groups that share a node."""
    joined: dict[int, list[int]] = {}
    for group in groups:
        whole = list(dict.fromkeys([*group, *chain(*(joined[node] for node in group if node in joined))]))
        joined.update(dict.fromkeys(whole, whole))
    return list({id(whole): whole for whole in joined.values()}.values())


def _listed(told: Iterable[str], sign: str = ", ") -> str:
    names = list(dict.fromkeys(told))
    if len(names) > _MOST_TOLD + 1:
        names = [*names[:_MOST_TOLD], f"{len(names) - _MOST_TOLD} more"]
    return names[0] if len(names) == 1 else f"{sign.join(names[:-1])} and {names[-1]}"


def _measure(axis: Axis, value: float) -> str:
    digits = np.format_float_positional(value, precision=4, trim="-")
    return f"{digits} {axis.state.original.facade.units}"
