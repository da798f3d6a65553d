"""A file that one process at a time may have, as the system sees to it."""

from __future__ import annotations

import sys
from typing import BinaryIO

if sys.platform == "win32":
    import msvcrt

    #: Far behind all that is written: the locked byte could not be read.
    _BEHIND = 1 << 40

    def locked(stream: BinaryIO) -> bool:
        """Lock an open file until it is closed, or its process ends; tell whether that was free."""
        stream.seek(_BEHIND)
        try:
            msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:
    import fcntl

    def locked(stream: BinaryIO) -> bool:
        """Lock an open file until it is closed, or its process ends; tell whether that was free."""
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True
