"""Steps of editing in words."""

from __future__ import annotations

import pytest

from layoutkit.model import Drag, Edit, RegionSize, Resize, Step
from layoutkit.model.told import told


@pytest.mark.parametrize(
    ("step", "text"),
    [
        (Edit("add", "columns", ("w",), (2,), (1,)), "column 2 again, before 1"),
        (Edit("add", "rows", ("w",), (2,), (4,)), "row 2 again, after 3"),
        (
            Edit("add", "columns", ("w", "p"), (2, 1), (4, 1)),
            "column 2 again, after 3; column 1 again, before 1",
        ),
        (Edit("remove", "rows", ("w",), (3,)), "without row 3"),
        (Edit("remove", "columns", ("w",), (3,), gap="before"), "without column 3 and the gap before it"),
        (Edit("move", "columns", ("w",), (1,), to=(3,)), "column 1 moved to 3"),
        (Edit("move", "rows", ("w",), to=(2,), element="F/A.2"), "F/A.2 moved to row 2"),
        (Edit("remove", "rows", ("w",), (1,), width=9.0), "without row 1, facade 9 wide"),
        (Resize(12.5, 6.0), "facade 12.5 wide and 6 high"),
        (Resize(height=6.0), "facade 6 high"),
        (RegionSize("F/A", 2.0), "F/A 2 wide"),
        (Drag("F/A", "left", 1.25), "left side of F/A to 1.25"),
    ],
)
def test_what_a_step_does(step: Step, text: str) -> None:
    assert told(step) == text
