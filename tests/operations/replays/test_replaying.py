"""Replays: scopes follow the tree, chance hangs on seed and site alone, branches share out what there is."""

from collections import Counter
from dataclasses import dataclass
from typing import ClassVar

import pytest
from built import box, open_edges, scene
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Faulty, Severity
from layoutkit.model import Polygon, Scene
from layoutkit.operations import Branch, Context, Node, Operation, Operations, Result, Site
from layoutkit.operations.sites import sites_of
from layoutkit_operations.kinds import Array, Boolean, Delete, Extrude, Select
from layoutkit_operations.replaying import Replay, dealt_out

PLOTS = [box(12 * n, 0, 10, 10) for n in range(9)]


def tree(*roots, sites=()):
    return Operations("t", "m", roots, sites)


def heights(world):
    return {body.name: float(body.points[:, 2].max()) for body in world.bodies}


def replayed(stages, operations, own, seed=0):
    outcome = next(iter(stages("replay", own, operations=operations, seed=seed)))
    return outcome.document


RANDOM = Node(Select(labels=("Plot",)), (Node(Extrude(height=5, random=0.5)),))


@given(st.integers(0, 40), st.lists(st.floats(0.1, 5), min_size=1, max_size=5), st.integers(0, 2**31))
def test_branches_share_out_all_of_the_output_and_nothing_twice(count, weights, seed):
    output = tuple(f"E_{n}" for n in range(count))
    parts = list(dealt_out(output, [Branch((), w) for w in weights], Context(None, (seed,))))
    assert sorted(name for part in parts for name in part) == sorted(output)
    for part, weight in zip(parts, weights, strict=True):
        assert abs(len(part) - count * weight / sum(weights)) < 2
        assert list(part) == [name for name in output if name in part]


def test_a_branch_gets_single_elements_as_often_as_it_weighs():
    branches = [Branch((), 1), Branch((), 3)]
    counts = Counter(
        next(n for n, part in enumerate(dealt_out(("A",), branches, Context(None, (seed,)))) if part)
        for seed in range(2000)
    )
    assert counts[1] / 2000 == pytest.approx(0.75, abs=0.04)


def test_weights_may_be_as_large_as_numbers_are():
    branches = [Branch((), 1e308), Branch((), 1e308), Branch((), 1e-300)]
    parts = list(dealt_out(tuple("ABCD"), branches, Context(None, (0,))))
    assert [len(part) for part in parts] == [2, 2, 0]


def test_each_branch_does_its_own_and_later_roots_see_what_is_there(stages):
    low, high = Node(Extrude(height=2)), Node(Extrude(height=9))
    select = Node(Select(labels=("Plot",)), (), (Branch((low,)), Branch((high,))))
    last = Node(Select(labels=("Top",)), (Node(Array(label="Vent", each_width=1, each_height=1)),))
    world = replayed(stages, tree(select, last), scene(*PLOTS))
    assert Counter(heights(world).values()) in ({2.0: 4, 9.0: 5}, {2.0: 5, 9.0: 4})
    assert len(world.bodies) == 9
    assert all((body.skin != 0).any() for body in world.bodies)  # the vents on every top


def test_what_an_earlier_child_deletes_is_gone_for_the_next(stages):
    solid = Node(Extrude(height=3), (Node(Delete()), Node(Select(labels=("Top",)), (Node(Delete()),))))
    world = replayed(stages, tree(Node(Select(labels=("Plot",)), (solid,))), scene(*PLOTS))
    assert not world.bodies


def test_the_same_seed_gives_the_same_world_and_another_seed_another(stages):
    operations = tree(RANDOM)
    one, two, other = (replayed(stages, operations, scene(*PLOTS), seed) for seed in (1, 1, 2))
    assert heights(one) == heights(two)
    assert set(heights(one).values()).isdisjoint(heights(other).values())


def test_a_site_is_built_alike_whichever_others_there_are(stages):
    operations = tree(RANDOM, sites=("Plot",))
    every = replayed(stages, operations, scene(*PLOTS), 3)
    some = Scene("built", "m", scene(*PLOTS).polygons[4:6])
    assert heights(replayed(stages, operations, some, 3)).items() <= heights(every).items()


def test_what_has_no_labels_is_worked_on_as_well_and_sites_in_sites_are_not(stages):
    inside = (Polygon("Shed", box(1, 1, 2, 2)), Polygon("Inner", box(5, 5, 4, 4), ("Plot",)))
    every = Scene("built", "m", (Polygon("Outer", box(0, 0, 10, 10), ("Plot",)), *inside))
    world = replayed(stages, tree(Node(Extrude(height=2)), sites=("Plot",)), every)
    assert heights(world) == {"Outer": 2, "Shed": 2, "Inner": 2}


def test_what_a_later_merge_takes_away_is_not_made(stages):
    """A chimney inside of a tower that is merged with the house below it."""
    chimney = Node(Array(label="Chimney", each_width=1, each_height=1, margin=2), (Node(Extrude(height=1)),))
    house = Node(Extrude(height=4), (Node(Select(labels=("Top",)), (chimney,)),))
    merged = Node(Boolean(action="union", with_="intersecting"))
    roots = (
        Node(Select(labels=("House",)), (house,)),
        Node(Select(labels=("Tower",)), (Node(Extrude(height=20)),)),
        Node(Select(labels=("Chimney", "Tower")), (merged,)),
    )
    labelled = (Polygon("H", box(2, 2, 6, 6), ("House",)), Polygon("T", box(0, 0, 10, 10), ("Tower",)))
    world = replayed(stages, tree(*roots), Scene("built", "m", labelled))
    assert heights(world) == {"T": 20}


