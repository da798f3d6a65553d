"""The schema: shipped as generated, explained throughout, and with plugins' kinds like built-in ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, ClassVar

from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.constraints.attributes import AttributeType, attribute
from layoutkit.diagnostics.codes import CODES
from layoutkit.documents import NAMESPACE, check, schema
from layoutkit.model import Facade
from layoutkit_operations.kinds import BUILT_IN as OPERATIONS

Kinds = Mapping[str, type[Constraint]]
ROOT = Path(__file__).parents[2]
XS = "{http://www.w3.org/2001/XMLSchema}"


def test_the_shipped_schema_is_the_generated_one(kinds: Kinds) -> None:
    shipped = ROOT / "schemas" / "layoutkit.xsd"
    operations = {kind.kind: kind for kind in OPERATIONS}
    written = schema(kinds, operations)
    assert shipped.read_bytes() == written, "write it anew: layoutkit schema -o schemas/layoutkit.xsd"


def test_everything_is_explained(kinds: Kinds) -> None:
    root = etree.fromstring(schema(kinds))
    explained = [*root.iter(f"{XS}element", f"{XS}attribute")]
    assert len(explained) > 40
    for declared in explained:
        text = declared.findtext(f"{XS}annotation/{XS}documentation")
        assert text, declared.get("name")
        assert text.endswith("."), declared.get("name")


def test_a_schema_without_kinds_allows_no_constraint() -> None:
    validator = etree.XMLSchema(etree.fromstring(schema({})))
    assert validator.validate(etree.fromstring(FACADE.format("")))
    assert not validator.validate(etree.fromstring(FACADE.format("<size of='F'/>")))


def _grams(text: str) -> float:
    if text == "crash":
        raise RuntimeError("the scales are broken")
    return float(text.removesuffix("g"))


@dataclass(frozen=True, kw_only=True)
class Weight(Constraint):
    """A plugin's kind."""

    kind: ClassVar[str] = "weight"
    summary: ClassVar[str] = "The facade weighs no more than that."

    at_most: float = attribute(AttributeType("grams", _grams, pattern="[0-9]+g|crash"), "The limit.")
    note: str = attribute(AttributeType("text", str), "Anything.", "")

    def faults(self, facade: Facade):  # type: ignore[no-untyped-def]
        if self.note == "crash":
            raise RuntimeError("no scales")
        return iter(())


FACADE = (
    '<facade xmlns="urn:layoutkit:1" name="f" units="m"><region symbol="F" width="1" height="1"/>\n'
    "<constraints>{}</constraints></facade>"
)


def test_a_plugins_kind_takes_part(kinds: Kinds, written: Callable[..., Path]) -> None:
    both = {**kinds, "weight": Weight}
    validator = etree.XMLSchema(etree.fromstring(schema(both)))
    for constraint, codes in (
        ('<weight at-most="5g"/>', []),
        ('<weight at-most="5"/>', ["LK105"]),
        ('<weight atmost="5g"/>', ["LK103"]),
        ("<weight/>", ["LK104"]),
    ):
        text = FACADE.format(constraint)
        assert [d.code for d in check(written(text), both)] == codes
        assert validator.validate(etree.fromstring(text)) is (not codes)


def test_a_plugin_that_fails_is_named(written: Callable[..., Path]) -> None:
    for constraint in ('<weight at-most="crash"/>', '<weight at-most="5g" note="crash"/>'):
        found = check(written(FACADE.format(constraint)), {"weight": Weight})
        assert [(d.code, d.place and d.place.line) for d in found] == [("LK407", 2)]
        assert "'weight' of the module test_schema failed: RuntimeError" in found[0].message


def test_every_code_in_use_is_registered() -> None:
    sources = [*(ROOT / "layoutkit").rglob("*.py"), *(ROOT / "plugins").rglob("*.py")]
    used = {
        (code, source.name)
        for source in sources
        for code in re.findall(r"[\"'](LK\d{3,})[\"']", source.read_text())
        if source.parent.name != "codes"
    }
    assert len(used) > 40
    assert not {(code, file) for code, file in used if code not in CODES}


