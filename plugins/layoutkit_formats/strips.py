"""Strips of a floor: where its bays stand, and which floors stand in line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from layoutkit_formats.boxes import CORES, GROUNDS, LabelBox, inside
from layoutkit_formats.floors import Row

Span = tuple[float, float]

#: Elements wider than this many bays are cut at the strips' lines.
WIDE = 1.6

#: Windows that an element spans are one bay where the gaps between them are below this share of their width.
CLOSE = 0.6

#: Floors stand in line if this share of their bays does.
IN_LINE = 0.5


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
    bays: tuple[Span, ...]


def bays_of(boxes: Sequence[LabelBox], row: Row, frame: LabelBox, tolerance: float) -> tuple[Span, ...]:
    """Return the spans along x at which the elements of a row stand, disjoint, from left to right."""
    slab = frame._replace(y0=row.y0, y1=row.y1)
    parts = [b for b in inside(boxes, slab, 0.0) if b.label not in GROUNDS and _counts(b, boxes, row)]
    cores = _joined([b.span(0) for b in parts if b.label in CORES and b.width < 0.6 * frame.width], tolerance)
    others = [b for b in parts if b.label not in CORES]
    if not cores:
        narrow = [b.span(0) for b in others if b.width < 0.5 * frame.width]
        return tuple(_joined(narrow, tolerance))
    cores = _bound(cores, [b.span(0) for b in others if b.label != "Cornice"])
    usual = median(end - start for start, end in cores)
    spans, free = list(cores), []
    for box in others:
        hit = [k for k, core in enumerate(cores) if _overlap(core, box.span(0)) > 0.3 * _length(core)]
        if len(hit) == 1 and box.width <= max(2.0 * _length(cores[hit[0]]), WIDE * usual):
            spans[hit[0]] = _hull(spans[hit[0]], box.span(0))
        elif not hit and box.width < WIDE * usual:
            beside = _beside(cores, box, usual) if box.label == "Blind" else None
            if beside is None:
                free.append(box.span(0))
            else:
                spans[beside] = _hull(spans[beside], box.span(0))
    return tuple(_joined(_apart(cores, spans) + free, tolerance))


def _counts(part: LabelBox, boxes: Sequence[LabelBox], row: Row) -> bool:
    """Tell whether an element belongs to the row, and does not just reach into it."""
    tallest = max(b.height for b in boxes if b.label == part.label and b.span(0) == part.span(0))
    return part.height >= 0.25 * min(row.height, tallest)


def _length(span: Span) -> float:
    return span[1] - span[0]


def _overlap(one: Span, other: Span) -> float:
    return min(one[1], other[1]) - max(one[0], other[0])


def _hull(one: Span, other: Span) -> Span:
    return min(one[0], other[0]), max(one[1], other[1])


def _joined(spans: Sequence[Span], tolerance: float) -> list[Span]:
    """Join spans that overlap by more than the tolerance, and part those that overlap by less."""
    found: list[Span] = []
    for span in sorted(spans):
        if found and _overlap(found[-1], span) > tolerance:
            found[-1] = _hull(found[-1], span)
        else:
            found.append(span)
    for k in range(len(found) - 1):
        if found[k][1] > found[k + 1][0]:
            middle = 0.5 * (found[k][1] + found[k + 1][0])
            found[k], found[k + 1] = (found[k][0], middle), (middle, found[k + 1][1])
    return found


def _bound(cores: Sequence[Span], binders: Sequence[Span]) -> list[Span]:
    """Join close windows that one element (a sill, a hood, a balcony) spans."""
    usual = median(map(_length, cores))
    tied = set()
    for binder in binders:
        hit = [k for k, core in enumerate(cores) if _overlap(core, binder) > 0.6 * _length(core)]
        if all(cores[b][0] - cores[a][1] < CLOSE * usual for a, b in zip(hit, hit[1:], strict=False)):
            tied.update(hit[:-1])
    found: list[Span] = []
    for k, core in enumerate(cores):
        if k - 1 in tied:
            found[-1] = _hull(found[-1], core)
        else:
            found.append(core)
    return found


def _beside(cores: Sequence[Span], box: LabelBox, usual: float) -> int | None:
    """Return the window that a shutter hangs beside."""
    gaps = [(-_overlap(core, box.span(0)), k) for k, core in enumerate(cores)]
    gap, k = min(gaps)
    return k if gap < 0.25 * usual else None


def _apart(cores: Sequence[Span], spans: Sequence[Span]) -> list[Span]:
    """Part the spans around neighbouring windows where sills or hoods of the two overlap."""
    found = list(spans)
    for k in range(len(found) - 1):
        if found[k][1] > found[k + 1][0]:
            middle = 0.5 * (found[k][1] + found[k + 1][0])
            middle = min(max(middle, cores[k][1]), cores[k + 1][0])
            found[k], found[k + 1] = (found[k][0], middle), (middle, found[k + 1][1])
    return found


def groups_of(bays: Sequence[tuple[Span, ...]], tolerance: float) -> list[Group]:
    """Put rows together whose bays stand in line, those with many bays first.

    Parameters
    ----------
    bays
        For each row, its bays.
    tolerance
        By how much, in pixels, spans may overlap and still stand apart.
    """
    found: list[Group] = []
    for index in sorted(range(len(bays)), key=lambda i: (-len(bays[i]), i)):
        for at, group in enumerate(found):
            union = _in_line(group.bays, bays[index], tolerance)
            if union is not None:
                found[at] = Group(tuple(sorted((*group.rows, index))), union)
                break
        else:
            found.append(Group((index,), bays[index]))
    return sorted(found, key=lambda group: group.rows)


def _in_line(group: tuple[Span, ...], row: tuple[Span, ...], tolerance: float) -> tuple[Span, ...] | None:
    """Return the union of the bays if those of the row stand in line with the group's, else None."""
    if not row or not group:
        return None
    union = _joined([*group, *row], tolerance)
    matched = 0
    for span in union:
        own = [s for s in row if _overlap(s, span) > tolerance]
        others = [s for s in group if _overlap(s, span) > tolerance]
        if len(own) > 1 or len(others) > 1:
            return None
        if own and others:
            if _overlap(own[0], others[0]) < 0.6 * min(_length(own[0]), _length(others[0])):
                return None
            matched += 1
    new = len(union) - len(group)
    if matched < IN_LINE * len(row) or new > max(1, 0.34 * len(group)):
        return None
    return tuple(union)


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


def strips_of(bays: Sequence[Span], frame: LabelBox, thin: float) -> tuple[Strip, ...]:
    """Divide the frame's width into bays and the piers between them.

    Piers narrower than `thin` are given to the bays beside them.
    """
    lines, kinds = [frame.x0], []
    for start, end in bays:
        if start - lines[-1] > thin:
            lines.append(start)
            kinds.append(False)
        elif len(lines) > 1:
            lines[-1] = 0.5 * (lines[-1] + start)
        lines.append(end)
        kinds.append(True)
    if frame.x1 - lines[-1] > thin:
        lines.append(frame.x1)
        kinds.append(False)
    elif len(lines) > 1:
        lines[-1] = frame.x1
    return tuple(Strip(a, b, kind) for a, b, kind in zip(lines, lines[1:], kinds, strict=False))
