"""Session documents: every fault at its place, edits read back as written, also those that were undone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import (
    Source,
    check,
    facade_bytes,
    is_session,
    layout_bytes,
    read,
    read_session,
    schema,
    session_bytes,
)
from layoutkit.documents.mending import mended
from layoutkit.model import (
    Drag,
    Edit,
    Facade,
    Grid,
    Layout,
    Region,
    RegionSet,
    RegionSize,
    Resize,
    Session,
    Step,
)
from tests.documents.test_document_round_trips import TEXT, WORDS

KINDS = {kind.kind: kind for kind in BUILT_IN}
SCHEMA = etree.XMLSchema(etree.fromstring(schema(KINDS)))

FLOOR = Region("S", 4.0, 1.0, "columns", (Region("A", 2.0, 1.0), Region("A", 2.0, 1.0)))
FACADE = Facade(
    "f",
    "m",
    Region("F", 4.0, 2.0, "rows", (FLOOR, FLOOR)),
    grids=(Grid("a", RegionSet("F/S/A")), Grid("b", RegionSet("F/S"))),
)
HEAD = '<session xmlns="urn:layoutkit:1" name="s" facade="facade.xml">'
OPEN = HEAD.removesuffix(">")
ADD = '<edit action="add" axis="columns" grids="a" source="1" at="2"/>'
XSD, READER = "the schema sees it, too", "only the reader sees it"


@dataclass(frozen=True)
class Broken:
    """A session, and what is wrong with it as ``CODE line:column``."""

    name: str
    text: str
    expected: tuple[str, ...]
    seen_by: str


def steps(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    """A session whose edits begin in line 2."""
    return Broken(name, f"{HEAD}\n{text}\n</session>", expected, seen_by)


def edit(name: str, attributes: str, *expected: str, seen_by: str = READER) -> Broken:
    """A session of one edit; columns of the grid `a`, if it does not say otherwise."""
    shown = attributes if "grids=" in attributes else f'grids="a" {attributes}'
    shown = shown if "axis=" in shown else f'axis="columns" {shown}'
    return steps(name, f"<edit {shown}/>", *expected, seen_by=seen_by)


def whole(name: str, text: str, *expected: str, seen_by: str = XSD) -> Broken:
    return Broken(name, text, expected, seen_by)


CASES = [
    # The root
    steps("no edit", "", seen_by=READER),
    whole("misspelt", HEAD.replace("session", "sesion").replace(">", "/>"), "LK101 1:1"),
    whole("another namespace", '<session xmlns="urn:other"/>', "LK101 1:1"),
    whole("another version", '<session xmlns="urn:layoutkit:2"/>', "LK101 1:1"),
    whole("no namespace", '<session name="s" facade="facade.xml"/>', "LK101 1:1"),
    whole("no attributes", '<session xmlns="urn:layoutkit:1"/>', "LK104 1:1", "LK104 1:1"),
    whole("units", f'{OPEN} units="m"/>', "LK103 1:1"),
    whole("done that is no number", f'{OPEN} done="all"/>', "LK105 1:1"),
    whole("none done", f'{OPEN} done="0">\n{ADD}</session>', seen_by=READER),
    whole("more done", f'{OPEN} done="2">\n{ADD}</session>', "LK105 1:1", seen_by=READER),
    whole("no facade", HEAD.replace("facade.", "fasade.") + "</session>", "LK504 1:1", seen_by=READER),
    whole("itself", HEAD.replace("facade.", "session.") + "</session>", "LK505 1:1", seen_by=READER),
    whole("a layout", HEAD.replace("facade.", "layout.") + "</session>", "LK505 1:1", seen_by=READER),
    whole("a name too long", HEAD.replace("facade.", "x" * 300) + "</session>", "LK001 1:1", seen_by=READER),
    steps("text", "undo", "LK109 2:1"),
    steps("region", '<region symbol="A" width="1" height="1"/>', "LK108 2:1"),
    steps("unknown step", "<undo/>", "LK102 2:1"),
    steps("inside an edit", f"{ADD[:-2]}>{ADD}</edit>", "LK108 2:63"),
    # Edits
    edit("add", 'action="add" source="1" at="3"'),
    edit("remove", 'action="remove" source="2"'),
    edit("move", 'action="move" source="2" to="1"'),
    edit("move an element", 'action="move" element="F/S.2/A" to="1"'),
    edit("families", 'grids="a b" action="add" source="2 1" at="3 1" width="5.5"'),
    edit("rows", 'axis="rows" action="add" source="1" at="1" height="3e0"'),
    edit("no action", 'source="1"', "LK104 2:1", seen_by=XSD),
    edit("unknown action", 'action="delete" source="1"', "LK105 2:1", seen_by=XSD),
    edit("unknown axis", 'action="remove" axis="x" source="1"', "LK105 2:1", seen_by=XSD),
    edit("misspelt attribute", 'action="remove" sorce="1"', "LK103 2:1", seen_by=XSD),
    edit("no grid", 'grids="" action="remove" source="1"', "LK105 2:1", seen_by=XSD),
    edit("grid twice", 'grids="a a" action="remove" source="1"', "LK105 2:1"),
    edit("grid by number", 'grids="1" action="remove" source="1"', "LK105 2:1", seen_by=XSD),
    edit("unknown grids", 'grids="c b d" action="remove" source="1 1"', "LK246 2:1", "LK246 2:1"),
    edit("the zeroth", 'action="remove" source="0"', "LK105 2:1", seen_by=XSD),
    edit("the last", 'action="remove" source="-1"', "LK105 2:1", seen_by=XSD),
    edit("beyond all", f'action="remove" source="{"9" * 10}"', "LK105 2:1"),
    edit("a half", 'action="remove" source="1.5"', "LK105 2:1", seen_by=XSD),
    edit("a list with commas", 'action="remove" source="1,2"', "LK105 2:1", seen_by=XSD),
    edit("added from nowhere", 'action="add" at="1"', "LK104 2:1"),
    edit("added nowhere", 'action="add" source="1"', "LK104 2:1"),
    edit("nothing said", 'action="add"', "LK104 2:1", "LK104 2:1"),
    edit("removed to somewhere", 'action="remove" source="1" at="2" to="3"', "LK103 2:1", "LK103 2:1"),
    edit("moved nowhere", 'action="move" source="1"', "LK104 2:1"),
    edit("moved at", 'action="move" source="1" at="2"', "LK104 2:1", "LK103 2:1"),
    edit("line and element moved", 'action="move" source="1" element="F/S" to="1"', "LK103 2:1"),
    edit("element removed", 'action="remove" element="F/S"', "LK104 2:1", "LK103 2:1"),
    edit("element by its set", 'action="move" element="@A" to="1"', "LK105 2:1", seen_by=XSD),
    edit("two elements", 'action="move" element="F/S/A F/S/A.2" to="1"', "LK105 2:1", seen_by=XSD),
    edit("element to two places", 'action="move" element="F/S/A" to="1 2"', "LK105 2:1"),
    edit("fewer places", 'grids="a b" action="add" source="1 2" at="1"', "LK105 2:1"),
    edit("more places", 'action="move" source="1" to="1 2"', "LK105 2:1"),
    edit("no width", 'action="remove" source="1" width="0"', "LK106 2:1", seen_by=XSD),
    # Sizes
    steps("resize", '<resize width="3"/><resize height="3"/><resize width="3" height="4"/>', seen_by=READER),
    steps("resize to nothing", "<resize/>", "LK104 2:1", seen_by=READER),
    steps("resize below 0", '<resize width="-1"/>', "LK106 2:1"),
    steps("resize by a share", '<resize width="120%"/>', "LK106 2:1"),
    steps("drag", '<drag region="F/S.2" side="top" to="-1.5"/>', seen_by=READER),
    steps("drag nothing", "<drag/>", *["LK104 2:1"] * 3),
    steps("drag a corner", '<drag region="F" side="top left" to="1"/>', "LK105 2:1"),
    steps("drag to nowhere", '<drag region="F" side="top" to="nan"/>', "LK105 2:1"),
    steps("size", '<size region="F/S/A.2" height="0.5"/>', seen_by=READER),
    steps("size of nothing", '<size height="0.5"/>', "LK104 2:1"),
    steps("no size", '<size region="F/S"/>', "LK104 2:1", seen_by=READER),
    steps("a constraint", '<size of="F/S" min="1"/>', *["LK103 2:1"] * 2, *["LK104 2:1"] * 2),
    steps("one fault in each", f"{ADD}\n<resize/>\n{ADD.replace('1', 'x')}", "LK104 3:1", "LK105 4:1"),
]  # fmt: skip


@pytest.fixture
def session(tmp_path: Path) -> Path:
    (tmp_path / "facade.xml").write_bytes(facade_bytes(FACADE))
    (tmp_path / "layout.xml").write_bytes(layout_bytes(Layout("l", "m", FACADE.root)))
    return tmp_path / "session.xml"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_fault_is_reported_once_at_its_place(case: Broken, session: Path) -> None:
    session.write_text(case.text)
    found = check(session, KINDS)
    assert [f"{d.code} {d.place.line}:{d.place.column}" for d in found if d.place] == list(case.expected)
    assert all(d.severity is Severity.ERROR and d.code in CODES and d.message and d.hint for d in found)
    assert SCHEMA.validate(etree.fromstring(case.text)) is (case.seen_by == READER)
    if case.expected:
        with pytest.raises(Faulty) as raised:
            read_session(session, KINDS)
        codes = [d.code for d in raised.value.diagnostics]
        assert codes == [expected.split()[0] for expected in case.expected]
    else:
        assert read_session(session, KINDS).facade == FACADE


def test_faults_of_the_facade_are_the_sessions(session: Path) -> None:
    session.write_text(f"{HEAD}\n<resize/></session>")
    facade = session.with_name("facade.xml")
    facade.write_text(facade.read_text().replace('of="F/S/A"', 'of="F/S/B"'))
    found = check(session, KINDS)
    assert [(d.code, d.place and Path(d.place.file).name) for d in found] == [
        ("LK104", "session.xml"),
        ("LK241", "facade.xml"),
    ]


def test_a_facade_without_grids_is_told(session: Path) -> None:
    session.write_text(f"{HEAD}\n{ADD}</session>")
    session.with_name("facade.xml").write_bytes(facade_bytes(replace(FACADE, grids=())))
    assert [(d.code, d.hint) for d in check(session, KINDS)] == [
        ("LK246", "the facade has none: `layoutkit grids` finds some")
    ]


def test_the_facade_is_looked_for_beside_the_session(session: Path, tmp_path: Path) -> None:
    (tmp_path / "edits").mkdir()
    inner = tmp_path / "edits" / "s.xml"
    inner.write_bytes(session_bytes(Session("s", "../facade.xml")))
    assert read_session(str(inner), KINDS).facade == FACADE
    inner.write_bytes(session_bytes(Session("s", "../facad.xml")))
    (missing,) = check(inner, KINDS)
    assert (missing.code, missing.hint) == ("LK504", "did you mean '../facade.xml'?")


def test_what_is_a_session(session: Path, tmp_path: Path) -> None:
    session.write_text(HEAD)  # and broken off
    assert is_session(session)
    assert is_session(Source("-", HEAD.encode()))
    assert not is_session(tmp_path / "facade.xml")
    assert not is_session(Source("-", b"no XML"))
    with pytest.raises(Faulty, match="LK001"):
        is_session(tmp_path / "none.xml")
    session.write_text(f"{HEAD}</session>")
    with pytest.raises(Faulty, match="<session> is no facade") as raised:
        read(session, KINDS)
    assert (
        raised.value.diagnostics[0].hint == "name the facade that it edits, which its attribute facade says"
    )
    with pytest.raises(Faulty, match="<facade> is no session"):
        read_session(tmp_path / "facade.xml", KINDS)


STEPS = st.text("AB_é", min_size=1, max_size=3)
PATHS = st.lists(
    st.builds(lambda symbol, n: f"{symbol}.{n}" if n > 1 else symbol, STEPS, st.integers(1, 12)), min_size=1
).map("/".join)
SIZES = st.floats(1e-9, 1e9)
NAMED = st.lists(st.sampled_from(("a", "b")), min_size=1, unique=True).map(tuple)
NUMBERS = st.integers(1, 999)


@st.composite
def edits(draw: st.DrawFn) -> Edit:
    pairs = draw(st.lists(st.tuples(NUMBERS, NUMBERS), min_size=1, max_size=3))
    source, places = (tuple(numbers) for numbers in zip(*pairs, strict=True))
    what: dict[str, Any] = draw(
        st.sampled_from(
            [
                {"action": "add", "source": source, "at": places},
                {"action": "remove", "source": source},
                {"action": "move", "source": source, "to": places},
                {"action": "move", "element": draw(PATHS), "to": places[:1]},
            ]
        )
    )
    sizes = draw(st.fixed_dictionaries({}, optional={"width": SIZES, "height": SIZES}))
    return Edit(axis=draw(st.sampled_from(("columns", "rows"))), grids=draw(NAMED), **what, **sizes)


def sized(kind: Callable[..., Step], **others: st.SearchStrategy[Any]) -> st.SearchStrategy[Step]:
    both = st.tuples(st.none() | SIZES, st.none() | SIZES).filter(lambda pair: pair != (None, None))
    return st.builds(lambda pair, **more: kind(**more, width=pair[0], height=pair[1]), both, **others)


SIDES = st.sampled_from(("left", "right", "top", "bottom"))
ANY_STEP: st.SearchStrategy[Step] = st.one_of(
    edits(),
    sized(Resize),
    sized(RegionSize, region=PATHS),
    st.builds(Drag, PATHS, SIDES, st.floats(-1e9, 1e9)),
)
SESSIONS = st.builds(
    Session,
    TEXT,
    st.just("facade.xml"),
    st.lists(ANY_STEP, max_size=4).map(tuple),
    st.lists(ANY_STEP, max_size=3).map(tuple),
)


@given(SESSIONS)
def test_sessions_read_back(tmp_path_factory: pytest.TempPathFactory, written: Session) -> None:
    path = tmp_path_factory.mktemp("s") / "session.xml"
    (path.parent / "facade.xml").write_bytes(facade_bytes(FACADE))
    path.write_bytes(session_bytes(written))
    found = read_session(path, KINDS)
    assert (found.session, found.facade, found.diagnostics) == (written, FACADE, ())
    assert session_bytes(found.session) == path.read_bytes()
    lines = [step.place.line for step in found.session.steps if step.place]
    assert lines == list(range(3, 3 + len(written.steps)))
    assert SCHEMA.validate(etree.parse(path)), SCHEMA.error_log
    assert check(path, KINDS) == []


@given(SESSIONS, ANY_STEP)
def test_undo_and_redo(session: Session, step: Step) -> None:
    taken = session.taking(step)
    assert taken.done == (*session.done, step)
    assert taken.undone == ()
    assert taken.undo().redo() == taken
    assert taken.undo().steps == taken.steps
    while session.done:
        assert session.undo().redo() == session
        session = session.undo()
    with pytest.raises(ValueError, match="nothing to undo"):
        session.undo()
    while session.undone:
        assert session.redo().undo() == session
        session = session.redo()
    with pytest.raises(ValueError, match="nothing to redo"):
        session.redo()


def test_what_was_taken_back_survives_saving(session: Path) -> None:
    first, second = Resize(3.0), Drag("F/S", "top", 1.5)
    edited = Session("s", "facade.xml", (first, second)).undo()
    session.write_bytes(session_bytes(edited))
    assert b' done="1">' in session.read_bytes()
    again = read_session(session, KINDS).session
    assert again.redo().done == (first, second)
    assert b"done" not in session_bytes(again.redo())


def test_a_character_that_xml_cannot_hold_is_refused() -> None:
    with pytest.raises(Faulty, match="LK009"):
        session_bytes(Session("\0", "facade.xml"))


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        (ADD.replace("edit", "edti"), ADD),
        (ADD.replace("axis", "axes"), ADD),
        (ADD.replace("columns", "colums"), ADD),
        ('<size region="F/S" widht="2"/>', '<size region="F/S" width="2"/>'),
        ('<drag region="F" side="Top" to="2"/>', '<drag region="F" side="top" to="2"/>'),
    ],
)
def test_misspelt_edits_are_mended(wrong: str, right: str, session: Path) -> None:
    session.write_text(f"{HEAD}\n{wrong}\n</session>")
    done = mended(
        session.read_bytes(), str(session), lambda data: check(Source(str(session), data), KINDS), KINDS
    )
    assert done.source.decode() == f"{HEAD}\n{right}\n</session>"
    assert done.diagnostics == ()


WORDY = f"# Edits\n\n```xml\n{HEAD}\n{ADD.replace('grids', 'girds')}\n</session>\n```\n"


def test_the_commands_know_sessions(session: Path, layoutkit: Callable[..., Any]) -> None:
    session.write_text(f'{OPEN} done="1">\n{ADD}\n<drag region="F/S" side="top" to="1.50"/></session>')
    assert layoutkit("validate", session.parent).out.splitlines()[-1] == "3 documents: 3 valid"
    run = layoutkit("inspect", session)
    assert run.out.splitlines() == [
        "session s: facade.xml, 1 edit in force, 1 taken back",
        '1 edit action="add" axis="columns" grids="a" source="1" at="2"',
        '2 drag region="F/S" side="top" to="1.5" (taken back)',
    ]
    assert layoutkit("inspect", session, "--json").data == {
        "kind": "session",
        "name": "s",
        "facade": "facade.xml",
        "done": 1,
        "edits": [
            {"kind": "edit", "action": "add", "axis": "columns", "grids": ["a"], "source": [1], "at": [2]},
            {"kind": "drag", "region": "F/S", "side": "top", "to": 1.5},
        ],
    }
    session.write_text(session.read_text().replace("axis", "axes"))
    assert layoutkit("inspect", session).code == 1
    assert layoutkit("validate", session).code == 1
    assert layoutkit("validate", session, "--fix").code == 0
    assert layoutkit("vary", session, "-n", "1", "-o", session.parent / "out").code == 1


def test_sessions_in_texts_are_checked(session: Path) -> None:
    text = session.with_name("edits.md")
    text.write_text(WORDY)
    assert [(d.code, d.place and d.place.line) for d in check(text, KINDS)] == [("LK103", 5)]


@given(
    st.lists(st.sampled_from((ADD, "<resize/>", '<resize width="x"/>', "<undo/>", "x")), max_size=4), WORDS
)
def test_what_the_schema_rejects_the_reader_rejects(
    tmp_path_factory: pytest.TempPathFactory, parts: list[str], grid: str
) -> None:
    folder = tmp_path_factory.mktemp("s")
    (folder / "facade.xml").write_bytes(facade_bytes(replace(FACADE, grids=(Grid(grid, RegionSet("F")),))))
    text = HEAD + "".join(parts).replace('"a"', f'"{grid}"') + "</session>"
    (folder / "session.xml").write_text(text, encoding="utf-8")
    if not SCHEMA.validate(etree.fromstring(text)):
        assert check(folder / "session.xml", KINDS)
