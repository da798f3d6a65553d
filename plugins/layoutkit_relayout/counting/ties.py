"""What ties sizes and words to each other: read off regions and constraints, before any word is chosen.

A layout's sizes along an axis are one number for each symbol path, its *frame*. Whether there are such sizes
hangs on the words in two ways only, as long as no constraint asks for more:

- A composite region's children add up to it along its split: only how often each letter occurs matters.
- Across its split, its children are as large as it is: only which letters occur matters.

For each built-in kind of constraint it is said here which frames it relates, and whether the order of letters
matters to it. Of other kinds nothing is known: they are taken to relate everything.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from layoutkit.constraints import Alignment, Constraint, Frequency, SameSize, Size, Symmetry
from layoutkit.constraints.instances import Instances
from layoutkit.constraints.lock import Lock
from layoutkit.constraints.word_rules import Counts
from layoutkit.model import Extent, Word
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.variants import MARK

#: A region's symbol path and an axis: its size along that axis.
Frame = tuple[str, int]
#: Two regions along one axis whose words agree: divided at the same places, they are in line in any order.
Even = tuple[str, str]


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
    even: frozenset[Even] | None = frozenset()
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
    if relative and any(type(constraint) is not Frequency for constraint in rule.origin):
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
    kind = type(constraint)
    if kind in _KINDS:
        yield from _KINDS[kind](constraint, model)
    elif kind.size_rules is not Constraint.size_rules:
        yield _everything(model, constraint)


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


def _instances(constraint: Instances, model: Model) -> Iterator[Tie]:
    """Yield the parents whose sizes a relative range hangs on, with the instances that their words name."""
    if any(end is not None and end.relative for end in (constraint.min, constraint.max)):
        parents = {path.rpartition("/")[0] for path in constraint.paths(model.facade)}
        frames = frozenset((parent, model.axis(parent)) for parent in parents)
        yield Tie(frames, _open(model.group_of[parent] for parent in parents), origin=constraint)


def _none(constraint: Size | Frequency, model: Model) -> Iterator[Tie]:
    """Yield nothing: a region's own range ties it to no other; frequencies are told from their rules."""
    return iter(())


def _same_size(constraint: SameSize, model: Model) -> Iterator[Tie]:
    """Yield all extents together: which of them there are hangs on which regions occur, if on no more.

    Where there is a run, or a context, the order of letters says which they are.
    """
    frames: set[Frame] = set()
    ordered: set[WordGroup] = set()
    contexts = (
        (constraint.first, constraint.first_before, constraint.first_after),
        (constraint.second, constraint.second_before, constraint.second_after),
    )
    for extent, before, after in contexts:
        if extent is None:
            continue
        parents = _parents(extent, model)
        if extent.regions is not None:
            frames |= {(path, constraint.axis) for path in model.facade.select(extent.regions)}
        else:
            symbols = [(parent, model.group_of[parent].symbols[parent].values()) for parent in parents]
            frames |= {(f"{p}/{symbol}", constraint.axis) for p, own in symbols for symbol in own}
        if extent.regions is None or before is not None or after is not None:
            ordered |= {model.group_of[parent] for parent in parents}
    groups = _open(ordered)
    paths = frozenset((constraint.within,) if constraint.within else ())
    yield Tie(frozenset(frames), groups, groups, None if groups else frozenset(), constraint, paths=paths)


def _parents(extent: Extent, model: Model) -> list[str]:
    if extent.regions is None:
        return list(extent.paths)
    return [p for path in model.facade.select(extent.regions) if (p := path.rpartition("/")[0])]


def _symmetry(constraint: Symmetry, model: Model) -> Iterator[Tie]:
    """Yield the children of each region with pairs: in a word that mirrors itself, both occur, or none.

    Where one instance of a region may mirror another, the order says which ones do.
    """
    for path in constraint.of:
        group = model.group_of[path]
        symbols = group.symbols[path].values()
        instances = any(MARK in symbol for symbol in symbols)
        if constraint.pairs or instances:
            frames = frozenset((f"{path}/{symbol}", model.axis(path)) for symbol in symbols)
            ordered = _open((group,)) if instances else frozenset()
            yield Tie(frames, ordered, ordered, None if ordered else frozenset())


