"""What the conformance suite finds: one promise that a constraint kind does not keep, and where."""

from __future__ import annotations

import traceback
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Finding:
    """A promise that a constraint kind does not keep.

    Attributes
    ----------
    promise
        Its name, one of `layoutkit.testing.PROMISES`.
    message
        What is wrong, in one line.
    subject
        The facade and the constraint with which it shows; empty where it hangs on neither.
    details
        Further lines: the layout with which it shows.
    """

    promise: str
    message: str
    subject: str = ""
    details: tuple[str, ...] = ()

    def __str__(self) -> str:
        where = f" [{self.subject}]" if self.subject else ""
        return "\n".join(
            [f"{self.promise}: {self.message}{where}", *(f"    {line}" for line in self.details)]
        )


def raised(error: BaseException) -> str:
    """Return what was raised, and the line of code that it came from."""
    frames = traceback.extract_tb(error.__traceback__)
    where = f" ({frames[-1].filename}:{frames[-1].lineno})" if frames else ""
    text = str(error).splitlines()[0] if str(error) else ""
    return f"{type(error).__name__}: {text}{where}" if text else f"{type(error).__name__}{where}"
