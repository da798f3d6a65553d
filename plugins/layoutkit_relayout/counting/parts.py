"""The parts that counting falls into: groups of regions whose words have to do with each other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from functools import cached_property

from layoutkit.constraints.claims import Frame
from layoutkit_relayout.counting.ties import Tie, above, ties_of
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup


@dataclass(frozen=True, eq=False)
class Part:
    """Ties that hang together, with the groups whose words they hang on.

    Whether a part can be sized hangs on the words of its own groups, and, for those around, on no more than
    which of their letters occur. A layout exists if every part can be sized: the frames of different parts
    are in no tie together, so that their sizes can be put side by side.

    Attributes
    ----------
    groups
        Its own, in the order of the model's; no group is in two parts.
    around
        Further groups that say which of the part's regions there are.
    """

    ties: tuple[Tie, ...]
    groups: tuple[WordGroup, ...]
    around: tuple[WordGroup, ...]

    @cached_property
    def ordered(self) -> frozenset[WordGroup]:
        """Groups in whose words the order of letters matters."""
        return frozenset(group for tie in self.ties for group in tie.ordered)

    @cached_property
    def whole(self) -> bool:
        """Whether only a whole layout tells."""
        return any(tie.whole for tie in self.ties)

    @cached_property
    def frames(self) -> frozenset[Frame]:
        """All frames of its ties."""
        return frozenset(frame for tie in self.ties for frame in tie.frames)


def fixed_frames(model: Model) -> frozenset[Frame]:
    """Return the frames whose sizes are given: the facade's, a face's, and what spans one of these."""
    facade = model.facade
    found: set[Frame] = set()
    pending = [(path, axis) for path in (facade.root.symbol, *facade.faces) for axis in (0, 1)]
    while pending:
        path, axis = pending.pop()
        found.add((path, axis))
        region = facade.regions[path]
        if region.split not in (None, "faces") and model.axis(path) != axis:
            symbols = model.group_of[path].symbols[path].values()
            pending += [(f"{path}/{symbol}", axis) for symbol in symbols]
    return frozenset(found)


def parts_of(model: Model) -> tuple[Part, ...]:
    """Return the parts of a facade; every group with a choice is in one."""
    fixed = fixed_frames(model)
    ties = ties_of(model)
    joined = Joined()
    for tie in ties:
        # A size that is given ties nothing together.
        joined.unite([*(frame for frame in tie.frames if frame not in fixed), *tie.groups, tie])
    together: defaultdict[Hashable, list[Tie]] = defaultdict(list)
    for tie in ties:
        if tie.spoken or not tie.frames <= fixed:  # that sizes which are given are equal is no demand
            together[joined.leader(tie)].append(tie)
    return tuple(_part(own, model) for own in together.values())


def _part(ties: Iterable[Tie], model: Model) -> Part:
    ties = tuple(ties)
    own = {group for tie in ties for group in tie.groups}
    paths = {path for tie in ties for path in tie.regions} | {m for group in own for m in group.members}
    around = {group for path in paths for group in above(model, path)} - own
    in_order = [group for group in model.groups if group in own or group in around]
    return Part(ties, tuple(g for g in in_order if g in own), tuple(g for g in in_order if g in around))


class Joined:
    """Things united with each other (union-find)."""

    def __init__(self) -> None:
        self._above: dict[Hashable, Hashable] = {}

    def leader(self, thing: Hashable) -> Hashable:
        """Return the one that stands for all that a thing is united with."""
        way = [thing]
        while (above := self._above.get(way[-1], way[-1])) != way[-1]:
            way.append(above)
        for passed in way:
            self._above[passed] = way[-1]
        return way[-1]

    def unite(self, things: Iterable[Hashable]) -> None:
        """Unite things with each other."""
        leaders = [self.leader(thing) for thing in things]
        for leader in leaders[1:]:
            self._above[leader] = leaders[0]
