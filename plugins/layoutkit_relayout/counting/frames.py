"""Sizes by frame: one unknown for each symbol path and axis, whatever the words are."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from layoutkit.constraints.claims import Frame
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import SIZE, UNIT, Form, Range
from layoutkit_relayout.counting.parts import fixed_frames
from layoutkit_relayout.model import Interval, Model


class Framed(Arrangement):
    """An arrangement whose unknowns are the sizes of symbols alone: cut lines are sums of these.

    So the unknowns have the same meaning for all words.
    """

    def _divided(
        self, path: str, axis: int, word: Sequence[str], extent: Form
    ) -> tuple[tuple[Form, ...], dict[str, Form]]:
        return self._by_sizes(path, axis, word, extent, Counter(word))


@dataclass(frozen=True, eq=False)
class Row:
    """`least` ≤ Σ factor · size ≤ `most`, over frames whose sizes are not given.

    Attributes
    ----------
    tiled
        The region that the row makes its children fill, if it does.
    rule
        What it states.
    """

    factors: Mapping[Frame, float]
    least: float
    most: float
    tiled: str | None
    rule: Range


class Frames:
    """The frames of one facade at one size: those that have to be equal are one.

    Parameters
    ----------
    size
        Width and height, in document units.
    """

    def __init__(self, model: Model, size: tuple[float, float]) -> None:
        self.model, self.size = model, size
        self.fixed = fixed_frames(model)
        self._known: dict[Frame, Frame | None] = {}

    def unknown(self, path: str, axis: int) -> Frame | None:
        """Return the outermost frame that a region spans along an axis; None where its size is given."""
        frame = (path, axis)
        if frame not in self._known:
            parent = path.rpartition("/")[0]
            if frame in self.fixed:
                self._known[frame] = None
            elif self.model.axis(parent) == axis:
                self._known[frame] = frame
            else:
                self._known[frame] = self.unknown(parent, axis)
        return self._known[frame]

    def given(self, path: str, axis: int) -> float:
        """Return the size of a region whose size is given."""
        return self.model.frame(path, self.size)[axis]

    def hull(self, frame: Frame) -> Interval:
        """Return an interval that holds every size of a frame."""
        low, high = self.model.hull(*frame)
        return low, min(high, self.given(*frame))

    def rows(self, arrangement: Framed, rules: Sequence[Range]) -> Iterator[Row]:
        """Yield rules of an arrangement as rows over frames."""
        names = self._names(arrangement)
        tiled = {id(tiling): path for tiling in arrangement.tilings for path in tiling.words or ()}
        for rule in rules:
            factors: defaultdict[Frame, float] = defaultdict(float)
            constant = 0.0
            for variable, factor in rule.form.items():
                if variable in (SIZE, UNIT):
                    constant += factor * (self.size[rule.axis] if variable == SIZE else 1.0)
                else:
                    factors[names[rule.axis][variable]] += factor
            own = {frame: factor for frame, factor in factors.items() if abs(factor) > 1e-12}
            yield Row(own, rule.least - constant, rule.most - constant, tiled.get(id(rule)), rule)

    def _names(self, arrangement: Framed) -> tuple[dict[int, Frame], dict[int, Frame]]:
        """Return what each variable of an arrangement is the size of."""
        found: tuple[dict[int, Frame], dict[int, Frame]] = {}, {}
        for path in arrangement.frames:
            for axis in (0, 1):
                frame = self.unknown(path, axis)
                if frame == (path, axis):
                    (variable,) = arrangement.extent(path, axis)
                    found[axis][variable] = frame
        return found
