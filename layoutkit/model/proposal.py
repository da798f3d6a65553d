"""What an edit can come to, and what it cannot, as a stage of editing tells it."""

from __future__ import annotations

from dataclasses import dataclass

from layoutkit.model.session import Edit


@dataclass(frozen=True, slots=True)
class ProposedEdit:
    """An edit that can be made.

    Attributes
    ----------
    distortion
        How far the regions are off the sizes of what they are copies of: 0 if none is, 0.1 if they are off
        by a tenth as a whole.
    cluster
        The group of proposals alike in structure that it belongs to, counted from 0.
    new
        Unique paths of the elements that it made or moved, in the edited facade.
    """

    edit: Edit
    distortion: float
    cluster: int
    new: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class DroppedEdit:
    """An edit that comes to nothing.

    Attributes
    ----------
    reason
        Why, in the user's words.
    """

    edit: Edit
    reason: str
