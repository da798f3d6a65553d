"""What is mended and what is left: documents, and what becomes of them, byte for byte."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.constraints.attributes import PATH, attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.documents import check
from layoutkit.documents.mending import MENDED, Mended, mended, proposals
from layoutkit.documents.mending.repair import apart, applied
from layoutkit.documents.source import Source
from layoutkit.documents.spelling import meant
from layoutkit.samples import list_samples
from tests.validation.conftest import HOUSE

KINDS = {kind.kind: kind for kind in BUILT_IN}
FILE = "house.xml"


def checked(source: bytes) -> Sequence[Diagnostic]:
    return check(Source(FILE, source), KINDS)


def mend(source: bytes) -> Mended:
    return mended(source, FILE, checked, KINDS)


@dataclass(frozen=True)
class Case:
    """A change of the house, and what it is mended to: by default what it was."""

    name: str
    code: str
    was: str
    becomes: str
    also: str | None = None

    @property
    def broken(self) -> str:
        assert HOUSE.count(self.was) == 1, self.was
        return HOUSE.replace(self.was, self.becomes)

    @property
    def whole(self) -> str:
        return HOUSE if self.also is None else HOUSE.replace(self.was, self.also)


ROWS = HOUSE[HOUSE.index('<region symbol="Top"') : HOUSE.index("    </region>")].rstrip()

SAFE = [
    Case("no namespace", "LK101", 'facade xmlns="urn:layoutkit:1" name', "facade name"),
    Case("empty namespace", "LK101", '<facade xmlns="urn:layoutkit:1"', '<facade xmlns=""'),
    Case("misspelt namespace", "LK101", '"urn:layoutkit:1"', '"urn:layoutkt:1"'),
    Case("namespace in capitals", "LK101", '"urn:layoutkit:1"', '"URN:LAYOUTKIT:1"'),
    Case("namespace with a slash", "LK101", '"urn:layoutkit:1"', '"urn:layoutkit:1/"'),
    Case("attribute misspelt", "LK103", 'width="6"', 'widht="6"'),
    Case("attribute in capitals", "LK103", 'symbol="Top"', 'Symbol="Top"'),
    Case("label instead of labels", "LK103", 'labels="Window"', 'label="Window"'),
    Case("element misspelt, empty", "LK102", '<region symbol="Top"', '<regoin symbol="Top"'),
    Case("constraint misspelt", "LK102", '<size of="Facade/Bay"', '<sise of="Facade/Bay"'),
    Case("choice misspelt", "LK105", 'units="m"', 'units="M"'),
    Case("choice in the singular", "LK105", 'split="rows"', 'split="row"'),
    Case("the document's own unit", "LK106", 'width="3"', 'width="3 m"', 'width="3"'),
    Case("split forgotten", "LK110", ' split="rows"', "", ' split="rows"'),
    Case("size said twice", "LK112", 'height="1"', 'height="1" width="3.0"', 'height="1"'),
    Case("min and max exchanged", "LK202", 'min="0.5" max="3"', 'min="3" max="0.5"'),
    Case("sum rounded", "LK212", 'height="3"', 'height="2.999999"'),
    Case("sum rounded, replicas", "LK212", 'width="3"', 'width="2.999999"'),
    Case(
        "sum rounded, only replicas to change",
        "LK212",
        ROWS,
        '<region symbol="A" height="1.333333"/><again symbol="A"/><again symbol="A"/>',
        '<region symbol="A" height="1.3333333333"/><again symbol="A"/><again symbol="A"/>',
    ),
    Case(
        "left and right exchanged",
        "LK213",
        '  <region symbol="Facade"',
        '  <picture file="a" left="60" top="0" right="0" bottom="9"/>\n  <region symbol="Facade"',
        '  <picture file="a" left="0" top="0" right="60" bottom="9"/>\n  <region symbol="Facade"',
    ),
    Case(
        "choices misspelt",
        "LK105",
        "</constraints>",
        '<alignment first="Facade/Pier" second="Facade/Bay" lines="lefft right"/></constraints>',
        '<alignment first="Facade/Pier" second="Facade/Bay" lines="left right"/></constraints>',
    ),
]

LEFT = [
    Case("root of another namespace", "LK101", "urn:layoutkit:1", "urn:layoutkit:2"),
    Case("root of a later version", "LK101", "urn:layoutkit:1", "urn:layoutkit:1.2"),
    Case("element far from any", "LK102", '<size of="Facade/Bay"', '<extent of="Facade/Bay"'),
    Case("element that lacks what it would need", "LK102", '<size of="Facade/Bay" min', "<sise min"),
    Case("attribute between two others", "LK103", 'min="80%"', 'mix="80%"'),
    Case("attribute that is there already", "LK103", 'height="4" split', 'height="4" heigth="5" split'),
    Case("size missing", "LK104", ' height="3"', ""),
    Case("another unit", "LK105", 'units="m"', 'units="cm"'),
    Case("size in another unit", "LK106", 'width="3"', 'width="300 cm"'),
    Case("decimal comma", "LK106", 'width="1.5"', 'width="1,5"'),
    Case("size below 0", "LK106", 'width="3"', 'width="-3"'),
    Case("text", "LK109", "<constraints>", "<constraints>why"),
    Case("the other size", "LK112", 'height="1"', 'width="1"'),
    Case("two sizes that differ", "LK112", 'height="1"', 'height="1" width="2"'),
    Case("name of another region", "LK201", "Facade/Pier", "Facade/Peer"),
    Case("share above a size", "LK202", 'min="80%"', 'min="80%" max="0.1"'),
    Case(
        "symbol defined in two ways", "LK210", '<again symbol="Pier"/>', '<region symbol="Pier" width="1.5"/>'
    ),
    Case("sum off by more than rounding", "LK212", 'width="3"', 'width="3.0001"'),
    Case(
        "top and bottom exchanged",
        "LK213",
        '  <region symbol="Facade"',
        '<picture file="a" left="0" top="9" right="6" bottom="0"/><region symbol="Facade"',
    ),
    Case("broken XML", "LK002", "</constraints>", ""),
    Case("document type", "LK004", "<facade", "<!DOCTYPE facade><facade"),
]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "iso-8859-1"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("case", SAFE, ids=lambda case: case.name)
def test_what_is_safe_is_mended_and_nothing_else_is_touched(case: Case, end: str, encoding: str) -> None:
    declared = encoding.removesuffix("-sig")

    def written(text: str) -> bytes:
        text = text.replace("UTF-8", declared).replace('name="house"', 'name="hôuse"').replace("\n", end)
        return text.encode(encoding)

    result = mend(written(case.broken))
    assert result.source.decode(encoding) == written(case.whole).decode(encoding)
    assert {repair.code for repair in result.repairs} == {case.code}
    assert result.diagnostics == ()


@pytest.mark.parametrize("case", LEFT, ids=lambda case: case.name)
def test_what_could_be_meant_otherwise_is_left(case: Case) -> None:
    source = case.broken.encode()
    result = mend(source)
    assert case.code in {d.code for d in result.diagnostics}
    assert (result.source, result.repairs) == (source, ())


def test_every_code_that_can_be_mended_has_a_case_for_it() -> None:
    assert {case.code for case in SAFE} == set(MENDED)


def test_a_misspelt_element_is_renamed_at_both_ends() -> None:
    broken = HOUSE.replace('<region symbol="Bay"', '<reigon symbol="Bay"').replace(
        "    </region>\n    <again", "    </reigon >\n    <again"
    )
    result = mend(broken.encode())
    assert result.source.decode() == HOUSE.replace("    </region>\n    <again", "    </region >\n    <again")


@dataclass(frozen=True, kw_only=True)
class Ratio(Constraint):
    """A kind as a plugin adds it."""

    kind: ClassVar[str] = "ratio"
    namespace: ClassVar[Namespace] = Namespace("golden", "urn:golden:1")
    summary: ClassVar[str] = "The region is as wide as it is high."
    within: str = attribute(PATH, "The region.")


def test_constraints_of_plugins_are_mended_as_those_built_in() -> None:
    kinds = {**KINDS, "golden:ratio": Ratio}
    whole = HOUSE.replace(
        "</constraints>", '<g:ratio xmlns:g="urn:golden:1" within="Facade"></g:ratio>\n  </constraints>'
    )
    broken = (
        whole.replace("<g:ratio", "<g:ratoi").replace("</g:ratio", "</g:ratoi").replace("within", "wihtin")
    )
    result = mended(broken.encode(), FILE, lambda source: check(Source(FILE, source), kinds), kinds)
    assert result.source.decode() == whole
    # One of another namespace is not taken for it.
    foreign = broken.replace("urn:golden:1", "urn:silver:1").encode()
    assert mended(foreign, FILE, lambda s: check(Source(FILE, s), kinds), kinds).source == foreign


def test_layouts_and_masses_are_mended_too() -> None:
    layout = """<layout xmlns="urn:layoutkit:1" name="out" units="m">
  <region symbol="F" width="6" height="4" split="rows">
    <region symbol="A" height="4" split="columns">
      <region symbol="B" width="3"{}/>
      <region symbol="C" width="3"/>
    </region>
  </region>
