"""Operations documents: read back as written, with all files that they name; every fault at its place."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import (
    OperationsDocument,
    Source,
    check,
    is_operations,
    operations_bytes,
    read_operations,
    read_operations_files,
)
from layoutkit.documents.mending.expected import ROOTS
from layoutkit.model import Example, Placement, PlacementModel, Polygon, Scene
from layoutkit.model.session import Edit
from layoutkit.operations import Branch, Node, Operations
from tests.operations.documents.operation_kinds import (
    ACME,
    CONSTRAINTS,
    FILES,
    KINDS,
    MODEL,
    Bend,
    Grow,
    Still,
)
from tests.scenes_documents.drawn_scenes import LABELS, NUMBERS, PLACEMENTS, SIZES, TEXT

HEAD = f'<operations xmlns="urn:layoutkit:1" xmlns:acme="{ACME.uri}" name="o" units="m"'
GROW = '<grow amount="2"/>'


def document(inside: str, attributes: str = "") -> str:
    return f"{HEAD}{attributes}>\n{inside}\n</operations>"


def sent(text: str | bytes) -> OperationsDocument:
    data = text if isinstance(text, bytes) else text.encode()
    return read_operations_files({**FILES, "o.xml": data}, "o.xml", KINDS, CONSTRAINTS)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with the files that operations name."""
    for name, data in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(data)
    return tmp_path


NAMED = sent(document('<grow amount="1" facade="walls/wall.xml" session="walls/edits.xml"/>'))
(NAMING,) = (node.operation for node in NAMED.operations.roots if isinstance(node.operation, Grow))

MODELS = st.builds(
    lambda name, placement: PlacementModel(
        name,
        "px",
        "Sill",
        (Example(Scene("s", "px", (Polygon("p", ((0, 0), (1, 0), (1, 1))),)), placement),),
    ),
    TEXT,
    PLACEMENTS.map(lambda p: Placement(p.x, p.y, p.width, p.height, p.angle, "Sill")),
)
COLOURS = st.tuples(*[st.integers(0, 255)] * 3)
OPERATIONS = st.one_of(
    st.just(Still()),
    st.builds(
        Grow,
        amount=SIZES.filter(lambda size: size not in (13, 666)),
        labels=LABELS,
        random=st.floats(0, 1e6),
        wide_too=st.booleans(),
        colour=st.none() | COLOURS,
        facade=st.sampled_from((None, NAMING.facade)),
        session=st.sampled_from((None, NAMING.session)),
        model=st.none() | MODELS,
    ),
    st.builds(Bend, angle=NUMBERS.filter(lambda a: a <= 90), note=TEXT, model=st.none() | MODELS),
)


def nodes(children: st.SearchStrategy[tuple[Node, ...]]) -> st.SearchStrategy[tuple[Node, ...]]:
    branches = st.lists(st.builds(Branch, children, SIZES), max_size=2).map(tuple)
    return st.lists(st.builds(Node, OPERATIONS, children, branches), min_size=1, max_size=3).map(tuple)


TREES = st.builds(
    Operations,
    name=TEXT,
    units=st.sampled_from(("m", "px")),
    roots=nodes(st.recursive(st.just(()), nodes, max_leaves=6)),
    sites=LABELS,
)


@given(TREES)
@settings(max_examples=60)
def test_what_is_written_is_read(operations: Operations) -> None:
    written = operations_bytes(operations)
    found = sent(written)
    assert (found.operations, found.diagnostics) == (operations, ())
    assert operations_bytes(found.operations) == written


def test_defaults_are_left_away() -> None:
    tree = Operations("o", "m", (Node(Grow(amount=2.0), (), (Branch(()), Branch((), 2.5))),))
    lines = operations_bytes(tree).decode().splitlines()
    assert lines[2:6] == ['  <grow amount="2">', "    <branch/>", '    <branch weight="2.5"/>', "  </grow>"]


def test_an_empty_tree_and_one_without_sites() -> None:
    found = sent(f"{HEAD}/>").operations
    assert (found.roots, found.sites, found.units) == ((), (), "m")


