"""What examples are told apart from: the same box a little farther on, to each side.

An example says where a shape stands, and so also that it does not stand most of its width farther on.
Learned with the target value 0, such boxes take weight from whatever an example shares with them: what holds
everywhere along a wall says nothing of where on it. (Not in the paper, whose regression sees examples alone.)
"""

from __future__ import annotations

import numpy as np

from layoutkit.scenes.features import Array
from layoutkit_placement.learning.samples import Boxes, overlaps

#: How far boxes are moved, in the example's width or height (found by cross-validation).
ASIDE = 0.75
#: From this intersection over the union with another shape on, a box is as right as that.
SAME = 0.5


def counterexamples(box: Array, others: Boxes) -> Boxes:
    """Return boxes where no shape should stand, as one stands nearby, shape (boxes, 5).

    Parameters
    ----------
    box
        The example, shape (5,).
    others
        Other shapes of its kind in the same scene.
    """
    found = aside(box)
    wrong: Boxes = found[overlaps(found, others).max(axis=1, initial=0.0) < SAME]
    return wrong


def aside(box: Array) -> Boxes:
    """Return a box a little farther on, to each side, shape (4, 5)."""
    x, y, width, height, angle = box
    along, up = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    steps = [sign * ASIDE * side for side in (width * along, height * up) for sign in (1, -1)]
    return np.array([(x + dx, y + dy, width, height, angle) for dx, dy in steps])
