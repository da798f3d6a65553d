"""What is known of the words of a model at a size, whatever is asked of their numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import numpy as np

from layoutkit.constraints.claims import EquallyLarge
from layoutkit.model import Extent
from layoutkit_relayout.bounding.flows import Flow, flow_of, tallies
from layoutkit_relayout.model import Interval, Model
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Ints, Machine

#: Sizes may miss their ends by this share of the facade's.
SLACK = 1e-8
#: Words with more different beginnings than this, by tallies, are stated as flows.
_MOST_TALLIES = 20_000
#: A size that no facade has.
_FAR = 1e12


class Vocabulary:
    """Flows and tallies of a model's groups at a size, and the runs that matter; each is made once."""

    def __init__(self, model: Model, size: tuple[float, float]) -> None:
        self.model, self.size = model, size
        self.same_sizes = [claim for claim in model.claims if isinstance(claim, EquallyLarge)]
        self._flows: dict[Machine, Flow] = {}
        self._tallies: dict[tuple[object, ...], Ints | None] = {}
        self._runs: dict[WordGroup, tuple[tuple[str, ...], ...]] = {}

    def flow(self, group: WordGroup, machine: Machine) -> Flow:
        """Return the flow of a group's words; where runs matter, states know enough of the letters before."""
        if machine not in self._flows:
            history = max((len(run) - 1 for run in self.runs(group)), default=0)
            self._flows[machine] = flow_of(machine, history)
        return self._flows[machine]

    def tallies(
        self,
        group: WordGroup,
        flow: Flow,
        names: Sequence[str | tuple[str, ...]],
        rooms: Mapping[str, Interval],
    ) -> Ints | None:
        """Return the tallies of a group's words that fill some members; None if they are too many.

        Parameters
        ----------
        rooms
            How large each of the members is, as shares of the facade's size.
        """
        key = (flow, *rooms.items())
        if key not in self._tallies:
            sizes = np.zeros((2, len(rooms), len(names)))
            for row, path in enumerate(rooms):
                axis = self.model.axis(path)
                for column, letter in enumerate(group.letters):
                    child = f"{path}/{group.symbols[path][letter]}"
                    sizes[:, row, column] = np.array(self.model.hull(child, axis)) / self.size[axis]
            sizes, room = np.clip(sizes, 0.0, _FAR), np.array(list(rooms.values())).T
            rows = tallies(flow, names, sizes[0], room[1] + SLACK, _MOST_TALLIES)
            if rows is not None:
                rows = rows[np.all(rows @ sizes[1].T >= room[0] - SLACK, axis=1)]
            self._tallies[key] = rows
        return self._tallies[key]

    def runs(self, group: WordGroup) -> tuple[tuple[str, ...], ...]:
        """Return the runs of letters, of two or more, whose sizes are spoken of."""
        if group not in self._runs:
            extents = [extent for claim in self.same_sizes for extent in claim.extents]
            found = [
                run for e in extents for p in e.paths if p in group.members for run in self.spelled(e, p)
            ]
            self._runs[group] = tuple(dict.fromkeys(run for run in found if len(run) > 1))
        return self._runs[group]

    def spelled(self, extent: Extent, path: str) -> Iterator[tuple[str, ...]]:
        """Yield the runs of letters that an extent speaks of in a region; at the ends of words, none."""
        word, group = extent.word, self.model.group_of[path]
        if word is None or word.at_start or word.at_end or group.partners[path]:
            return
        names = {
            child.symbol: frozenset([child.symbol, *(f"@{label}" for label in child.labels)])
            for child in self.model.facade.regions[path].children
        }
        symbols = group.symbols[path]
        yield from product(
            *(
                [letter for letter in group.letters if regions.contains(names[symbols[letter]])]
                for regions in word.sets
            )
        )
