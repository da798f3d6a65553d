"""Documents of masses, of buildings' layouts, of regions with a depth: there and back, and their faults."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree
from walls import DESIGN, Wall, building, design

from layoutkit.constraints import BUILT_IN, Frequency, Size
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import (
    check,
    facade_bytes,
    is_mass,
    layout_bytes,
    mass_bytes,
    read,
    read_mass,
    schema,
)
from layoutkit.model import Block, Facade, Footprint, Layout, Mass, Measure, Part, Region, RegionSet
from layoutkit.model.outline import fault

KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))

NUMBERS = st.floats(-1e4, 1e4).map(lambda value: round(value, 5))
SIZES = st.floats(0.01, 1e4)
PARTS: st.SearchStrategy[Part] = st.one_of(
    st.builds(Block, height=SIZES, base=NUMBERS, x=NUMBERS, y=NUMBERS, width=SIZES, depth=SIZES),
    st.builds(
        Footprint,
        height=SIZES,
        base=NUMBERS,
        points=st.lists(st.tuples(NUMBERS, NUMBERS), min_size=3, max_size=6, unique=True).map(tuple),
        around=st.booleans(),
        corner=st.floats(1, 179),
    ).filter(lambda part: not fault(part.points, part.closed)),
)


@given(st.lists(PARTS, min_size=1, max_size=4))
def test_masses_read_back(tmp_path_factory: pytest.TempPathFactory, parts: list[Part]) -> None:
    mass = Mass(tuple(replace(part, name=f"Part{n}") for n, part in enumerate(parts)))
    if not mass.faces:
        return
    path = tmp_path_factory.mktemp("m") / "mass.xml"
    path.write_bytes(mass_bytes(mass, "a & b", "px"))
    found = read_mass(path)
    assert (found.mass, found.name, found.units) == (mass, "a & b", "px")
    assert SCHEMA.validate(etree.parse(path))
    assert is_mass(path)
    assert {d.severity for d in check(path, KINDS)} <= {Severity.NOTE}


@given(st.floats(-5, 5), st.sampled_from(["", "brick", "Grès de <Bourgogne> & chaux"]))
def test_depth_and_material_read_back(
    tmp_path_factory: pytest.TempPathFactory, depth: float, material: str
) -> None:
    inner = Region("A", 2.0, 1.0, depth=depth, material=material)
    root = Region("F", 2.0, 1.0, "columns", (inner,), depth=-depth, material=material)
    path = tmp_path_factory.mktemp("f") / "facade.xml"
    path.write_bytes(facade_bytes(Facade("f", "m", root)))
    assert read(path, KINDS).model == Facade("f", "m", root)
    assert SCHEMA.validate(etree.parse(path))


#: On a building: two doors at most for all, and storeys of the design's height on each face.
RULES = (
    Frequency(of=RegionSet("@Door"), within="H", max=Measure(2.0), scope="building"),
    Size(of=RegionSet("H/F"), min=Measure(3.0), max=Measure(3.0)),
)


def saved(folder: Path, walls: list[Wall]) -> Path:
    """Write the design, and walls as a layout of a building; return the layout's path."""
    _, layout = building(walls, *RULES)
    (folder / "facade.xml").write_bytes(facade_bytes(design(*RULES)))
    path = folder / "layout.xml"
    path.write_bytes(layout_bytes(replace(layout, facade_file="facade.xml")))
    return path


def test_a_buildings_layout_holds_all_that_is_needed(tmp_path: Path) -> None:
    walls = [DESIGN, replace(DESIGN, pier=1.25, base=2.0)]
    path = saved(tmp_path, walls)
    facade, layout = building(walls, *RULES)
    found = read(path, KINDS).model
    assert isinstance(found, Layout)
    assert (found.root, found.mass) == (layout.root, layout.mass)
    assert found.facade is not None
    assert found.facade.root == facade.root
    assert found.facade.faces == facade.faces
    assert found.facade.constraints == facade.constraints
    assert SCHEMA.validate(etree.parse(path))
    assert check(path, KINDS) == []
    (tmp_path / "facade.xml").unlink()
    assert [d.code for d in check(path, KINDS)] == ["LK504"]


