"""Our own pipelines on random plots from random seeds: closed solids, openings in place, facades as ruled.

The checks here share nothing with those of the program.
"""

import io
import math
import re
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh
from built import box, open_edges

from layoutkit.documents.operations import read_operations
from layoutkit.model import Polygon, Scene
from layoutkit.operations import Context
from layoutkit.pictures.worlds.glb import render_world_glb
from layoutkit.sizing.threads import single_threaded
from layoutkit_operations import replaying

FACADES = Path(__file__).parents[3] / "facades"
#: Where the coordinates of surveys lie, in metres.
FAR = (512_300.0, 5_548_700.0)
#: As a share of a body's size.
NEAR = 1e-6
#: How far the ends of a wall move at most for each unit of depth: facades go on round 135 degrees.
STEEPEST = math.tan(math.radians(135 / 2))


@dataclass
class Pipeline:
    """Operations, and what is kept from one replay of them to the next."""

    operations: object
    kept: dict = field(default_factory=dict)

    def replayed(self, stages, scene, seed):
        """The world that comes of a scene, and the sites that it is made of."""
        made = replaying.replayed(self.operations, scene, Context(stages, (seed,), kept=self.kept))
        return made.world, list(made.sites)


@pytest.fixture(scope="module")
def pipelines(stages):
    host = stages.host
    return {
        name: Pipeline(
            read_operations(FACADES / name / "operations.xml", host.operations, host.constraints).operations
        )
        for name in ("houses", "towers")
    }


def convex(random):
    """Corners at random on an ellipse, no two very near."""
    count = int(random.integers(3, 9))
    angles = (np.arange(count) + random.uniform(-0.3, 0.3, count)) * 2 * math.pi / count
    return tuple(
        zip((random.uniform(1, 2.5) * np.cos(angles)).tolist(), np.sin(angles).tolist(), strict=True)
    )


def with_a_notch(random):
    """A rectangle without one of its corners: an L."""
    wide, (across, up) = float(random.uniform(1, 2)), random.uniform(0.3, 0.7, 2).tolist()
    return ((0, 0), (wide, 0), (wide, up), (across * wide, up), (across * wide, 1), (0, 1))


def plot(random, label):
    """A plot of 100 to 2,000 m², turned, some of them far from the origin, some with a front."""
    outline = (convex if random.random() < 0.6 else with_a_notch)(random)
    size = math.exp(random.uniform(math.log(100), math.log(2000)))
    scale = math.sqrt(size / shapely.Polygon(outline).area)
    turn, (x, y) = random.uniform(0, 2 * math.pi), FAR if random.random() < 0.3 else (0.0, 0.0)
    cosine, sine = scale * math.cos(turn), scale * math.sin(turn)
    points = tuple((x + u * cosine - v * sine, y + u * sine + v * cosine) for u, v in outline)
    own = Polygon("Plot_1", points, (label,))
    if label != "Plot":
        return own
    (x0, y0), (x1, y1) = points[:2]
    return replace(own, edges=((0, ("Front",)),), angle=math.degrees(math.atan2(y1 - y0, x1 - x0)))


def drawn(number):
    """Which pipeline, scene and seed a number stands for; every tenth is a tower."""
    random = np.random.default_rng(number)
    name = "towers" if number % 10 == 9 else "houses"
    label = "Site" if name == "towers" else ("Plot", "plots")[number % 2]
    return name, Scene("drawn", "m", (plot(random, label),)), int(random.integers(2**31))


def volume_of(body):
    a, b, c = np.moveaxis(body.points[body.triangles] - body.points[0], 1, 0)
    return float(np.linalg.det(np.stack([a, b, c], axis=1)).sum()) / 6


