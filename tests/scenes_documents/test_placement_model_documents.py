"""Placement models: read back as written, their settings those of the model, every fault at its place."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Faulty
from layoutkit.documents import (
    Source,
    check,
    is_placement_model,
    placement_model_bytes,
    read_placement_model,
    schema,
)
from layoutkit.documents.scene_grammar import PLACEMENT_MODEL
from layoutkit.model import Example, LearningSettings, Placement, PlacementModel, Polygon, Scene
from tests.scenes_documents.drawn_scenes import PLACEMENTS, TEXT, scenes

KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))
VALUES: dict[type, st.SearchStrategy[Any]] = {
    float: st.floats(0, 1e6),
    int: st.integers(0, 10**9),
    bool: st.booleans(),
    str: TEXT,
    tuple: st.lists(st.sampled_from(("boundary-distance", "corner-angle", "x2")), max_size=3).map(tuple),
}
SETTINGS = st.builds(LearningSettings, **{f.name: VALUES[type(f.default)] for f in fields(LearningSettings)})
HEAD = '<placement-model xmlns="urn:layoutkit:1" name="sills" units="px" label="Sill"'
EXAMPLE = (
    '<example name="e"><placement x="0" y="0" width="2" height="1" label="Sill"/>'
    '<polygon name="w" points="0,0 1,0 1,1" labels="Window"/></example>'
)


@st.composite
def models(draw: st.DrawFn) -> PlacementModel:
    units = draw(st.sampled_from(("m", "px")))
    examples = []
    for _ in range(draw(st.integers(1, 3))):
        scene = replace(draw(scenes()), units=units, picture=None, placements=())
        first, *beside = (
            replace(placed, label="Sill") for placed in draw(st.lists(PLACEMENTS, min_size=1, max_size=3))
        )
        examples.append(Example(scene, first, tuple(beside)))
    return PlacementModel(draw(TEXT), units, "Sill", tuple(examples), draw(SETTINGS))


@given(models())
def test_what_is_written_is_read(model: PlacementModel) -> None:
    written = placement_model_bytes(model)
    SCHEMA.assertValid(etree.fromstring(written))
    found = read_placement_model(Source("m.xml", written))
    assert (found.model, found.diagnostics) == (model, ())
    assert placement_model_bytes(found.model) == written


def test_every_setting_is_an_attribute_with_its_help() -> None:
    for field in fields(LearningSettings):
        attribute = PLACEMENT_MODEL.attributes[field.name.replace("_", "-")]
        assert (attribute.default, attribute.help) == (field.default, field.metadata["help"])
    found = read_placement_model(Source("m.xml", f"{HEAD}>{EXAMPLE}</placement-model>".encode()))
    assert found.model.settings == LearningSettings()


def test_placements_of_an_examples_scene_become_polygons() -> None:
    scene = Scene("s", "m", (Polygon("a", ((0, 0), (1, 0), (1, 1))),), (Placement(1, 1, 2, 1, label="Sill"),))
    model = PlacementModel("m", "m", "Sill", (Example(scene, scene.placements[0]),))
    read = read_placement_model(Source("m.xml", placement_model_bytes(model))).model
    assert read.examples[0].scene == scene.settled()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (f"{HEAD}>\n</placement-model>", ["LK107 1"]),
        (f"{HEAD}>\n<example/></placement-model>", ["LK107 2"]),
        (f"{HEAD}>\n{EXAMPLE.replace('Sill', 'Door')}</placement-model>", ["LK105 2"]),
        (f"{HEAD}>\n{EXAMPLE.replace(' name=', ' nama=', 1)}</placement-model>", ["LK103 2"]),
        (f"{HEAD}>\n{EXAMPLE.replace('0,0 1,0 1,1', '0,0 1,0')}</placement-model>", ["LK851 2"]),
        (f"{HEAD}>\n<polygon points='0,0 1,0 1,1'/></placement-model>", ["LK108 2"]),
        (f"{HEAD} reach='-1'>\n{EXAMPLE}</placement-model>", ["LK105 1"]),
        (f"{HEAD} hierarchy='perhaps'>\n{EXAMPLE}</placement-model>", ["LK105 1"]),
        (f"{HEAD} relationships='Boundary'>\n{EXAMPLE}</placement-model>", ["LK105 1"]),
        (f"{HEAD} reech='2'>\n{EXAMPLE}</placement-model>", ["LK103 1"]),
        (HEAD.replace("label", "lable") + f">\n{EXAMPLE}</placement-model>", ["LK103 1"]),
        ('<placement-model xmlns="urn:layoutkit:1"/>', ["LK104 1"] * 3 + ["LK107 1"]),
        ('<model xmlns="urn:layoutkit:1"/>', ["LK101 1"]),
    ],
)
def test_faults(text: str, expected: list[str], tmp_path: Path) -> None:
    path = tmp_path / "model.xml"
    path.write_text(text)
    with pytest.raises(Faulty) as raised:
        read_placement_model(path)
    assert [f"{d.code} {d.place.line}" for d in raised.value.diagnostics if d.place] == expected
    assert all(d.hint for d in raised.value.diagnostics)
    assert bool(check(path, KINDS))


def test_what_is_a_placement_model() -> None:
    assert is_placement_model(Source("-", HEAD.encode() + b">"))
    assert not is_placement_model(Source("-", b"<scene/>"))