def test_a_buildings_layout_is_held_against_the_constraints(tmp_path: Path) -> None:
    path = saved(tmp_path, [DESIGN, DESIGN, replace(DESIGN, storeys=(2.75, 2.75))])
    found = check(path, KINDS)
    assert [d.code for d in found] == ["LK502"] * 3
    assert "has 3 of @Door" in found[0].message
    assert [d.message.split(":")[0] for d in found[1:]] == ["Building/Wall3/F", "Building/Wall3/F.2"]


HEAD = '<mass xmlns="urn:layoutkit:1" name="m" units="m">'
LAYOUT = '<layout xmlns="urn:layoutkit:1" name="l" units="m">'
FACADE = '<facade xmlns="urn:layoutkit:1" name="f" units="m">'
BOX = '<box width="4" depth="3" height="5"/>'
WALL = '<footprint name="Wall" points="0,0 4,0" closed="no" height="5"/>'
DEEP = '<region symbol="F" width="4" height="5" depth="deep"/>'
FACE = '<region symbol="Wall" width="4" height="5"/>'


def building_of(faces: str, mass: str = f"<mass>{WALL}</mass>", size: str = 'width="4" height="5"') -> str:
    """A layout whose mass stands in line 2, and whose faces stand in line 4."""
    return f'{LAYOUT}\n{mass}\n<region symbol="Building" {size} split="faces">\n{faces}\n</region></layout>'


BROKEN: Mapping[str, tuple[str, list[str]]] = {
    "no part": (f"{HEAD}\n</mass>", ["LK107 1:1"]),
    "no namespace": (f'<mass name="m" units="m">\n{BOX}</mass>', ["LK101 1:1"]),
    "no units": (f'<mass xmlns="urn:layoutkit:1" name="m">\n{BOX}</mass>', ["LK104 1:1"]),
    "unknown part": (f"{HEAD}\n<cone/>{BOX}</mass>", ["LK102 2:1"]),
    "part out of place": (f"{HEAD}\n<region/>{BOX}</mass>", ["LK108 2:1"]),
    "misspelt": (f'{HEAD}\n<box widht="4" depth="3" height="5"/></mass>', ["LK103 2:1"]),
    "no depth": (f'{HEAD}\n<box width="4" height="5"/></mass>', ["LK104 2:1"]),
    "not a number": (f'{HEAD}\n<box x="inf" width="4" depth="3" height="5"/></mass>', ["LK105 2:1"]),
    "no height": (f'{HEAD}\n<box width="4" depth="3" height="0"/></mass>', ["LK106 2:1"]),
    "height lost": (f'{HEAD}\n<box width="4" depth="3" height="1e-9"/></mass>', ["LK801 2:1"]),
    "too far": (f'{HEAD}\n<box x="1e12" width="4" depth="3" height="1"/></mass>', ["LK801 2:1"]),
    "points": (f'{HEAD}\n<footprint points="0 0,1 1" height="1"/></mass>', ["LK105 2:1"]),
    "too many points": (
        f'{HEAD}\n<footprint points="{" ".join(f"{n},{n * n}" for n in range(1001))}" height="1"/></mass>',
        ["LK105 2:1"],
    ),
    "crossing": (f'{HEAD}\n<footprint points="0,0 1,1 1,0 0,1" height="1"/></mass>', ["LK801 2:1"]),
    "two points": (f'{HEAD}\n<footprint points="0,0 1,1" height="1"/></mass>', ["LK801 2:1"]),
    "closed": (f'{HEAD}\n<footprint points="0,0 1,1" height="1" closed="1"/></mass>', ["LK105 2:1"]),
    "names": (f"{HEAD}\n{BOX}\n{BOX}</mass>", ["LK803 3:1"]),
    "bad name": (f'{HEAD}\n<box name="2" width="4" depth="3" height="5"/></mass>', ["LK105 2:1"]),
    "wall inside": (f"{HEAD}\n{BOX}{WALL.replace('0,0 4,0', '1,1 2,1')}</mass>", []),
    "children": (f"{HEAD}\n<box width='4' depth='3' height='5'>{BOX}</box></mass>", ["LK108 2:37"]),
    "several": (
        f'{HEAD}\n<box width="x" depth="3" height="5"/>\n<footprint/></mass>',
        ["LK106 2:1", "LK104 3:1", "LK104 3:1"],
    ),
    "layout: sound": (building_of(FACE), []),
    "layout: no mass": (building_of(FACE, mass=""), ["LK107 1:1"]),
    "layout: mass without part": (building_of(FACE, mass="<mass/>"), ["LK107 2:1"]),
    "layout: mass behind": (
        f'{LAYOUT}\n<region symbol="Building" width="4" height="5" split="faces">\n{FACE}</region>\n'
        f"<mass>{WALL}</mass></layout>",
        ["LK108 4:1"],
    ),
    "layout: mass without faces": (
        f'{LAYOUT}\n<mass>{WALL}</mass>\n<region symbol="F" width="4" height="5"/></layout>',
        ["LK806 3:1"],
    ),
    "layout: other faces": (building_of(FACE.replace("Wall", "Wand")), ["LK806 3:1"]),
    "layout: other width": (
        building_of(FACE.replace('"4"', '"3"'), size='width="3" height="5"'),
        ["LK806 3:1"],
    ),
    "layout: other base": (
        building_of(FACE.replace("/>", ' base="1"/>'), size='width="4" height="6"'),
        ["LK806 3:1"],
    ),
    "layout: widths": (building_of(FACE, size='width="5" height="5"'), ["LK212 3:1"]),
    "layout: heights": (building_of(FACE, size='width="4" height="7"'), ["LK212 3:1"]),
    "layout: no height": (building_of('<region symbol="Wall" width="4"/>'), ["LK104 4:1"]),
    "layout: again": (building_of(f'{FACE}<again symbol="Wall"/>'), ["LK108 4:45"]),
    "layout: faces inside": (
        building_of(FACE.replace("/>", ' split="faces">\n<region symbol="A" width="4"/></region>')),
        ["LK105 4:1"],
    ),
    "layout: base of no face": (
        f'{LAYOUT}\n<region symbol="F" width="4" height="5" split="rows">\n'
        '<region symbol="A" height="5" base="1"/></region></layout>',
        ["LK112 3:1"],
    ),
    "facade: faces": (
        f'{FACADE}\n<region symbol="B" width="4" height="5" split="faces">\n{FACE}</region></facade>',
        ["LK807 2:1"],
    ),
    "facade: mass": (f"{FACADE}\n<mass>{WALL}</mass>\n{FACE}</facade>", ["LK108 2:1"]),
    "facade: depth": (f"{FACADE}\n{DEEP}</facade>", ["LK105 2:1"]),
}


