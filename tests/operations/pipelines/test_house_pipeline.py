"""Houses on plots: every plot has one within it that faces the street, and all of it is sound."""

from pathlib import Path

import numpy as np
import pytest
import shapely
from pipeline_replays import documents_of
from site_replays import assert_drawn, bare, built, designs_of, dressed

from facades.draft import pipeline_files
from layoutkit.model import Layout, Scene
from layoutkit.operations.sites import sites_of
from layoutkit_operations.checking import faults_of, volume

REAL = Path(__file__).parents[3] / ".." / "shared" / "data" / "city" / "bubenec.gpkg"


@pytest.fixture(scope="module")
def documents(stages):
    return documents_of("houses", stages.host)


@pytest.fixture(scope="module")
def village(documents, stages):
    return built(*documents, stages, seed=0)


def houses_in(site):
    """The elements that are houses, or parts of these, and not trees."""
    return [e for e in site.elements.values() if {"House", "Core", "Wing"} & set(e.labels)]


def footprint(site):
    return shapely.union_all([shapely.Polygon(element.points) for element in houses_in(site)])


def ground_of(site):
    return shapely.Polygon(site.elements[site.name].points)


def test_the_documents_are_those_that_the_scripts_draft():
    for file, data in pipeline_files("houses"):
        assert file.read_bytes() == data, file.name


def test_designs_are_faultless_keep_their_own_constraints_and_are_drawn(stages):
    designs = designs_of("houses", stages.host)
    assert len(designs) == 6
    for file, facade in designs.items():
        assert Layout(facade.name, facade.units, facade.root, facade).violations() == ()
        assert_drawn(file, facade)


def test_nothing_is_told(village):
    assert village.told == ()


def test_every_body_is_closed_and_has_a_volume(village):
    assert [fault for body in village.world.bodies for fault in faults_of(body)] == []
    assert all(volume(body) > 0 for body in village.world.bodies)


def test_every_plot_has_one_house_and_it_lies_inside(village):
    assert len(village.sites) >= 30
    for site in village.sites.values():
        solids = {element.solid for element in houses_in(site)}
        assert len(solids) == 1, site.name
        assert footprint(site).difference(ground_of(site)).area < 1e-6, site.name


def test_houses_face_the_street(village):
    """The door is in a wall that looks where the plot's front edge does, and is near to it."""
    for site in village.sites.values():
        edge = dict(site.elements[site.name].edges)
        assert edge, site.name
        points = np.array(site.elements[site.name].points)
        fronts = shapely.MultiLineString(
            [points[[number, (number + 1) % len(points)]].tolist() for number in edge]
        )
        doors = [
            surface
            for surface in dressed(site)
            if any("Door" in region.labels for region in regions(surface.dressing.layout.root))
        ]
        assert doors, site.name
        assert all("Front" in surface.labels for surface in doors)
        assert footprint(site).distance(fronts) < 12.0, site.name


def regions(region):
    yield region
    for child in region.children:
        yield from regions(child)


def test_all_walls_are_facades_that_keep_to_their_designs(village):
    for site in village.sites.values():
        assert bare(site, 1.0, 1.0) == [n for n in bare(site, 1.0, 1.0) if "Tree" in n or "Chimney" in n]
        assert all(surface.dressing.layout.violations() == () for surface in dressed(site))


def test_houses_differ_from_each_other(village):
    """All branches occur: kinds of roofs, designs, wings and chimneys that are one with the house."""
    surfaces = [s for site in village.sites.values() for s in site.surfaces.values()]
    designs = {s.dressing.design.file for s in surfaces if s.dressing is not None}
    assert len(designs) == 6
    kinds = {label for s in surfaces for label in s.labels} | {
        label for site in village.sites.values() for element in houses_in(site) for label in element.labels
    }
    assert {"Roof", "Gable", "Top", "House", "Core", "Wing"} <= kinds
    assert any("Chimney" in s.name and s.solid.endswith("House_1") for s in surfaces)
    heights = [np.ptp(body.points[:, 2]) for body in village.world.bodies if "House" in body.labels]
    assert len({round(float(height), 2) for height in heights}) >= 10


def test_trees_stand_clear_of_houses(village):
    trees = 0
    for site in village.sites.values():
        for element in site.elements.values():
            if "Tree" in element.labels:
                trees += 1
                crown = shapely.Polygon(element.points)
                assert crown.intersection(footprint(site)).area <= 0.2 * crown.area
                assert element.solid == element.name
    assert trees >= len(village.sites)


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [1, 2])
def test_other_seeds_are_sound_as_well(documents, stages, seed):
    operations, scene = documents
    some = [site.name for site in sites_of(scene, operations.sites)][seed::8]
    part = Scene(scene.name, scene.units, tuple(p for p in scene.polygons if p.name in some))
    found = built(operations, part, stages, seed)
    assert found.told == ()
    assert [fault for body in found.world.bodies for fault in faults_of(body)] == []


@pytest.mark.skipif(not REAL.is_file(), reason="the data of a real city are not here")
def test_real_plots_get_houses_inside_of_them(documents, stages):
    """Plots without fronts and of any shape: nearly all with room for a house have one."""
    operations, _ = documents
    scene, _ = stages.host.scene_formats.find("geopackage").read(REAL, "plots")
    roomy = [p for p in scene.polygons if is_roomy(shapely.Polygon(p.points))]
    chosen = [roomy[n] for n in np.random.default_rng(5).choice(len(roomy), 8, replace=False)]
    found = built(operations, Scene(scene.name, scene.units, tuple(chosen)), stages, seed=0)
    assert {diagnostic.code for diagnostic in found.told} <= {"LK875"}
    assert [fault for body in found.world.bodies for fault in faults_of(body)] == []
    housed = [site for site in found.sites.values() if houses_in(site)]
    inside = [site for site in housed if footprint(site).difference(ground_of(site)).area < 1e-6]
    assert len(housed) >= 7
    assert len(inside) >= 7


def is_roomy(plot):
    return plot.area >= 60 and shapely.maximum_inscribed_circle(plot).length >= 4
