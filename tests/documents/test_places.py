"""A fault is reported exactly where it stands: in any encoding, with any line ends, however it is read."""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass
from unittest import mock

from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import Source, check
from layoutkit.documents import source as sources

KINDS = {kind.kind: kind for kind in BUILT_IN}
#: How a document may be written down: codec, what it declares, what stands before it.
WRITINGS = (
    ("utf-8", None, b""),
    ("utf-8", "UTF-8", b""),
    ("utf-8", None, codecs.BOM_UTF8),
    ("utf-16-le", None, codecs.BOM_UTF16_LE),
    ("utf-16-be", "UTF-16", codecs.BOM_UTF16_BE),
    ("latin-1", "ISO-8859-1", b""),
    ("koi8-r", "koi8-r", b""),
    ("ascii", "US-ASCII", b""),
)
SIGNS = "ab \t\n\n\ré\N{CYRILLIC SMALL LETTER YA}\N{GRINNING FACE}e\u0301\u2028\u0085\ufeff"


@dataclass(frozen=True)
class Planted:
    """A document, and where the fault in it begins."""

    text: str
    at: int
    code: str


def blanks() -> st.SearchStrategy[str]:
    long = st.integers(65_530, 65_540).flatmap(lambda n: st.sampled_from((" " * n, "\n" * n)))
    return st.text(" \t\n", max_size=6) | st.just("\n") | st.one_of([st.text(" \n", max_size=3)] * 8 + [long])


@st.composite
def planted(draw: st.DrawFn) -> Planted:
    """Draw a layout or a facade of many regions, with one fault in one of them."""
    root, number = draw(st.sampled_from(("layout", "facade"))), draw(st.integers(1, 12))
    wrong, text, at = draw(st.integers(0, number - 1)), "", 0
    code = draw(st.sampled_from(("LK103", "LK105", "LK109", "LK002")))
    for index in range(number):
        if draw(st.booleans()):
            comment = draw(st.text(SIGNS, max_size=12)).replace("\r", "\n")
            text += f"<!--{comment}-->"
        text += draw(blanks())
        tag = f'<region symbol="A{index}" width="1" material="{draw(st.sampled_from(("", "é", "😀 x")))}"/>'
        if index == wrong:
            at = len(text)
            if code == "LK103":
                tag = tag.replace(" ", ' colour="x" ', 1)
            elif code == "LK105":
                tag = tag.replace("A", "1", 1)
            elif code == "LK109":
                tag = f"{draw(st.sampled_from(('x', '&#65;', 'é]')))} {tag}"
            else:
                at, tag = at + len(tag) - 2, tag[:-2] + "<"
        text += tag
    head = f'<{root} xmlns="urn:layoutkit:1" name="n" units="m">{draw(blanks())}'
    head += f'<region symbol="F" width="{number}" height="1" split="columns">'
    return Planted(f"{head}{text}</region>{draw(blanks())}</{root}>", len(head) + at, code)


def place_in(text: str, at: int) -> tuple[int, int]:
    """Count lines and columns as a person does."""
    before = re.split("\r\n|\r|\n", text[:at])
    return len(before), len(before[-1]) + 1


@given(planted(), st.sampled_from(WRITINGS), st.sampled_from(("\n", "\r\n", "\r")), st.integers(1, 600))
def test_a_fault_is_reported_where_it_was_planted(
    case: Planted, writing: tuple[str, str | None, bytes], end: str, chunk: int
) -> None:
    codec, declared, mark = writing
    head = f'<?xml version="1.0" encoding="{declared}"?>' if declared else ""
    text, at = head + case.text, len(head) + case.at
    encoded = "".join(sign if can(sign, codec) else "?" for sign in text)
    before, after = encoded[:at].replace("\n", end), encoded[at:].replace("\n", end)
    data = mark + (before + after).encode(codec)
    with mock.patch.object(sources, "CHUNK", max(chunk, len(data) // 1000)):
        found = [d for d in check(Source("x.xml", data), KINDS) if d.code == case.code]
    assert [(d.place.line, d.place.column) for d in found if d.place] == [place_in(before, len(before))]


def test_text_far_behind_a_tag_is_seen_however_it_is_encoded_and_read() -> None:
    for stray in ("x", "&#65;", "<![CDATA[x]]>", "\N{CJK UNIFIED IDEOGRAPH-4E00}" * 40):
        for codec in ("utf-8", "utf-16", "utf-16-be"):
            for blanks, chunk in ((9, 1), (200, 7), (200, 8), (200, 64), (1000, 131)):
                head = '<layout xmlns="urn:layoutkit:1" name="n" units="m">'
                root = f'<region symbol="F" width="1" height="1" split="columns">{" " * blanks}{stray} '
                text = f'{head}{root}<region symbol="A" width="1"/></region></layout>'
                with mock.patch.object(sources, "CHUNK", chunk):
                    found = check(Source("x.xml", text.encode(codec)), KINDS)
                assert [d.code for d in found] == ["LK109"], (stray, codec, blanks, chunk)


def can(sign: str, codec: str) -> bool:
    try:
        sign.encode(codec)
    except UnicodeEncodeError:
        return False
    return True


@given(planted(), st.text(SIGNS, max_size=40))
def test_a_document_inside_a_text_has_the_places_of_the_text(case: Planted, before: str) -> None:
    line, column = place_in(before, len(before))
    found = [d for d in check(Source.part(case.text, "x.sh", line, column), KINDS) if d.code == case.code]
    expected = place_in(before + case.text, len(before) + case.at)
    assert [(d.place.line, d.place.column) for d in found if d.place] == [expected]


def test_what_a_part_declares_as_its_encoding_does_not_matter() -> None:
    text = '<?xml version="1.0" encoding="UTF-16"?>\n<mass xmlns="urn:layoutkit:1" name="é" units="é"/>'
    found = check(Source.part(text, "notes.txt", 7, 3), KINDS)
    assert [str(d.place) for d in found] == ["notes.txt:8:1", "notes.txt:8:1"]


MARKDOWN = """\
# Houses

- one:

  ```xml
  <?xml version="1.0"?>
  <facade xmlns="urn:layoutkit:1" name="f" units="m">
    <region symbol="F" width="1" height="0"/>
  </facade>
  ```

```xml
<size of="F" min="nothing that is a document"/>
```

~~~~ XML title="a tower"

<!-- 😀 --> <mass xmlns="urn:layoutkit:1" name="f" units="m"/>
~~~~

```xml
<layout xmlns="urn:layoutkit:1" name="l" units="m"><region symbol="F" width="1"
"""


def test_documents_in_markdown() -> None:
    for end in ("\n", "\r\n", "\r"):
        data = MARKDOWN.replace("\n", end).encode("utf-8-sig")
        found = [f"{d.code} {d.place}" for d in check(Source("houses.md", data), KINDS)]
        assert found == ["LK106 houses.md:8:5", "LK107 houses.md:18:12", "LK002 houses.md:22:52"]


def test_markdown_without_documents() -> None:
    for data, code in ((b"# nothing\n", "LK101"), (b"```xml\n<size/>\n```", "LK101"), (b"\xff", "LK003")):
        assert [d.code for d in check(Source("x.md", data), KINDS)] == [code]