def test_codes_are_given_out_once_in_order_and_say_everything() -> None:
    files = sorted((ROOT / "layoutkit/diagnostics/codes").glob("*.py"))
    written = [code for file in files for code in re.findall(r'^        "(LK\d+)",$', file.read_text(), re.M)]
    assert list(CODES) == sorted(CODES) == sorted(written)
    for code, entry in CODES.items():
        assert re.fullmatch(r"LK\d{3}", code)
        assert code == entry.code
        assert entry.title
        assert not entry.title.endswith(".")
        assert all(text.endswith(".") for text in (entry.explanation, entry.cause, entry.remedy)), code


VALIDATOR = etree.XMLSchema(etree.fromstring(schema({kind.kind: kind for kind in BUILT_IN})))
ATTRIBUTES = (
    "symbol",
    "width",
    "height",
    "split",
    "labels",
    "fill",
    "of",
    "within",
    "min",
    "max",
    "first",
    "lines",
    "name",
)
VALUES = st.sampled_from(
    [
        "F",
        "A",
        "1",
        "0",
        "-1",
        "1e3",
        " 2 ",
        "nan",
        "50%",
        "columns",
        "rows",
        "left",
        "m",
        "",
        "F/A",
        "A B",
        "@A",
    ]
) | st.text("Aé_1.- %/@|~\u00a0\u0660", max_size=3)
GIVEN = st.dictionaries(st.sampled_from(ATTRIBUTES), VALUES, max_size=4)


def _elements(
    names: tuple[str, ...], children: st.SearchStrategy[list[etree._Element]]
) -> st.SearchStrategy[Any]:
    def made(name: str, attributes: dict[str, str], inside: list[etree._Element]) -> etree._Element:
        element = etree.Element(f"{{{NAMESPACE}}}{name}", attributes, nsmap={None: NAMESPACE})
        element.extend([etree.fromstring(etree.tostring(child)) for child in inside])
        return element

    return st.builds(made, st.sampled_from(names), GIVEN, children)


LEAVES = _elements(("region", "again", "constraints"), st.just([]))
RULES = _elements(
    ("constraints",), st.lists(_elements(("size", "frequency", "alignment", "x"), st.just([])), max_size=2)
)
REGIONS = st.recursive(
    LEAVES, lambda inner: _elements(("region",), st.lists(inner, max_size=3)), max_leaves=5
)


@given(st.lists(REGIONS, min_size=1, max_size=2), st.lists(RULES, max_size=1))
def test_what_the_schema_rejects_the_reader_rejects(regions: list[Any], rules: list[Any]) -> None:
    kinds = {kind.kind: kind for kind in BUILT_IN}
    root = etree.Element(f"{{{NAMESPACE}}}facade", {"name": "f", "units": "m"}, nsmap={None: NAMESPACE})
    root.extend(regions + rules)
    source = etree.tostring(root)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "facade.xml"
        path.write_bytes(source)
        found = check(path, kinds)
    if not VALIDATOR.validate(etree.fromstring(source)):
        assert found, source.decode()


@given(GIVEN, st.sampled_from(BUILT_IN))
def test_the_schema_and_the_reader_agree_on_attributes(
    values: dict[str, str], kind: type[Constraint]
) -> None:
    constraint = etree.Element(kind.kind, values)
    text = FACADE.replace("{}", etree.tostring(constraint, encoding="unicode"))
    with TemporaryDirectory() as folder:
        path = Path(folder) / "facade.xml"
        path.write_text(text, encoding="utf-8")
        found = check(path, {k.kind: k for k in BUILT_IN})
    if not VALIDATOR.validate(etree.fromstring(text)):
        assert any(d.code.startswith("LK1") for d in found), text
