"""Towers on sites: one solid each, of podium, shafts and what draws back, and all of it is sound."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
from pipeline_replays import documents_of
from site_replays import assert_drawn, bare, built, designs_of, dressed

from facades.draft import pipeline_files
from layoutkit.model import Layout
from layoutkit_operations.checking import faults_of, volume


@pytest.fixture(scope="module")
def documents(stages):
    return documents_of("towers", stages.host)


@pytest.fixture(scope="module")
def quarter(documents, stages):
    return built(*documents, stages, seed=0)


def test_the_documents_are_those_that_the_scripts_draft():
    for file, data in pipeline_files("towers"):
        assert file.read_bytes() == data, file.name


def test_designs_are_faultless_keep_their_own_constraints_and_are_drawn(stages):
    designs = designs_of("towers", stages.host)
    assert len(designs) == 3
    for file, facade in designs.items():
        assert Layout(facade.name, facade.units, facade.root, facade).violations() == ()
        assert_drawn(file, facade)


def test_nothing_is_told(quarter):
    assert quarter.told == ()


def test_every_body_is_closed_and_has_a_volume(quarter):
    assert [fault for body in quarter.world.bodies for fault in faults_of(body)] == []
    assert all(volume(body) > 0 for body in quarter.world.bodies)


def test_every_site_has_one_tower_within_it_of_all_that_was_placed(quarter):
    for site in quarter.sites.values():
        whole = f"{site.name}.Podium_1"
        assert {n for n in site.solids if "Pavilion" not in n} == {whole}
        podium = shapely.Polygon(site.elements[whole].points)
        ground = shapely.Polygon(site.elements[site.name].points)
        assert podium.difference(ground).area < 1e-6
        merged = [e for e in site.elements.values() if e.solid == whole]
        assert len(merged) >= 3


def test_towers_are_of_three_kinds_and_differ(quarter):
    labels = [
        {label for e in site.elements.values() for label in e.labels} for site in quarter.sites.values()
    ]
    assert any({"Shaft", "Crown", "Cap", "Mast"} <= own for own in labels)
    assert any({"Slab", "Notch"} <= own for own in labels)
    assert any("Tower" in own for own in labels)
    heights = [float(np.ptp(b.points[:, 2])) for b in quarter.world.bodies if "Podium" in b.labels]
    assert min(heights) > 30
    assert len({round(height, 2) for height in heights}) == len(heights)


def test_twins_stand_apart_and_one_is_taller(quarter):
    for site in quarter.sites.values():
        twins = [e for e in site.elements.values() if "Tower" in e.labels]
        if twins:
            one, other = twins
            assert shapely.Polygon(one.points).distance(shapely.Polygon(other.points)) > 0
            tops = [
                s.frame.origin[2]
                for e in twins
                for s in site.surfaces.values()
                if s.element == e.name and "Top" in s.labels
            ]
            assert abs(tops[0] - tops[1]) > 0.5


def test_a_notch_takes_something_away(quarter):
    for site in quarter.sites.values():
        notches = [e for e in site.elements.values() if "Notch" in e.labels]
        for notch in notches:
            slab = site.elements[site.surfaces[notch.surface].element]
            sides = [s for s in site.surfaces.values() if s.element == slab.name and "Side" in s.labels]
            cut = [s for s in sides if len(s.outlines[0]) > 4]
            assert len(cut) == 2
            floor = [s for s in site.surfaces.values() if s.element == notch.name and "Top" in s.labels]
            assert [s.frame.out for s in floor] == [pytest.approx((0, 0, 1))]


def test_all_walls_are_facades_that_keep_to_their_designs(quarter):
    designs = set()
    for site in quarter.sites.values():
        # Masts are too slender, and boxes of machinery on twins have none.
        left = [name for name in bare(site, 1.2, 1.2) if "Tower_" not in name or "Cap_" not in name]
        assert left == []
        assert all(surface.dressing.layout.violations() == () for surface in dressed(site))
        designs |= {surface.dressing.design.file for surface in dressed(site)}
    assert designs == {"curtain.xml", "podium.xml", "punched.xml"}


def test_pavilions_are_round_under_hips(quarter):
    pavilions = [body for body in quarter.world.bodies if "Pavilion" in body.labels]
    assert len(pavilions) == 2
    for body in pavilions:
        assert sum("Roof" in surface.labels for surface in body.surfaces) == 8
        assert sum("Side" in surface.labels for surface in body.surfaces) == 8


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [1, 2])
def test_other_seeds_are_sound_as_well(documents, stages, seed):
    operations, scene = documents
    some = tuple(p for p in scene.polygons if p.name in ("Site_2", f"Site_{3 + seed}"))
    found = built(operations, replace(scene, polygons=some), stages, seed)
    assert found.told == ()
    assert [fault for body in found.world.bodies for fault in faults_of(body)] == []