def test_operations_nest() -> None:
    tree = sent(
        document(
            f'<acme:bend angle="5">{MODEL}<still>{GROW}</still>{GROW}<branch weight="2">{GROW}</branch>'
            "<branch/></acme:bend>",
            ' sites="Plot Lot"',
        )
    ).operations
    (bend,) = tree.roots
    assert isinstance(bend.operation, Bend)
    assert bend.operation.model is not None
    assert bend.operation.model.label == "Sill"
    assert [type(child.operation) for child in bend.children] == [Still, Grow]
    assert [(branch.weight, len(branch.children)) for branch in bend.branches] == [(2, 1), (1, 0)]
    assert len(tree.nodes) == 5
    assert tree.sites == ("Plot", "Lot")
    assert [node.operation.place.line for node in tree.nodes if node.operation.place] == [2] * 5


def test_files_are_read_along() -> None:
    assert NAMING.facade is not None
    assert NAMING.facade.facade is not None
    assert (NAMING.facade.facade.name, NAMING.facade.picture) == ("wall", b"not looked into")
    assert NAMING.session is not None
    # Only what is in force of it.
    assert NAMING.session.steps == (Edit("remove", "columns", ("panes",), source=(2,)),)
    assert set(NAMED.files) == {"o.xml", "walls/wall.xml", "walls/photos/wall.jpg", "walls/edits.xml"}


def test_a_folder_reads_as_what_is_sent(folder: Path) -> None:
    path = folder / "o.xml"
    path.write_bytes(NAMED.files["o.xml"])
    found = read_operations(path, KINDS, CONSTRAINTS)
    assert found.operations == NAMED.operations
    assert found.files == NAMED.files
    again = read_operations_files(found.files, "o.xml", KINDS, CONSTRAINTS)
    assert (again.operations, again.files) == (found.operations, found.files)


def test_files_outside_of_the_folder_keep_their_way(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder / "walls")
    text = document('<grow amount="1" facade="../plain.xml"/><grow amount="1" facade="../walls/wall.xml"/>')
    Path("o.xml").write_text(text)
    found = read_operations("o.xml", KINDS, CONSTRAINTS)
    assert set(found.files) == {
        "o.xml",
        "../plain.xml",
        "../walls/wall.xml",
        "../walls/photos/wall.jpg",
    }
    again = read_operations_files(found.files, "o.xml", KINDS, CONSTRAINTS)
    assert again.operations == found.operations


