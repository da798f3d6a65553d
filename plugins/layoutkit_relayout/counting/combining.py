"""Combinations of words, and of sizes left open, gone through one by one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from layoutkit.constraints.claims import Frame
from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.laying import Asked, Laying
from layoutkit_relayout.counting.profiles import Profile
from layoutkit_relayout.counting.programs import NEAR, Sum, Unknown, left_open
from layoutkit_relayout.counting.systems import Link, Spread, System, Systems, united
from layoutkit_relayout.counting.tables import Open
from layoutkit_relayout.counting.tally import Tally
from layoutkit_relayout.counting.ways import Either, Perhaps, Together, Ways
from layoutkit_relayout.model import Interval

#: What stands for a frame where none is asked for.
_ANY: Interval = (0.0, 0.0)
#: What a step costs that takes no program, and what a program does for each of its coefficients.
_STEP, _PROGRAM = 0.02, 0.001
#: One walk may take this share of what is left.
_SHARE = 0.25


@dataclass(frozen=True, eq=False)
class State:
    """The choices made so far.

    Attributes
    ----------
    sums
        What has to hold.
    ranges
        What is left open for each frame by itself.
    profiles
        The words chosen.
    picks
        For each spread chosen from, the number of the interval; several where all of them will do.
    """

    sums: tuple[Sum, ...]
    ranges: Mapping[Frame, Interval]
    profiles: tuple[tuple[Open, Profile], ...] = ()
    picks: tuple[tuple[int, ...], ...] = ()


class Found(NamedTuple):
    """A combination: what it leaves open for the frame that is asked for, its words, and its picks."""

    interval: Interval
    words: Ways
    picks: tuple[tuple[int, ...], ...]


class Combining:
    """Goes through the combinations of links that cannot be taken apart.

    Attributes
    ----------
    doubted
        Regions of whose words it is not known whether all that were counted exist.
    """

    def __init__(self, systems: Systems, laying: Laying, effort: Effort) -> None:
        self.systems, self.laying, self.effort = systems, laying, effort
        self.tally = Tally(systems.model, systems.frames)
        self.scale = max(systems.frames.size)
        self.slack = NEAR * self.scale
        self.doubted: dict[str, None] = {}
        self._known: dict[object, list[Found]] = {}

    def doubt(self, groups: Iterable[Open]) -> None:
        """Note groups of whose words it is not known which fit together."""
        self.doubted |= dict.fromkeys(own.group.members[0] for own in groups)

    def spread(self, links: Sequence[Link], frame: Frame | None, system: System) -> Spread:
        """Return the sizes that links leave open for a frame, with the ways to each.

        Parameters
        ----------
        frame
            None: there is one entry, for any sizes.
        """
        link = united(links)
        # The number of ways to each interval of a spread does not matter to what can be combined.
        key = (frame, *_signature(link, system))
        if key not in self._known:
            walk = _Walk(self, link, frame, system)
            try:
                self._known[key] = list(walk.found())
            except Unknown:
                self._known[key] = [walk.unknown(walk.start)]
            if not all(own.words.exact for own in self._known[key]):
                self.doubt(link.groups)
        found: defaultdict[Interval, list[Ways]] = defaultdict(list)
        inside = [_Picked(list(spread.values())) for _, spread in link.spreads]
        self.effort.spend(_STEP * len(self._known[key]))
        for own in self._known[key]:
            picked = [ways[pick] for ways, pick in zip(inside, own.picks, strict=True)]
            found[own.interval].append(Together([own.words, *picked]))
        spread = {interval: Either(ways) for interval, ways in found.items()}
        return {interval: ways for interval, ways in spread.items() if ways.most}

    def met(self, spreads: Sequence[Spread]) -> Spread:
        """Return the sizes that several spreads leave open together."""
        found, *others = spreads
        for other in others:
            pairs = _STEP * len(found) * len(other)
            if pairs > self.effort.left:
                found = self._hull(found, other)
                continue
            self.effort.spend(pairs)
            both: defaultdict[Interval, list[Ways]] = defaultdict(list)
            for one, ways in found.items():
                for another, more in other.items():
                    meeting = max(one[0], another[0]), min(one[1], another[1])
                    if meeting[0] <= meeting[1] + self.slack:
                        both[meeting].append(Together([ways, more]))
            found = {interval: Either(ways) for interval, ways in both.items()}
        return found

    def _hull(self, *spreads: Spread) -> Spread:
        """Return one interval that holds all of several spreads, with every way to choose from them."""
        ends = [end for spread in spreads for interval in spread for end in interval]
        everything = Together([Either(list(spread.values())) for spread in spreads])
        return {(min(ends), max(ends)): Perhaps(everything)} if ends else {}


class _Picked(dict[tuple[int, ...], Ways]):
    """The ways to several intervals of a spread, by their numbers, each added up once."""

    def __init__(self, ways: Sequence[Ways]) -> None:
        super().__init__()
        self._ways = ways

    def __missing__(self, pick: tuple[int, ...]) -> Ways:
        self[pick] = found = Either([self._ways[number] for number in pick])
        return found


class _Walk:
    """One walk through all combinations of a link, depth first; what cannot hold is not gone into."""

    def __init__(self, combining: Combining, link: Link, frame: Frame | None, system: System) -> None:
        self.combining, self.frame, self.system = combining, frame, system
        self.systems = combining.systems
        self.effort = combining.laying.effort if link.uneven else combining.effort
        # Few alternatives first, but sizes last: they relate nothing by themselves.
        self.link = replace(link, groups=tuple(sorted(link.groups, key=lambda own: len(own.profiles))))
        self.order = sorted(range(len(link.spreads)), key=lambda n: len(link.spreads[n][1]))
        self.end = self.effort.spent + self.effort.left * _SHARE
        self.counts = [
            tie.counts for tie in link.ties if tie.counts is not None and self._is_there(tie.counts.path)
        ]
        # Where only one choice of sizes is left, what is open for it tells all at once.
        self.at_once = frame is None and not link.uneven and not self._hanging_ties()

    def _is_there(self, path: str) -> bool:
        return path in self.system.reached

    def _hanging_ties(self) -> bool:
        return any(tie.groups and tie.counts is None for tie in self.link.ties)

    @cached_property
    def start(self) -> State:
        """The state in which nothing is chosen."""
        ranges = {own: self.system.ranges[own] for own in sorted(self.link.frames)}
        for own, spread in self.link.spreads:
            low, high = min(low for low, _ in spread), max(high for _, high in spread)
            ranges[own] = max(ranges[own][0], low), min(ranges[own][1], high)
        return State(tuple(Sum(row.factors, row.least, row.most) for row in self.link.rows), ranges)

    def found(self) -> Iterator[Found]:
        """Yield all combinations.

        Raises
        ------
        Unknown
            If a program cannot be solved.
        """
        if all(own.profiles for own in self.link.groups) and all(spread for _, spread in self.link.spreads):
            yield from self._words(0, self.start)

    def _words(self, number: int, state: State) -> Iterator[Found]:
        """Choose the words of the groups from a number on."""
        if self.effort.spent >= self.end:
            yield self.unknown(state)
        elif number == len(self.link.groups):
            counted = self._counted(state)
            if counted is not None:
                yield from self._laid_out(counted) if self.link.uneven else self._sizes(0, counted)
        else:
            own = self.link.groups[number]
            for profile in own.profiles:
                sums = (*state.sums, *self.systems.filled(own, profile))
                after = replace(state, sums=sums, profiles=(*state.profiles, (own, profile)))
                if number == len(self.link.groups) - 1 or self._open(None, after) is not None:
                    yield from self._words(number + 1, after)

    def _counted(self, state: State) -> State | None:
        """Add what frequencies ask of sizes; None if they cannot be kept."""
        times = {own.group: self.systems.tables.times(own, profile) for own, profile in state.profiles}
        self.effort.spend(_STEP * len(self.counts))
        for rule in self.counts:
            asked = self.combining.tally.asked(rule, times)
            if asked is None:
                return None
            state = replace(state, sums=(*state.sums, *asked))
        return state

    def _sizes(self, number: int, state: State) -> Iterator[Found]:
        """Choose from the spreads from a number on."""
        if self.effort.spent >= self.end:
            yield self.unknown(state)
        elif number == len(self.order):
            yield from self._whole(state)
        elif self.at_once and number == len(self.order) - 1:
            yield from self._last(state)
        else:
            for after in self._picked(number, state):
                if number == len(self.order) - 1 or self._open(None, after) is not None:
                    yield from self._sizes(number + 1, after)

    def _picked(self, number: int, state: State) -> Iterator[State]:
        """Yield the state after each choice from a spread."""
        frame, spread = self.link.spreads[self.order[number]]
        least, most = state.ranges[frame]
        for pick, (low, high) in enumerate(spread):
            ranges = {**state.ranges, frame: (max(least, low), min(most, high))}
            yield replace(state, ranges=ranges, picks=(*state.picks, (pick,)))

    def _last(self, state: State) -> Iterator[Found]:
        """Take all sizes at once that are left open for the last frame."""
        frame, spread = self.link.spreads[self.order[-1]]
        open_ = self._open(frame, state)
        if open_ is not None:
            low, high = open_[0] - self.combining.slack, open_[1] + self.combining.slack
            picks = tuple(n for n, own in enumerate(spread) if own[0] <= high and own[1] >= low)
            if picks:
                yield self._made(_ANY, _all(state.profiles), replace(state, picks=(*state.picks, picks)))

    def _whole(self, state: State) -> Iterator[Found]:
        """Decide on a whole combination."""
        if self._hanging_ties():
            hanging = self.systems.hanging(self.link, self.system, state.profiles)
            state = replace(state, sums=(*state.sums, *hanging))
        open_ = self._open(self.frame, state)
        if open_ is not None:
            yield self._made(open_, _all(state.profiles), state)

    def _laid_out(self, state: State) -> Iterator[Found]:
        """Decide, for all choices from the spreads, on words where places matter."""
        states = [state]
        for number in range(len(self.order)):
            if self.effort.spent + len(states) * len(self.link.spreads[self.order[number]][1]) > self.end:
                yield self.unknown(state)
                return
            states = [after for own in states for after in self._picked(number, own)]
            states = [own for own in states if self._open(None, own) is not None]
        if not self.order and self._open(None, state) is None:
            return
        asked = Asked(self.link, self.system, state.sums)
        found = self.combining.laying.ways(asked, state.profiles, [own.ranges for own in states])
        for own, ways in zip(states, found, strict=True):
            yield self._made(_ANY, ways, own)

    def _made(self, interval: Interval, words: Ways, state: State) -> Found:
        picks = dict(zip(self.order, state.picks, strict=False))
        everything = [tuple(range(len(spread))) for _, spread in self.link.spreads]
        return Found(interval, words, tuple(picks.get(n, own) for n, own in enumerate(everything)))

    def unknown(self, state: State) -> Found:
        """Return all that can still be chosen, of which it is not known whether it can be sized."""
        rest = self.link.groups[len(state.profiles) :]
        words = Perhaps(Together([_all(state.profiles), *(own.everything for own in rest)]))
        return self._made(self._anything(state), words, state)

    def _anything(self, state: State) -> Interval:
        return _ANY if self.frame is None else state.ranges[self.frame]

    def _open(self, frame: Frame | None, state: State) -> Interval | None:
        """Return what is left open for a frame."""
        rows, frames = len(state.sums), len(state.ranges)
        self.effort.spend(_STEP if rows < 2 else 1.0 + _PROGRAM * frames * (frames + rows))
        return left_open(frame, state.sums, state.ranges, self.combining.scale)


def _all(profiles: Sequence[tuple[Open, Profile]]) -> Ways:
    return Together([own.words(profile) for own, profile in profiles])


def _signature(link: Link, system: System) -> tuple[object, ...]:
    """Return all that the combinations of a link hang on."""
    rows = frozenset((frozenset(row.factors.items()), row.least, row.most) for row in link.rows)
    ranges = frozenset((frame, system.ranges[frame]) for frame in link.frames)
    spreads = tuple((frame, tuple(spread)) for frame, spread in link.spreads)
    regions = frozenset(path for tie in link.ties for path in tie.regions if path in system.reached)
    return rows, ranges, link.groups, link.ties, spreads, regions
