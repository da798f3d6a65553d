"""The greatest memory of this process."""

from __future__ import annotations

import resource
from pathlib import Path

_STATUS, _CLEAR = Path("/proc/self/status"), Path("/proc/self/clear_refs")


class Peak:
    """The greatest memory from now on, where the system can tell; elsewhere since the process began."""

    def __init__(self) -> None:
        try:
            _CLEAR.write_text("5")
            self._own = True
        except OSError:
            self._own = False

    def megabytes(self) -> float:
        """Return the greatest memory so far."""
        if self._own:
            line = next(line for line in _STATUS.read_text().splitlines() if line.startswith("VmHWM"))
            return int(line.split()[1]) / 1024
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
