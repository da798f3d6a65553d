"""One thread for linear algebra: small matrices are faster so, and sums have one order, so one result."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

#: Whether there is but one thread already: to look through all libraries again takes milliseconds.
_LIMITED = ContextVar("_LIMITED", default=False)


@contextmanager
def single_threaded() -> Iterator[None]:
    """Keep BLAS to one thread inside the block."""
    if _LIMITED.get():
        yield
        return
    import numpy as np  # noqa: F401 - its BLAS must be loaded to be limited
    import scipy.linalg  # noqa: F401 - brings one of its own
    from threadpoolctl import threadpool_limits

    token = _LIMITED.set(True)
    try:
        with threadpool_limits(limits=1):
            yield
    finally:
        _LIMITED.reset(token)
