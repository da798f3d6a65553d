"""Combinations of words, and of sizes left open, gone through one by one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.frames import Row
from layoutkit_relayout.counting.laying import Laying
from layoutkit_relayout.counting.profiles import Profile, Words
from layoutkit_relayout.counting.programs import NEAR, Sum, Unknown, left_open
from layoutkit_relayout.counting.systems import Link, Spread, System, Systems, united
from layoutkit_relayout.counting.tables import Open, Word
from layoutkit_relayout.counting.ties import Frame
from layoutkit_relayout.counting.ways import Either, Perhaps, Together, Ways
from layoutkit_relayout.model import Interval

#: What stands for a frame where none is asked for.
_ANY: Interval = (0.0, 0.0)
#: What a step costs that takes no program.
_STEP = 0.02


class Step(NamedTuple):
    """A choice made: what then has to hold, the range that it leaves a frame, and in how many ways it is made.

    Attributes
    ----------
    profile
        The words chosen, where it is a group's.
    """

    sums: tuple[Sum, ...]
    frame: Frame | None
    range: Interval
    ways: Ways
    profile: tuple[Open, Profile] | None = None


@dataclass(frozen=True, eq=False)
class State:
    """The choices made so far."""

    sums: tuple[Sum, ...]
    ranges: Mapping[Frame, Interval]
    ways: tuple[Ways, ...] = ()
    profiles: tuple[tuple[Open, Profile], ...] = ()

    def after(self, step: Step) -> State:
        """Return the state after a step."""
        ranges = self.ranges
        if step.frame is not None:
            low, high = ranges[step.frame]
            ranges = {**ranges, step.frame: (max(low, step.range[0]), min(high, step.range[1]))}
        profiles = self.profiles if step.profile is None else (*self.profiles, step.profile)
        return State((*self.sums, *step.sums), ranges, (*self.ways, step.ways), profiles)


class Combining:
    """Goes through the combinations of links that cannot be taken apart."""

    def __init__(self, systems: Systems, laying: Laying, effort: Effort) -> None:
        self.systems, self.laying, self.effort = systems, laying, effort
        self.scale = max(systems.frames.size)
        self.slack = NEAR * self.scale
        self._known: dict[object, tuple[Link, Spread]] = {}
        self._met: dict[tuple[int, ...], Spread] = {}

    def spread(self, links: Sequence[Link], frame: Frame | None, system: System) -> Spread:
        """Return the sizes that links leave open for a frame, with the ways to each.

        Parameters
        ----------
        frame
            None: there is one entry, for any sizes.
        """
        link = united(links)
        key = (frame, *_signature(link, system))
        if key not in self._known:
            found: defaultdict[Interval, list[Ways]] = defaultdict(list)
            for interval, ways in _Walk(self, link, frame, system).found():
                if ways.most:
                    found[interval].append(ways)
            # The link is kept as well: its parts are told by their identity.
            self._known[key] = link, {interval: Either(ways) for interval, ways in found.items()}
        return self._known[key][1]

    def met(self, spreads: Sequence[Spread]) -> Spread:
        """Return the sizes that several spreads leave open together."""
        key = tuple(map(id, spreads))
        if key not in self._met:
            found, *others = spreads
            for other in others:
                both: defaultdict[Interval, list[Ways]] = defaultdict(list)
                for one, ways in found.items():
                    for another, more in other.items():
                        meeting = max(one[0], another[0]), min(one[1], another[1])
                        if meeting[0] <= meeting[1] + self.slack:
                            both[meeting].append(Together([ways, more]))
                found = {interval: Either(ways) for interval, ways in both.items()}
            self._met[key] = found
        return self._met[key]


class _Walk:
    """One walk through all combinations of a link, depth first; what cannot hold is not gone into."""

    def __init__(self, combining: Combining, link: Link, frame: Frame | None, system: System) -> None:
        self.combining, self.link, self.frame, self.system = combining, link, frame, system
        self.systems, self.effort = combining.systems, combining.effort
        self.choices = [list(self._profiles(own)) for own in link.groups]
        self.choices += [
            [Step((), own, interval, ways) for interval, ways in spread.items()] for own, spread in link.spreads
        ]
        # Few alternatives first, but sizes last: they relate nothing by themselves.
        groups = len(link.groups)
        self.choices[:groups] = sorted(self.choices[:groups], key=len)
        self.choices[groups:] = sorted(self.choices[groups:], key=len)
        self.end = self.effort.spent + self.effort.left / 2
        # Where only one choice of sizes is left, what is open for it tells all at once.
        hanging = any(tie.groups or tie.aligned for tie in link.ties)
        self.at_once = frame is None and bool(link.spreads) and not hanging

    def found(self) -> Iterator[tuple[Interval, Ways]]:
        """Yield what each combination leaves open for the frame; the same may come more than once."""
        if not all(self.choices):
            return
        ranges = {own: self.system.ranges[own] for own in self.link.frames}
        for own, spread in self.link.spreads:
            low, high = min(low for low, _ in spread), max(high for _, high in spread)
            ranges[own] = max(ranges[own][0], low), min(ranges[own][1], high)
        state = State(tuple(_sum(row) for row in self.link.rows), ranges)
        yield from self._from(0, state)

    def _from(self, number: int, state: State) -> Iterator[tuple[Interval, Ways]]:
        if self.effort.spent >= self.end:
            rest = [Either([step.ways for step in steps]) for steps in self.choices[number:]]
            yield self._anything(state), Perhaps(Together([*state.ways, *rest]))
        elif number == len(self.choices):
            yield from self._whole(state)
        elif self.at_once and number == len(self.choices) - 1:
            yield from self._last(self.choices[number], state)
        else:
            for step in self.choices[number]:
                after = state.after(step)
                if number == len(self.choices) - 1 or self._open(None, after) is not None:
                    yield from self._from(number + 1, after)

    def _anything(self, state: State) -> Interval:
        return _ANY if self.frame is None else state.ranges[self.frame]

    def _last(self, steps: Sequence[Step], state: State) -> Iterator[tuple[Interval, Ways]]:
        """Take all sizes at once that are left open for the last frame."""
        open_ = self._open(steps[0].frame, state)
        if open_ is not None:
            low, high = open_[0] - self.combining.slack, open_[1] + self.combining.slack
            ways = [step.ways for step in steps if step.range[0] <= high and step.range[1] >= low]
            yield _ANY, Together([*state.ways, Either(ways)])

    def _whole(self, state: State) -> Iterator[tuple[Interval, Ways]]:
        """Decide on a whole combination."""
        ways = Together(state.ways)
        words = None
        if self.link.ties:
            words = self._words(state)
            arrangement = self.systems.arrangement(words)
            if not self.combining.laying.counted(self.link.ties, arrangement):
                return
            if self.link.uneven:
                if self._open(None, state) is not None:
                    yield _ANY, self.combining.laying.ways(self.link, self.system, state)
                return
            state = State((*state.sums, *self._hanging(arrangement)), state.ranges)
        try:
            open_ = self._open(self.frame, state)
        except Unknown:
            yield self._anything(state), Perhaps(ways)
            return
        if open_ is not None:
            yield open_, ways

    def _hanging(self, arrangement) -> Iterator[Sum]:
        """Yield the rows of ties that hang on words."""
        origins = {id(tie.origin) for tie in self.link.ties if tie.origin is not None}
        rules = [rule for rule in self.systems.ranges(arrangement) if id(rule.origin) in origins]
        yield from map(_sum, self.systems.frames.rows(arrangement, rules))

    def _words(self, state: State) -> Mapping[str, Word]:
        own = {path: word for each, profile in state.profiles for path, word in each.example(profile).items()}
        return {**self.system.words, **own}

    def _open(self, frame: Frame | None, state: State) -> Interval | None:
        """Return what is left open for a frame."""
        self.effort.spent += _STEP if len(state.sums) < 2 else 1.0
        return left_open(frame, state.sums, state.ranges, self.combining.scale)

    def _profiles(self, own: Open) -> Iterator[Step]:
        """Yield the words of a group, by profile, with what each asks of the lengths of members."""
        for profile in own.profiles:
            sums = []
            for stretch in self.systems.tables.stretches(own, profile):
                axis = self.systems.model.axis(stretch.member)
                symbols = own.group.symbols[stretch.member]
                factors = {
                    (f"{stretch.member}/{symbols[letter]}", axis): float(times)
                    for letter, times in stretch.times.items()
                }
                frame, given = self.systems.frames.unknown(stretch.member, axis), 0.0
                if frame is None:
                    given = self.systems.frames.given(stretch.member, axis)
                else:
                    factors[frame] = -1.0
                sums.append(Sum(factors, given - stretch.rest[1], given - stretch.rest[0]))
            yield Step(tuple(sums), None, _ANY, Words(own.group, own.table, profile), (own, profile))


def _signature(link: Link, system: System) -> tuple[object, ...]:
    """Return all that the ways of a link hang on."""
    rows = frozenset((frozenset(row.factors.items()), row.least, row.most) for row in link.rows)
    ranges = frozenset((frame, system.ranges[frame]) for frame in link.frames)
    spreads = frozenset((frame, id(spread)) for frame, spread in link.spreads)
    words = frozenset(system.words.items()) if link.ties else None
    return rows, ranges, link.groups, link.ties, spreads, words


def _sum(row: Row) -> Sum:
    return Sum(row.factors, row.least, row.most)
