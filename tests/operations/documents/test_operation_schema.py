"""The schema of operations: what it accepts, and that it rejects nothing that the reader accepts."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.diagnostics import Faulty
from layoutkit.documents import NAMESPACE, operations_bytes, read_operations_files, schema, schemas
from tests.operations.documents.operation_kinds import ACME, CONSTRAINTS, FILES, KINDS, MODEL
from tests.operations.documents.test_operation_documents import BROKEN, TREES, document

XS = "{http://www.w3.org/2001/XMLSchema}"
OURS = {name: kind for name, kind in KINDS.items() if ":" not in name}


@pytest.fixture(scope="module")
def validator(tmp_path_factory: pytest.TempPathFactory) -> etree.XMLSchema:
    """Return the schema as `layoutkit schema -o other.xsd` writes it: parts that import each other."""
    folder = tmp_path_factory.mktemp("schema")
    for name, text in schemas(CONSTRAINTS, KINDS, "other.xsd").items():
        (folder / name).write_bytes(text)
    return etree.XMLSchema(etree.parse(str(folder / "other.xsd")))


def fine(text: str) -> bool:
    try:
        read_operations_files({**FILES, "o.xml": text.encode()}, "o.xml", KINDS, CONSTRAINTS)
    except Faulty:
        return False
    return True


@pytest.mark.parametrize(
    "inside",
    [
        "",
        "<still/><acme:bend/>",
        f"<acme:bend>{MODEL}<still><acme:bend/></still><branch><still/></branch><branch/></acme:bend>",
        f"<grow amount='2' colour='#00ff7F'>{MODEL}<acme:bend><grow amount='1'/></acme:bend></grow>",
        "<grow amount='2' facade='plain.xml'><branch><acme:bend/></branch></grow>",
    ],
)
def test_what_is_sound_is_accepted(inside: str, validator: etree.XMLSchema) -> None:
    text = document(inside, ' sites="A B"')
    validator.assertValid(etree.fromstring(text))
    assert fine(text)


#: What no schema can see.
READER = {
    "value that the kind refuses",
    "what the operation says",
    "no name",
    *(name for name, (_, expected) in BROKEN.items() if expected[0][:5] in ("LK880", "LK887")),
}


@pytest.mark.parametrize("name", BROKEN)
def test_the_schema_agrees(name: str, validator: etree.XMLSchema) -> None:
    inside, _ = BROKEN[name]
    assert validator.validate(etree.fromstring(document(inside))) is (name in READER)


@pytest.mark.parametrize(
    "inside",
    [
        "<acme:bned/>",
        "<acme:bend angel='3'/>",
        "<acme:bend><stil/></acme:bend>",
        "<acme:bend><acme:branch/></acme:bend>",
        "<acme:bend><branch weihgt='2'/></acme:bend>",
        "<acme:bend><still/><placement-model/></acme:bend>",
        "<acme:bend><facade/></acme:bend>",
    ],
)
def test_faults_in_others_operations_are_seen(inside: str, validator: etree.XMLSchema) -> None:
    assert not validator.validate(etree.fromstring(document(inside)))
    assert not fine(document(inside))


@given(tree=TREES)
def test_what_is_written_is_accepted(tree: Any, validator: etree.XMLSchema) -> None:
    validator.assertValid(etree.fromstring(operations_bytes(tree)))


NAMES = ("still", "grow", "branch", "bend", "placement-model", f"{{{ACME.uri}}}bend", "example")
GIVEN = st.dictionaries(
    st.sampled_from(("amount", "angle", "weight", "labels", "colour", "name", "wide-too")),
    st.sampled_from(("1", "0", "-1", "A", "A B", "", "#000000", "#fff", "yes", "1e3", " 2 ", "1,5")),
    max_size=2,
)


def element(name: str, given: dict[str, str], inside: list[Any]) -> Any:
    qualified = name if name.startswith("{") else f"{{{NAMESPACE}}}{name}"
    prefixes: Any = {None: NAMESPACE, "acme": ACME.uri}
    made = etree.Element(qualified, given, nsmap=prefixes)
    made.extend([etree.fromstring(etree.tostring(child)) for child in inside])
    return made


def elements(inside: st.SearchStrategy[list[Any]]) -> st.SearchStrategy[Any]:
    return st.builds(element, st.sampled_from(NAMES), GIVEN, inside)


FOREST = st.recursive(
    elements(st.just([])), lambda inner: elements(st.lists(inner, max_size=3)), max_leaves=5
)


@given(roots=st.lists(FOREST, max_size=2))
def test_what_the_schema_rejects_the_reader_rejects(roots: list[Any], validator: etree.XMLSchema) -> None:
    text = etree.tostring(element("operations", {"name": "o", "units": "m"}, roots), encoding="unicode")
    if not validator.validate(etree.fromstring(text)):
        assert not fine(text), text


def test_everything_is_explained() -> None:
    for text in schemas({}, KINDS).values():
        for declared in etree.fromstring(text).iter(f"{XS}element", f"{XS}attribute"):
            told = declared.findtext(f"{XS}annotation/{XS}documentation")
            foreign = ":" in declared.get("ref", "").removeprefix("layoutkit:")
            assert foreign or (told and told.endswith(".")), etree.tostring(declared)


def test_without_kinds_no_operation_is_allowed() -> None:
    alone = etree.XMLSchema(etree.fromstring(schema({})))
    assert alone.validate(etree.fromstring(document("")))
    assert not alone.validate(etree.fromstring(document("<still/>")))


def test_kinds_of_ones_own_need_no_other_file() -> None:
    parts = schemas(CONSTRAINTS, OURS)
    assert list(parts) == ["layoutkit.xsd"]
    alone = etree.XMLSchema(etree.fromstring(parts["layoutkit.xsd"]))
    assert alone.validate(etree.fromstring(document("<still><still/></still>")))


def test_the_command_writes_parts_that_import_what_it_wrote(
    install: Callable[..., Path], layoutkit: Any, tmp_path: Path
) -> None:
    source = Path(__file__).with_name("operation_kinds.py").read_text(encoding="utf-8")
    hook = (
        "from layoutkit.hooks import hookimpl\n\n@hookimpl\ndef layoutkit_operations():\n    return [Bend]\n"
    )
    install("benders", f"{source}\n\n{hook}")
    run = layoutkit("schema", "-o", tmp_path / "own.xsd")
    assert (run.code, run.out.splitlines()) == (0, [str(tmp_path / "own.xsd"), str(tmp_path / "acme.xsd")])
    written = etree.XMLSchema(etree.parse(str(tmp_path / "own.xsd")))
    text = document("<select labels='A'><acme:bend angle='2'><delete/></acme:bend></select>")
    written.assertValid(etree.fromstring(text))
    part = layoutkit("schema", "--namespace", "acme")
    assert (part.code, part.out.encode().rstrip()) == (
        0,
        (tmp_path / "acme.xsd").read_bytes().replace(b"own.xsd", b"layoutkit.xsd").rstrip(),
    )
