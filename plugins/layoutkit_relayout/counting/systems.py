"""What has to hold in one part, once it is known which regions there are: rows over frames."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.constraints.claims import Frame, counted, relations_of
from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.rules import Convex, Range, Rows, SizeRule
from layoutkit_relayout.counting.frames import Framed, Frames, Row
from layoutkit_relayout.counting.parts import Part
from layoutkit_relayout.counting.profiles import Profile
from layoutkit_relayout.counting.programs import NEAR, Sum
from layoutkit_relayout.counting.tables import Open, Tables, Word
from layoutkit_relayout.counting.ties import Tie
from layoutkit_relayout.counting.ways import Ways
from layoutkit_relayout.model import Interval, Model, meet

#: A frame's size lies between two ends, in so many ways.
Spread = Mapping[Interval, Ways]


@dataclass(frozen=True, eq=False)
class Link:
    """Something that relates some frames.

    Attributes
    ----------
    rows
        What holds, whatever the words are.
    groups
        Groups whose words it hangs on; no group is in two links.
    ties
        Ties that hang on these words, beside that the words fill their regions.
    spreads
        For single frames, the sizes that what is inside of them leaves open.
    """

    frames: frozenset[Frame]
    rows: tuple[Row, ...] = ()
    groups: tuple[Open, ...] = ()
    ties: tuple[Tie, ...] = ()
    spreads: tuple[tuple[Frame, Spread], ...] = ()

    @property
    def uneven(self) -> bool:
        """Whether places matter, not only sizes: then the sizes that are left open may have gaps."""
        return any(tie.ordered or tie.aligned for tie in self.ties)


@dataclass(frozen=True, eq=False)
class System:
    """All links of a part.

    Attributes
    ----------
    ranges
        For each frame, the sizes that it may have by itself.
    words
        Words, by path, that say which regions there are: for a part's own groups, any of the right letters.
    reached
        The regions that there are.
    possible
        Whether all holds that is given.
    """

    part: Part
    links: tuple[Link, ...]
    ranges: Mapping[Frame, Interval]
    words: Mapping[str, Word]
    reached: Collection[str]
    possible: bool


class Systems:
    """States the parts of one facade at one size."""

    def __init__(self, model: Model, parts: Sequence[Part], tables: Tables, frames: Frames) -> None:
        self.model, self.tables, self.frames = model, tables, frames
        # What frequencies ask of sizes is told with the counts.
        self.constraints = tuple(c for c in model.constraints if not counted(c, model.facade))
        self.tied = {id(tie.origin): tie for part in parts for tie in part.ties if tie.origin is not None}
        self._spoken = {part: [c for c in self.constraints if self._asks(c, part)] for part in parts}

    def system(self, part: Part, own: Sequence[Open], around: Sequence[Open]) -> System:
        """State a part where the words of its groups, and of those around, have known letters."""
        words = {
            path: word for each in (*own, *around) for path, word in each.example(each.profiles[0]).items()
        }
        arrangement = self.arrangement(words)
        rules = [r for r in self.rules(arrangement, self._spoken[part]) if isinstance(r, Range)]
        rows = [row for row in self.frames.rows(arrangement, rules) if self._holds_for_all(row)]
        ranges = self._ranges(arrangement, part)
        possible = True
        links = []
        for row in rows:
            if len(row.factors) > 1:
                if row.factors.keys() <= ranges.keys():
                    links.append(Link(frozenset(row.factors), (row,)))
            elif row.factors:
                ((frame, factor),) = row.factors.items()
                if frame in ranges:
                    ends = sorted((row.least / factor, row.most / factor))
                    ranges[frame] = max(ranges[frame][0], ends[0]), min(ranges[frame][1], ends[1])
            else:
                possible &= row.least <= self._slack and row.most >= -self._slack
        possible &= all(low <= high + self._slack for low, high in ranges.values())
        possible &= all(self._has_room(frame) for frame in part.frames if frame[0] in arrangement.frames)
        links += [Link(self._frames_of(each), groups=(each,)) for each in own]
        for tie in part.ties:
            bound = tuple(each for each in own if each.group in tie.groups)
            if (tie.groups and tie.spoken) or tie.aligned or tie.counts is not None:
                names = (self.frames.unknown(*frame) for frame in tie.frames)
                frames = frozenset(name for name in names if name in ranges)
                links.append(Link(frames, groups=bound, ties=(tie,)))
        return System(part, tuple(_by_group(links)), ranges, words, arrangement.frames.keys(), possible)

    def arrangement(self, words: Mapping[str, Word]) -> Framed:
        """Return the arrangement of some words, and of those that there is no choice of."""
        found: dict[str, Word] = {}
        for path in self.model.reached(found):  # what is added here is reached in turn
            group = self.model.group_of[path]
            word = words.get(path) if group.forced is None else group.word_of(path, group.forced)
            if word is not None:
                found[path] = word
        return Framed(self.model.facade, self.model.completed(found))

    def rules(self, arrangement: Framed, constraints: Iterable[Constraint]) -> list[SizeRule]:
        """Return what some constraints, and the words themselves, ask of an arrangement."""
        return [*(rule for c in constraints for rule in self._asked(c, arrangement)), *arrangement.tilings]

    def _asked(self, constraint: Constraint, arrangement: Framed) -> Iterator[SizeRule]:
        """Yield what a constraint asks of sizes, as long as that can be gone by."""
        for rule in size_rules_of(constraint, arrangement):
            if isinstance(rule, Rows | Convex) and relations_of(constraint, self.model.facade) is not None:
                what = "says what its rules relate, and has one that counts cannot go by: leave that unsaid"
                raise Misbehaviour(constraint, what)
            yield rule

    def filled(self, own: Open, profile: Profile) -> Iterator[Sum]:
        """Yield how the words of a profile fill each member."""
        for stretch in self.tables.stretches(own, profile):
            axis = self.model.axis(stretch.member)
            symbols = own.group.symbols[stretch.member]
            factors = {
                (f"{stretch.member}/{symbols[letter]}", axis): float(times)
                for letter, times in stretch.times.items()
            }
            frame, given = self.frames.unknown(stretch.member, axis), 0.0
            if frame is None:
                given = self.frames.given(stretch.member, axis)
            else:
                factors[frame] = -1.0
            yield Sum(factors, given - stretch.rest[1], given - stretch.rest[0])

    def hanging(self, link: Link, system: System, chosen: Sequence[tuple[Open, Profile]]) -> Iterator[Sum]:
        """Yield what constraints ask of sizes that hangs on how often letters occur in words."""
        words = {path: word for own, profile in chosen for path, word in own.example(profile).items()}
        arrangement = self.arrangement({**system.words, **words})
        constraints = [tie.origin for tie in link.ties if tie.origin is not None]
        rules = [r for c in constraints for r in self._asked(c, arrangement) if isinstance(r, Range)]
        for row in self.frames.rows(arrangement, rules):
            yield Sum(row.factors, row.least, row.most)

    @property
    def _slack(self) -> float:
        return NEAR * max(self.frames.size)

    def _asks(self, constraint: Constraint, part: Part) -> bool:
        """Tell whether a constraint asks something of a part that holds whatever the words are.

        It does not where it is a tie of another part, or one that hangs on words.
        """
        tie = self.tied.get(id(constraint))
        return tie is None or (tie in part.ties and not tie.groups)

    def _holds_for_all(self, row: Row) -> bool:
        """Tell whether a row holds for all words with the same letters: not if it fills one with a choice."""
        if row.tiled is None:
            return True
        closed = self.model.group_of[row.tiled].forced is not None
        return closed and not self.tables.plain(row.tiled, self.model.axis(row.tiled))

    def _has_room(self, frame: Frame) -> bool:
        """Tell whether a frame whose size is given can have that size, as far as its own range tells."""
        if self.frames.unknown(*frame) is not None:
            return True
        low, high = self.model.hull(*frame)
        return low - self._slack <= self.frames.given(*frame) <= high + self._slack

    def _ranges(self, arrangement: Framed, part: Part) -> dict[Frame, Interval]:
        """Return what each frame of a part may be by itself: the hulls of all regions that are as large."""
        own = {self.frames.unknown(*frame) for frame in part.frames}
        found: dict[Frame, Interval] = {}
        for path in arrangement.frames:
            for axis in (0, 1):
                frame = self.frames.unknown(path, axis)
                if frame is not None and frame in own:
                    hull = self.frames.hull((path, axis))
                    found[frame] = meet(found.get(frame, hull), hull)
        return found

    def _frames_of(self, own: Open) -> frozenset[Frame]:
        """Return the frames that a group's words relate: those of members, and of letters that are tied."""
        found = set()
        for member in own.members:
            axis = self.model.axis(member)
            found.add(self.frames.unknown(member, axis))
            for letter in self.tables.letters(own):
                found.add(self.frames.unknown(f"{member}/{own.group.symbols[member][letter]}", axis))
        return frozenset(frame for frame in found if frame is not None)


def _by_group(links: Iterable[Link]) -> list[Link]:
    """Make links that hang on the words of the same group one."""
    found: dict[Link, None] = {}
    of: dict[Open, Link] = {}
    for link in links:
        alike = dict.fromkeys(of[group] for group in link.groups if group in of)
        for other in alike:
            del found[other]
        joined = united((*alike, link)) if alike else link
        found[joined] = None
        of |= dict.fromkeys(joined.groups, joined)
    return list(found)


def united(links: Iterable[Link]) -> Link:
    """Return one link for several."""
    links = tuple(links)
    return Link(
        frozenset(frame for link in links for frame in link.frames),
        tuple(row for link in links for row in link.rows),
        tuple(dict.fromkeys(group for link in links for group in link.groups)),
        tuple(dict.fromkeys(tie for link in links for tie in link.ties)),
        tuple(spread for link in links for spread in link.spreads),
    )
