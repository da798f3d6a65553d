"""Grids in facade documents: every fault at its place, read back as written, and kept whatever is done."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import BUILT_IN, Constraint, Size
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.diagnostics.ranking import ranked
from layoutkit.documents import Source, check, facade_bytes, read, schema, with_constraints, with_grids
from layoutkit.documents.mending import mended
from layoutkit.model import Facade, Grid, Region, RegionSet, place
from tests.documents.test_document_round_trips import TEXT, WORDS, roots

Kinds = Mapping[str, type[Constraint]]
KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))

#: Two floors of a wall and a window with two panes, twice.
HEAD = """<facade xmlns="urn:layoutkit:1" name="f" units="m">
<region symbol="F" width="4" height="2" split="rows">
<region symbol="S" height="1" split="columns"><region symbol="A" width="1" labels="Wall"/>
<region symbol="W" width="1" split="columns" labels="Window"><region symbol="P" width="0.5"/>
<again symbol="P"/></region><again symbol="A"/><again symbol="W"/></region>
<again symbol="S"/></region>
"""
XSD, READER = "the schema sees it, too", "only the reader sees it"


@dataclass(frozen=True)
class Broken:
    """What a facade holds from line 7 on, and what is wrong with it as ``CODE line:column``."""

    name: str
    text: str
    expected: tuple[str, ...]
    seen_by: str = XSD

    @property
    def whole(self) -> str:
        return f"{HEAD}{self.text}\n</facade>"


def grids(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    """Grids that begin in line 8."""
    return Broken(name, f"<grids>\n{text}\n</grids>", expected, seen_by)


TWICE = ("LK241 8:1", "LK241 8:1")
CASES = [
    grids("by labels", '<grid name="a" of="@Window"/>', seen_by=READER),
    grids("by paths", '<grid name="b" elements="F/S/A.2  F/S.2/A "/>', seen_by=READER),
    grids("both ways, one element twice", '<grid name="a" of="@Wall" elements="F/S/A"/>', seen_by=READER),
    grids("of one element", '<grid name="a" elements="F"/>', seen_by=READER),
    grids("none", "", seen_by=READER),
    Broken("before constraints", "<grids/>\n<constraints/>", ("LK108 8:1",)),
    Broken("twice", "<grids/>\n<grids/>", ("LK108 8:1",)),
    Broken("a grid by itself", '<grid name="a" of="@Wall"/>', ("LK108 7:1",)),
    Broken("misspelt", "<grid>\n</grid>", ("LK108 7:1",)),
    Broken("attribute of all", '<grids name="a"/>', ("LK103 7:1",)),
    grids("text", "walls", "LK109 8:1"),
    grids("unknown element", '<gird name="a" of="@Wall"/>', "LK102 8:1"),
    grids("foreign element", '<x:grid xmlns:x="urn:x" name="a" of="@Wall"/>', "LK102 8:1"),
    grids("a constraint", '<size of="F"/>', "LK108 8:1"),
    grids("inside a grid", '<grid name="a" of="@Wall"><grid name="b" of="F"/></grid>', "LK108 8:27"),
    grids("no name", '<grid of="@Wall"/>', "LK104 8:1"),
    grids("no elements", '<grid name="a"/>', "LK104 8:1", seen_by=READER),
    grids("neither", "<grid/>", "LK104 8:1", "LK104 8:1"),
    grids("name of two words", '<grid name="a b" of="@Wall"/>', "LK105 8:1"),
    grids("name that is a number", '<grid name="1" of="@Wall"/>', "LK105 8:1"),
    grids("empty name", '<grid name="" of="@Wall"/>', "LK105 8:1"),
    grids("attribute misspelt", '<grid name="a" element="F/S"/>', "LK103 8:1"),
    grids("set that is none", '<grid name="a" of="@Wall |"/>', "LK105 8:1", seen_by=READER),
    grids("empty set", '<grid name="a" of=""/>', "LK105 8:1", seen_by=READER),
    grids("no path", '<grid name="a" elements=""/>', "LK105 8:1"),
    grids("only blanks", '<grid name="a" elements="  "/>', "LK105 8:1"),
    grids("a label among paths", '<grid name="a" elements="F/S @Wall"/>', "LK105 8:1"),
    grids("a path with a zeroth", '<grid name="a" elements="F/S.0/A"/>', "LK105 8:1"),
    grids("a path with a number alone", '<grid name="a" elements="F/.2"/>', "LK105 8:1"),
    grids("a path from nowhere", '<grid name="a" elements="/F"/>', "LK105 8:1"),
    grids("paths with commas", '<grid name="a" elements="F/S, F/S.2"/>', "LK105 8:1"),
    grids("unknown label", '<grid name="a" of="@Wal"/>', "LK241 8:1", seen_by=READER),
    grids("unknown region in a set", '<grid name="a" of="F/S/B | F/X/*"/>', *TWICE, seen_by=READER),
    grids("a number in a set", '<grid name="a" of="F/S.2"/>', "LK105 8:1", seen_by=READER),
    grids("unknown path", '<grid name="a" elements="F/S.3/A F/S/X"/>', *TWICE, seen_by=READER),
    grids("the first one with its number", '<grid name="a" elements="F/S.1"/>', "LK241 8:1", seen_by=READER),
    grids(
        "an element twice, and another", '<grid name="a" elements="F/S F/S.2 F/S F/S F/S.2"/>',
        *["LK242 8:1"] * 2, seen_by=READER,
    ),
    grids("a label inside a region", '<grid name="a" of="F/S | @Wall"/>', "LK243 8:1", seen_by=READER),
    grids("a path inside a path", '<grid name="a" elements="F/S.2/A F/S.2"/>', "LK243 8:1", seen_by=READER),
    grids("a path inside a set", '<grid name="a" of="F/S" elements="F/S.2/A"/>', "LK243 8:1", seen_by=READER),
    grids("a set inside a path", '<grid name="a" of="@Wall" elements="F/S.2"/>', "LK243 8:1", seen_by=READER),
    grids("a path beside a path", '<grid name="a" elements="F/S F/S.2/A"/>', seen_by=READER),
    grids("a set that leaves nothing", '<grid name="a" of="@Wall - F/*"/>', "LK244 8:1", seen_by=READER),
    grids(
        "one name", '<grid name="a" of="@Wall"/>\n<grid name="a" of="@Window"/>', "LK245 9:1", seen_by=READER
    ),
    grids(
        "all there is", '<grid name="a" of="@Wal"/>\n<grid name="a" elements="F/S.9 F/S F/S"/>\n<grid/>',
        "LK241 8:1", "LK245 9:1", "LK241 9:1", "LK242 9:1", "LK104 10:1", "LK104 10:1",
    ),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_fault_is_reported_once_at_its_place(case: Broken, tmp_path: Path) -> None:
    path = tmp_path / "facade.xml"
    path.write_text(case.whole)
    found = check(path, KINDS)
    assert [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place] == list(case.expected)
    assert all(d.severity is Severity.ERROR and d.code in CODES and d.message and d.hint for d in found)
    assert SCHEMA.validate(etree.fromstring(case.whole)) is (case.seen_by == READER)
    if case.expected:
        with pytest.raises(Faulty) as raised:
            read(path, KINDS)
        assert list(raised.value.diagnostics) == found


def test_all_codes_of_grids_are_tried() -> None:
    tried = {expected.split()[0] for case in CASES for expected in case.expected}
    assert tried >= {code for code in CODES if code.startswith("LK24")} - {"LK246"}  # which is of sessions


@pytest.mark.parametrize(
    ("wrong", "hint"),
    [
        ('of="@Windw"', "did you mean 'Window'?"),
        ('elements="F/S.3/W"', "did you mean 'F/S.2/W'?"),
        ('elements="F/S.2/V"', "known are: A, A.2, W, W.2"),
        ('elements="F/S.2/W.3/P.2"', "did you mean 'F/S.2/W.2/P.2'?"),
        ('elements="F/S.2/W.3/Q.2"', "did you mean 'F/S.2/W.2'?"),
        ('elements="F/S/A/P"', "F/S/A is not divided: name it, or another region"),
        ('elements="E/S"', "known are: F"),
        ('element="F"', "did you mean 'elements'?"),
    ],
)
def test_hints_say_what_is_meant(wrong: str, hint: str) -> None:
    text = grids("", f'<grid name="a" {wrong}/>').whole
    assert [d.hint for d in check(Source("f.xml", text.encode()), KINDS)] == [hint]


def test_names_are_not_judged_where_some_are_unreadable() -> None:
    text = grids("", '<grid name="a" of="@Nothing"/>').whole.replace('symbol="A"', 'symbol="1"')
    assert [d.code for d in check(Source("f.xml", text.encode()), KINDS)] == ["LK105", "LK105"]


def test_a_name_that_several_grids_lack_is_told_once() -> None:
    lines = "\n".join(f'<grid name="g{n}" elements="F/S.{n + 3}/A F/Z"/>' for n in range(3))
    found = ranked(check(Source("f.xml", grids("", lines).whole.encode()), KINDS))
    assert [(d.code, len(d.related)) for d in found] == [
        ("LK241", 0),
        ("LK241", 3),
        ("LK241", 0),
        ("LK241", 0),
    ]


@pytest.mark.parametrize(
    ("wrong", "right"),
    [('<gird name="a" of="@Wall"/>', '<grid name="a" of="@Wall"/>'),
     ('<grid name="a" element="F/S"/>', '<grid name="a" elements="F/S"/>')],
)  # fmt: skip
def test_misspelt_grids_are_mended(wrong: str, right: str) -> None:
    source = grids("", wrong).whole.encode()
    done = mended(source, "f.xml", lambda data: check(Source("f.xml", data), KINDS), KINDS)
    assert done.source.decode() == grids("", right).whole
    assert done.diagnostics == ()


@st.composite
def gridded(draw: st.DrawFn) -> Facade:
    """A facade and some grids of its regions, of which none overlap."""
    facade = Facade(draw(TEXT), "m", draw(roots()))
    names = draw(st.lists(WORDS, max_size=3, unique=True))
    return replace(facade, grids=tuple(draw(_grids(facade, name)) for name in names))


def _grids(facade: Facade, name: str) -> st.SearchStrategy[Grid]:
    symbols = st.sampled_from(list(facade.places)).map(RegionSet)
    paths = [placed.path for placed in place(facade.root)]
    some = st.lists(st.sampled_from(paths), min_size=1, max_size=4, unique=True).map(tuple)
    return st.one_of(
        st.builds(Grid, st.just(name), symbols),
        st.builds(Grid, st.just(name), st.none(), some),
        st.builds(Grid, st.just(name), symbols, some),
    ).filter(lambda grid: not nested(grid, facade))


def nested(grid: Grid, facade: Facade) -> bool:
    """Tell whether an element is inside another one, by comparing all of them."""
    members = grid.members(facade)
    return any(one.path.startswith(f"{other.path}/") for one, other in permutations(members, 2))


@given(gridded())
def test_grids_read_back(tmp_path_factory: pytest.TempPathFactory, facade: Facade) -> None:
    path = tmp_path_factory.mktemp("grids") / "facade.xml"
    path.write_bytes(facade_bytes(facade))
    again = read(path, KINDS)
    assert again.model == facade
    assert again.diagnostics == ()
    assert isinstance(again.model, Facade)
    assert all(grid.place and grid.place.file == str(path) for grid in again.model.grids)
    assert facade_bytes(again.model) == path.read_bytes()
    assert SCHEMA.validate(etree.parse(path)), SCHEMA.error_log
    bare = facade_bytes(replace(facade, grids=()))
    path.write_bytes(with_grids(bare, facade.grids))
    assert read(path, KINDS).model == facade


@given(st.data(), roots(), st.booleans())
def test_elements_inside_others_are_found(data: st.DataObject, root: Region, both: bool) -> None:
    facade = Facade("f", "m", root)
    symbols = st.sampled_from(list(facade.places))
    paths = st.sampled_from([placed.path for placed in place(root)])
    sets = data.draw(st.lists(symbols, min_size=1, max_size=3))
    chosen = tuple(data.draw(st.lists(paths, min_size=not both, max_size=3, unique=True)))
    grid = Grid("g", RegionSet.union(sets) if both else None, chosen)
    found = check(Source("f.xml", facade_bytes(replace(facade, grids=(grid,)))), KINDS)
    assert [d.code for d in found] == ["LK243"] * nested(grid, facade)
    for diagnostic in found:
        inner, outer = diagnostic.message.split("the element ")[1:]
        members = {member.path for member in grid.members(facade)}
        assert inner.removesuffix(" is inside ") in members
        assert outer in members
        assert inner.startswith(f"{outer}/")


ADDED = (Size(of=RegionSet("F"), comment="why"),)
REGION = '<region symbol="F" width="1" height="1"/>'
START = '<facade xmlns="urn:layoutkit:1" name="f" units="m">'


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            f"{START}\n  {REGION}\n  <grids>\n    <grid name='a' of='F'/>\n  </grids>\n</facade>\n",
            f'{START}\n  {REGION}\n  <constraints>\n    <!-- why -->\n    <size of="F"/>\n  </constraints>\n'
            "  <grids>\n    <grid name='a' of='F'/>\n  </grids>\n</facade>\n",
        ),
        (
            f"{START}\r\n\t{REGION} <!-- all -->\r\n\r\n\t<!-- mine -->\r\n\t<grids/>\r\n</facade>",
            f"{START}\r\n\t{REGION} <!-- all -->\r\n\r\n\t<constraints>\r\n\t\t<!-- why -->\r\n"
            '\t\t<size of="F"/>\r\n\t</constraints>\r\n\r\n\t<!-- mine -->\r\n\t<grids/>\r\n</facade>',
        ),
        (
            f"{START}{REGION}<grids/></facade>",
            f"{START}{REGION}\n  <constraints>\n    <!-- why -->\n    <size of=\"F\"/>\n  </constraints>\n"
            "  <grids/></facade>",
        ),
        (
            f"{START}\n {REGION}\n <constraints><size of='F'/></constraints><!-- a --><grids/>\n</facade>",
            f"{START}\n {REGION}\n <constraints><size of='F'/>\n   <!-- why -->\n   <size of=\"F\"/>\n"
            " </constraints><!-- a --><grids/>\n</facade>",
        ),
    ],
    ids=["on lines", "with remarks", "on one line", "with constraints"],
)  # fmt: skip
def test_constraints_are_added_before_grids(before: str, after: str) -> None:
    assert with_constraints(before.encode(), ADDED).decode() == after
    assert check(Source("f.xml", after.encode()), KINDS) == []


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            f"{START}{REGION}</facade>",
            f'{START}{REGION}\n  <grids>\n    <grid name="g" of="F"/>\n  </grids>\n</facade>',
        ),
        (
            f"{START}\n {REGION}\n <grids>\n  <grid name='a' of='F'/> <!-- a -->\n </grids>\n</facade>",
            f"{START}\n {REGION}\n <grids>\n  <grid name='a' of='F'/> <!-- a -->\n\n"
            '  <grid name="g" of="F"/>\n </grids>\n</facade>',
        ),
        (
            f"{START}\n\t{REGION}\n\t<constraints/>\n</facade>",
            f"{START}\n\t{REGION}\n\t<constraints/>\n"
            '\t<grids>\n\t\t<grid name="g" of="F"/>\n\t</grids>\n</facade>',
        ),
    ],
    ids=["none before", "some before", "behind constraints"],
)  # fmt: skip
def test_where_grids_go(before: str, after: str) -> None:
    assert with_grids(before.encode(), (Grid("g", RegionSet("F")),)).decode() == after
    assert with_grids(before.encode(), ()) == before.encode()


@pytest.mark.parametrize("codec", ["utf-8-sig", "utf-16", "utf-16-be", "iso-8859-1", "ascii"])
@pytest.mark.parametrize("prefix", ["", "k:"])
@pytest.mark.parametrize("between", ["", "\n", " <!-- é -->\n<!-- -->\n", "<!-- a - b -->"])
def test_encodings_and_prefixes(codec: str, prefix: str, between: str) -> None:
    declared = {"utf-8-sig": "utf-8", "utf-16-be": "utf-16"}.get(codec, codec)
    region = REGION.replace("/>", ' labels="Wänd"><!-- b --></region>')
    body = f"{START}\n{region}{between}<grids></grids></facade>"
    body = body.replace("xmlns=", "xmlns:k=" if prefix else "xmlns=").replace("<!", "\1").replace("</", "\0")
    body = body.replace("<", f"<{prefix}").replace("\0", f"</{prefix}").replace("\1", "<!")
    source = f'<?xml version="1.0" encoding="{declared}"?>\n{body}'.encode(codec, "xmlcharrefreplace")
    both = with_constraints(with_grids(source, (Grid("wände", RegionSet("@Wänd")),)), ADDED)
    name = Source("f.xml", both)
    assert check(name, KINDS) == []
    at = next(i for i, (a, b) in enumerate(zip(source, both, strict=False)) if a != b)
    assert both.startswith(source[:at])
    for part in source.decode(codec).split("<"):
        assert part.rstrip() in both.decode(codec)


Run = Callable[..., Any]


@pytest.fixture
def house(tmp_path: Path) -> Path:
    path = tmp_path / "house.xml"
    path.write_text(
        grids("", '<grid name="windows" of="@Window"/>\n<grid name="a" elements="F/S/A.2"/>').whole
    )
    return path


@pytest.mark.parametrize(
    ("command", "written"),
    [
        ("infer house.xml -o other/inferred.xml", "other/inferred.xml"),
        ("vary house.xml -n 1 -o out", "out/facade.xml"),
        ("vary broken.xml -n 1 -o out", None),
        ("validate broken.xml --fix", "broken.xml"),
    ],
)
def test_no_command_loses_grids(
    command: str, written: str | None, house: Path, layoutkit: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(house.parent)
    Path("broken.xml").write_text(house.read_text().replace("width", "widht", 1))
    run = layoutkit(*shlex.split(command))
    assert run.code == (written is None), run.err
    if written is not None:
        given, kept = (read(path, KINDS).model for path in (house, Path(written)))
        assert isinstance(given, Facade)
        assert isinstance(kept, Facade)
        assert kept.grids == given.grids


def test_inspect_tells_of_grids(house: Path, layoutkit: Run) -> None:
    run = layoutkit("inspect", house)
    assert run.out.splitlines()[-5:] == [
        "grid windows: 2 rows, 2 columns",
        "  F/S/W    F/S/W.2",
        "  F/S.2/W  F/S.2/W.2",
        "grid a: 1 row, 1 column",
        "  F/S/A.2",
    ]
    assert layoutkit("inspect", house, "--json").data["grids"] == [
        {"name": "windows", "rows": [["F/S/W", "F/S/W.2"], ["F/S.2/W", "F/S.2/W.2"]]},
        {"name": "a", "rows": [["F/S/A.2"]]},
    ]


def test_phantoms_fill_the_gaps(house: Path, layoutkit: Run) -> None:
    house.write_text(grids("", '<grid name="g" of="F/S/W" elements="F/S.2/A.2"/>').whole)
    assert layoutkit("inspect", house, "--json").data["grids"][0]["rows"] == [
        ["F/S/W", None, "F/S/W.2"],
        ["F/S.2/W", "F/S.2/A.2", "F/S.2/W.2"],
    ]
    assert layoutkit("inspect", house).out.splitlines()[-2] == "  F/S/W    –          F/S/W.2"


def test_facades_without_grids_have_none(house: Path, layoutkit: Run) -> None:
    house.write_text(f"{HEAD}</facade>")
    assert layoutkit("inspect", house, "--json").data["grids"] == []