def faults_of_openings(body):
    """What is wrong with openings, from the triangles that they are made of."""
    near = NEAR * float(np.ptp(body.points, axis=0).max())
    for number, opening in enumerate(body.openings):
        surface = body.surfaces[opening.surface]
        corners = body.points[body.triangles[body.opening == number]] + body.origin
        if not len(corners):
            yield f"{opening.name} has no triangles"
            continue
        frame = surface.frame
        own = (corners - frame.origin) @ np.array([frame.right, frame.up, frame.out]).T
        if np.abs(own[..., 2] - opening.depth).max() > near:
            yield f"{opening.name} stands {own[..., 2].min()} before {surface.name}, not {opening.depth}"
        outline = shapely.Polygon(opening.outline)
        # Where walls meet at an angle, what is deep is stretched along them, to meet round the corner.
        stretch = STEEPEST * abs(opening.depth) * np.array([1, 0, 1, 0]) + near
        shown = np.concatenate([own[..., :2].min(axis=(0, 1)), own[..., :2].max(axis=(0, 1))])
        if (np.abs(shown - outline.bounds) > stretch).any():
            yield f"{opening.name} is shown at {shown}, not at {outline.bounds}"
        visible = shapely.union_all([shapely.Polygon(each) for each in surface.outlines])
        if outline.difference(visible).area > near * outline.length:
            yield f"{opening.name} reaches beyond {surface.name}"


def faults_of(world, sites):
    """What is wrong with a world."""
    for body in world.bodies:
        if edges := open_edges(body.triangles):
            yield f"{body.name} has {len(edges)} open edges"
        if (volume := volume_of(body)) <= 0:
            yield f"{body.name} has a volume of {volume}"
        yield from faults_of_openings(body)
    for site in sites:
        for name, surface in site.surfaces.items():
            if surface.dressing is not None:
                yield from (f"{name}: {each}" for each in surface.dressing.layout.violations())


def faults_of_model(world):
    """What another reader finds in the model as it is written."""
    model = trimesh.load(io.BytesIO(render_world_glb(world)), file_type="glb")
    for body in world.bodies:
        # trimesh has a node for each primitive, and names them so.
        own = re.compile(re.escape(body.name) + r"(_[0-9a-f]{6})?")
        meshes = [model.geometry[model.graph[n][1]] for n in model.graph.nodes_geometry if own.fullmatch(n)]
        whole = trimesh.util.concatenate(
            [trimesh.Trimesh(m.vertices, m.faces, process=False) for m in meshes]
        )
        whole.merge_vertices()
        if not whole.is_watertight or whole.volume <= 0:
            yield f"{body.name} in the model: watertight {whole.is_watertight}, volume {whole.volume}"


def checked(stages, pipelines, numbers):
    """All faults of replays, each with its number; and what there was to check."""
    faults, counts = [], Counter()
    with single_threaded():
        for number in numbers:
            name, scene, seed = drawn(number)
            world, sites = pipelines[name].replayed(stages, scene, seed)
            found = [*faults_of(world, sites), *(faults_of_model(world) if number % 10 in (0, 9) else ())]
            faults += [(number, name, seed, scene.polygons[0].points, each) for each in found]
            counts["built"] += bool(world.bodies)
            counts["solids"] += len(world.bodies)
            counts["openings"] += sum(len(body.openings) for body in world.bodies)
            counts["facades"] += sum(s.dressing is not None for site in sites for s in site.surfaces.values())
    return faults, counts


def test_some_replays_hold_what_they_promise(stages, pipelines):
    faults, counts = checked(stages, pipelines, range(12))
    assert not faults
    assert counts["built"] >= 9
    assert counts["openings"] > counts["facades"] > counts["solids"] / 2


@pytest.mark.nightly
def test_a_thousand_replays_hold_what_they_promise(stages, pipelines):
    faults, counts = checked(stages, pipelines, range(1000))
    print(dict(counts))
    assert not faults, faults
    assert counts["built"] >= 900


def test_the_checks_find_what_is_wrong(stages, pipelines):
    _, scene, seed = drawn(0)
    scene = replace(scene, polygons=(replace(scene.polygons[0], points=box(0, 0, 20, 25)),))
    world, sites = pipelines["houses"].replayed(stages, scene, seed)
    body = next(each for each in world.bodies if each.openings)
    assert not list(faults_of(world, sites))
    first = body.openings[0]
    wrong = {
        "open edges": replace(body, triangles=body.triangles[1:]),
        "volume": replace(body, triangles=body.triangles[:, ::-1]),
        "stands": replace(body, openings=(replace(first, depth=1.0), *body.openings[1:])),
        "reaches beyond": replace(body, openings=(moved(first), *body.openings[1:])),
    }
    for words, other in wrong.items():
        assert any(words in each for each in faults_of(replace(world, bodies=(other,)), ()))


def moved(opening):
    return replace(opening, outline=tuple((x + 50, y) for x, y in opening.outline))
