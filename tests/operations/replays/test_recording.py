"""Recording: steps made on an example are a tree that makes the same of it, and the like elsewhere."""

import pytest
import shapely
from built import box, context, design

from layoutkit.diagnostics import Faulty
from layoutkit.documents import operations_bytes
from layoutkit.documents.operations import read_operations
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.operations import Asset, Branch, Design, Steps
from layoutkit_operations.kinds import Boolean, Edit, Extrude, Mesh, Place, Select, Vary
from layoutkit_operations.recording import Recorder, asset, steps
from layoutkit_operations.recording import design as read_design


def plots(*widths, deep=30.0, name="plots"):
    lefts = [sum(widths[:n]) for n in range(len(widths))]
    polygons = tuple(
        Polygon(f"Plot_{n}", box(left, 0, wide, deep), ("Plot",), edges=((0, ("Front",)),), angle=0)
        for n, (left, wide) in enumerate(zip(lefts, widths, strict=True), 1)
    )
    return Scene(name, "m", polygons)


def house(left, wide):
    return Placement(left + wide / 2, 8.5, wide - 6, 9, 0, "House")


@pytest.fixture(scope="module")
def recorded(stages, tmp_path_factory):
    """A session: houses on plots, one of them shown on each of two, with a porch and facades."""
    folder = tmp_path_factory.mktemp("recorded")
    design(folder)
    session = Recorder(plots(16, 18, 15), sites=("Plot",), seed=4, stages=stages)
    houses = session.select("Plot").place("House", {"Plot_1": [house(0, 16)], "Plot_2": [house(16, 18)]})
    solids = houses.do(Extrude(height=5.5, random=0.1, cap="gable"))
    # A porch, shown on one house in coordinates of its front, is found on all of them.
    front = "Plot_1.House_1.Side_1"
    wide = solids.scene(front).bounds[2]
    one = Place(limit=1)
    porch = solids.select("Front").place("Porch", {front: [Placement(wide / 2, 1.2, 2, 2.4)]}, like=one)
    porch.do(Extrude(height=1.5)).do(Boolean(action="union"))
    solids.select("Side").do(Vary(facade=read_design("wall.xml", folder)))
    return session, houses, porch, folder


def test_examples_are_carried_to_all_that_the_step_works_on(recorded):
    session, houses, porch, _ = recorded
    assert houses.output == ("Plot_1.House_1", "Plot_2.House_1", "Plot_3.House_1")
    assert len(porch.output) == 3
    assert len(session.world.bodies) == 3
    assert not [d for d in session.diagnostics if d.code.startswith("LK88") and d.code != "LK885"]


def test_a_replay_of_what_was_recorded_gives_the_same_world(recorded, stages, tmp_path):
    session, _, _, folder = recorded
    file = folder / "operations.xml"
    file.write_bytes(operations_bytes(session.operations("houses")))
    read = read_operations(file, stages.host.operations, stages.host.constraints)
    again = next(iter(stages("replay", plots(16, 18, 15), operations=read.operations, seed=4))).document
    for one, other in zip(session.world.bodies, again.bodies, strict=True):
        assert one.name == other.name
        assert one.points.tobytes() == other.points.tobytes()
        assert one.triangles.tobytes() == other.triangles.tobytes()
        assert one.openings == other.openings


def test_it_can_be_replayed_on_other_plots(recorded, stages):
    session, _, _, _ = recorded
    other = plots(20, 14, 17, 22, 15, deep=34.0, name="elsewhere")
    outcome = next(iter(stages("replay", other, operations=session.operations("houses"), seed=9)))
    assert len(outcome.document.bodies) == 5
    for body in outcome.document.bodies:
        plot = next(p for p in other.polygons if p.name == body.parent)
        corners = shapely.MultiPoint((body.points + body.origin)[:, :2])
        assert shapely.Polygon(plot.points).covers(corners)
        assert body.openings


def test_steps_follow_the_tree_whatever_the_order_of_recording(stages):
    session = Recorder(plots(16, 18), stages=stages)
    every = session.select("Plot")
    last = session.select("House")
    solid = every.do(Extrude(height=3))
    assert last.output == ()
    assert solid.output == ("Plot_1", "Plot_2")
    kinds = [type(node.operation).__name__ for node in session.operations("s").nodes]
    assert kinds == ["Select", "Extrude", "Select"]


def test_a_split_makes_branches(stages):
    session = Recorder(plots(16, 18, 15, 20), stages=stages)
    low, high = session.select("Plot").split(1, 1)
    low.do(Extrude(height=2))
    high.do(Extrude(height=8))
    assert sorted((*low.output, *high.output)) == ["Plot_1", "Plot_2", "Plot_3", "Plot_4"]
    assert len(low.output) == 2
    (root,) = session.operations("s").roots
    assert [type(branch) for branch in root.branches] == [Branch, Branch]
    assert {round(float(b.points[:, 2].max())) for b in session.world.bodies} == {2, 8}


def test_what_is_not_there_is_named(stages):
    session = Recorder(plots(16, 18), stages=stages)
    step = session.select("Plot")
    with pytest.raises(Faulty, match="Plot_9"):
        step.place("House", {"Plot_9": [house(0, 16)]})
    with pytest.raises(Faulty, match="no examples"):
        step.place("House", {})
    with pytest.raises(Faulty, match="height is 0"):
        step.do(Extrude(height=0))
    with pytest.raises(Faulty, match="placement-model"):
        step.do(Place())
    for nonsense in (
        Extrude(height=3, cap="gabel"),
        Extrude(height="3"),
        Vary(facade="wall.xml"),
        Select(labels=(["Plot"],)),
    ):
        with pytest.raises(Faulty, match="LK882"):
            step.do(nonsense)
    with pytest.raises(Faulty, match="no weight"):
        step.split(0, 1)
    assert Recorder(plots(16), sites="Plot", stages=stages).operations("s").sites == ("Plot",)
    assert isinstance(session.operations("s").roots[0].operation, Select)
    assert not context().told


def test_files_that_were_not_read_are_refused(stages, tmp_path):
    design(tmp_path)
    (tmp_path / "cube.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
    session = Recorder(plots(16), stages=stages)
    for operation in (
        Vary(facade=Design("wall.xml")),
        Edit(session=Steps("edits.xml")),
        Mesh(file=Asset("cube.obj")),
    ):
        with pytest.raises(Faulty, match="was not read"):
            session.do(operation)
    assert not session.operations("none").roots
    session.select("Plot").do(Mesh(file=asset("cube.obj", tmp_path)))
    assert len(session.world.bodies) == 1
    with pytest.raises(Faulty):
        steps("wall.xml", tmp_path)


def test_slips_are_told_as_a_replay_tells_them(stages):
    session = Recorder(plots(16), stages=stages)
    assert session.select("Plott").do(Extrude(height=3)).output == ()
    assert [(d.code, "'Plot'" in d.hint) for d in session.diagnostics] == [("LK888", True)]
    assert [d.code for d in Recorder(plots(16), sites=("Plott",), stages=stages).diagnostics] == ["LK881"]
    with pytest.raises(Faulty, match="is no operation"):
        session.do("extrude")
    with pytest.raises(Faulty, match=r"write \(138, 106, 72\)"):
        session.do(Extrude(height=1, colour="#8a6a48"))
