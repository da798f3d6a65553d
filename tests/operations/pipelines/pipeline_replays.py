"""What tests of pipelines are made of: their documents replayed, and what stands where."""

from dataclasses import dataclass

import shapely

from layoutkit.documents import read_operations, read_scene
from layoutkit.model import Scene, World
from layoutkit.operations import Context, Operations, Site
from layoutkit.samples import list_pipelines


@dataclass(frozen=True)
class Replayed:
    """A scene with operations made on it, the site and the world that came of it, and what was told."""

    scene: Scene
    site: Site
    world: World
    told: tuple


def documents_of(name, host) -> tuple[Operations, Scene]:
    """The operations of a pipeline, and its first scene, as their documents have them."""
    sample = next(sample for sample in list_pipelines() if sample.name == name)
    operations = read_operations(sample.operations, host.operations, host.constraints).operations
    return operations, read_scene(sample.scenes[0]).scene


def replayed(operations, scene, stages, seed) -> Replayed:
    """What comes of operations without sites on a scene."""
    from layoutkit_operations import replaying

    made = replaying.replayed(operations, scene, Context(stages, (seed,)))
    return Replayed(scene, made.sites[0], made.world, tuple(made.context.told))


def placed(site, label):
    """By name, polygons of what was placed in the elements of a label, themselves."""
    inside = {e.name: e for e in site.elements.values() if label in e.labels}
    found = {}
    for element in site.elements.values():
        if element.parent in inside:
            found[element.name] = shapely.Polygon(element.points)
    return found


def overlap(one, other):
    """How much of the smaller of two polygons the other one covers, as a share."""
    return one.intersection(other).area / min(one.area, other.area)
