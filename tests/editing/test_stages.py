"""The stages of editing: what programs get from them, whatever they are asked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest
from editing.random_facades import facades, labelled_lattices
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import Size
from layoutkit.diagnostics import Faulty, Place, Severity
from layoutkit.hooks import Outcome
from layoutkit.hooks.host import Host
from layoutkit.model import (
    Drag,
    DroppedEdit,
    Edit,
    Facade,
    Grid,
    Measure,
    ProposedEdit,
    Region,
    RegionSet,
    RegionSize,
    Resize,
    Session,
    place,
)
from layoutkit_editing.original import Original
from layoutkit_editing.stages.propose import brief


def run(stage: str, facade: Facade, **options: Any) -> list[Outcome]:
    found = Host.load().stages.find(stage)
    return list(found.run(facade, found.options(**options)))


def row(*symbols: str, name: str = "row") -> Facade:
    """Return a row of regions 1 m wide and 2 m high, each of them labelled by its symbol."""
    parts = tuple(Region(symbol, 1.0, 2.0, labels=(symbol,)) for symbol in symbols)
    return Facade(name, "m", Region("Row", float(len(symbols)), 2.0, "columns", parts))


def gridded(facade: Facade, **grids: Sequence[str]) -> Facade:
    return replace(facade, grids=tuple(Grid(name, elements=tuple(own)) for name, own in grids.items()))


STREET = gridded(
    row("Wall", "Window", "Wall", "Door", "Wall", "Window", "Wall"),
    openings=("Row/Window", "Row/Door", "Row/Window.2"),
    windows=("Row/Window", "Row/Window.2"),
)


def terminals(facade: Facade) -> list[str]:
    return [placed.path for placed in place(facade.root) if placed.region.terminal]


def told(outcomes: Sequence[Outcome]) -> list[tuple[str, Severity]]:
    return [(d.code, d.severity) for outcome in outcomes for d in outcome.diagnostics]


def test_grids_are_added_behind_those_that_are_there() -> None:
    bare = replace(STREET, grids=(STREET.grids[1],))
    (outcome,) = run("grids", bare)
    assert (outcome.status, outcome.diagnostics) == ("found", ())
    assert isinstance(outcome.document, Facade)
    assert replace(outcome.document, grids=bare.grids) == bare
    assert outcome.document.grids[0] == bare.grids[0]
    sets = [{placed.path for placed in grid.members(bare)} for grid in outcome.document.grids]
    assert sets.count({"Row/Window", "Row/Window.2"}) == 1
    assert {"Row/Window", "Row/Door", "Row/Window.2"} in sets
    names = [grid.name for grid in outcome.document.grids]
    assert len(set(names)) == len(names)
    (first,) = run("grids", bare, limit=1)
    assert first.document == replace(bare, grids=outcome.document.grids[:2])


def test_a_selection_and_what_is_like_it() -> None:
    facade = row("Wall", "Window", "Shop", "Window", "Wall", "Window", "Shop", "Window", "Wall")
    (outcome,) = run("grids", facade, like=("Row/Window.2", "Row/Window"))
    assert isinstance(outcome.document, Facade)
    chosen, *others = outcome.document.grids
    assert (chosen.name, chosen.elements) == ("window", ("Row/Window", "Row/Window.2"))
    assert [other.elements for other in others] == [("Row/Window.3", "Row/Window.4")]


@pytest.mark.parametrize(("like", "code"), [(("Row/Door.2",), "LK241"), (("Row", "Row/Door"), "LK243")])
def test_a_selection_that_cannot_be_a_grid(like: tuple[str, ...], code: str) -> None:
    with pytest.raises(Faulty) as caught:
        run("grids", STREET, like=like)
    assert [d.code for d in caught.value.diagnostics] == [code]


def test_what_is_proposed() -> None:
    outcomes = run("propose", STREET, grids=("openings",))
    assert {outcome.status for outcome in outcomes} == {"found"}
    edits = [outcome.proposal.edit for outcome in outcomes if isinstance(outcome.proposal, ProposedEdit)]
    assert len(edits) == len(outcomes)
    assert {(edit.action, edit.axis, edit.grids) for edit in edits} == {("add", "columns", ("openings",))}
    for outcome in outcomes:
        assert isinstance(outcome.document, Facade)
        assert isinstance(outcome.proposal, ProposedEdit)
        assert outcome.origins is not None
        (path,) = outcome.proposal.new
        (grid,) = (grid for grid in outcome.document.grids if grid.name == "openings")
        (cells,) = grid.cells(outcome.document)
        shown = [pictures(outcome)[own.path] for own in cells if own is not None]
        (at,), (source,) = outcome.proposal.edit.at, outcome.proposal.edit.source
        assert cells[at - 1] is not None
        assert cells[at - 1].path == path
        assert shown.pop(at - 1) == STREET.grids[0].elements[source - 1]
        assert tuple(shown) == STREET.grids[0].elements
        assert outcome.proposal.distortion == pytest.approx(0.0, abs=1e-9)


def test_the_first_of_each_group_come_first() -> None:
    outcomes = run("propose", STREET, grids=("openings",))
    clusters = [o.proposal.cluster for o in outcomes if isinstance(o.proposal, ProposedEdit)]
    assert clusters[: max(clusters) + 1] == list(range(max(clusters) + 1))


def test_moved_elements_are_new() -> None:
    outcomes = run("propose", STREET, grids=("openings",), action="move")
    assert outcomes
    for outcome in outcomes:
        assert isinstance(outcome.proposal, ProposedEdit)
        assert outcome.proposal.new


def test_what_makes_room_for_what_moves_is_not_new() -> None:
    for options in ({}, {"element": "Row/Door"}):
        outcomes = run("propose", STREET, grids=("openings",), action="move", **options)
        for outcome in outcomes:
            assert isinstance(outcome.proposal, ProposedEdit)
            assert isinstance(outcome.document, Facade)
            (path,) = outcome.proposal.new
            (cells,) = outcome.document.grids[0].cells(outcome.document)
            place_taken = cells[outcome.proposal.edit.to[0] - 1]
            assert place_taken is not None
            assert place_taken.path == path


def test_long_reasons_are_told_in_brief() -> None:
    """The first clauses, as far as they can be read at a glance; programs get them whole."""
    rules = [f"the part number {number} stays of one size" for number in range(9)]
    reason = f"these cannot hold together: {'; '.join(rules)}"
    assert brief("nothing would move") == "nothing would move"
    assert brief(reason) == f"these cannot hold together: {'; '.join(rules[:3])}; and 6 more"
    assert brief("word " * 99).endswith("word …")
    assert len(brief("word " * 99)) <= 162


@pytest.mark.parametrize("constraints", [(), (Size(of=RegionSet("@Door"), max=Measure(9.0)),)])
def test_only_constraints_that_are_there_can_be_loosened(constraints: tuple[Size, ...]) -> None:
    single = replace(gridded(STREET, doors=("Row/Door",)), constraints=constraints)
    (diagnostic,) = run("propose", single, grids=("doors",), action="remove")[-1].diagnostics
    assert ("loosen" in diagnostic.hint) == bool(constraints)


def test_one_region_and_all_like_it() -> None:
    (outcome,) = run("grids", replace(STREET, grids=()), like=("Row/Window.2",))
    assert isinstance(outcome.document, Facade)
    (grid,) = outcome.document.grids
    assert (grid.name, grid.elements) == ("window", ("Row/Window", "Row/Window.2"))


def test_a_drag_that_stops_is_told() -> None:
    wide = Drag("Row/Window", "right", 50.0)
    (outcome,) = run("edit", STREET, then=wide)
    (note,) = (d for d in outcome.diagnostics if d.code == "LK659")
    assert note.severity is Severity.NOTE
    assert note.message.startswith("the right side of Row/Window went to ")
    assert note.message.endswith(", not to 50")
    (outcome,) = run("edit", STREET, session=Session("s", "f.xml", (wide,)))
    assert "LK659" not in {d.code for d in outcome.diagnostics}, "it was told when it was made"


def test_what_is_taken_out_leaves_nothing_new() -> None:
    outcomes = run("propose", STREET, grids=("openings",), action="remove")
    assert all(isinstance(o.proposal, ProposedEdit) and o.proposal.new == () for o in outcomes)


def test_percentages_are_of_the_facade_after_the_session() -> None:
    wide = Session("s", "f.xml", (Resize(width=14.0),))
    for session, width in ((None, 14.0), (wide, 28.0)):
        outcomes = run(
            "propose", STREET, session=session, grids=("openings",), width=Measure(2.0, relative=True)
        )
        assert {o.document.root.width for o in outcomes if isinstance(o.document, Facade)} == {width}


def test_dropped_proposals_are_told_at_the_end() -> None:
    door = Size(of=RegionSet("@Door"), max=Measure(1.0, relative=True))
    facade = replace(STREET, constraints=(door,))
    # The door cannot grow with all else, as wide as the facade is to be.
    outcomes = run("propose", facade, grids=("openings",), action="remove", width=Measure(40.0))
    lost = [outcome for outcome in outcomes if isinstance(outcome.proposal, DroppedEdit)]
    found = [outcome for outcome in outcomes if isinstance(outcome.proposal, ProposedEdit)]
    assert [*found, *lost] == outcomes[: len(found) + len(lost)]
    assert all(outcome.document is None and outcome.status == "infeasible" for outcome in lost)
    assert all(outcome.proposal.reason for outcome in lost if isinstance(outcome.proposal, DroppedEdit))
    codes = {code for code, _ in told(outcomes)}
    assert codes == ({"LK655"} if found and lost else {"LK653"} if lost else set())
    assert told(outcomes[:-1]) == []


def test_no_proposal_is_infeasible_with_the_reasons() -> None:
    single = gridded(STREET, doors=("Row/Door",))
    outcomes = run("propose", single, grids=("doors",), action="remove")
    assert outcomes[-1].status == "infeasible"
    (diagnostic,) = outcomes[-1].diagnostics
    assert (diagnostic.code, diagnostic.severity) == ("LK653", Severity.ERROR)
    assert diagnostic.message == "no column can be taken out of doors"
    assert any("no other line" in line for line in diagnostic.details)


@pytest.mark.parametrize(
    ("facade", "options", "code"),
    [
        (replace(STREET, grids=()), {"grids": ("openings",)}, "LK652"),
        (STREET, {"grids": ("opening",)}, "LK651"),
        (STREET, {}, "LK651"),
        (STREET, {"grids": ("openings",), "action": "move", "element": "Row/Gate"}, "LK658"),
    ],
)
def test_what_cannot_be_asked_for(facade: Facade, options: dict[str, Any], code: str) -> None:
    with pytest.raises(Faulty) as caught:
        run("propose", facade, **options)
    assert [d.code for d in caught.value.diagnostics] == [code]


def test_a_building_is_not_edited() -> None:
    faces = Region("House", 7.0, 2.0, "faces", (STREET.root,))
    for stage in ("propose", "edit"):
        with pytest.raises(Faulty, match="a building cannot be edited") as caught:
            run(stage, replace(STREET, root=faces, grids=()))
        assert [d.code for d in caught.value.diagnostics] == ["LK653"]


def test_edits_are_made_again() -> None:
    for outcome in run("propose", STREET, grids=("openings",)):
        assert isinstance(outcome.proposal, ProposedEdit)
        edit = outcome.proposal.edit
        for options in ({"session": Session("s", "f.xml", (edit,))}, {"then": edit}):
            (again,) = run("edit", STREET, **options)
            assert again.status == "found"
            assert again.document == outcome.document
            assert again.origins == outcome.origins


def test_what_was_taken_back_is_not_made() -> None:
    (outcome,) = run("edit", STREET, session=Session("s", "f.xml", (), (Resize(width=14.0),)))
    assert isinstance(outcome.document, Facade)
    assert outcome.document.root == STREET.root
    assert pictures(outcome) == {path: path for path in terminals(STREET)}


def test_an_edit_that_cannot_be_made_again_is_told_at_its_place() -> None:
    edit = Edit("remove", "columns", ("openings",), (9,), place=Place("s.xml", 4, 3))
    with pytest.raises(Faulty) as caught:
        run("edit", STREET, session=Session("s", "f.xml", (Resize(width=8.0), edit)))
    (diagnostic,) = caught.value.diagnostics
    assert (diagnostic.code, diagnostic.place) == ("LK654", edit.place)
    assert "without column 9" in diagnostic.message


@pytest.mark.parametrize("step", [Drag("Row/Gate", "left", 1.0), RegionSize("Row/Gate", 2.0)])
def test_a_step_of_a_region_that_is_not_there(step: Drag | RegionSize) -> None:
    with pytest.raises(Faulty, match="no region 'Row/Gate'") as caught:
        run("edit", STREET, then=step)
    assert [d.code for d in caught.value.diagnostics] == ["LK658"]


def test_a_step_that_cannot_be_made() -> None:
    facade = replace(STREET, constraints=(Size(of=RegionSet("@Door"), max=Measure(1.0)),))
    (outcome,) = run("edit", facade, then=RegionSize("Row/Door", 2.0))
    assert (outcome.status, outcome.document) == ("infeasible", None)
    assert told([outcome]) == [("LK653", Severity.ERROR)]


def test_soft_constraints_that_give_way_are_told() -> None:
    soft = Size(of=RegionSet("@Door"), max=Measure(1.0), weight=1.0)
    (outcome,) = run("edit", replace(STREET, constraints=(soft,)), then=RegionSize("Row/Door", 2.0))
    assert outcome.status == "found"
    assert told([outcome]) == [("LK603", Severity.NOTE)]


def pictures(outcome: Outcome) -> dict[str, str]:
    """Return the region of the street that each terminal shows as a whole."""
    boxes = {placed.box: placed.path for placed in place(STREET.root)}
    assert outcome.origins is not None
    return {path: boxes[piece.source] for path, (piece,) in outcome.origins.items()}


@given(facades(2), st.data())
@settings(max_examples=25)
def test_any_facade_gets_outcomes(facade: Facade, data: st.DataObject) -> None:
    """Whatever there is to edit: documents with origins, or reasons; and the same ones twice."""
    lattices = labelled_lattices(Original(facade))
    if not lattices:
        return
    places = Original(facade).places
    named = {own.name: [places[source].path for source in own.elements] for own in lattices}
    subject = gridded(facade, **named)
    options = {
        "grids": (data.draw(st.sampled_from(sorted(named))),),
        "action": data.draw(st.sampled_from(["add", "remove", "move"])),
        "axis": data.draw(st.sampled_from(["columns", "rows"])),
    }
    outcomes = run("propose", subject, **options)
    assert outcomes
    for outcome in outcomes:
        if isinstance(outcome.document, Facade):
            assert outcome.status == "found"
            assert outcome.origins is not None
            assert outcome.origins.keys() == set(terminals(outcome.document))
            assert isinstance(outcome.proposal, ProposedEdit)
            assert set(outcome.proposal.new) <= {placed.path for placed in place(outcome.document.root)}
            for pieces in outcome.origins.values():
                shares = [piece.share.width * piece.share.height for piece in pieces]
                assert sum(shares) == pytest.approx(1.0)
                assert min(shares) > 0
                shown = {edge for piece in pieces for edge in piece.source}
                assert -1e-6 <= min(shown) <= max(shown) <= max(facade.root.width, facade.root.height) + 1e-6
        else:
            assert outcome.status == "infeasible"
            assert isinstance(outcome.proposal, DroppedEdit) or outcome is outcomes[-1]
    again = run("propose", subject, **options)
    assert [replace(o, seconds=0.0) for o in again] == [replace(o, seconds=0.0) for o in outcomes]
