"""What each kind of constraint means for places, by the words of its documentation: for brute force."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import singledispatch
from itertools import permutations

import numpy as np
from oracle_places import Inside, Place, Places
from oracle_plans import AXIS
from oracle_programs import Form, Pair, Row, TooMany

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
)
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.model import Extent, Measure, Region

LINES = {"left": 0.0, "center": 0.5, "right": 1.0, "top": 0.0, "middle": 0.5, "bottom": 1.0}
UPRIGHT = ("left", "center", "right")
#: More places of one region than this are not tried in every order.
MOST_PLACES = 4


@dataclass(frozen=True)
class Never:
    """The words alone break the constraint."""


@dataclass(frozen=True, eq=False)
class Either:
    """One of several lists of rows holds."""

    ways: tuple[tuple[Row, ...], ...]


@dataclass(frozen=True, eq=False)
class Apart:
    """One of several sizes, by axis, is not zero."""

    forms: tuple[tuple[Form, ...], tuple[Form, ...]]


Demand = Row | Pair | Never | Either | Apart


@singledispatch
def demands(constraint: Constraint, places: Places) -> Iterator[Demand]:
    """Yield what a constraint demands of places."""
    raise NotImplementedError(constraint.kind)


@demands.register
def _(constraint: SequenceConstraint, places: Places) -> Iterator[Demand]:
    """Yield nothing: plans are made of words that sequences admit."""
    yield from ()


@demands.register
def _(constraint: Size, places: Places) -> Iterator[Demand]:
    for inside in places.insides:
        if inside.path in places.facade.select(constraint.of):
            around = places.facade.regions[inside.path.rpartition("/")[0] or inside.path]
            axis = AXIS[around.split or ""]
            given = _extent(places.region(inside), axis)
            low = max(constraint.min.of(given) if constraint.min else 0.0, 1e-3 * given)
            yield Row(axis, places.form(inside), low, np.inf)
            if constraint.max is not None:
                yield Row(axis, -places.form(inside), -constraint.max.of(given), np.inf)


@demands.register
def _(constraint: Frequency, places: Places) -> Iterator[Demand]:
    region = places.facade.regions[constraint.within]
    axis = AXIS[region.split or ""]
    counted = places.facade.select(constraint.of, constraint.within)
    first = places.facade.places[constraint.within][0].path
    given = sum(
        placed.path.startswith(f"{first}/") for path in counted for placed in places.facade.places[path]
    )
    for inside in places.insides:
        if inside.path == constraint.within:
            count = sum(other.path in counted for other in inside.all())
            growth = places.form(inside) / _extent(region, axis)
            yield from _counted(count, constraint.min, constraint.max, given, axis, growth)


def _counted(
    count: int, low: Measure | None, high: Measure | None, given: int, axis: int, growth: Form
) -> Iterator[Demand]:
    """Yield what keeps a count between two ends, shares of which are of what is given, times the growth."""
    for end, sign in ((low, 1.0), (high, -1.0)):
        if end is not None and end.relative:
            yield Row(axis, -sign * end.value * given * growth, -sign * count, np.inf)
        elif end is not None and sign * (end.value - count) > 1e-9:
            yield Never()


@demands.register
def _(constraint: Instances, places: Places) -> Iterator[Demand]:
    for path in (path for path in places.facade.select(constraint.of) if "/" in path):
        parent = path.rpartition("/")[0]
        region = places.facade.regions[parent]
        axis = AXIS[region.split or ""]
        given = region.word.count(path.rpartition("/")[2])
        for inside in (other for other in places.insides if other.path == parent):
            own = list({child.number: child for child in inside.children if child.path == path}.values())
            growth = places.form(inside) / _extent(region, axis)
            high = constraint.max if len(own) > 1 else None  # one is always allowed
            if own:
                yield from _counted(len(own), constraint.min, high, given, axis, growth)
            if constraint.min is not None:
                yield from (_apart(a, b, places) for n, a in enumerate(own) for b in own[n + 1 :])


def _apart(one: Inside, other: Inside, places: Places) -> Demand:
    """Return what makes two regions different, in their insides or in a size."""
    pairs = list(zip(one.all(), other.all(), strict=False))
    if any(a.word != b.word for a, b in pairs):
        return Either(((),))
    forms = tuple(places.form(a) - places.form(b) for a, b in pairs)
    return Apart((forms, forms))


@demands.register
def _(constraint: Alignment, places: Places) -> Iterator[Demand]:
    axis = 0 if constraint.lines[0] in UPRIGHT else 1
    shares = tuple(LINES[line] for line in constraint.lines)
    first, second = (
        [
            place
            for place in places.of(regions)
            if places.stands(place.parent and place.parent.inside, (place.index, place.index + 1), *context)
        ]
        for regions, context in (
            (constraint.first, (constraint.first_before, constraint.first_after)),
            (constraint.second, (constraint.second_before, constraint.second_after)),
        )
    )
    for scope in _scopes(constraint.within, places):
        for one in (place for place in first if place.within(scope)):
            for other in (place for place in second if place.within(scope)):
                if one is not other:
                    yield Pair(axis, one.ends[axis], other.ends[axis], shares)


def _scopes(within: str | None, places: Places) -> list[Place] | list[None]:
    return [None] if within is None else places.at([within])


@demands.register
def _(constraint: SameSize, places: Places) -> Iterator[Demand]:
    axis = 0 if constraint.dimension == "width" else 1
    sides = [(constraint.first, (constraint.first_before, constraint.first_after))]
    if constraint.second is not None:
        sides.append((constraint.second, (constraint.second_before, constraint.second_after)))
    for scope in _scopes(constraint.within, places):
        sizes = [
            size
            for extent, (before, after) in sides
            for parent, run, size in _extents(extent, axis, places)
            if (scope is None or parent is scope or (parent is not None and parent.within(scope)))
            and places.stands(parent and parent.inside, run, before, after)
        ]
        yield from (Row(axis, size - sizes[0], 0.0, 0.0) for size in sizes[1:])


def _extents(
    extent: Extent, axis: int, places: Places
) -> Iterator[tuple[Place | None, tuple[int, int], Form]]:
    """Yield the parent, the run and the size of every occurrence of an extent."""
    if extent.regions is not None:
        for place in places.of(extent.regions):
            start, end = place.ends[axis]
            yield place.parent, (place.index, place.index + 1), end - start
        return
    assert extent.word is not None
    for place in places.at(extent.paths):
        for start, end in places.runs(place.inside, extent.word):
            run = place.inside.children[start:end]
            yield place, (start, end), np.sum([places.form(child) for child in run], axis=0)


@demands.register
def _(constraint: Symmetry, places: Places) -> Iterator[Demand]:
    partners = {a: b for pair in constraint.pairs for a, b in (pair, pair[::-1])}
    for inside in (other for other in places.insides if other.path in constraint.of):
        word = inside.word
        if any(partners.get(a, a) != b for a, b in zip(word, reversed(word), strict=True)):
            yield Never()
        axis = AXIS[places.region(inside).split or ""]
        forms = [places.form(child) for child in inside.children]
        yield from (Row(axis, a - b, 0.0, 0.0) for a, b in zip(forms, reversed(forms), strict=True))


@demands.register
def _(constraint: SameArrangement, places: Places) -> Iterator[Demand]:
    if len({inside.word for inside in places.insides if inside.path in constraint.of}) > 1:
        yield Never()


@demands.register
def _(constraint: Lock, places: Places) -> Iterator[Demand]:
    paths = places.facade.select(constraint.of)
    for inside in (other for other in places.insides if other.path in paths):
        region = places.region(inside)
        if "size" in constraint.keep:
            for axis in (0, 1):
                size = _extent(region, axis)
                yield Row(axis, places.form(inside), size, size)
        if "inside" in constraint.keep:
            yield from _kept_inside(inside, inside, region, places)
    for path in paths if "place" in constraint.keep else ():
        if "/" in path:
            yield _kept_place(path, constraint.anchor, places)


def _kept_inside(inside: Inside, whole: Inside, region: Region, places: Places) -> Iterator[Demand]:
    """Yield what keeps all words inside, and each size's share of the whole."""
    own = places.region(inside)
    if inside.word != own.word:
        yield Never()
    for axis in (0, 1):
        share = _extent(own, axis) / _extent(region, axis)
        yield Row(axis, places.form(inside) - share * places.form(whole), 0.0, 0.0)
    for child in inside.children:
        yield from _kept_inside(child, whole, region, places)


def _kept_place(path: str, anchor: tuple[str, ...], places: Places) -> Demand:
    """Return which of a region's places may stand where which of the input's did."""
    named = {0 if line in UPRIGHT else 1: LINES[line] for line in ("left", "bottom", *anchor)}
    root, own = places.all[0], places.at([path])
    box = places.facade.places[root.path][0].box
    points = []
    for placed in places.facade.places[path]:
        left, top = placed.box.x0 - box.x0, box.y1 - placed.box.y1
        spare = placed.box.width - box.width, placed.box.height - box.height
        points.append((left + named[0] * spare[0], top + named[1] * spare[1]))
    if len(own) != len(points):
        return Never()
    if len(own) > MOST_PLACES:
        raise TooMany
    return Either(
        tuple(
            tuple(
                Row(
                    axis,
                    place.line(axis, named[axis]) - root.line(axis, named[axis]),
                    point[axis],
                    point[axis],
                )
                for place, point in zip(own, order, strict=True)
                for axis in (0, 1)
            )
            for order in permutations(points)
        )
    )


def _extent(region: Region, axis: int) -> float:
    return (region.width, region.height)[axis]
