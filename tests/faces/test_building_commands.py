"""Buildings on the command line: what is refused, shown, checked and drawn."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import trimesh
from PIL import Image
from walls import DESIGN, building, design

from layoutkit.constraints import Frequency
from layoutkit.documents import facade_bytes, layout_bytes, mass_bytes
from layoutkit.model import Block, Facade, Mass, Measure, Region, RegionSet

Run = Callable[..., Any]
RULE = Frequency(of=RegionSet("@Door"), within="H", min=Measure(1.0))
MASS = Mass(
    (
        Block(width=8.5, depth=6.0, height=9.5),
        Block(name="Up", x=1, y=1, width=3, depth=3, height=2, base=9.5),
    )
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A design, a mass, and a layout of two walls."""
    (tmp_path / "facade.xml").write_bytes(facade_bytes(design(RULE)))
    (tmp_path / "mass.xml").write_bytes(mass_bytes(MASS, "house", "m"))
    _, layout = building([DESIGN, replace(DESIGN, base=2.0)], RULE)
    (tmp_path / "layout.xml").write_bytes(layout_bytes(replace(layout, facade_file="facade.xml")))
    return tmp_path


def test_a_mass_is_shown_as_its_faces(folder: Path, layoutkit: Run) -> None:
    lines = layoutkit("inspect", folder / "mass.xml").out.splitlines()
    assert lines[:2] == ["mass house: 8 faces, m", "South 8.5 × 9.5"]
    assert lines[-1] == "Up_West 3 × 2 from 9.5 up"
    data = layoutkit("inspect", folder / "mass.xml", "--json").data
    assert (data["kind"], data["name"], data["units"]) == ("mass", "house", "m")
    assert data["faces"][1] == {"name": "East", "width": 6.0, "height": 9.5, "base": 0.0}


def test_a_buildings_layout_is_shown_with_its_faces_side_by_side(folder: Path, layoutkit: Run) -> None:
    out = layoutkit("inspect", folder / "layout.xml").out
    assert "Building 17 × 11.5 faces" in out
    assert "Wall2 8.5 × 9.5 from 2 up rows" in out
    regions = layoutkit("inspect", folder / "layout.xml", "--json").data["regions"]
    boxes = {region["path"]: region["box"] for region in regions}
    assert boxes["Building/Wall2"] == [8.5, 2.0, 17.0, 11.5]


def test_masses_and_layouts_of_buildings_are_validated(folder: Path, layoutkit: Run) -> None:
    run = layoutkit("validate", folder / "mass.xml", folder / "layout.xml")
    assert (run.code, run.err) == (0, "")
    (folder / "bad.xml").write_text('<mass xmlns="urn:layoutkit:1" name="m" units="m"><box/></mass>')
    run = layoutkit("validate", folder / "bad.xml", "--json")
    assert run.code == 1
    assert {d["code"] for d in run.data["diagnostics"]} == {"LK104"}


def test_a_building_is_drawn_as_a_strip_and_as_a_model(folder: Path, layoutkit: Run) -> None:
    for suffix in ("png", "svg", "glb"):
        assert layoutkit("render", folder / "layout.xml", "-o", folder / f"out.{suffix}").code == 0
    with Image.open(folder / "out.png") as image:
        assert image.size == (850, 575)
        assert image.getpixel((100, 10)) == (255, 255, 255)  # nothing stands above the lower wall
        assert image.getpixel((600, 10)) != (255, 255, 255)
    scene = trimesh.load(io.BytesIO((folder / "out.glb").read_bytes()), file_type="glb")
    assert {name.split()[0] for name in scene.geometry} == {"Wall1", "Wall2"}
    assert scene.bounds[:, 1] == pytest.approx([0.0, 11.5])


def test_a_facade_by_itself_is_a_wall(folder: Path, layoutkit: Run) -> None:
    assert layoutkit("render", folder / "facade.xml", "-o", folder / "wall.glb").code == 0
    scene = trimesh.load(io.BytesIO((folder / "wall.glb").read_bytes()), file_type="glb")
    assert scene.bounds.ravel() == pytest.approx([0.0, 0.0, -0.25, 8.5, 9.5, 0.0])


@pytest.mark.parametrize(
    ("arguments", "code", "diagnostic"),
    [
        (["--mass", "none.xml"], 1, "LK001"),
        (["--mass", "facade.xml"], 1, "LK101"),
        (["--mass", "mass.xml", "--width", "120%"], 2, "LK706"),
        (["--mass", "mass.xml", "--height", "12"], 2, "LK706"),
        (["--mass", "pixels.xml"], 1, "LK503"),
        (["--mass", "broken.xml"], 1, "LK106"),
    ],
    ids=lambda value: value if isinstance(value, str) else None,
)
def test_what_cannot_be_dressed_is_refused(
    arguments: list[str],
    code: int,
    diagnostic: str,
    folder: Path,
    layoutkit: Run,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(folder)
    (folder / "pixels.xml").write_bytes(mass_bytes(MASS, "house", "px"))
    (folder / "broken.xml").write_bytes(mass_bytes(MASS, "house", "m").replace(b'"8.5"', b'"0"'))
    run = layoutkit("vary", "facade.xml", "-n", 1, "-o", "out", *arguments)
    assert (run.code, diagnostic in run.err) == (code, True)
    assert not (folder / "out").exists()


def test_vary_still_wants_a_facade(folder: Path, layoutkit: Run) -> None:
    run = layoutkit("vary", folder / "mass.xml", "-o", folder / "out")
    assert run.code == 1
    assert "LK101" in run.err


def test_depth_and_material_are_kept_in_variations(folder: Path, layoutkit: Run) -> None:
    run = layoutkit("vary", folder / "facade.xml", "-n", 1, "--width", "110%", "-o", folder / "out", "--json")
    assert run.code == 0
    text = Path(run.data["variations"][0]["layout"]).read_text()
    assert text.count('depth="-0.25" material="glass"') == text.count('symbol="Window"') + text.count(
        'symbol="Door"'
    )
    assert "<mass" not in text


def test_a_terminal_root_makes_a_model_as_well(folder: Path, layoutkit: Run) -> None:
    (folder / "one.xml").write_bytes(facade_bytes(Facade("one", "m", Region("F", 2.0, 1.0, depth=0.5))))
    assert layoutkit("render", folder / "one.xml", "-o", folder / "one.glb").code == 0
    scene = trimesh.load(io.BytesIO((folder / "one.glb").read_bytes()), file_type="glb")
    assert scene.bounds.ravel() == pytest.approx([0.0, 0.0, 0.0, 2.0, 1.0, 0.5])
