"""Who has to meet whom: groups of regions coupled by alignments, and the lines of their letters."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import takewhile

from layoutkit.constraints.claims import InLine
from layoutkit_relayout.choir.voices import NEAR
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup


@dataclass(frozen=True, slots=True)
class Line:
    """Two things, each a share of its letter, that have to meet at some lines where they overlap."""

    first: tuple[float, float]
    second: tuple[float, float]
    lines: tuple[float, ...]

    def mirrored(self) -> Line:
        """Return what has to meet where both letters stand at the far end instead."""
        first, second = ((1 - end, 1 - start) for start, end in (self.first, self.second))
        return Line(first, second, tuple(1 - share for share in self.lines))

    def clash(self, start: float, width: float, other: float, breadth: float) -> bool:
        """Tell whether two letters at two places keep them from meeting."""
        a, b = start + self.first[0] * width, start + self.first[1] * width
        c, d = other + self.second[0] * breadth, other + self.second[1] * breadth
        if min(b, d) - max(a, c) <= NEAR:
            return False
        return any(abs(a + share * (b - a) - c - share * (d - c)) > NEAR for share in self.lines)


class Company:
    """The groups of one facade, and what ties them."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self._insides: dict[tuple[str, int], tuple[tuple[str, float, float], ...]] = {}
        self._lines: dict[tuple[WordGroup, str, WordGroup, str], tuple[Line, ...]] = {}

    def stage(self, group: WordGroup) -> str | None:
        """Return the region whose whole extent a group's words run along; None if its members differ."""
        axis = self.model.axis(group.members[0])
        found = {self._base(member, axis) for member in group.members}
        return found.pop() if len(found) == 1 else None

    def _base(self, path: str, axis: int) -> str:
        """Return the outermost region that has the same place along an axis as a composite region."""
        above, faces = path.rpartition("/")[0], self.model.facade.faces
        while above and self.model.axis(above) != axis and path not in faces:
            path, above = above, above.rpartition("/")[0]
        if path not in faces or axis == 0:
            return path
        # Faces that begin and end at the same heights are one place.
        ends = faces[path].y0, faces[path].y1
        return next(face for face, box in faces.items() if (box.y0, box.y1) == ends)

    def partners(self, group: WordGroup) -> frozenset[WordGroup]:
        """Return the groups, itself among them, whose words have to meet the group's, directly or not."""
        return self._companies.get(group, frozenset((group,)))

    @cached_property
    def _companies(self) -> dict[WordGroup, frozenset[WordGroup]]:
        found: dict[WordGroup, frozenset[WordGroup]] = {}
        for group, others in self._meeting.items():
            company = frozenset((group, *others))
            union = company.union(*(found.get(member, frozenset()) for member in company))
            for member in union:
                found[member] = union
        return found

    def meet(self, one: WordGroup, other: WordGroup) -> bool:
        """Tell whether something in one group's words has to be in line with something in the other's."""
        return other in self._meeting.get(one, ())

    @cached_property
    def _meeting(self) -> dict[WordGroup, set[WordGroup]]:
        found: defaultdict[WordGroup, set[WordGroup]] = defaultdict(set)
        for axis in (0, 1):
            for path, partners in self._partners[axis].items():
                for partner in partners:
                    one, other = self._apart(path, partner, axis)
                    if one and other and self._base(one, axis) == self._base(other, axis):
                        groups = self.model.group_of[one], self.model.group_of[other]
                        if groups[0] is not groups[1]:
                            found[groups[0]].add(groups[1])
        return dict(found)

    def _apart(self, path: str, partner: str, axis: int) -> tuple[str, str]:
        """Return the first regions, from the top down, that divide the axis for one and not the other."""
        chains = [self._dividing(own, axis) for own in (path, partner)]
        common = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(*chains, strict=False)))
        one, other = ([*chain_, ""][common] for chain_ in chains)
        return one, other

    def _dividing(self, path: str, axis: int) -> list[str]:
        """Return the regions around a path that divide an axis, from the top down."""
        steps = path.split("/")
        above = ("/".join(steps[:number]) for number in range(1, len(steps)))
        return [own for own in above if self.model.axis(own) == axis]

    @cached_property
    def _partners(self) -> tuple[dict[str, dict[str, list[tuple[float, ...]]]], ...]:
        """For each axis and path, the paths that it may have to be in line with, and by which lines."""
        found: tuple[dict[str, dict[str, list[tuple[float, ...]]]], ...] = {}, {}
        for claim in (claim for claim in self.model.claims if isinstance(claim, InLine)):
            for one, other in ((claim.first, claim.second), (claim.second, claim.first)):
                for path in one:
                    for partner in other:
                        known = found[claim.axis].setdefault(path, {})
                        known.setdefault(partner, []).append(claim.shares)
        return found

    def lines(self, one: WordGroup, letter: str, other: WordGroup, another: str) -> tuple[Line, ...]:
        """Return what has to meet between a letter of one group and one of another."""
        key = (one, letter, other, another)
        if key not in self._lines:
            self._lines[key] = tuple(dict.fromkeys(self._between(one, letter, other, another)))
        return self._lines[key]

    def _between(self, one: WordGroup, letter: str, other: WordGroup, another: str) -> Iterator[Line]:
        axis = self.model.axis(one.members[0])
        for member in one.members:
            for path, *share in self._inside(f"{member}/{one.symbols[member][letter]}", axis):
                partners = self._partners[axis].get(path, {})
                for neighbour in other.members:
                    region = f"{neighbour}/{other.symbols[neighbour][another]}"
                    for partner, *own in self._inside(region, axis):
                        for lines in partners.get(partner, ()):
                            yield Line((share[0], share[1]), (own[0], own[1]), lines)

    def _inside(self, path: str, axis: int) -> tuple[tuple[str, float, float], ...]:
        """Return what stands in a region along an axis, itself first: paths that are tied, with shares."""
        key = (path, axis)
        if key not in self._insides:
            found: dict[tuple[str, float, float], None] = {}
            pending = [(path, 0.0, 1.0)]
            while pending:
                own, start, end = pending.pop()
                if own in self._partners[axis]:
                    found[own, start, end] = None
                group = self.model.group_of.get(own)
                if group is None or group.forced is None:
                    continue
                word = group.word_of(own, group.forced)
                if self.model.axis(own) != axis:
                    pending += [(f"{own}/{symbol}", start, end) for symbol in dict.fromkeys(word)]
                    continue
                sizes = [self.model.centre(f"{own}/{symbol}") for symbol in word]
                for symbol, size in zip(word, sizes, strict=True):
                    after = start + (end - start) * size / sum(sizes)
                    pending.append((f"{own}/{symbol}", start, after))
                    start = after
            self._insides[key] = tuple(found)
        return self._insides[key]
