"""Plans of small tasks, and folders as they compare."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import batch_work
import pytest

from layoutkit.batch import Plan, Shared, Task
from layoutkit.batch.journal import JOURNAL_FILE

Squares = Callable[..., Plan]


@pytest.fixture
def squares() -> Squares:
    """Return a maker of plans: as many squares, but for tasks of other work by their number."""

    def make(count: int, others: dict[int, Any] | None = None, **arguments: Any) -> Plan:
        shared = Shared({"tail": b"tail"}, {"kind": "square"})
        return Plan(
            "squares",
            [
                Task(
                    f"many/{number}",
                    (others or {}).get(number, batch_work.square),
                    {"number": number, **arguments},
                    shared,
                )
                for number in range(count)
            ],
        )

    return make


def contents(folder: Path) -> dict[str, bytes]:
    """Return all files of a folder but the journal, by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and path.name != JOURNAL_FILE
    }


@pytest.fixture
def same() -> Callable[[Path, Path], None]:
    """Return a check that two folders hold the same bytes, but for their journals."""

    def check(one: Path, other: Path) -> None:
        assert contents(one) == contents(other)
        assert (one / "manifest.json").exists()

    return check
