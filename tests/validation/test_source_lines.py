"""The line of the source, and the caret under the column: in every encoding, however long the line."""

from __future__ import annotations

import io
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Place
from layoutkit.reports.drawing import drawn
from layoutkit.reports.source import SHOWN, Excerpt, excerpts
from layoutkit.reports.text import from_bytes


def excerpt(source: bytes, line: int, column: int) -> Excerpt:
    place = Place("f.xml", line, column)
    return excerpts(from_bytes(source), [place])[place]


def pointed(source: bytes, line: int, column: int) -> tuple[str, str]:
    return drawn(excerpt(source, line, column))


def test_a_caret_stands_under_the_column() -> None:
    assert pointed(b"<a>\n  <b/>\n</a>", 2, 3) == ("2 |   <b/>", "  |   ^")


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "iso-8859-1", "windows-1252"]
)
def test_lines_are_found_in_every_encoding_with_any_line_ends(end: str, encoding: str) -> None:
    name = "utf-16" if encoding.startswith("utf-16") else encoding.removesuffix("-sig")
    text = end.join([f'<?xml version="1.0" encoding="{name}"?>', "<é>", "  <ü/><ö/>", "</é>"])
    found = excerpt(text.encode(encoding), 3, 7)
    assert (found.text, found.index) == ("  <ü/><ö/>", 6)


def test_what_cannot_be_decoded_is_shown_as_such() -> None:
    assert (
        excerpt(b"<a \xff\xfe b='1'/>", 1, 1).text
        == "<a \N{REPLACEMENT CHARACTER}\N{REPLACEMENT CHARACTER} b='1'/>"
    )
    for encoding in (b"klingon", b"hex"):
        assert excerpt(b'<?xml version="1.0" encoding="' + encoding + b'"?>\n<a/>', 2, 1).text == "<a/>"


def test_tabs_and_wide_characters_keep_the_caret_in_place() -> None:
    line, caret = pointed('\t<窓 a="é"/> <b/>'.encode(), 1, 13)
    assert line == '1 |     <窓 a="é"/> <b/>'
    assert caret == "  |" + " " * 17 + "^"
    line, caret = pointed("<e\N{COMBINING ACUTE ACCENT}/><b/>".encode(), 1, 6)
    assert caret.index("^") == len("1 | <e/>")


def test_nothing_in_a_file_acts_on_the_terminal() -> None:
    line, _ = pointed("<a \x1b[31m\u202e b='\x07'/>".encode(), 1, 1)
    assert (
        line
        == "1 | <a "
        + "\N{REPLACEMENT CHARACTER}[31m\N{REPLACEMENT CHARACTER} b='\N{REPLACEMENT CHARACTER}'/>"
    )


def test_a_very_long_line_is_cut_around_the_column() -> None:
    source = b"<r>" + b"<again symbol='A'/>" * 100_000 + b"<bad/>" + b"<again symbol='A'/>" * 100_000
    column = len("<r>") + 19 * 100_000 + 1
    found = excerpt(source, 1, column)
    assert found.text[found.index :].startswith("<bad/>")
    assert found.text[0] == found.text[-1] == "…"
    assert len(found.text) == SHOWN + 2
    line, caret = drawn(found)
    assert line[caret.index("^") :].startswith("<bad/>")


def test_no_more_is_read_than_needed() -> None:
    class Endless(io.RawIOBase):
        read_so_far = 0

        def readable(self) -> bool:
            return True

        def read(self, size: int = -1) -> bytes:
            self.read_so_far += size
            return b"<a/>\n" * (size // 5)

    stream = Endless()
    place = Place("f.xml", 20_000, 1)
    assert excerpts(lambda: stream, [place])[place].text == "<a/>"  # type: ignore[arg-type,return-value]
    assert stream.read_so_far < 300_000


def test_places_that_the_file_does_not_have_are_left_out() -> None:
    places = [Place("f.xml", 9, 1), Place("f.xml"), Place("f.xml", 1, 5)]
    found = excerpts(from_bytes(b"<a/>"), places)
    assert list(found) == [places[2]]
    assert drawn(found[places[2]]) == ("1 | <a/>", "  |     ^")


@given(
    st.lists(st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\r\n\0"), max_size=300)),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]),
    st.data(),
)
def test_the_character_pointed_at_is_the_one_meant(
    lines: list[str], end: str, encoding: str, data: st.DataObject
) -> None:
    lines = ["<a>", *lines]  # what has no byte order mark is not to look like one
    number = data.draw(st.integers(1, len(lines)))
    line = lines[number - 1]
    column = data.draw(st.integers(1, max(1, len(line))))
    found = excerpt(end.join(lines).encode(encoding), number, column)
    assert found.text[found.index : found.index + 1] == line[column - 1 : column]
    assert re.sub("^…|…$", "", found.text) in line or "…" in line
