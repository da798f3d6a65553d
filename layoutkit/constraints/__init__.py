"""What a constraint is, and the built-in kinds, one file a kind."""

from layoutkit.constraints.alignment import Alignment
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.frequency import Frequency
from layoutkit.constraints.same_arrangement import SameArrangement
from layoutkit.constraints.same_size import SameSize
from layoutkit.constraints.sequence import Sequence
from layoutkit.constraints.size import Size

#: Every built-in kind, in the order of the reference.
BUILT_IN: tuple[type[Constraint], ...] = (Size, Sequence, Frequency, Alignment, SameSize, SameArrangement)

__all__ = [
    "BUILT_IN",
    "Alignment",
    "Constraint",
    "Frequency",
    "SameArrangement",
    "SameSize",
    "Sequence",
    "Size",
]