def test_what_cannot_be_let_into_a_mesh_is_left_off_it_and_told(stages):
    """Windows on the sides of a sharp plan, whose roof was cut into slivers."""
    plan = ((57.4604, -24.5336), (120.6043, -28.0671), (-85.3581, 26.4205), (-93.0775, 26.4096))
    cut = (Node(Extrude(height=-1), (Node(Boolean(action="difference")),)),)
    sizes = {"each_width": 8, "each_height": 8, "gap_across": 5, "gap_up": 5, "margin": 0.2}
    boxes = Node(Array(label="Box", **sizes), cut)
    panes = Node(Array(label="Window", **{**sizes, "each_width": 20, "each_height": 20, "gap_across": 10}))
    inside = (Node(Select(labels=("Roof",)), (boxes,)), Node(Select(labels=("Side",)), (panes,)))
    operations = tree(Node(Extrude(height=1.609, cap="hip", pitch=50.5), inside))
    outcome = next(iter(stages("replay", Scene("sharp", "m", (Polygon("H", plan),)), operations=operations)))
    (body,) = outcome.document.bodies
    assert not open_edges(body.triangles)
    assert not any(d.severity is Severity.ERROR for d in outcome.diagnostics)
    assert bool(body.openings) != any("is not shown" in d.message for d in outcome.diagnostics)


def test_sites_have_what_is_inside_them_and_see_inner_sites_as_obstacles():
    polygons = (
        Polygon("Outer", box(0, 0, 20, 20), ("Plot",)),
        Polygon("Inner", box(2, 2, 6, 6), ("Plot",)),
        Polygon("Tree", box(3, 3, 1, 1), ("Tree",)),
        Polygon("Pond", box(12, 12, 3, 3), ("Pond",)),
        Polygon("Street", box(0, -5, 20, 5), ("Street",)),
    )
    outer, inner = sites_of(Scene("s", "m", polygons), ("Plot",))
    assert [(p.name, p.labels) for p in outer.polygons] == [
        ("Outer", ("Plot",)),
        ("Inner", ()),
        ("Pond", ("Pond",)),
    ]
    assert [p.name for p in inner.polygons] == ["Inner", "Tree"]


def test_everything_of_the_scene_lies_on_the_ground_once(stages):
    polygons = (*scene(*PLOTS).polygons, Polygon("Street", box(0, -5, 100, 4), ("Street",)))
    operations = tree(Node(Select(labels=("Plot",))), sites=("Plot",))
    world = replayed(stages, operations, Scene("s", "m", polygons))
    assert sorted(p.name for p in world.ground) == sorted(p.name for p in polygons)


def test_units_that_differ_are_refused(stages):
    with pytest.raises(Faulty) as raised:
        replayed(stages, Operations("t", "px", ()), scene(*PLOTS))
    assert [d.code for d in raised.value.diagnostics] == ["LK881"]


def test_outputs_and_parts_are_known_by_node(stages):
    select = Node(Select(labels=("Plot",)), (), (Branch((RANDOM,)), Branch(())))
    replay = Replay(tree(select), Context(stages, (0,)))
    replay.on(Site.of(scene(*PLOTS)))
    assert len(replay.outputs[0]) == 9
    assert set(replay.parts[0, 0]) | set(replay.parts[0, 1]) == set(replay.outputs[0])
    assert set(replay.outputs[2]) == set(replay.parts[0, 0])


def test_a_site_that_fails_is_told_and_takes_no_other_with_it(stages):
    operations = tree(Node(FailsOnD(), RANDOM.children), sites=("Plot",))
    outcome = next(iter(stages("replay", scene(*PLOTS), operations=operations, seed=3)))
    alone = replayed(stages, tree(RANDOM, sites=("Plot",)), scene(*PLOTS), 3)
    built = heights(outcome.document)
    assert built == {name: height for name, height in heights(alone).items() if name != "D"}
    (told,) = outcome.diagnostics
    assert (told.severity, told.code) == (Severity.ERROR, "LK901")


@dataclass(frozen=True, kw_only=True)
class FailsOnD(Operation):
    """It cannot be done on one of the sites."""

    kind: ClassVar[str] = "fails-on-d"
    summary: ClassVar[str] = "Fails."

    def apply(self, scope, site, context):
        if "D" in scope:
            raise KeyError("D")
        return Result(site, scope)


def test_sites_in_sites_are_built_once(stages):
    inner = Polygon("Inner", box(2, 2, 4, 4), ("Plot",))
    every = Scene("built", "m", (Polygon("Outer", box(0, 0, 10, 10), ("Plot",)), inner))
    world = replayed(stages, tree(RANDOM, sites=("Plot",)), every)
    assert sorted(heights(world)) == ["Inner", "Outer"]
    assert not world.ground


def test_labels_that_match_nothing_are_told(stages):
    wrong = tree(Node(Select(labels=("Plto",))))
    outcome = next(iter(stages("replay", scene(*PLOTS), operations=wrong)))
    assert [(d.code, "'Plot'" in d.hint) for d in outcome.diagnostics] == [("LK888", True)]
    matched = tree(Node(Select(labels=("Plto", "Plot"))))
    assert not next(iter(stages("replay", scene(*PLOTS), operations=matched))).diagnostics
    with pytest.raises(Faulty, match="@Parcel"):
        replayed(stages, tree(RANDOM, sites=("Parcel",)), scene(*PLOTS))
