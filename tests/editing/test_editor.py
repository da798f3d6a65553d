"""Editing step by step: proposals, choices, undo and redo, sessions that replay."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from drawn import columns, facade, leaf, rows

from layoutkit.documents import facade_bytes
from layoutkit.model import Facade, Grid, RegionSet, place
from layoutkit.model.session import Drag, Edit, RegionSize, Resize
from layoutkit_editing.editor import Editor, Unrepeatable
from layoutkit_editing.proposing.proposals import Dropped, Proposal
from layoutkit_editing.topology.site import Refused


def house() -> Facade:
    """Return two storeys of three windows each, a door below, and panes in each window."""

    def bay(name: str, width: float, panes: int, *labels: str) -> object:
        pane = leaf("Pane", width / panes, 2.0, ["Pane"])
        return columns(name, *[pane] * panes)

    def storey(name: str, middle: object) -> object:
        window = replace(bay("W", 1.0, 2), labels=("Window",))  # type: ignore[type-var]
        wall, pier = leaf("Wall", 0.8, 2.0), leaf("Pier", 0.6, 2.0)
        return columns(name, wall, window, pier, middle, pier, window, wall)  # type: ignore[arg-type]

    upper = storey("Upper", replace(bay("V", 1.4, 3), labels=("Window",)))  # type: ignore[type-var]
    lower = storey("Lower", leaf("Door", 1.4, 2.0, ["Door"]))
    root = rows("F", leaf("Cornice", 5.4, 0.4), upper, leaf("Band", 5.4, 0.8), lower)  # type: ignore[arg-type]
    return facade(
        root,
        Grid("openings", RegionSet.parse("@Window | @Door")),
        Grid("panes", elements=("F/Upper/W/Pane", "F/Upper/W/Pane.2")),
    )


def taken(editor: Editor, *arguments: object, **options: object) -> list[Proposal]:
    """Return the proposals of an edit that are not dropped."""
    found = editor.proposals(*arguments, **options)  # type: ignore[arg-type]
    return [each for each in found if isinstance(each, Proposal)]


def words(facade: Facade) -> dict[str, str]:
    """Return the word of each composite region by its path, the numbers of variants left out."""
    return {
        p.path: re.sub(r"_\d", "", " ".join(p.region.word)) for p in place(facade.root) if p.region.children
    }


def test_the_facade_before_any_edit_is_the_input() -> None:
    input_ = house()
    assert facade_bytes(Editor(input_).facade) == facade_bytes(input_)


def test_all_sources_go_to_all_places_and_what_looks_alike_is_shown_once() -> None:
    """There are two kinds of columns, the outer and the middle one, and four places."""
    found = taken(Editor(house()), "add", "columns", ["openings"])
    made = [
        " ".join(
            each.state.original.places[each.state.tree.nodes[own].source].region.symbol
            for own in each.state.lattice("openings").cells[0]
            if own is not None
        )
        for each in found
    ]
    assert sorted(made) == ["V W V W", "W V V W", "W V W V", "W V W W", "W W V W"]
    assert [each.edit.source for each in found] == sorted(each.edit.source for each in found)


def test_a_row_is_copied_whole_and_the_facade_grows_by_it() -> None:
    editor = Editor(house())
    found = taken(editor, "add", "rows", ["openings"])
    upper_again = next(each for each in found if each.edit.source == (1,) and each.edit.at == (1,))
    editor.take(upper_again)
    assert words(editor.facade)["F"] == "Cornice Upper Band Upper Band Lower"
    assert editor.facade.root.height == pytest.approx(house().root.height + 2.8)
    assert editor.facade.root.width == pytest.approx(house().root.width)


def test_grids_in_what_is_copied_are_copied_as_grids_of_their_own() -> None:
    editor = Editor(house())
    editor.take(next(p for p in taken(editor, "add", "columns", ["openings"]) if p.edit.source == (1,)))
    assert [grid.name for grid in editor.facade.grids] == ["openings", "panes", "panes_2"]
    both = taken(editor, "add", "columns", ["panes", "panes_2"])
    assert both[0].edit.source == (1,), "grids of one kind are edited alike"
    editor.take(both[0])
    assert sum(word == "Pane Pane Pane" for word in words(editor.facade).values()) >= 2


def test_subgrids_and_the_grid_around_them_are_edited_together() -> None:
    editor = Editor(house())
    found = taken(editor, "add", "columns", ["openings", "panes"])
    assert found[0].edit.grids == ("openings", "panes")
    assert len(found[0].edit.source) == 2, "one number for each number of columns"


def test_undo_and_redo_give_the_same_bytes() -> None:
    editor = Editor(house())
    states = [facade_bytes(editor.facade)]
    for action, axis in (("add", "columns"), ("add", "rows"), ("remove", "columns")):
        editor.take(taken(editor, action, axis, ["openings"])[0])
        states.append(facade_bytes(editor.facade))
    assert len(set(states)) == 4
    for wanted in reversed(states[:-1]):
        editor.undo()
        assert facade_bytes(editor.facade) == wanted
    for wanted in states[1:]:
        editor.redo()
        assert facade_bytes(editor.facade) == wanted
    with pytest.raises(Refused, match="nothing to redo"):
        editor.redo()


def test_a_session_replays_to_the_same_bytes() -> None:
    editor = Editor(house())
    editor.take(taken(editor, "add", "columns", ["openings"])[1])
    editor.make(Resize(width=9.0))
    editor.take(taken(editor, "move", "columns", ["openings"])[0])
    editor.make(RegionSize("F/Band", height=1.0))
    editor.take(taken(editor, "add", "rows", ["openings"])[0])
    editor.undo()
    session = editor.session("house", "house.xml")
    again = Editor(house())
    again.replay(session)
    assert facade_bytes(again.facade) == facade_bytes(editor.facade)
    again.redo()
    editor.redo()
    assert facade_bytes(again.facade) == facade_bytes(editor.facade)


def test_a_step_that_cannot_be_made_is_named() -> None:
    editor = Editor(house())
    step = Edit("add", "columns", ("openings",), (7,), (1,))
    with pytest.raises(Unrepeatable, match="has no place 7 for a column") as raised:
        editor.replay(replace(editor.session("s", "f.xml"), done=(step,)))
    assert raised.value.step is step


def test_removing_what_was_added_gives_the_input_again() -> None:
    editor = Editor(house())
    added = next(p for p in taken(editor, "add", "columns", ["openings"]) if p.edit.at == (3,))
    editor.take(added)
    back = [p for p in taken(editor, "remove", "columns", ["openings"]) if p.edit.source == (3,)]
    results = []
    for each in back:
        editor.take(each)
        results.append(facade_bytes(replace(editor.facade, grids=())))
        editor.undo()
    assert facade_bytes(replace(house(), grids=())) in results


def test_an_element_is_moved_directly() -> None:
    editor = Editor(house())
    found = taken(editor, "move", "columns", ["openings"], element="F/Lower/Door")
    assert {each.edit.to for each in found} == {(1,), (3,)}
    editor.take(found[0])
    assert words(editor.facade)["F/Lower"] == "Wall Door Pier W Pier W Wall"
    assert words(editor.facade)["F/Upper"] == words(house())["F/Upper"], "other rows stay"


def test_dragging_a_side_resizes_what_is_around_it_and_keeps_topology() -> None:
    editor = Editor(house())
    door = {p.path: p.box for p in place(house().root)}["F/Lower/Door"]
    editor.make(Drag("F/Lower/Door", "top", door.y1 + 0.2))
    boxes = {p.path: p.box for p in place(editor.facade.root)}
    assert boxes["F/Lower/Door"].y1 == pytest.approx(door.y1 + 0.2)
    assert words(editor.facade) == words(house())


def test_a_proposal_that_cannot_be_sized_is_dropped_with_its_reason() -> None:
    found = Editor(house()).proposals("add", "columns", ["openings"], width=2.0)
    assert any(isinstance(each, Dropped) and each.reason for each in found) or all(
        each.state.targets.extents[0] == 2.0 for each in found if isinstance(each, Proposal)
    )
    hopeless = Editor(house())
    with pytest.raises(Refused):
        hopeless.make(RegionSize("F/Upper/W", width=50.0, height=0.0))


def street() -> Facade:
    """Return a row of two windows."""
    wall, window = leaf("Wall", 1.0, 3.0), leaf("Window", 2.0, 3.0, ["Window"])
    windows = Grid("windows", RegionSet.parse("@Window"))
    return facade(columns("Row", wall, window, wall, window, wall), windows)


def test_taking_a_column_out_leaves_every_storey_in_place() -> None:
    """The door is alone in its row: what stands beside it takes its room, and the storey stays."""
    wall, window = leaf("Wall", 1.0, 3.0), leaf("Window", 2.0, 3.0, ["Window"])
    upper = columns("Upper", wall, window, wall, window, wall, window, wall)
    ground = columns(
        "Ground", leaf("Stone", 4.0, 3.0), leaf("Door", 2.0, 3.0, ["Door"]), leaf("Stone", 4.0, 3.0)
    )
    editor = Editor(facade(rows("F", upper, ground), Grid("w", RegionSet.parse("@Window | @Door"))))
    found = taken(editor, "remove", "columns", ["w"])
    assert found
    for each in found:
        editor.take(each)
        assert words(editor.facade)["F"] == "Upper Ground"
        assert editor.facade.root.height == pytest.approx(6.0)
        editor.undo()


def test_what_was_moved_there_and_back_is_where_it_was() -> None:
    wide, narrow = leaf("A", 6.0, 2.0, ["Window"]), leaf("B", 2.0, 2.0, ["Window"])
    street_ = columns("R", leaf("a"), wide, leaf("n"), narrow, leaf("z"))
    editor = Editor(facade(street_, Grid("w", RegionSet.parse("@Window"))))
    before = facade_bytes(editor.facade)
    editor.make(Edit("move", "columns", ("w",), (1,), to=(2,)))
    assert facade_bytes(editor.facade) != before
    editor.make(Edit("move", "columns", ("w",), (2,), to=(1,)))
    assert facade_bytes(editor.facade) == before
    assert not editor.moment.state.shifts


def test_edits_go_on_from_what_was_dragged() -> None:
    """What is inserted before a dragged window pushes it along; no other window is squeezed."""
    editor = Editor(street())
    editor.make(Drag("Row/Window", "left", 1.5))
    (first,) = taken(editor, "add", "columns", ["windows"])
    widths = [end - start for start, end in (first.sized.span(own, 0) for own in first.state.elements)]
    assert widths == pytest.approx([widths[0]] * 3)
    assert widths[0] == pytest.approx(editor.facade.root.children[1].width)


def test_a_line_can_be_dragged_by_either_side() -> None:
    editor = Editor(street())
    editor.make(Drag("Row/Wall.2", "left", 2.5))
    editor.make(Drag("Row/Window", "right", 3.2))
    assert {p.path: p.box for p in place(editor.facade.root)}["Row/Window"].x1 == pytest.approx(3.2)


def test_a_drag_that_stops_says_where_and_a_side_that_cannot_move_is_refused() -> None:
    editor = Editor(street())
    editor.make(Drag("Row/Window", "right", 50.0))
    assert "went to" in editor.remarks[0]
    for region, side in (("Row", "left"), ("Row/Window", "bottom")):
        with pytest.raises(Refused, match="places are counted from there"):
            editor.make(Drag(region, side, 1.0))  # type: ignore[arg-type]
    editor.make(Drag("Row/Window", "top", 4.0))
    assert editor.facade.root.height == pytest.approx(4.0)


def test_a_proposal_of_another_moment_is_refused() -> None:
    editor = Editor(street())
    (only,) = taken(editor, "add", "columns", ["windows"])
    editor.take(only)
    with pytest.raises(Refused, match="another moment"):
        editor.take(only)


@pytest.mark.parametrize(
    "step",
    [
        Resize(width=float("inf")),
        Resize(height=float("nan")),
        Drag("Row/Window", "left", float("nan")),
        RegionSize("Row/Window", width=0.0),
        Edit("add", "columns", ("nope",), (1,), (1,)),
        Edit("add", "columns", ("windows",), (1,), ()),
        Edit("move", "columns", ("windows",), element="Row/Window"),
        Edit("move", "columns", ("windows",), to=(1,), element="Row/Door"),
    ],
)
def test_a_step_that_makes_no_sense_is_refused_and_changes_nothing(step: Any) -> None:
    editor = Editor(street())
    with pytest.raises(Refused):
        editor.make(step)
    assert facade_bytes(editor.facade) == facade_bytes(street())
    assert not editor.session("s", "f.xml").done


def test_a_building_is_refused() -> None:
    root = replace(house().root, split="faces")
    with pytest.raises(Refused, match="a building cannot be edited"):
        Editor(Facade("b", "m", root))


def test_facades_of_our_own_are_edited(tmp_path: Path) -> None:
    from layoutkit import documents
    from layoutkit.cli.session import Session

    kinds = Session().host.constraints
    file = Path(__file__).parents[2] / "facades" / "townhouse" / "facade.xml"
    read = documents.read(file, kinds).model
    assert isinstance(read, Facade)
    bare = replace(read, constraints=(), grids=(Grid("windows", RegionSet.parse("@Window")),))
    editor = Editor(bare)
    for action, axis in (("add", "columns"), ("add", "rows"), ("remove", "columns")):
        editor.take(taken(editor, action, axis, ["windows"])[0])
    (tmp_path / "facade.xml").write_bytes(facade_bytes(replace(editor.facade, picture=None)))
    again = documents.read(tmp_path / "facade.xml", kinds)
    assert not again.diagnostics