@pytest.mark.parametrize("name", BROKEN)
def test_every_fault_is_found_at_its_place(name: str, tmp_path: Path) -> None:
    text, expected = BROKEN[name]
    path = tmp_path / "document.xml"
    path.write_text(text)
    found = [d for d in check(path, KINDS) if d.severity is Severity.ERROR]
    assert [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place] == expected
    assert all(d.hint and d.message and d.code in CODES for d in found)
    if is_mass(path) and expected:
        with pytest.raises(Faulty) as raised:
            read_mass(path)
        assert [d for d in raised.value.diagnostics if d.severity is Severity.ERROR] == found


#: What only the reader can see.
UNSEEN = {"LK801", "LK803", "LK806", "LK807", "LK212"}


@pytest.mark.parametrize("name", BROKEN)
def test_the_schema_agrees(name: str) -> None:
    text, expected = BROKEN[name]
    codes = {fault.split()[0] for fault in expected}
    readers_own = name in ("too many points", "layout: no mass", "layout: no height", "layout: again")
    readers_own |= name == "layout: base of no face"
    assert SCHEMA.validate(etree.fromstring(text.encode())) == (codes <= UNSEEN or readers_own)


def test_partly_hidden_faces_are_remarked_upon_in_masses_only(tmp_path: Path) -> None:
    part = '<box name="B" x="2" y="-1" width="1" depth="2" height="2"/>'
    (tmp_path / "mass.xml").write_text(f"{HEAD}\n{BOX}\n{part}</mass>")
    notes = check(tmp_path / "mass.xml", KINDS)
    assert {(d.code, d.severity) for d in notes} == {("LK802", Severity.NOTE)}
    assert [d.place.line for d in notes if d.place] == [2, 3, 3]
    assert "10% of the face South" in notes[0].message