def _lock(constraint: Lock, model: Model) -> Iterator[Tie]:
    """Yield sizes, and shares of what is inside, one by one; but all in one where places are kept."""
    facade = model.facade
    sizes = facade.select(constraint.of) if "size" in constraint.keep else ()
    frames = [frozenset(((path, 0), (path, 1))) for path in sizes]
    for path, region in constraint.kept_inside(facade).items():
        children = {f"{path}/{symbol}" for symbol in region.word}
        frames.append(frozenset((own, model.axis(path)) for own in (path, *children)))
    placed = [path for copies in constraint.placed(facade).values() for path in copies]
    if not placed:
        yield from (Tie(own) for own in frames)
        return
    groups = _open({group for path in placed for group in above(model, path)})
    anchored = [_placing(stem(model, path, axis), axis, model) for path in placed for axis in (0, 1)]
    spans = {(path, axis) for path in placed for axis in (0, 1)}
    everything = frozenset().union(*frames, *anchored, spans)
    yield Tie(
        everything, groups, groups, None if groups else frozenset(), constraint, paths=frozenset(placed)
    )


def _alignment(constraint: Alignment, model: Model) -> Iterator[Tie]:
    """Yield all pairs together that may be out of line.

    A region's place along an axis is that of the last region of its stem. Two stems that are equal stand in
    the same place, or apart. Where they part at two children of one region, they stand apart. So only those
    remain that part in different regions, which then span the same extent, or which end where the other goes
    on; there the order of letters matters on the way from there.
    """
    axis = constraint.axis
    sides = [
        {stem(model, path, axis): path for path in model.facade.select(regions)}
        for regions in (constraint.first, constraint.second)
    ]
    sets = [model.facade.select(regions) for regions in (constraint.first, constraint.second)]
    frames: set[Frame] = set()
    ordered: set[WordGroup] = set()
    even: set[Even] | None = set()
    for one, first in sides[0].items():
        for other, second in sides[1].items():
            base = _base(model, first, axis) == _base(model, second, axis)
            common = _common(one, other) if base else 0
            ways = one[common:], other[common:]
            if base and (not any(ways) or (all(ways) and _parent(ways[0][0]) == _parent(ways[1][0]))):
                continue
            frames |= {(path, axis) for path in (first, second)} | _placing((*one, *other), axis, model)
            groups = _open({model.group_of[_parent(path)] for way in ways for path in way})
            ordered |= groups
            if groups and even is not None:
                heads = [_parent(way[0]) for way in ways if way]
                alike = base and len(heads) == 2 and {model.group_of[head] for head in heads} == groups
                alike = alike and len(groups) == 1
                even = even | {(heads[0], heads[1])} if alike else None
    contexts: tuple[Word | None, ...] = (constraint.first_before, constraint.first_after)
    contexts += (constraint.second_before, constraint.second_after)
    if any(context is not None for context in contexts) and frames:
        ordered |= _open({model.group_of[p] for own in sets for path in own if (p := _parent(path))})
        even = None if ordered else even
    if frames:
        paths = frozenset((*sets[0], *sets[1], *((constraint.within,) if constraint.within else ())))
        found = None if even is None else frozenset(even)
        groups = frozenset(ordered)
        yield Tie(frozenset(frames), groups, groups, found, constraint, paths=paths, aligned=True)


def stem(model: Model, path: str, axis: int) -> tuple[str, ...]:
    """Return a region and all that it stands in, as far as their parents divide the axis; outermost first."""
    steps = path.split("/")
    own = ["/".join(steps[:number]) for number in range(2, len(steps) + 1)]
    return tuple(path for path in own if model.axis(_parent(path)) == axis)


def _placing(stem: Iterable[str], axis: int, model: Model) -> set[Frame]:
    """Return all frames that say where the regions of a stem stand in their parents."""
    parents = {_parent(path) for path in stem}
    inside = {f"{p}/{symbol}" for p in parents for symbol in model.group_of[p].symbols[p].values()}
    return {(path, axis) for path in (*parents, *inside)}


def _base(model: Model, path: str, axis: int) -> object:
    """Return what a region's place is measured from: the facade; on a building, how high its face stands."""
    for face, box in model.facade.faces.items():
        if axis == 1 and (path == face or path.startswith(f"{face}/")):
            return box.y0, box.y1
    return None


def _common(one: tuple[str, ...], other: tuple[str, ...]) -> int:
    number = 0
    while number < min(len(one), len(other)) and one[number] == other[number]:
        number += 1
    return number


def _parent(path: str) -> str:
    return path.rpartition("/")[0]


_KINDS: Mapping[type[Constraint], Callable[[Any, Model], Iterator[Tie]]] = {
    Size: _none,
    Frequency: _none,
    SameSize: _same_size,
    Symmetry: _symmetry,
    Lock: _lock,
    Instances: _instances,
    Alignment: _alignment,
}
