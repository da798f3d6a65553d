"""Plans of small tasks, and folders as they compare."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import batch_work
import pytest
from batch_work import contents

from layoutkit.batch import Plan, Shared, Task

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


@pytest.fixture
def same() -> Callable[[Path, Path], None]:
    """Return a check that two folders hold the same bytes, but for their journals."""

    def check(one: Path, other: Path) -> None:
        assert contents(one) == contents(other)
        assert (one / "manifest.json").exists()

    return check
