"""Broken documents, and the diagnostics that each must give: all of them, and none besides."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from lxml import etree

from layoutkit.constraints import Constraint
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import check, read, schema

Kinds = Mapping[str, type[Constraint]]

HEAD = '<facade xmlns="urn:layoutkit:1" name="f" units="m">'
TERMINAL = '<region symbol="F" width="2" height="1"/>'
#: Line 2 is the root, 3 and 4 its children, 6 and following the constraints.
TREE = """<region symbol="F" width="2" height="1" split="columns">
<region symbol="A" width="1" labels="Wall"/>
<region symbol="B" width="1" split="rows"><region symbol="C" height="1" labels="Window"/></region>
</region>"""

XSD, READER, NOT_XML = "the schema sees it, too", "only the reader sees it", "it is no XML"


@dataclass(frozen=True)
class Broken:
    """A document, what is wrong with it as ``CODE line:column``, and who can see it."""

    name: str
    text: str
    expected: tuple[str, ...]
    seen_by: str


def facade(name: str, body: str, *expected: str, seen_by: str = XSD) -> Broken:
    """A facade whose body begins in line 2."""
    return Broken(name, f"{HEAD}\n{body}\n</facade>", expected, seen_by)


def tree(name: str, children: str, *expected: str, seen_by: str = XSD, split: str = "columns") -> Broken:
    """A facade whose root region's children begin in line 3."""
    root = f'<region symbol="F" width="2" height="1" split="{split}">'
    return facade(name, f"{root}\n{children}\n</region>", *expected, seen_by=seen_by)


def rules(name: str, constraints: str, *expected: str, seen_by: str = XSD) -> Broken:
    """A facade with `TREE`, whose constraints begin in line 7."""
    return facade(name, f"{TREE}\n<constraints>\n{constraints}\n</constraints>", *expected, seen_by=seen_by)


