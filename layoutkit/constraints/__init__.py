"""What a constraint is, and the built-in kinds, one file a kind."""

from layoutkit.constraints.alignment import Alignment
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.frequency import Frequency
from layoutkit.constraints.generated import Repetition, Replication, Reuse, Reversal, TwoShuffle
from layoutkit.constraints.instances import Instances
from layoutkit.constraints.lock import Lock
from layoutkit.constraints.same_arrangement import SameArrangement
from layoutkit.constraints.same_size import SameSize
from layoutkit.constraints.sequence import Sequence
from layoutkit.constraints.size import Size
from layoutkit.constraints.symmetry import Symmetry

#: Every built-in kind, in the order of the reference.
BUILT_IN: tuple[type[Constraint], ...] = (
    Size,
    Sequence,
    Replication,
    Repetition,
    TwoShuffle,
    Reversal,
    Reuse,
    Frequency,
    Instances,
    Alignment,
    SameSize,
    Symmetry,
    SameArrangement,
    Lock,
)

__all__ = [
    "BUILT_IN",
    "Alignment",
    "Constraint",
    "Frequency",
    "Instances",
    "Lock",
    "Repetition",
    "Replication",
    "Reuse",
    "Reversal",
    "SameArrangement",
    "SameSize",
    "Sequence",
    "Size",
    "Symmetry",
    "TwoShuffle",
]