</layout>"""
    assert mend(layout.format(' height="4"').encode()).source == layout.format("").encode()
    mass = '<mass xmlns="urn:layoutkit:1" name="m" units="m"><box width="1" depth="1" {}="1"/></mass>'
    assert mend(mass.format("hieght").encode()).source == mass.format("height").encode()


def test_each_repair_says_where_what_it_was_and_what_it_is() -> None:
    broken = HOUSE.replace('width="6"', '\n    widht="6"').replace("<size of='", "<size of='")
    (repair,) = mend(broken.encode()).repairs
    assert (str(repair.place), repair.code) == ("house.xml:4:5", "LK103")
    assert (repair.was, repair.becomes, repair.summary) == ("widht", "width", "widht becomes width")


def test_comments_quotation_marks_and_references_are_kept() -> None:
    text = HOUSE.replace(
        '<region symbol="Facade" width="6"', "<!-- widht --> <region\tsymbol='Facade'\n widht = '6'"
    )
    text = text.replace('name="house"', "name='&lt;a> &amp; b'")
    assert mend(text.encode()).source.decode() == text.replace("widht = ", "width = ")


def test_what_one_repair_uncovers_is_mended_as_well() -> None:
    text = HOUSE.replace('split="columns"', 'split="column"').replace('width="3"', 'width="3" height="4"')
    result = mend(text.encode())
    assert result.source.decode() == HOUSE
    assert [repair.code for repair in result.repairs] == ["LK105", "LK112"]


def test_nothing_is_mended_where_that_would_uncover_more_faults_than_there_were() -> None:
    text = HOUSE.replace('split="columns"', 'split="column"').replace('width="1.5"', 'height="9"')
    text = text.replace('width="3"', 'height="4"')
    source = text.encode()
    assert mend(source).source == source


def test_a_repair_that_makes_it_worse_is_not_made_and_the_others_are() -> None:
    text = (
        HOUSE.replace("Window", "Windw")
        .replace('symbol="Top"', 'symbl="Top"')
        .replace("Facade/Bay", "@Windw")
    )
    broken = text.encode()

    def stubborn(source: bytes) -> Sequence[Diagnostic]:
        found = list(checked(source))
        return found if b"symbl" in source else [*found, *checked(b"<b"), *checked(b"<b"), *checked(b"<b")]

    assert mended(broken, FILE, stubborn, KINDS).source == broken
    more = broken.replace(b'units="m"', b'units="M"')
    assert mended(more, FILE, stubborn, KINDS).source == broken


def test_faults_of_the_facade_that_a_layout_names_are_not_looked_for_in_the_layout() -> None:
    elsewhere = [Diagnostic("LK103", "…", place) for d in checked(b"<a/>") if (place := d.place)]
    elsewhere = [replace(d, place=replace(d.place, file="facade.xml")) for d in elsewhere if d.place]
    assert mended(b"<a/>", FILE, lambda _: elsewhere, KINDS).repairs == ()


@pytest.mark.parametrize("sample", list_samples(), ids=lambda sample: sample.name)
def test_a_valid_document_is_not_changed(sample: object) -> None:
    source = sample.path.read_bytes()  # type: ignore[attr-defined]
    assert mend(source).source == source


REGION_NAMES = ["width", "height", "labels", "split", "symbol", "material", "depth", "fill", "base"]


@pytest.mark.parametrize(
    ("written", "known", "expected"),
    [
        ("widht", REGION_NAMES, "width"),
        ("WIDTH", REGION_NAMES, "width"),
        ("label", REGION_NAMES, "labels"),
        ("depht", REGION_NAMES, "depth"),
        ("colour", REGION_NAMES, None),
        ("mix", ["min", "max", "of"], None),
        ("cm", ["m", "px"], None),
        ("M", ["m", "px"], "m"),
        ("column", ["columns", "rows"], "columns"),
        ("frist", ["first", "first-after", "second"], "first"),
        ("first-befor", ["first-before", "first-after", "first"], "first-before"),
        ("x", [], None),
    ],
)
def test_a_name_is_taken_for_another_only_where_that_is_plain(
    written: str, known: list[str], expected: str | None
) -> None:
    assert meant(written, known) == expected


def errors(found: Sequence[Diagnostic]) -> int:
    return sum(d.severity is Severity.ERROR for d in found)


def altered(text: str, draw: st.DrawFn) -> str:
    """Do to a document what people do to documents."""
    words = [
        "width",
        "height",
        "symbol",
        "region",
        "split",
        "columns",
        "rows",
        "size",
        "constraints",
        "urn:layoutkit:1",
    ]
    word = draw(st.sampled_from(words))
    places = [index for index in range(len(text)) if text.startswith(word, index)]
    if not places:
        return text
    at = draw(st.sampled_from(places))
    inside = at + draw(st.integers(0, len(word) - 1))
    change = draw(
        st.sampled_from(
            [
                lambda: text[:inside] + text[inside + 1 :],
                lambda: text[:inside] + text[inside] + text[inside:],
                lambda: text[:inside] + text[inside : inside + 2][::-1] + text[inside + 2 :],
                lambda: text[:at] + word.upper() + text[at + len(word) :],
                lambda: text.replace('"3"', '"2.999999"', 1),
                lambda: text.replace('"1.5"', '"1.5" height="4"', 1),
                lambda: text.replace(' split="rows"', ""),
            ]
        )
    )
    return change()


@st.composite
def altered_houses(draw: st.DrawFn) -> bytes:
    text = HOUSE
    for _ in range(draw(st.integers(1, 6))):
        text = altered(text, draw)
    encoding = draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]))
    text = text.replace("\n", draw(st.sampled_from(["\n", "\r\n", "\r"])))
    return text.replace("UTF-8", encoding.removesuffix("-sig")).encode(encoding)


@given(altered_houses())
def test_mending_never_makes_a_document_worse_and_mending_twice_changes_nothing(source: bytes) -> None:
    before = errors(checked(source))
    once = mend(source)
    after = checked(once.source)
    assert errors(after) <= before
    assert list(once.diagnostics) == list(after)
    assert (once.source == source) is (not once.repairs)
    twice = mend(once.source)
    assert (twice.source, twice.repairs) == (once.source, ())
    for repair in once.repairs:
        assert repair.was != repair.becomes
        assert repair.place.line >= 1
        assert repair.place.column >= 1


@given(altered_houses())
def test_what_is_mended_differs_only_where_a_repair_says_so(source: bytes) -> None:
    # The repairs of one round, made by hand from their lines and columns, give what was written.
    found = proposals(source, FILE, checked(source), KINDS)
    repairs = apart(dict.fromkeys(repair for _, repair in found))
    codec = "utf-16" if source.startswith((b"\xff\xfe", b"\xfe\xff")) else "utf-8-sig"
    text = source.decode(codec).replace("\r\n", "\n").replace("\r", "\n")
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)
    for edit in sorted((e for r in repairs for e in r.edits), key=lambda e: e.start, reverse=True):
        first, last = (starts[place.line - 1] + place.column - 1 for place in (edit.first, edit.last))
        text = text[:first] + edit.text + text[last:]
    byte_codec = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}.get(source[:2], "utf-8")
    made = applied(source, repairs, byte_codec).decode(codec)
    assert made.replace("\r\n", "\n").replace("\r", "\n") == text
