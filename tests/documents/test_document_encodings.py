"""Places are right in every encoding, with any line ends, and in long files."""

from __future__ import annotations

import codecs
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from layoutkit.constraints import Constraint
from layoutkit.documents import check, read

Kinds = Mapping[str, type[Constraint]]

#: The fault is in line 3, column 13; é and a sign beyond 16 bits count one column each.
FAULTY = '<facade xmlns="urn:layoutkit:1" name="f" units="m">\n\n<!-- é{} --> <region symbol="É"/></facade>'


def places(path: Path, kinds: Kinds) -> list[str]:
    return [f"{d.code} {d.place.line}:{d.place.column}" for d in check(path, kinds) if d.place]


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize(
    ("declared", "codec", "mark"),
    [
        ("", "utf-8", b""),
        ("", "utf-8", codecs.BOM_UTF8),
        ("UTF-8", "utf-8", codecs.BOM_UTF8),
        ("", "utf-16-le", codecs.BOM_UTF16_LE),
        ("", "utf-16-be", codecs.BOM_UTF16_BE),
        ("UTF-16", "utf-16-le", codecs.BOM_UTF16_LE),
        ("UTF-16", "utf-16-be", codecs.BOM_UTF16_BE),
        ("ISO-8859-1", "latin-1", b""),
        ("windows-1252", "cp1252", b""),
        ("koi8-r", "koi8-r", b""),
    ],
)
def test_places_in_encodings(
    declared: str, codec: str, mark: bytes, line_end: str, kinds: Kinds, written: Callable[..., Path]
) -> None:
    head = f'<?xml version="1.0" encoding="{declared}"?>' if declared else ""
    sign = "\N{GRINNING FACE}" if codec.startswith("utf") else "x"
    text = (head + FAULTY.format(sign)).replace("\n", line_end)
    if codec == "koi8-r":
        text = text.replace("é", "я").replace("É", "Я")
    path = written(mark + text.encode(codec))
    assert places(path, kinds) == ["LK104 3:13", "LK104 3:13"]


@pytest.mark.parametrize("mark", [b"", codecs.BOM_UTF8])
def test_places_in_the_first_line(mark: bytes, kinds: Kinds, written: Callable[..., Path]) -> None:
    text = '<facade xmlns="urn:layoutkit:1" name="f" units="m"><region/></facade>'
    assert places(written(mark + text.encode()), kinds) == ["LK104 1:52"] * 3
    assert places(written(mark + b"<a><b></a>"), kinds) == ["LK002 1:9"]
    assert places(written(mark + b"<a>x</a>"), kinds) == ["LK101 1:1"]
    wide = ("\ufeff" if mark else "") + text
    assert places(written(wide.encode("utf-16-le")), kinds) == ["LK104 1:52"] * 3


def test_places_in_long_files(kinds: Kinds, written: Callable[..., Path]) -> None:
    text = FAULTY.format("x").replace("\n\n", "\n" * 100_000)
    assert places(written(text), kinds) == ["LK104 100001:13"] * 2


def test_places_in_long_lines(kinds: Kinds, written: Callable[..., Path]) -> None:
    text = FAULTY.format("x" * 100_000)
    assert places(written(text), kinds) == ["LK104 3:100012"] * 2


def test_bytes_that_are_not_of_the_encoding(kinds: Kinds, written: Callable[..., Path]) -> None:
    path = written('<facade xmlns="urn:layoutkit:1" name="é"/>'.encode("latin-1"))
    assert places(path, kinds) == ["LK003 1:39"]


def test_text_survives_every_encoding(kinds: Kinds, written: Callable[..., Path]) -> None:
    region = '<region symbol="É" width="1" height="1"/>'
    body = f'<facade xmlns="urn:layoutkit:1" name="é&#x1F600;" units="m">{region}</facade>'
    for codec in ("utf-8", "utf-16", "iso-8859-1"):
        source = f'<?xml version="1.0" encoding="{codec}"?>{body}'.encode(codec)
        model = read(written(source), kinds).model
        assert (model.name, model.root.symbol) == ("é\N{GRINNING FACE}", "É")


def test_an_editor_may_name_the_schema(kinds: Kinds, written: Callable[..., Path]) -> None:
    text = (
        '<?xml-model href="layoutkit.xsd"?>\n<facade xmlns="urn:layoutkit:1" name="f" units="m"'
        ' xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"'
        ' xsi:schemaLocation="urn:layoutkit:1 layoutkit.xsd">'
        '<region symbol="F" width=" 1 " height="1"/></facade>'
    )
    assert check(written(text), kinds) == []


def test_a_prefix_is_as_good_as_the_default_namespace(kinds: Kinds, written: Callable[..., Path]) -> None:
    text = (
        '<k:facade xmlns:k="urn:layoutkit:1" name="f" units="m"><k:region symbol="F" width="1" height="1"/>'
        '<k:constraints><k:size of="F"/></k:constraints></k:facade>'
    )
    assert len(read(written(text), kinds).model.constraints) == 1  # type: ignore[union-attr]
