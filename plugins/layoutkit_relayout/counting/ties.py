"""What ties sizes and words to each other: read off regions and constraints, before any word is chosen.

A layout's sizes along an axis are one number for each symbol path, its *frame*. Whether there are such sizes
hangs on the words in two ways only, as long as no constraint asks for more:

- A composite region's children add up to it along its split: only how often each letter occurs matters.
- Across its split, its children are as large as it is: only which letters occur matters.

Each constraint says which frames its rules relate, and whether the order of letters matters to it. One that
does not is taken to relate everything.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.constraints.claims import Even, Frame, counted, relations_of
from layoutkit.constraints.word_rules import Counts
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup

#: Two regions along one axis whose words agree: divided at the same places, they are in line in any order.
Pair = tuple[str, str]


@dataclass(frozen=True, eq=False)
class Tie:
    """Something that relates sizes and words: it can hold or not.

    Attributes
    ----------
    frames
        The frames whose sizes it relates.
    groups
        The groups with a choice on whose words it hangs, at least on how often each letter occurs.
    ordered
        Those of them where the order of letters matters.
    even
        Regions which, divided alike, make the order matter no more; None where there is no such way.
    origin
        The constraint, where all that it demands is in this tie.
    counts
        The frequency rule, if it is one.
    paths
        Further regions that it speaks of: where a layout has none of them, it does not hold back anything.
    whole
        Whether nothing is known about it.
    spoken
        Whether it comes from a constraint, not from the regions alone.
    aligned
        Whether it leaves the choice to stand in line or apart.
    """

    frames: frozenset[Frame]
    groups: frozenset[WordGroup] = frozenset()
    ordered: frozenset[WordGroup] = frozenset()
    even: frozenset[Pair] | None = frozenset()
    origin: Constraint | None = None
    counts: Counts | None = None
    paths: frozenset[str] = frozenset()
    whole: bool = False
    spoken: bool = True
    aligned: bool = False

    @property
    def regions(self) -> frozenset[str]:
        """All regions that it speaks of."""
        return self.paths | {path for path, _ in self.frames}


def ties_of(model: Model) -> tuple[Tie, ...]:
    """Return all ties of a facade's regions and constraints."""
    spoken = [tie for constraint in model.constraints for tie in _spoken(constraint, model)]
    spoken += [_counted(rule, model) for rule in model.counts]
    if any(demand.least.relative or demand.least.value > 1 for demand in model.demands):
        # Whether instances differ is only seen in their sizes.
        spoken.append(_everything(model, None))
    # A child that nothing inside or outside asks anything of is as large across as it has to be.
    asked = {frame for tie in spoken for frame in tie.frames}
    regions = model.facade.regions
    for path in reversed(list(regions)):
        parent = path.rpartition("/")[0]
        if regions[path].split not in (None, "faces"):
            asked.add((path, model.axis(path)))
        for axis in (0, 1):
            if (path, axis) in asked and parent and model.axis(parent) != axis:
                asked.add((parent, axis))
    composites = [path for path, region in regions.items() if region.split not in (None, "faces")]
    return (*spoken, *(tie for path in composites for tie in _divided(path, asked, model)))


def _divided(path: str, asked: set[Frame], model: Model) -> Iterator[Tie]:
    """Yield what a region's children have to do with it, along its split and across."""
    group, axis = model.group_of[path], model.axis(path)
    children = [f"{path}/{symbol}" for symbol in group.symbols[path].values()]
    along = frozenset((own, axis) for own in (path, *children))
    yield Tie(along, frozenset((group,)) if group.forced is None else frozenset(), spoken=False)
    across = [(child, 1 - axis) for child in children if (child, 1 - axis) in asked]
    if across:
        yield Tie(frozenset(((path, 1 - axis), *across)), spoken=False)


def _counted(rule: Counts, model: Model) -> Tie:
    """Return a frequency, which hangs on every word that leads to a counted region."""
    relative = any(end.relative and end.value > 0 for end in (rule.least, rule.most))
    if relative and not all(counted(constraint, model.facade) for constraint in rule.origin):
        return _everything(model, None)
    frames = frozenset({(rule.path, model.axis(rule.path))} if relative else ())
    groups = _counting(rule.path, rule.counted, model)
    return Tie(frames, groups, counts=rule, paths=frozenset((rule.path,)))


def _counting(path: str, counted: frozenset[str], model: Model) -> frozenset[WordGroup]:
    """Return the groups with a choice whose words say how often regions occur within one."""
    inside = (own for own in model.open_paths if own == path or own.startswith(f"{path}/"))
    leading = (own for own in inside if any(other.startswith(f"{own}/") for other in counted))
    return _open(model.group_of[own] for own in leading)


def _spoken(constraint: Constraint, model: Model) -> Iterator[Tie]:
    """Yield the ties that a constraint's demands on sizes amount to."""
    relations = relations_of(constraint, model.facade)
    if relations is None:
        yield _everything(model, constraint)
        return
    for relation in relations:
        ordered = _groups(relation.ordered, model)
        yield Tie(
            relation.frames,
            ordered | _groups(relation.words, model),
            ordered,
            _even(relation.evens, model) if ordered else frozenset(),
            constraint if relation.whole else None,
            paths=relation.paths,
            aligned=relation.apart,
        )


def _groups(paths: Iterable[str], model: Model) -> frozenset[WordGroup]:
    return _open(model.group_of[path] for path in paths)


def _even(evens: Iterable[Even | None], model: Model) -> frozenset[Pair] | None:
    """Return the regions that have to be divided alike; None where the order matters however they are."""
    found: set[Pair] = set()
    for even in evens:
        groups = _groups(even.ordered, model) if even is not None else frozenset()
        if even is not None and not groups:
            continue
        if even is None or len(groups) > 1 or {model.group_of[head] for head in even.heads} != groups:
            return None
        found.add(even.heads)
    return frozenset(found)


def _everything(model: Model, origin: Constraint | None) -> Tie:
    frames = frozenset((path, axis) for path in model.facade.regions for axis in (0, 1))
    groups = _open(model.groups)
    return Tie(frames, groups, groups, None, origin, whole=True, aligned=True)


def _open(groups: Iterable[WordGroup]) -> frozenset[WordGroup]:
    return frozenset(group for group in groups if group.forced is None)


def above(model: Model, path: str) -> Iterator[WordGroup]:
    """Yield the groups with a choice of all that a region stands in."""
    while path := path.rpartition("/")[0]:
        if model.group_of[path].forced is None:
            yield model.group_of[path]
