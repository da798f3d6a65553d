"""Scene documents: every fault at its place, the schema in agreement, and scenes read back as written."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import Source, check, is_scene, read, read_scene, save, scene_bytes, schema
from layoutkit.documents.mending import mended
from layoutkit.model import Picture, Placement, Polygon, Scene
from tests.scenes_documents.drawn_scenes import scenes

KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))
HEAD = '<scene xmlns="urn:layoutkit:1" name="s" units="m">'
BOX = '<polygon points="0,0 1,0 1,1 0,1"/>'
PLACED = '<placement x="0" y="0" width="1" height="1"/>'
PICTURE = '<picture file="a.png" left="0" top="0" right="1" bottom="1"/>'
EDGE = '<edge at="1 4" labels="A"/>'
XSD, READER = "the schema sees it, too", "only the reader sees it"


@dataclass(frozen=True)
class Broken:
    """A scene, and what is wrong with it as ``CODE line:column``."""

    name: str
    text: str
    expected: tuple[str, ...]
    seen_by: str


def inside(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    """A scene whose contents begin in line 2."""
    return Broken(name, f"{HEAD}\n{text}\n</scene>", expected, seen_by if expected else READER)


def points(name: str, text: str, *expected: str, seen_by: str = READER) -> Broken:
    """A scene of one polygon."""
    return inside(name, f'<polygon points="{text}"/>', *expected, seen_by=seen_by)


def whole(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    return Broken(name, text, expected, seen_by if expected else READER)


CASES = [
    whole("nothing in it", HEAD.replace(">", "/>")),
    whole("misspelt", HEAD.replace("scene", "scen").replace(">", "/>"), "LK101 1:1"),
    whole("another namespace", '<scene xmlns="urn:other" name="s" units="m"/>', "LK101 1:1"),
    whole("no namespace", '<scene name="s" units="m"/>', "LK101 1:1"),
    whole("no attributes", '<scene xmlns="urn:layoutkit:1"/>', "LK104 1:1", "LK104 1:1"),
    whole("units", HEAD.replace('"m"', '"mm"').replace(">", "/>"), "LK105 1:1"),
    whole("size", HEAD.replace(" units", ' width="3" units').replace(">", "/>"), "LK103 1:1"),
    inside("all", f'{PICTURE}{BOX}{PLACED}<polygon name="b" points="2,2 3,2 3,3"/>'),
    inside("text", "window", "LK109 2:1"),
    inside("region", '<region symbol="A"/>', "LK108 2:1"),
    inside("unknown", "<window/>", "LK102 2:1"),
    inside("misspelt polygon", f"{BOX.replace('polygon', 'poligon')}", "LK102 2:1"),
    inside("picture too late", f"{BOX}\n{PICTURE}", "LK108 3:1"),
    inside("two pictures", f"{PICTURE}\n{PICTURE}", "LK108 3:1"),
    inside("empty picture", PICTURE.replace('right="1"', 'right="0"'), "LK213 2:1", seen_by=READER),
    inside("in a placement", f"<placement {PLACED[11:-2]}>{BOX}</placement>", "LK108 2:45"),
    # Points
    points("a triangle, clockwise", "0,0 0,1 1,0"),
    points("exponents", "1e2,0 +1.5E2,0 .5e1,7."),
    points("no points", "", "LK105 2:1", seen_by=XSD),
    points("one number", "1 2 3", "LK105 2:1", seen_by=XSD),
    points("three numbers", "0,0,0 1,0,0 1,1,0", "LK105 2:1", seen_by=XSD),
    points("words", "a,b c,d e,f", "LK105 2:1", seen_by=XSD),
    points("not a number", "nan,0 1,0 1,1", "LK105 2:1", seen_by=XSD),
    points("infinite", "inf,0 1,0 1,1", "LK105 2:1", seen_by=XSD),
    points("too large for a float", "1e999,0 1,0 1,1", "LK105 2:1"),
    points("beyond", "1e12,0 0,1 0,0", "LK851 2:1"),
    points("one point", "0,0", "LK851 2:1"),
    points("two points", "0,0 1,0", "LK851 2:1"),
    points("there and back", "0,0 1,0 0,0", "LK851 2:1"),
    points("one point thrice", "1,1 1,1 1,1", "LK851 2:1"),
    points("on a line", "0,0 1,1 5,5 2,2", "LK851 2:1"),
    points("too small for its coordinates", "1e8,0 100000000.00000001,0 1e8,1e-8", "LK851 2:1"),
    points("crossing", "0,0 1,1 1,0 0,1", "LK852 2:1"),
    points("a spike", "0,0 2,0 2,1 2,3 2,1 0,1", "LK852 2:1"),
    points("touching itself", "0,0 4,0 4,4 2,0 0,4", "LK852 2:1"),
    points("a hole by a bridge", "0,0 9,0 9,9 0,9 0,0 3,3 3,6 6,6 6,3 3,3", "LK852 2:1"),
    # Polygons
    inside("no points at all", "<polygon/>", "LK104 2:1"),
    inside("angle", BOX.replace("/>", ' angle="ninety"/>'), "LK105 2:1"),
    inside("label with a hyphen", BOX.replace("/>", ' labels="French-door"/>'), "LK105 2:1"),
    inside("label for labels", BOX.replace("/>", ' label="Door"/>'), "LK103 2:1"),
    inside("a name twice", '<polygon name="a" points="0,0 1,0 0,1"/>\n' * 2, "LK856 3:1", seen_by=READER),
    inside("a hole", f"<polygon {BOX[9:-2]}>\n<hole/></polygon>", "LK102 3:1"),
    inside("own labels", f'<polygon {BOX[9:-2]}>{EDGE}<corner at="4" labels=""/></polygon>'),
    inside("5th", f"<polygon {BOX[9:-2]}>\n{EDGE.replace('4', '5')}</polygon>", "LK105 3:1", seen_by=READER),
    inside("the zeroth edge", f"<polygon {BOX[9:-2]}>\n{EDGE.replace('4', '0')}</polygon>", "LK105 3:1"),
    inside("edge of nothing", f"<polygon {BOX[9:-2]}>\n<edge/></polygon>", "LK104 3:1", "LK104 3:1"),
    inside(
        "an edge twice",
        f'<polygon {BOX[9:-2]}><edge at="1" labels="A"/><edge at="2 1" labels="B"/></polygon>',
        "LK105 2:1",
        seen_by=READER,
    ),
    # Placements
    inside("nowhere", "<placement/>", *["LK104 2:1"] * 4),
    inside("no width", PLACED.replace('width="1"', 'width="0"'), "LK106 2:1"),
    inside("no number", PLACED.replace('x="0"', 'x="left"'), "LK105 2:1"),
    inside("two labels", PLACED.replace("/>", ' label="A B"/>'), "LK105 2:1"),
    inside("mirrored", PLACED.replace("/>", ' mirrored="maybe"/>'), "LK105 2:1"),
    inside("infinite score", PLACED.replace("/>", ' score="inf"/>'), "LK105 2:1"),
    inside("three faults", f'{BOX}\n<polygon points="0,0"/>\n<placement/>\n{BOX[:-2]} angle="x"/>',
           "LK104 4:1", "LK104 4:1", "LK104 4:1", "LK104 4:1", "LK105 5:1", "LK851 3:1"),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_fault_is_reported_once_at_its_place(case: Broken, tmp_path: Path) -> None:
    path = tmp_path / "scene.xml"
    path.write_text(case.text)
    found = check(path, KINDS)
    places = [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place]
    assert sorted(places) == sorted(case.expected)
    assert [d.place for d in found] == sorted(d.place for d in found if d.place)
    assert all(d.severity is Severity.ERROR and d.code in CODES and d.message and d.hint for d in found)
    assert SCHEMA.validate(etree.fromstring(case.text)) is (case.seen_by == READER)
    if case.expected:
        with pytest.raises(Faulty) as raised:
            read_scene(path)
        assert [d.code for d in raised.value.diagnostics] == [d.code for d in found]
    else:
        assert read_scene(path).diagnostics == ()


@given(scenes())
def test_what_is_written_is_read(scene: Scene) -> None:
    written = scene_bytes(scene)
    SCHEMA.assertValid(etree.fromstring(written))
    found = read_scene(Source("s.xml", written))
    assert (found.scene, found.diagnostics) == (scene, ())
    assert scene_bytes(found.scene) == written


TRIANGLE = ((0.0, 0.0), (4.0, 0.0), (4.0, 3.5))


def test_a_document_as_it_is_written() -> None:
    scene = Scene(
        "room & more",
        "m",
        (
            Polygon(
                "floor",
                TRIANGLE,
                ("Room",),
                ((1, ("Street",)),),
                ((2, ()),),
                90.0,
            ),
        ),
        (Placement(1.0, 2.0, 0.5, 0.25, -45.0, "Chair", 0.75, True), Placement(3.0, 1.0, 1.0, 1.0)),
        Picture("photo.jpg", (0.0, 0.0, 40.0, 35.0)),
    )
    assert scene_bytes(scene).decode() == (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<scene xmlns="urn:layoutkit:1" name="room &amp; more" units="m">\n'
        '  <picture file="photo.jpg" left="0" top="0" right="40" bottom="35"/>\n'
        '  <polygon name="floor" points="0,0 4,0 4,3.5" labels="Room" angle="90">\n'
        '    <edge at="2" labels="Street"/>\n'
        '    <corner at="3" labels=""/>\n'
        "  </polygon>\n"
        '  <placement x="1" y="2" width="0.5" height="0.25" angle="-45" label="Chair" '
        'score="0.75" mirrored="yes"/>\n'
        '  <placement x="3" y="1" width="1" height="1"/>\n'
        "</scene>\n"
    )


def test_polygons_without_names_get_some() -> None:
    text = f"{HEAD}{BOX.replace('/>', ' labels=' + chr(34) + 'Door' + chr(34) + '/>')}{BOX}"
    text += '<polygon name="Door_2" points="5,5 6,5 6,6"/>'
    text += f"{BOX.replace('/>', ' labels=' + chr(34) + 'Door Big' + chr(34) + '/>')}</scene>"
    found = read_scene(Source("s.xml", text.encode())).scene
    assert [polygon.name for polygon in found.polygons] == ["Door_1", "Polygon_1", "Door_2", "Door_3"]


def test_repeated_points_are_a_note_and_taken_once() -> None:
    text = f'{HEAD}\n<polygon name="a" points="0,0 1,0 1,0 1,1 0,0"/></scene>'
    found = read_scene(Source("s.xml", text.encode()))
    assert found.scene.polygons[0].points == ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0))
    (note,) = found.diagnostics
    assert (note.code, note.severity, note.place and note.place.line) == ("LK853", Severity.NOTE, 2)


def test_what_is_a_scene(tmp_path: Path) -> None:
    save(tmp_path / "s.xml", scene_bytes(Scene("s", "m", ())))
    assert is_scene(tmp_path / "s.xml")
    assert is_scene(Source("-", HEAD.encode()))
    assert not is_scene(Source("-", b"no XML"))
    with pytest.raises(Faulty, match="<scene> is no facade") as raised:
        read(tmp_path / "s.xml", KINDS)
    assert "place" in raised.value.diagnostics[0].hint
    with pytest.raises(Faulty, match="<facade> is no scene"):
        read_scene(Source("f.xml", b'<facade xmlns="urn:layoutkit:1"/>'))


def test_misspelt_names_are_mended() -> None:
    text = f'{HEAD}<poligon points="0,0 1,0 1,1"/><placement x="0" y="0" widht="1" height="1"/></scene>'
    fixed = mended(text.encode(), "s.xml", lambda source: check(Source("s.xml", source), KINDS), KINDS)
    assert check(Source("s.xml", fixed.source), KINDS) == []


def test_ten_thousand_faults_are_counted_and_not_told_one_by_one() -> None:
    text = HEAD + '<polygon points="0,0 1,1 1,0 0,1"/>' * 3000 + "</scene>"
    found = check(Source("s.xml", text.encode()), KINDS)
    assert sum(d.count for d in found) == 3000
    assert len(found) < 1100


@given(st.integers(1, 5000))
def test_outlines_may_have_any_number_of_points(count: int) -> None:
    top = " ".join(f"{count - k},1" for k in range(count + 1))
    text = f'{HEAD}<polygon name="a" points="0,0 {count},0 {top}"/></scene>'
    assert len(read_scene(Source("s.xml", text.encode())).scene.polygons[0].points) == count + 3
    assert SCHEMA.validate(etree.fromstring(text))
