"""Pieces: which part of a photo shows where in a terminal of an edited facade."""

from __future__ import annotations

from dataclasses import dataclass

from layoutkit.model.box import Box

#: All of a terminal, as shares of it.
WHOLE = Box(0.0, 0.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True)
class Piece:
    """A part of a terminal's picture. The pieces of a terminal tile it.

    Attributes
    ----------
    share
        Where in the terminal it shows: from 0 to 1 of its width and height, y up.
    source
        Where in the facade that editing began with it is taken from, in document units, y up.
    """

    share: Box
    source: Box

    @classmethod
    def whole(cls, source: Box) -> Piece:
        """Return the only piece of a terminal that shows one part of the photo all over."""
        return cls(WHOLE, source)
