"""Facades of the CMP database, converted: every edit of the first grid found gives a proposal."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from edit_checks import check_proposal

from layoutkit.documents import facade_bytes
from layoutkit.model import Facade
from layoutkit_editing.editor import Editor
from layoutkit_editing.grids.detection import detected
from layoutkit_editing.moments import Moment
from layoutkit_editing.original import Original
from layoutkit_editing.proposing.proposals import Proposal
from layoutkit_formats.cmp import CmpFormat

CMP = Path(__file__).parents[3] / "shared" / "data" / "cmp"
NAMES = sorted(path.stem for path in CMP.glob("*.xml")) if CMP.is_dir() else []
SOME = ["cmp_b0033", "cmp_b0048", "cmp_b0188", "cmp_b0352"]
EDITS = (("add", "columns"), ("add", "rows"), ("remove", "columns"), ("remove", "rows"))


def with_grid(name: str) -> Facade:
    """Return a converted facade with the grid that is offered first; without one where none is found."""
    if not CMP.is_dir():
        pytest.skip("the CMP facades are not beside the project")
    facade, _ = CmpFormat().read(CMP / f"{name}.xml", CMP / f"{name}.jpg")
    return replace(facade, grids=tuple(found.grid for found in detected(Original(facade))[:1]))


def check_edits_of(facade: Facade) -> None:
    """Check that every edit gives proposals, all sound, or says why not."""
    editor, (grid,) = Editor(facade), facade.grids
    assert facade_bytes(editor.facade) == facade_bytes(facade)
    before = editor.moment.state
    for action, axis in EDITS:
        found = editor.proposals(action, axis, [grid.name])  # type: ignore[arg-type]
        sound = [each for each in found if isinstance(each, Proposal)]
        lines = before.lattice(grid.name).lines(0 if axis == "columns" else 1)
        assert sound or (action == "remove" and len(lines) == 1), (
            action,
            axis,
            [str(each) for each in found],
        )
        for each in sound:
            check_proposal(before, each)
            assert Moment(each.state, each.sized).origins.keys()


@pytest.mark.parametrize("name", [name for name in SOME if name in NAMES])
def test_edits_of_some_real_facades(name: str) -> None:
    check_edits_of(with_grid(name))


@pytest.mark.nightly
def test_edits_of_all_real_facades() -> None:
    """On at least fifty of sixty a grid is found with no help, and each can be edited."""
    facades = [with_grid(name) for name in NAMES]
    gridded = [facade for facade in facades if facade.grids]
    assert len(gridded) >= 50
    for facade in gridded:
        check_edits_of(facade)
