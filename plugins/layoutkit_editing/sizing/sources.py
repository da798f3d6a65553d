"""What sizing takes from the original: sizes, weights and the least sizes, by source."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

import numpy as np

from layoutkit_editing.original import Original
from layoutkit_editing.sizing.likeness import Likeness

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Changes of small terminals weigh at most this many times as much as those of the whole facade.
MOST_WEIGHT = 10.0
#: No terminal is made smaller than this share of the original facade: about two centimetres, or half a
#: pixel of a picture. Less could not be seen, and soon not be told from rounding.
LEAST_SHARE = 1e-3
#: What is that small in the original may still lose this share of its size.
LEAST_OF_ITSELF = 0.5


@dataclass(frozen=True, eq=False)
class Sources:
    """Numbers by source that serve the sizing of every state of an editing session.

    Attributes
    ----------
    spans, sizes
        As in the original (2 × n × 2, 2 × n).
    weights
        W² of each: 1 over its share of the facade's area, at most 10, squared (section 5).
    least
        The least sizes of copies, along both axes (2 × n).
    tolerance
        Up to which sizes and places are the same, in document units.
    likeness
        Which of them are alike.
    """

    spans: Floats
    sizes: Floats
    weights: Floats
    least: Floats
    tolerance: float
    likeness: Likeness

    @classmethod
    def of(cls, original: Original) -> Sources:
        """Work out the numbers of an original."""
        sizes = original.sizes
        shares = sizes[0] * sizes[1] / (sizes[0, 0] * sizes[1, 0])
        return cls(
            spans=original.spans,
            sizes=sizes,
            weights=np.minimum(MOST_WEIGHT, 1.0 / shares) ** 2,
            least=np.minimum(LEAST_SHARE * sizes[:, :1], LEAST_OF_ITSELF * sizes),
            tolerance=original.tolerance,
            likeness=Likeness.of(original),
        )


_KNOWN: WeakKeyDictionary[Original, Sources] = WeakKeyDictionary()


def sources_of(original: Original) -> Sources:
    """Return the numbers of an original, which are worked out once."""
    found = _KNOWN.get(original)
    if found is None:
        found = _KNOWN[original] = Sources.of(original)
    return found