def whole(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    return Broken(name, text, expected, seen_by)


CASES = [
    # Files and XML
    whole("empty file", "", "LK002 1:1", seen_by=NOT_XML),
    whole("no XML", "hello", "LK002 1:1", seen_by=NOT_XML),
    whole("cut off", f"{HEAD}\n<region", "LK002 2:1", seen_by=NOT_XML),
    whole("tags crossed", f"{HEAD}\n<region>\n</facade>", "LK002 3:3", seen_by=NOT_XML),
    whole("two roots", f"{HEAD}</facade>\n<facade/>", "LK002 2:1", seen_by=NOT_XML),
    whole("attribute twice", '<facade name="a"\n name="b"/>', "LK002 2:2", seen_by=NOT_XML),
    whole("bare ampersand", '<facade name="a & b"/>', "LK002 1:18", seen_by=NOT_XML),
    whole("unknown entity", f"{HEAD}\n &eacute;</facade>", "LK002 2:2", seen_by=NOT_XML),
    whole("unbound prefix", f"{HEAD}\n<x:region/></facade>", "LK002 2:1", seen_by=NOT_XML),
    whole("declaration late", '\n<?xml version="1.0"?>\n<facade/>', "LK002 2:1", seen_by=NOT_XML),
    whole(
        "unknown encoding", '<?xml version="1.0" encoding="klingon"?>\n<a/>', "LK003 1:31", seen_by=NOT_XML
    ),
    whole("multi-byte", '<?xml version="1.0" encoding="shift_jis"?>\n<a/>', "LK003 1:31", seen_by=NOT_XML),
    whole("document type", f"<!DOCTYPE facade>\n{HEAD}{TERMINAL}</facade>", "LK004 1:1", seen_by=READER),
    # The root
    whole("another format", "<annotation/>", "LK101 1:1"),
    whole("misspelt root", '<facad xmlns="urn:layoutkit:1"/>', "LK101 1:1"),
    whole("another namespace", '<facade xmlns="urn:other"/>', "LK101 1:1"),
    whole("no namespace", f'<facade name="f" units="m">{TERMINAL}</facade>', "LK101 1:1"),
    whole("no attributes", f'<facade xmlns="urn:layoutkit:1">{TERMINAL}</facade>', "LK104 1:1", "LK104 1:1"),
    whole(
        "bad units", f'<facade xmlns="urn:layoutkit:1" name="f" units="cm">{TERMINAL}</facade>', "LK105 1:1"
    ),
    whole("no region", f"{HEAD}</facade>", "LK107 1:1"),
    facade(
        "picture after region",
        f'{TERMINAL}\n<picture file="f" left="0" top="0" right="1" bottom="1"/>',
        "LK108 3:1",
    ),
    facade("two regions", f"{TERMINAL}\n{TERMINAL}", "LK108 3:1"),
    facade("unknown part", f"{TERMINAL}\n<notes/>", "LK102 3:1"),
    facade("foreign element", f'{TERMINAL}\n<x:notes xmlns:x="urn:x"/>', "LK102 3:1"),
    facade("replica of nothing", f'{TERMINAL}\n<again symbol="F"/>', "LK108 3:1"),
    facade("text", f"{TERMINAL}\n  oops <!-- a --> again", "LK109 3:3"),
    # Pictures
    facade(
        "picture without a side", f'<picture file="f" left="0" top="0" right="1"/>{TERMINAL}', "LK104 2:1"
    ),
    facade(
        "picture not a number",
        f'<picture file="f" left="0" top="x" right="1" bottom="1"/>{TERMINAL}',
        "LK105 2:1",
    ),
    facade(
        "picture outside",
        f'<picture file="f" left="-1" top="0" right="1" bottom="1"/>{TERMINAL}',
        "LK105 2:1",
    ),
    facade(
        "picture empty twice",
        f'<picture file="f" left="1" top="1" right="1" bottom="0"/>{TERMINAL}',
        "LK213 2:1",
        "LK213 2:1",
        seen_by=READER,
    ),
    # Regions
    *(
        facade(f"size {size}", f'<region symbol="F" width="{size}" height="1"/>', "LK106 2:1")
        for size in (
            "nan",
            "inf",
            "-1",
            "0",
            "0.0e3",
            "1,5",
            "2 m",
            "",
            "1_0",
            "0x1",
            "\N{ARABIC-INDIC DIGIT TWO}",
        )
    ),
    facade("size too large", '<region symbol="F" width="1e999" height="1"/>', "LK106 2:1", seen_by=READER),
    facade("root without height", '<region symbol="F" width="1"/>', "LK104 2:1"),
    facade("unknown attribute", '<region symbol="F" width="1" height="1" colour="red"/>', "LK103 2:1"),
    facade("misspelt attribute once", '<region symbl="F" width="1" height="1"/>', "LK103 2:1"),
    facade("bad symbol", '<region symbol="1st" width="1" height="1"/>', "LK105 2:1"),
    facade("bad label", '<region symbol="F" width="1" height="1" labels="Wall a-b"/>', "LK105 2:1"),
    facade("bad fill", '<region symbol="F" width="1" height="1" fill="tile"/>', "LK105 2:1"),
    facade(
        "split without children",
        '<region symbol="F" width="1" height="1" split="rows"/>',
        "LK111 2:1",
        seen_by=READER,
    ),
    facade(
        "children without split",
        '<region symbol="F" width="1" height="1">\n<region symbol="A" height="1"/></region>',
        "LK110 2:1",
        seen_by=READER,
    ),
    tree("bad split", '<region symbol="A" width="9"/>', "LK105 2:1", split="column"),
    tree("child without size", '<region symbol="A"/>', "LK104 3:1", seen_by=READER),
    tree("child with the other size", '<region symbol="A" height="2"/>', "LK112 3:1", seen_by=READER),
    tree("child with both sizes", '<region symbol="A" width="2" height="1"/>', "LK112 3:1", seen_by=READER),
    tree(
        "not adding up",
        '<region symbol="A" width="1"/><region symbol="B" width="1.5"/>',
        "LK212 2:1",
        seen_by=READER,
    ),
    tree(
        "no sum of unknowns", '<region symbol="A" width="nan"/><region symbol="B" width="1.5"/>', "LK106 3:1"
    ),
    tree("misspelt region", '<regoin symbol="A" width="2"/>', "LK102 3:1"),
    tree("no sum without a child", '<region symbol="A" width="1"/>\n<x:b xmlns:x="urn:x"/>', "LK102 4:1"),
    tree(
        "faults on all levels",
        '<region symbol="A" width="1" split="rows"><region symbol="C" height="x"/></region>\n'
        '<region symbol="B" width="1" split="rows" labels="-"><region symbol="D"/></region>',
        "LK106 3:43",
        "LK105 4:1",
        "LK104 4:54",
    ),
    # Replicas
    tree(
        "two definitions",
        '<region symbol="A" width="0.5"/>\n<region symbol="A" width="1.5"/>',
        "LK210 4:1",
        seen_by=READER,
    ),
    tree("replica first", '<again symbol="A"/>\n<region symbol="A" width="2"/>', "LK211 3:1"),
    tree(
        "unknown replica", '<region symbol="A" width="2"/>\n<again symbol="B"/>', "LK211 4:1", seen_by=READER
    ),
    tree("replica of the unreadable", '<region symbol="9" width="1"/>\n<again symbol="A"/>', "LK105 3:1"),
    tree("replica with a size", '<region symbol="A" width="1"/>\n<again symbol="A" width="1"/>', "LK103 4:1"),
    tree(
        "replica with a child",
        '<region symbol="A" width="1"/><again symbol="A"><region/></again>',
        "LK108 3:49",
    ),
    # Constraints
    rules("unknown kind", '<frequncy of="A"/>', "LK102 7:1"),
    rules("constraint without attribute", '<size min="1"/>', "LK104 7:1"),
    rules("constraint with another", '<size of="F/A" mim="1"/>', "LK103 7:1"),
    rules("bad measure", '<size of="F/A" min="1m"/>', "LK105 7:1"),
    rules("negative measure", '<size of="F/A" min="-1"/>', "LK105 7:1"),
    rules("two points", '<size of="F/A" min="1.2.3"/>', "LK105 7:1", seen_by=READER),
    rules("signed measure", '<size of="F/A" min="+1"/>', "LK105 7:1"),
    rules("bad set", '<size of="F/A |" min="1"/>', "LK105 7:1", seen_by=READER),
    rules("bad choice", '<same-size first="F/A" dimension="size"/>', "LK105 7:1"),
    rules("bad choices", '<alignment first="F/A" second="F/A" lines="left centre"/>', "LK105 7:1"),
    rules("no choice", '<alignment first="F/A" second="F/A" lines=""/>', "LK105 7:1"),
    rules("child of a constraint", '<size of="F/A"><region/></size>', "LK108 7:16"),
    rules("text in a constraint", '<size of="F/A">why</size>', "LK109 7:16"),
    rules("a constraint of another namespace", '<x:size xmlns:x="urn:x" of="F/A"/>', "LK113 7:1"),
    rules(
        "unknown region",
        '<size of="F/X" min="1"/>\n<size of="F/A | @Wal"/>',
        "LK201 7:1",
        "LK201 8:1",
        seen_by=READER,
    ),
    rules("crossed bounds", '<size of="F/A" min="2" max="1"/>', "LK202 7:1", seen_by=READER),
    rules("arrangement of a terminal", '<frequency of="A" within="F/A"/>', "LK205 7:1", seen_by=READER),
    rules(
        "lines of two axes",
        '<alignment first="F/A" second="F/B" lines="left top"/>',
        "LK206 7:1",
        seen_by=READER,
    ),
    rules("run across", '<same-size first="F/B: C" dimension="width"/>', "LK207 7:1", seen_by=READER),
    rules("different symbols", '<same-arrangement of="F F/B"/>', "LK208 7:1", seen_by=READER),
    rules(
        "initial sizes without their ends",
        '<size of="F/A" distribution="uniform" min="1"/>\n<size of="F/A" bias="-0.5"/>',
        "LK214 7:1",
        "LK214 8:1",
        seen_by=READER,
    ),
    rules(
        "contexts on the wrong side",
        '<alignment first="F/A" second="F/A" lines="left" first-before="A -|"/>\n'
        '<same-size first="F/A" dimension="width" second-after="B"/>',
        "LK215 7:1",
        "LK215 8:1",
        seen_by=READER,
    ),
    rules(
        "neighbour of no one",
        '<alignment first="F/A" second="F/A" lines="left" first-after="C"/>',
        "LK201 7:1",
        seen_by=READER,
    ),
    rules("instances of the root", '<instances of="F"/>', "LK216 7:1", seen_by=READER),
    rules("no instance", '<instances of="F/A" max="0"/>', "LK202 7:1", seen_by=READER),
    rules("two partners", '<symmetry of="F" pairs="A:B B:A"/>', "LK217 7:1", "LK217 7:1", seen_by=READER),
    rules("no pair", '<symmetry of="F" pairs="A-B"/>', "LK105 7:1", seen_by=READER),
    rules("two anchors", '<lock of="F/A" keep="place" anchor="left right"/>', "LK218 7:1", seen_by=READER),
    rules("locked inside of a terminal", '<lock of="F/A" keep="inside"/>', "LK205 7:1", seen_by=READER),
    rules("lock of nothing", '<lock of="F/A" keep="colour"/>', "LK105 7:1"),
    rules("lock without keep", '<lock of="F/A"/>', "LK104 7:1"),
    rules("weight that is none", '<size of="F/A" weight="heavy"/>', "LK105 7:1"),
    rules("weight of nothing", '<size of="F/A" weight="0"/>', "LK105 7:1", seen_by=READER),
    rules("bias beyond the end", '<size of="F/A" min="1" bias="-2"/>', "LK105 7:1", seen_by=READER),
    # Generators
    rules("pattern cut off", '<repetition within="F" pattern="A (B"/>', "LK105 7:1", seen_by=READER),
    rules("pattern with ends", '<repetition within="F" pattern="|- A B -|"/>', "LK105 7:1", seen_by=READER),
    rules("no pattern", '<repetition within="F"/>', "LK104 7:1"),
    rules(
        "name in a pattern that is not there",
        '<repetition within="F" pattern="A+[@Wal] X"/>',
        "LK201 7:1",
        "LK201 7:1",
        seen_by=READER,
    ),
    rules("pattern that counts", '<repetition within="F" pattern="B (A A)+"/>', "LK220 7:1", seen_by=READER),
    rules("shuffle of one", '<two-shuffle within="F" of="A"/>', "LK105 7:1", seen_by=READER),
    rules("nothing to reverse", '<reversal within="F"/>', "LK221 7:1", seen_by=READER),
    rules(
        "regions that do not correspond",
        '<sequence within="F" word="A B"/>\n<reuse within="F/B" like="F"/>',
        "LK222 8:1",
        seen_by=READER,
    ),
    rules("run in another order", '<replication within="F" of="B A"/>', "LK223 7:1", seen_by=READER),
    rules("shuffle in a terminal", '<two-shuffle within="F/A"/>', "LK205 7:1", seen_by=READER),
    facade(
        "names are not judged where some are unreadable",
        '<region symbl="F" width="1" height="1" split="rows"><region symbol="?" height="1"/></region>\n'
        '<constraints><size of="F/A"/></constraints>',
        "LK103 2:1",
        "LK105 2:53",
    ),
    facade(
        "names are judged where only sizes are unreadable",
        '<region symbol="F" width="x" height="1"/>\n<constraints><size of="G"/></constraints>',
        "LK106 2:1",
        "LK201 3:14",
    ),
    # Layouts
    whole(
        "layout, bad seed",
        f'<layout xmlns="urn:layoutkit:1" name="l" units="m" seed="-1">{TERMINAL}</layout>',
        "LK105 1:1",
    ),
    whole(
        "layout with constraints",
        f'<layout xmlns="urn:layoutkit:1" name="l" units="m">{TERMINAL}\n<constraints/></layout>',
        "LK108 2:1",
    ),
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_fault_is_reported_once_at_its_place(
    case: Broken, kinds: Kinds, written: Callable[..., Path]
) -> None:
    path = written(case.text)
    found = check(path, kinds)
    assert [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place] == list(case.expected)
    assert {d.place.file for d in found if d.place} == {str(path)}
    assert all(d.severity is Severity.ERROR and d.code in CODES and d.message for d in found)
    with pytest.raises(Faulty) as raised:
        read(path, kinds)
    assert list(raised.value.diagnostics) == found


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_fault_has_a_hint(case: Broken, kinds: Kinds, written: Callable[..., Path]) -> None:
    assert all(d.hint for d in check(written(case.text), kinds))


@pytest.mark.parametrize("case", [c for c in CASES if c.seen_by != NOT_XML], ids=lambda case: case.name)
def test_the_schema_agrees(case: Broken, kinds: Kinds) -> None:
    validator = etree.XMLSchema(etree.fromstring(schema(kinds)))
    assert validator.validate(etree.fromstring(case.text.encode())) is (case.seen_by == READER)


def test_many_kinds_of_fault_are_tried() -> None:
    tried = {expected.split()[0] for case in CASES for expected in case.expected}
    assert len(CASES) >= 60
    # What takes a search to find is tried with the stage that finds it.
    assert tried >= {c for c in CODES if c.startswith("LK1") or "LK201" <= c < "LK224"} - {"LK203"}


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (f"{HEAD}\n<region>\n</facade>", "<region>, opened in line 2, is not closed before this place"),
        (f'{HEAD}<region symbol="F" widht="1" height="1"/></facade>', "did you mean 'width'?"),
        (
            f'{HEAD}<region symbol="F" width="1" height="1" split="colums"/></facade>',
            "did you mean 'columns'?",
        ),
        (f'{HEAD}{TERMINAL}<constraints><siez of="F"/></constraints></facade>', "did you mean 'size'?"),
        (
            f'{HEAD}<region symbol="F" width="3" height="1" split="columns">'
            '<region symbol="A" width="2.4"/></region></facade>',
            "add 0.6 to the children, or make the parent's width 2.4",
        ),
        (
            f'{HEAD}<region symbol="F" width="3" height="1" split="columns">'
            '<region symbol="A" height="3"/></region></facade>',
            "write width instead of height",
        ),
    ],
)
def test_hints_say_what_to_do(text: str, hint: str, kinds: Kinds, written: Callable[..., Path]) -> None:
    assert check(written(text), kinds)[0].hint == hint


def test_missing_files_and_folders(tmp_path: Path, kinds: Kinds) -> None:
    (tmp_path / "facade.xml").touch()
    missing, folder = check(tmp_path / "facad.xml", kinds), check(tmp_path, kinds)
    assert [d.code for d in missing + folder] == ["LK001", "LK001"]
    assert missing[0].hint == "did you mean 'facade.xml'?"
    assert folder[0].hint == "it is a folder; it holds facade.xml"
    assert check(tmp_path / "none" / "a.xml", kinds)[0].hint == f"there is no folder {tmp_path / 'none'}"
    assert check("a\0b", kinds)[0].code == "LK001"
