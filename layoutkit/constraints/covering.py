"""The automaton of a region's sequences: it accepts the words that a chain of them covers.

A thread follows one chain while a word is read: the piece that covers the current position, and, where it
has begun already, the piece that goes on after it. Two at most are needed: a third that overlaps the first
could follow it directly. The automaton's states are sets of threads, made as they are reached.
"""

from __future__ import annotations

from dataclasses import dataclass

#: The piece that covers the last position read and how much of it is read; then the same of its successor.
Thread = tuple[int, int, int, int]
State = frozenset[Thread]
_NONE = -1


@dataclass(frozen=True, slots=True)
class Piece:
    """A sequence as sets of symbols, and whether it is tied to the region's start or end.

    Attributes
    ----------
    weight
        How likely, against the others, a word goes on with it.
    """

    sets: tuple[frozenset[str], ...]
    at_start: bool = False
    at_end: bool = False
    weight: float = 1.0


class Covering:
    """Accepts the words that a chain of pieces covers, each overlapping the one before in a subregion.

    Meets `layoutkit.constraints.word_rules.Automaton` and `Weighing`.
    """

    def __init__(self, pieces: tuple[Piece, ...]) -> None:
        self.pieces = pieces
        self._steps: dict[tuple[State, str], State | None] = {}

    def start(self) -> State:
        """Return the state in which every piece tied to the start is about to begin."""
        return frozenset((i, 0, _NONE, 0) for i, piece in enumerate(self.pieces) if piece.at_start)

    def step(self, state: State, symbol: str) -> State | None:
        """Return the state after `symbol`, or None if no chain goes on so."""
        key = (state, symbol)
        if key not in self._steps:
            self._steps[key] = frozenset(t for thread in state for t in self._follow(thread, symbol)) or None
        return self._steps[key]

    def accepts(self, state: State) -> bool:
        """Tell whether some chain ends here: its piece is read whole, and tied to the end."""
        return any(
            self.pieces[piece].at_end and read == len(self.pieces[piece].sets) for piece, read, _, _ in state
        )

    @property
    def weighs(self) -> bool:
        """Whether the pieces differ in weight."""
        return len({piece.weight for piece in self.pieces}) > 1

    def weight(self, state: State, symbol: str) -> float:
        """Return the greatest weight among the pieces that a word is in and that go on with the symbol."""
        going = (thread for thread in state if self._follow(thread, symbol))
        begun = (number for piece, _, following, _ in going for number in (piece, following))
        return max((self.pieces[number].weight for number in begun if number != _NONE), default=0.0)

    def _follow(self, thread: Thread, symbol: str) -> list[Thread]:
        piece, read, following, begun = thread
        if not self._reads(piece, read, symbol):
            return []
        read += 1
        if following != _NONE:
            return (
                self._settle(piece, read, following, begun + 1)
                if self._reads(following, begun, symbol)
                else []
            )
        found = [(piece, read, _NONE, 0)] if self._may_wait(piece, read) else []
        if self.pieces[piece].at_end:
            return found  # nothing follows a piece that ends the word
        for other, successor in enumerate(self.pieces):
            if not successor.at_start and symbol in successor.sets[0]:
                found += self._settle(piece, read, other, 1)
        return found

    def _reads(self, piece: int, read: int, symbol: str) -> bool:
        sets = self.pieces[piece].sets
        return read < len(sets) and symbol in sets[read]

    def _may_wait(self, piece: int, read: int) -> bool:
        """Tell whether a piece may stand without a successor: half read, or at the end of the word."""
        return read < len(self.pieces[piece].sets) or self.pieces[piece].at_end

    def _settle(self, piece: int, read: int, following: int, begun: int) -> list[Thread]:
        """Hand over to the successor where the piece is read whole; drop a successor that ends before it."""
        if read == len(self.pieces[piece].sets):
            if self._may_wait(following, begun):
                return [(following, begun, _NONE, 0)]
            # The successor is read whole at the same position: it adds nothing, the chain may not go on.
            return []
        return [(piece, read, following, begun)] if begun < len(self.pieces[following].sets) else []
