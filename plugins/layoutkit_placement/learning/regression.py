"""Kernel regression: how well a placement agrees with all examples at once.

Guerrero et al. 2015, section 3.4, equation 4.
"""

from __future__ import annotations

import numpy as np

from layoutkit.scenes.features import Array


def weights(similarities: Array, targets: Array, regularisation: float) -> Array:
    """Return the weight of each example: the paper's (K + λI)⁻¹ t.

    A kernel of best assignments need not be positive semidefinite, whatever the paper's supplement says:
    its second expansion puts the two sets that are compared into different forms, so that it proves no inner
    product (Vert 2008, "The optimal assignment kernel is not positive definite"). Negative eigenvalues,
    which are small where they occur, are taken for 0: the regression is of the nearest valid kernel.

    Parameters
    ----------
    similarities
        Of the examples to each other, shape (examples, examples).
    targets
        Shape (examples,).
    regularisation
        λ, as a share of the mean similarity of the examples to themselves.
    """
    values, vectors = np.linalg.eigh(similarities)
    own = float(np.trace(similarities)) / max(1, len(similarities))
    if own <= 0:  # nothing stands about any example: they cannot be told from anything
        return np.zeros(len(similarities))
    scale = np.maximum(values, 0) + regularisation * own
    found: Array = vectors @ ((vectors.T @ targets) / scale)
    return found
