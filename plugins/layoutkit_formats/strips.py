"""Strips of a floor: where its bays stand, and which floors stand in line."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any, NamedTuple

from layoutkit_formats.boxes import CORES, GROUNDS, LabelBox
from layoutkit_formats.floors import Row, Span

#: Elements wider than this many bays are cut at the strips' lines.
WIDE = 1.6

#: Sills and hoods that are wider than this many windows are cut there too.
OVERHANG = 2.4

#: Pillars lower than this share of a floor flank a window; higher ones divide the floor.
LOW = 0.85

#: Windows that an element spans are one bay where the gaps between them are below this share of their width.
CLOSE = 0.6

#: Floors stand in line if this share of their windows does, on either side.
IN_LINE = 0.6

#: A floor joins a group if it adds at most this share of strips to it.
ADDED = 0.2

#: Windows in line have their centres this near, as a share of the wider one's width.
CENTRED = 0.25


class Bay(NamedTuple):
    """Where an element stands in a row, with what belongs to it.

    Attributes
    ----------
    x0, x1
        The strip that it needs.
    core
        Where its window, door or shop stands; empty (both ends alike) where there is none.
    """

    x0: float
    x1: float
    core: Span

    @property
    def has_core(self) -> bool:
        """Whether a window, door or shop stands in it."""
        return self.core[1] > self.core[0]


@dataclass(frozen=True, slots=True)
class Group:
    """Floors that share their strips.

    Attributes
    ----------
    rows
        Indices of the rows, ascending.
    bays
        Where elements stand, from left to right, disjoint.
    """

    rows: tuple[int, ...]
    bays: tuple[Bay, ...]


def bays_of(boxes: Sequence[LabelBox], row: Row, frame: LabelBox, tolerance: float) -> tuple[Bay, ...]:
    """Return where the elements of a row stand, disjoint, from left to right."""
    slab = frame._replace(y0=row.y0, y1=row.y1)
    parts = [
        box.clipped(slab)
        for box in boxes
        if box.label not in GROUNDS
        and min(box.y1, row.y1) - max(box.y0, row.y0) > 0.25 * min(row.height, box.height)
    ]
    spans = [b.span(0) for b in parts if b.label in CORES and b.width < 0.6 * frame.width]
    cores = _joined([_bare(span) for span in spans], tolerance)
    others = [b for b in parts if b.label not in CORES]
    if not cores:
        narrow = [_accessory(b.span(0)) for b in others if b.width < 0.5 * frame.width]
        return tuple(_joined(narrow, tolerance))
    cores = _bound(cores, [b.span(0) for b in others if b.label != "Molding"])
    usual = median(core.x1 - core.x0 for core in cores)
    bays, pillars, free = list(cores), [], []
    for box in others:
        hit = [k for k, bay in enumerate(cores) if _overlap(bay.core, box.span(0)) > 0.3 * _length(bay.core)]
        if len(hit) == 1 and box.width <= max(OVERHANG * _length(cores[hit[0]].core), WIDE * usual):
            bays[hit[0]] = _widened(bays[hit[0]], box.span(0))
        elif not hit and box.width < WIDE * usual:
            flanks = box.label == "Blind" or (box.label == "Pillar" and box.height < LOW * row.height)
            beside = _beside(cores, box, usual) if flanks else None
            if beside is not None:
                bays[beside] = _widened(bays[beside], box.span(0))
            elif box.label == "Pillar":
                pillars.append(_accessory(box.span(0)))
            else:
                free.append(_accessory(box.span(0)))
    pillars = _clustered(pillars, 2.0 * tolerance)
    bays = [_beside_pillars(bay, pillars) for bay in _apart(bays)] + pillars
    free = [span for span in free if all(_overlap(span, bay) <= tolerance for bay in bays)]
    return tuple(_joined(bays + _clustered(free, 2.0 * tolerance), tolerance))


def _beside_pillars(bay: Bay, pillars: Sequence[Bay]) -> Bay:
    """Return a bay without what pillars beside its window cover."""
    x0 = max((p.x1 for p in pillars if bay.x0 < p.x1 <= bay.core[0]), default=bay.x0)
    x1 = min((p.x0 for p in pillars if bay.core[1] <= p.x0 < bay.x1), default=bay.x1)
    return bay._replace(x0=x0, x1=x1)


def _clustered(bays: Sequence[Bay], gap: float) -> list[Bay]:
    """Join bays that are less than a gap apart."""
    found: list[Bay] = []
    for bay in sorted(bays):
        if found and bay.x0 - found[-1].x1 < gap:
            found[-1] = _together(found[-1], bay)
        else:
            found.append(bay)
    return found


def _bare(span: Span) -> Bay:
    return Bay(*span, span)


def _accessory(span: Span) -> Bay:
    return Bay(*span, (span[0], span[0]))


def _length(span: Span) -> float:
    return span[1] - span[0]


def _overlap(one: Sequence[Any], other: Sequence[Any]) -> float:
    end = one[1] if one[1] < other[1] else other[1]
    return float(end - (one[0] if one[0] > other[0] else other[0]))


def _widened(bay: Bay, span: Span) -> Bay:
    return bay._replace(x0=min(bay.x0, span[0]), x1=max(bay.x1, span[1]))


def _together(one: Bay, other: Bay) -> Bay:
    """Return two bays as one."""
    core = one.core if one.has_core else other.core
    if one.has_core and other.has_core:
        core = min(one.core[0], other.core[0]), max(one.core[1], other.core[1])
    return Bay(min(one.x0, other.x0), max(one.x1, other.x1), core)


def _joined(bays: Sequence[Bay], tolerance: float) -> list[Bay]:
    """Join bays that overlap by more than the tolerance, and part those that overlap by less."""
    found: list[Bay] = []
    for bay in sorted(bays):
        if found and _overlap(found[-1], bay) > tolerance:
            found[-1] = _together(found[-1], bay)
        else:
            found.append(bay)
    for k in range(len(found) - 1):
        _part(found, k, 0.5 * (found[k].x1 + found[k + 1].x0))
    return found


def _part(bays: list[Bay], k: int, line: float) -> None:
    """Part a bay from the next at `line` if they overlap."""
    if bays[k].x1 > bays[k + 1].x0:
        bays[k], bays[k + 1] = bays[k]._replace(x1=line), bays[k + 1]._replace(x0=line)


def _bound(cores: Sequence[Bay], binders: Sequence[Span]) -> list[Bay]:
    """Join close windows that one element (a sill, a hood, a balcony) spans."""
    usual = median(_length(bay.core) for bay in cores)
    tied = set()
    for binder in binders:
        hit = [k for k, bay in enumerate(cores) if _overlap(bay.core, binder) > 0.6 * _length(bay.core)]
        if all(cores[b].x0 - cores[a].x1 < CLOSE * usual for a, b in itertools.pairwise(hit)):
            tied.update(hit[:-1])
    found: list[Bay] = []
    for k, core in enumerate(cores):
        if k - 1 in tied:
            found[-1] = _together(found[-1], core)
        else:
            found.append(core)
    return found


def _beside(cores: Sequence[Bay], box: LabelBox, usual: float) -> int | None:
    """Return the window that a shutter hangs beside, or that a pillar flanks."""
    gap, k = min((-_overlap(bay.core, box.span(0)), k) for k, bay in enumerate(cores))
    return k if gap < (0.25 if box.label == "Blind" else 0.12) * usual else None


def _apart(bays: Sequence[Bay]) -> list[Bay]:
    """Part neighbouring bays where sills or hoods of the two overlap."""
    found = list(bays)
    for k in range(len(found) - 1):
        middle = 0.5 * (found[k].x1 + found[k + 1].x0)
        _part(found, k, min(max(middle, found[k].core[1]), found[k + 1].core[0]))
    return found


def groups_of(bays: Sequence[tuple[Bay, ...]], tolerance: float) -> list[Group]:
    """Put rows together whose bays stand in line, beginning with those that most others are in line with.

    Parameters
    ----------
    bays
        For each row, its bays.
    tolerance
        By how much, in pixels, bays may overlap and still stand apart.
    """
    rows = range(len(bays))
    follows = [sum(_in_line(bays[i], bays[j], tolerance) is not None for j in rows) for i in rows]
    found: list[Group] = []
    for index in sorted(rows, key=lambda i: (-follows[i], -len(bays[i]), i)):
        for at, group in enumerate(found):
            union = _in_line(group.bays, bays[index], tolerance)
            if union is not None:
                found[at] = Group(tuple(sorted((*group.rows, index))), union)
                break
        else:
            found.append(Group((index,), bays[index]))
    return sorted(found, key=lambda group: group.rows)


def _in_line(group: tuple[Bay, ...], row: tuple[Bay, ...], tolerance: float) -> tuple[Bay, ...] | None:
    """Return the union of the bays if those of the row stand in line with the group's, else None."""
    union = _joined([*group, *row], tolerance)
    matched = 0
    for bay in union:
        own = [b for b in row if _overlap(b, bay) > tolerance]
        others = [b for b in group if _overlap(b, bay) > tolerance]
        if own and others and not _stacked(own, others, tolerance):
            return None
        if not (own and others) and max(len(own), len(others)) > 1:
            return None
        matched += bool(own and others and own[0].has_core)
    cores = max(sum(bay.has_core for bay in bays) for bays in (row, group))
    if not matched or matched < IN_LINE * cores or len(union) - len(group) > ADDED * len(group):
        return None
    return tuple(union)


