"""One thread for linear algebra: small matrices are faster so, and sums have one order, so one result."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

#: What libraries of linear algebra look at when they are loaded.
_COUNTS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
#: Whether there is but one thread already: to look through all libraries again takes milliseconds.
_LIMITED = ContextVar("_LIMITED", default=False)


def begin_single_threaded() -> None:
    """Let every library that this process, or one that it starts, loads from now on have one thread."""
    os.environ.update(dict.fromkeys(_COUNTS, "1"))


@contextmanager
def single_threaded() -> Iterator[None]:
    """Keep BLAS to one thread inside the block."""
    if _LIMITED.get():
        yield
        return
    import numpy as np  # noqa: F401 - its BLAS must be loaded to be limited
    from threadpoolctl import threadpool_limits

    if any(os.environ.get(count) != "1" for count in _COUNTS):
        import scipy.linalg  # noqa: F401 - brings one of its own, which would else be loaded with many threads

    token = _LIMITED.set(True)
    try:
        with threadpool_limits(limits=1):
            yield
    finally:
        _LIMITED.reset(token)