def test_each_file_is_read_once(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = folder / "o.xml"
    naming = '<grow amount="1" facade="walls/wall.xml" session="walls/edits.xml"/>'
    path.write_text(document(naming * 3))
    loaded: list[str] = []
    whole = Source.whole

    def counting(source: Source) -> bytes:
        if source.data is None:
            loaded.append(Path(source.file).name)
        return whole(source)

    monkeypatch.setattr(Source, "whole", counting)
    found = read_operations(path, KINDS, CONSTRAINTS)
    assert sorted(loaded) == ["edits.xml", "o.xml", "wall.jpg", "wall.xml"]
    first, *others = (node.operation.facade for node in found.operations.nodes)  # type: ignore[attr-defined]
    assert all(other is first for other in others)


def test_what_was_not_sent_is_not_looked_for(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    text = document('<grow amount="1" facade="plain.xml"/>').encode()
    with pytest.raises(Faulty) as raised:
        read_operations_files({"o.xml": text, "plane.xml": b""}, "o.xml", KINDS, CONSTRAINTS)
    (missing,) = raised.value.diagnostics
    assert (missing.code, missing.hint) == ("LK880", "did you mean 'plane.xml'?")
    with pytest.raises(Faulty, match="not among those that were sent"):
        read_operations_files({}, "o.xml", KINDS, CONSTRAINTS)


BROKEN: dict[str, tuple[str, list[str]]] = {
    "misspelt kind": ("<gorw amount='2'/>", ["LK102 2:1"]),
    "misspelt kind, and faults inside": (
        f"<gorw amuont='2'>\n<stil/>{GROW}</gorw>",
        ["LK102 2:1", "LK103 2:1", "LK102 3:1"],
    ),
    "another's kind without its namespace": ("<bend/>", ["LK102 2:1"]),
    "our kind in another's namespace": ("<acme:grow amount='2'/>", ["LK102 2:1"]),
    "unknown namespace": ("<x:bend xmlns:x='urn:acme:operation'/>", ["LK113 2:1"]),
    "element of another document": ("<polygon points='0,0 1,0 1,1'/>", ["LK102 2:1"]),
    "misspelt attribute": ("<grow amonut='2'/>", ["LK103 2:1"]),
    "missing attribute": ("<still>\n<grow/></still>", ["LK104 3:1"]),
    "bad value": ("<grow amount='-2'/>", ["LK106 2:1"]),
    "bad colour": ("<grow amount='2' colour='red'/>", ["LK105 2:1"]),
    "value that the kind refuses": ("<acme:bend angle='91'/>", ["LK105 2:1"]),
    "text": ("<still>x</still>", ["LK109 2:8"]),
    "branch at the root": ("<branch/>", ["LK108 2:1"]),
    "branch in a branch": ("<still><branch>\n<branch/></branch></still>", ["LK108 3:1"]),
    "operation behind a branch": (f"<still><branch/>\n{GROW}</still>", ["LK108 3:1"]),
    "misspelt branch": ("<still>\n<brnach/></still>", ["LK102 3:1"]),
    "weight": ("<still>\n<branch weight='0'/></still>", ["LK106 3:1"]),
    "model at the root": (MODEL, ["LK108 2:1"]),
    "model where none is held": (f"<still>\n{MODEL}</still>", ["LK108 3:1"]),
    "model behind operations": (f"<grow amount='1'>{GROW}\n{MODEL}</grow>", ["LK108 3:1"]),
    "two models": (f"<grow amount='1'>{MODEL}\n{MODEL}</grow>", ["LK108 3:1"]),
    "faulty model": (f"<grow amount='1'>\n{MODEL.replace('units', 'unist')}</grow>", ["LK103 3:1"]),
    "model without examples": (
        "<grow amount='1'>\n<placement-model name='' units='m' label='Sill'/></grow>",
        ["LK107 3:1"],
    ),
    "what the operation says": ("<still>\n<grow amount='13'/></still>", ["LK882 3:1"]),
    "file that is not there": ("<grow amount='1' facade='palin.xml'/>", ["LK880 2:1"]),
    "session that is not there": ("<grow amount='1' session='none.xml'/>", ["LK880 2:1"]),
    "name of no file": (f"<grow amount='1' facade='{'x' * 300}'/>", ["LK880 2:1"]),
    "no name": ("<grow amount='1' facade=''/>", ["LK105 2:1"]),
    "folder": ("<grow amount='1' facade='walls'/>", ["LK880 2:1"]),
    "layout for a facade": ("<grow amount='1' facade='layout.xml'/>", ["LK887 2:1"]),
    "picture that is not there": ("<grow amount='1' facade='unpictured.xml'/>", ["LK880 2:1"]),
}


@pytest.mark.parametrize("name", BROKEN)
def test_every_fault_is_reported_once_at_its_place(name: str, folder: Path) -> None:
    inside, expected = BROKEN[name]
    path = folder / "o.xml"
    path.write_text(document(inside))
    found = check(path, CONSTRAINTS, KINDS)
    assert [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place] == expected
    assert {d.place.file for d in found if d.place} == {str(path)}
    assert all(d.severity is Severity.ERROR and d.code in CODES and d.hint for d in found)
    with pytest.raises(Faulty) as raised:
        read_operations(path, KINDS, CONSTRAINTS)
    assert list(raised.value.diagnostics) == found


WHOLE = {
    "no namespace": (document(GROW).replace(' xmlns="urn:layoutkit:1"', ""), ["LK101 1"]),
    "another document": ('<scene xmlns="urn:layoutkit:1" name="s" units="m"/>', ["LK101 1"]),
    "root attributes": (
        document(GROW).replace("name", "nmae").replace('"m"', '"cm"'),
        ["LK103 1", "LK105 1"],
    ),
    "labels": (document(GROW, ' sites="1st"'), ["LK105 1"]),
    "broken XML": (document("<still>"), ["LK002 3"]),
}


@pytest.mark.parametrize("name", WHOLE)
def test_faults_of_whole_documents(name: str) -> None:
    text, expected = WHOLE[name]
    with pytest.raises(Faulty) as raised:
        sent(text)
    assert [f"{d.code} {d.place.line}" for d in raised.value.diagnostics if d.place] == expected


def test_faults_of_a_named_file_stand_at_their_places_and_at_each_element_that_names_it(folder: Path) -> None:
    path = folder / "o.xml"
    path.write_text(
        document('<grow amount="1" facade="faulty.xml"/>\n<grow amount="2" facade="faulty.xml"/>')
    )
    found = [
        (d.code, Path(d.place.file).name, d.place.line) for d in check(path, CONSTRAINTS, KINDS) if d.place
    ]
    assert sorted(found) == [("LK212", "faulty.xml", 1), ("LK887", "o.xml", 2), ("LK887", "o.xml", 3)]


@pytest.mark.parametrize(
    ("attributes", "message"),
    [
        ("amount='6m'", "'6m' has a unit: write 6 in the units of the document"),
        ("amount='1.5 cm'", "'1.5 cm' has a unit: write 1.5 in the units of the document"),
        ("amount='six'", "'six' is not a finite number greater than 0"),
        ("amount='1' random='2m'", "'2m' has a unit: write 2 in the units of the document"),
        ("amount='1' labels='Plot,Street'", "'Plot,Street' has commas: labels are separated by blanks"),
    ],
)
def test_usual_slips_in_values_are_named(attributes: str, message: str) -> None:
    with pytest.raises(Faulty, match=message):
        sent(document(f"<grow {attributes}/>"))


@pytest.mark.parametrize(
    ("inside", "hint"),
    [
        ("<gorw amount='2'/>", "did you mean 'grow'?"),
        ("<bend/>", f'write <acme:bend xmlns:acme="{ACME.uri}" ...>'),
        ("<acme:bned/>", "did you mean 'bend'?"),
        ("<x:bend xmlns:x='urn:acme:operation'/>", f"did you mean {ACME.uri!r}?"),
        ("<grow amonut='2'/>", "did you mean 'amount'?"),
        ("<still><brnach/></still>", "did you mean 'branch'?"),
        ("<polygon/>", "known are: grow, still"),
        ("<gorw><polygon/></gorw>", "did you mean 'grow'?"),
        ("<still><polygon/></still>", "known are: branch, grow, still"),
        ("<grow amount='1'><polygon/></grow>", "known are: branch, grow, placement-model, still"),
        ("<branch/>", "allowed are: <grow>, <still>"),
        ("<still><branch/><still/></still>", "the order is: operations, <branch>"),
        (
            f"<grow amount='1'><still/>{MODEL}</grow>",
            "the order is: <placement-model> at most once, operations, <branch>",
        ),
        ("<grow amount='1' facade='plian.xml'/>", "did you mean 'plain.xml'?"),
        ("<grow amount='1' facade='x'/>", "put the facade there, or correct the attribute that names it"),
        ("<grow amount='1' facade='walls/wal.xml'/>", "did you mean 'walls/wall.xml'?"),
    ],
)
@pytest.mark.parametrize("way", ["folder", "sent"])
def test_hints_say_what_to_do(inside: str, hint: str, way: str, folder: Path) -> None:
    path = folder / "o.xml"
    path.write_text(document(inside))
    reading: Callable[[], Any] = {
        "folder": lambda: read_operations(path, KINDS, CONSTRAINTS),
        "sent": lambda: sent(document(inside)),
    }[way]
    with pytest.raises(Faulty) as raised:
        reading()
    assert raised.value.diagnostics[0].hint == hint


def test_a_kind_that_fails_is_named() -> None:
    with pytest.raises(Faulty) as raised:
        sent(document('<still>\n<grow amount="666"/></still>'))
    (failed,) = raised.value.diagnostics
    assert failed.place is not None
    assert (failed.code, failed.place.line) == ("LK407", 3)
    assert failed.message.startswith("the operation 'grow' of the module ")
    assert "RuntimeError: too much" in failed.message


def test_what_is_an_operations_document() -> None:
    assert is_operations(Source("-", HEAD.encode() + b">"))
    assert not is_operations(Source("-", b"<scene/>"))
    assert "operations" in ROOTS
