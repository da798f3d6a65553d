"""One thread for linear algebra: small matrices are faster so, and sums have one order, so one result."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def single_threaded() -> Iterator[None]:
    """Keep BLAS to one thread inside the block."""
    import numpy as np  # noqa: F401 - its BLAS must be loaded to be limited
    import scipy.linalg  # noqa: F401 - brings one of its own
    from threadpoolctl import threadpool_limits

    with threadpool_limits(limits=1):
        yield
