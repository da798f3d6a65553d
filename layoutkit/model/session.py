"""Sessions: the edits of a facade, one after the other."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

from layoutkit.diagnostics import Place

Action = Literal["add", "remove", "move"]
Axis = Literal["columns", "rows"]
Gap = Literal["before", "after"]
Side = Literal["left", "right", "top", "bottom"]


@dataclass(frozen=True, slots=True)
class Edit:
    """A proposal that was taken: told by what it does, so that it is found again among any others.

    Columns and rows are counted from 1: from the left, and from the top down.

    Attributes
    ----------
    axis
        Whether columns or rows are edited; an element is moved across columns, or across rows.
    grids
        Names of the grids that are edited together.
    source
        Which column or row is copied, removed or moved, counted before the edit: one number for each family
        of grids that are alike, in the order of their names. Empty where an element is moved.
    at
        Where what is added stands afterwards, as many numbers as `source`.
    to
        Where what is moved stands afterwards, as many numbers as `source`; of an element, one.
    gap
        Which of the gaps beside what is removed goes with it.
    element
        The unique path of the one element that is moved, or None.
    width, height
        What the facade is to measure afterwards, in its units; None: what follows from what is inside.
    place
        Where in its document it stands.
    """

    action: Action
    axis: Axis
    grids: tuple[str, ...]
    source: tuple[int, ...] = ()
    at: tuple[int, ...] = ()
    to: tuple[int, ...] = ()
    gap: Gap = "after"
    element: str | None = None
    width: float | None = None
    height: float | None = None
    place: Place | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class Resize:
    """The facade given another width or height, or both, in its units."""

    width: float | None = None
    height: float | None = None
    place: Place | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class Drag:
    """A side of a region dragged to another place.

    Attributes
    ----------
    region
        A unique path in the facade as it is when the side is dragged.
    to
        The x of a left or right side, the y of a top or bottom one: in the facade's units, y up.
    """

    region: str
    side: Side
    to: float
    place: Place | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class RegionSize:
    """A region given another width or height, or both, in the facade's units.

    Attributes
    ----------
    region
        A unique path in the facade as it is when the size is given.
    """

    region: str
    width: float | None = None
    height: float | None = None
    place: Place | None = field(default=None, compare=False, repr=False)


Step = Edit | Resize | Drag | RegionSize


@dataclass(frozen=True)
class Session:
    """The edits of a facade, those taken back among them.

    Attributes
    ----------
    facade_file
        The document of the facade that they begin with, relative to the session's.
    done
        The steps in force, in order.
    undone
        Those that were taken back, the one to be made again first in front.
    """

    name: str
    facade_file: str
    done: tuple[Step, ...] = ()
    undone: tuple[Step, ...] = ()

    @property
    def steps(self) -> tuple[Step, ...]:
        """Those in force, then those that were taken back, as documents list them."""
        return self.done + self.undone

    def taking(self, step: Step) -> Session:
        """Return the session with one step more; what was taken back before cannot be made again."""
        return replace(self, done=(*self.done, step), undone=())

    def undo(self) -> Session:
        """Return the session without its last step, which can be made again.

        Raises
        ------
        ValueError
            If no step is in force.
        """
        if not self.done:
            raise ValueError("there is nothing to undo")
        return replace(self, done=self.done[:-1], undone=(self.done[-1], *self.undone))

    def redo(self) -> Session:
        """Return the session with the step made again that was taken back last.

        Raises
        ------
        ValueError
            If none was taken back.
        """
        if not self.undone:
            raise ValueError("there is nothing to redo")
        return replace(self, done=(*self.done, self.undone[0]), undone=self.undone[1:])
