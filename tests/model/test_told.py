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
            "w: column 2 again, after 3; p: column 1 again, before 1",
        ),
        (Edit("add", "columns", ("w", "p"), (2,), (4,)), "column 2 again, after 3"),
        (Edit("remove", "rows", ("w", "p"), (3, 1)), "w: without row 3; p: without row 1"),
        (Edit("move", "rows", ("w", "p"), (3, 1), to=(1, 2)), "w: row 3 moved to 1; p: row 1 moved to 2"),
        (Edit("remove", "rows", ("w",), (3,)), "without row 3"),
        (Edit("remove", "columns", ("w",), (3,), gap="before"), "without column 3 and the gap before it"),
        (Edit("move", "columns", ("w",), (1,), to=(3,)), "column 1 moved to 3"),
        (Edit("move", "rows", ("w",), to=(2,), element="F/A.2"), "to row 2: F/A.2"),
        (
            Edit("move", "columns", ("w",), to=(3,), element="Facade/Storeys/Floor1/Bay2/Window"),
            "to column 3: …/Storeys/Floor1/Bay2/Window",
        ),
        (Edit("move", "columns", ("w",), to=(3,), element=f"F/{'W' * 40}"), f"to column 3: …/{'W' * 40}"),
        (Edit("remove", "rows", ("w",), (1,), width=9.0), "without row 1, facade 9 wide"),
        (Resize(12.5, 6.0), "facade 12.5 wide and 6 high"),
        (Resize(height=6.0), "facade 6 high"),
        (RegionSize("F/A", 2.0), "F/A 2 wide"),
        (Drag("F/A", "left", 1.25), "left side of F/A to 1.25"),
    ],
)
def test_what_a_step_does(step: Step, text: str) -> None:
    assert told(step) == text
