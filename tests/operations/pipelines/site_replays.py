"""What tests of pipelines with sites are made of: every site replayed, and all of them as one world."""

from dataclasses import dataclass

import numpy as np
from PIL import Image

from facades.painting.canvas import paint
from layoutkit.documents import check, read
from layoutkit.model import Facade, Scene, World
from layoutkit.operations import Context, Site
from layoutkit.samples import list_pipelines


@dataclass(frozen=True)
class Built:
    """A scene with operations made on it: its sites, the world that came of them, and what was told."""

    scene: Scene
    sites: dict[str, Site]
    world: World
    told: tuple


def built(operations, scene, stages, seed) -> Built:
    """What comes of operations on the sites of a scene."""
    from layoutkit_operations.replaying import replayed

    made = replayed(operations, scene, Context(stages, (seed,)))
    return Built(scene, {site.name: site for site in made.sites}, made.world, tuple(made.context.told))


def dressed(site):
    """The surfaces of a site that have facades."""
    return [surface for surface in site.surfaces.values() if surface.dressing is not None]


def bare(site, least_width, least_height):
    """The names of upright sides of a site with room for a facade, that have none."""
    found = []
    for surface in site.surfaces.values():
        if "Side" in surface.labels and surface.dressing is None:
            widths, heights = (np.ptp(values) for values in zip(*surface.outlines[0], strict=True))
            if widths >= least_width and heights >= least_height:
                found.append(surface.name)
    return found


def designs_of(name, host):
    """The facades in the folder of a pipeline, by their files; every one is checked, and keeps to itself."""
    sample = next(sample for sample in list_pipelines() if sample.name == name)
    found = {}
    for file in sorted(sample.operations.parent.glob("*.xml")):
        assert check(file, host.constraints, host.operations) == []
        if file not in (sample.operations, *sample.scenes):
            found[file] = read(file, host.constraints).model
            assert isinstance(found[file], Facade)
    return found


def assert_drawn(file, facade):
    """The picture of a facade is the one that the script draws, but for a pixel along slanted edges."""
    kept = np.asarray(Image.open(file.parent / facade.picture.file).convert("RGB")).astype(int)
    drawn = np.asarray(paint(facade)).astype(int)
    assert drawn.shape == kept.shape
    assert np.abs(drawn - kept).mean() < 1.0