def _stacked(own: Sequence[Bay], others: Sequence[Bay], tolerance: float) -> bool:
    """Tell whether the bays of two rows that share a strip are one above the other.

    Several may stand over one that is at least as wide as all of them: a pair of windows over a wide one.
    """
    if len(own) == 1 == len(others):
        return _one_above_other(own[0], others[0])
    wide, narrow = (own, others) if len(own) == 1 else (others, own)
    if len(wide) > 1 or len({bay.has_core for bay in (*own, *others)}) > 1:
        return False
    start, end = min(bay.x0 for bay in narrow), max(bay.x1 for bay in narrow)
    apart = abs(start + end - wide[0].x0 - wide[0].x1) / 2
    inside = wide[0].x0 - tolerance <= start and end <= wide[0].x1 + tolerance
    return inside and apart <= CENTRED * (wide[0].x1 - wide[0].x0)


def _one_above_other(one: Bay, other: Bay) -> bool:
    """Tell whether two bays that share a strip have their windows, or their pillars, in line."""
    if one.has_core != other.has_core:
        return False
    spans = [bay.core if bay.has_core else (bay.x0, bay.x1) for bay in (one, other)]
    lengths = sorted(map(_length, spans))
    apart = abs(sum(spans[0]) - sum(spans[1])) / 2
    return apart <= CENTRED * lengths[1] and lengths[0] >= 0.4 * lengths[1]


@dataclass(frozen=True, slots=True)
class Strip:
    """A column that runs through all floors of a group.

    Attributes
    ----------
    bay
        Whether elements stand in it; else it is wall.
    """

    x0: float
    x1: float
    bay: bool

    @property
    def width(self) -> float:
        """The extent along x."""
        return self.x1 - self.x0


def strips_of(bays: Sequence[Bay], frame: LabelBox, thin: float) -> tuple[Strip, ...]:
    """Divide the frame's width into bays and the piers between them.

    Piers narrower than `thin` are given to the bays beside them.
    """
    lines, kinds = [frame.x0], []
    for start, end, _ in bays:
        if start - lines[-1] > thin:
            lines.append(start)
            kinds.append(False)
        elif kinds:
            lines[-1] = 0.5 * (lines[-1] + start)
        if end - lines[-1] > thin:
            lines.append(end)
            kinds.append(True)
    if frame.x1 - lines[-1] > thin or not kinds:
        lines.append(frame.x1)
        kinds.append(False)
    lines[-1] = frame.x1
    return tuple(Strip(a, b, kind) for a, b, kind in zip(lines, lines[1:], kinds, strict=False))
