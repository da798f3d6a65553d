"""Damage done to documents at random: to their structure, to their values, to their bytes.

Each mutation takes the document and a generator, and returns another document, which may be broken in any
way. Documents are cut into tags and what is between them, so that broken ones can be damaged further.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import grammar

_TOKEN = re.compile(r"<!--.*?-->|<[^>]*>|[^<]+|<", re.DOTALL)
_NAME = re.compile(r"</?([^\s/>]+)")
_ATTRIBUTE = re.compile(r'\s([^\s=<>"]+)\s*=\s*("[^"]*"|\'[^\']*\')')

#: Names that are known somewhere, and some that are known nowhere.
ELEMENTS = (
    *(t.name for t in (grammar.FACADE, grammar.LAYOUT, grammar.MASS, grammar.PICTURE, grammar.REGION)),
    *(t.name for t in (grammar.AGAIN, grammar.CONSTRAINTS, grammar.BOX, grammar.FOOTPRINT)),
    *(t.name for t in (grammar.GRIDS, grammar.GRID, grammar.SESSION, grammar.EDIT, grammar.DRAG)),
    *(kind.kind for kind in BUILT_IN),
    *("regoin", "Region", "x:region", "golden:ratio", "", "-", "xml", "a" * 5000, "größe", "\U0001f600"),
)
ATTRIBUTES = (
    *grammar.REGION.attributes,
    *grammar.PICTURE.attributes,
    *grammar.FOOTPRINT.attributes,
    *grammar.GRID.attributes,
    *grammar.EDIT.attributes,
    *(a.name for kind in BUILT_IN for a in kind.attributes()),
    *("widht", "xml:id", "xsi:schemaLocation", "xmlns", "xmlns:x", "x:y", "", "xml:space", "ß"),
)
NUMBERS = (
    *("0", "-0", "-1", "1", "2", "3", "5", "0.1", "1e308", "1e-308", "1e-320", "5e-324", "1.8e308", "nan"),
    *("inf", "-inf", "1e999", "1_000", "0x10", "+1", ".5", "5.", ".", "1e", "e5", "1,5", "1 2", " 1 ", "１"),
    *("9" * 39, "9" * 40, "9" * 400, "1" + "0" * 5000, "0." + "0" * 5000 + "1", "1000000", "100%", "150 %"),
    *("1e308%", "-5%", "0%", "9999999%", "2147483648", "18446744073709551616", "0.30000000000000004"),
)
TEXTS = (
    *("", " ", "*", "@", "@*", "/", "//", "F/", "/F", "F/*", "F/**", "..", "A|B", "A&amp;B", "A-B", "(A|B)"),
    *("((((", "))))", "A" * 100_000, "A/" * 10_000, "A " * 10_000, "@A|" * 5000, "(" * 2000 + ")" * 2000),
    *("⊢ A ⊣", "A+ B*", "A{1,1000000}", "[^", "\\", "$(", "${x}", "%s", "{0}", "..\\..", "/etc/hostname"),
    *("http://127.0.0.1:9/x", "file:///etc/hostname", "facade.xml", "mass.xml", "\U0001f600", "e\u0301"),
    *("&#0;", "&#xD800;", "&#x10FFFF;", "&lol;", "&amp;", "&#10;", "\u202e", "\ufeff", "\u0085", "NaN"),
    *("yes", "no", "m", "px", "columns", "rows", "faces", "stretch", "repeat", "left", "center", "middle"),
    *(
        "F/A.2 F/B",
        "F/A.0",
        "F/A.",
        "A.2/B.3 " * 10_000,
        "1 2 3",
        "1 " * 10_000,
        "add",
        "remove",
        "move",
        "top",
    ),
    *("0,0 1,0 1,1 0,1", "0,0 1,1", "0,0 1e308,0 0,1e308", "0,0 " * 999, "nan,nan", "0,0 1,1 1,0 0,1"),
)
INSIDES = (
    *(
        "text",
        "<!-- c -->",
        "<!-- -- -->",
        "<![CDATA[x]]>",
        "<![CDATA[",
        "]]>",
        "<?pi x?>",
        "<?xml?>",
        "&lol;",
    ),
    '<?xml-stylesheet href="http://127.0.0.1:9/x.xsl" type="text/xsl"?>',
    '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="/etc/hostname"/>',
    '<golden:ratio xmlns:golden="urn:golden:1" of="Facade/*" strength="1e308"/>',
    '<again symbol="A"/>',
    '<region symbol="A" width="1" height="1" split="columns"/>',
    '<mass><box width="1e308" depth="1e-320" height="nan"/></mass>',
    '<picture file="/dev/zero" left="0" top="0" right="1e308" bottom="nan"/>',
    "<!DOCTYPE x>",
    "<a>" * 100,
    "<" * 1000,
    "\n" * 70_000,
    " " * 100_000,
)
PROLOGUES = (
    '<!DOCTYPE facade [<!ENTITY lol "ha"><!ENTITY lol2 "&lol;&lol;&lol;&lol;">]>',
    f'<!DOCTYPE facade [<!ENTITY lol "{"ha" * 10_000}">]>',
    '<!DOCTYPE facade SYSTEM "http://127.0.0.1:9/x.dtd">',
    '<!DOCTYPE facade [<!ENTITY lol SYSTEM "file:///etc/hostname">]>',
    '<!DOCTYPE facade [<!ENTITY % p SYSTEM "http://127.0.0.1:9/x"> %p;]>',
    '<?xml version="1.1"?>',
    '<?xml version="1.0" encoding="UTF-16"?>',
    '<?xml version="1.0" encoding="x-unknown"?>',
    '<?xml version="1.0" encoding="shift_jis"?>',
    "<!-- " + "c" * 100_000 + " -->",
    "x",
    " ",
    "\ufeff",
)
CODECS = (
    *("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-7", "latin-1", "cp1252"),
    *("koi8-r", "cp037", "shift_jis", "ascii"),
)
MARKS = (codecs.BOM_UTF8, codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE, codecs.BOM_UTF32_LE, b"\0", b"\xff")

Mutation = Callable[[bytes, np.random.Generator], bytes]
_Change = Callable[[list[str], np.random.Generator], list[str]]


@dataclass(frozen=True)
class Span:
    """An element: from its start tag up to behind its end tag, among the tokens of a document."""

    start: int
    end: int


def mutated(source: bytes, generator: np.random.Generator) -> bytes:
    """Return a document that was damaged one to four times."""
    for _ in range(int(generator.integers(1, 5))):
        source = MUTATIONS[int(generator.integers(len(MUTATIONS)))](source, generator)
    return source


def spans(tokens: Sequence[str]) -> list[Span]:
    """Return the elements of a document, as far as tags match."""
    found, open_ = [], list[int]()
    for index, token in enumerate(tokens):
        if token.startswith(("<!", "<?")) or not token.startswith("<"):
            continue
        if token.startswith("</"):
            if open_:
                found.append(Span(open_.pop(), index + 1))
        elif token.endswith("/>"):
            found.append(Span(index, index + 1))
        else:
            open_.append(index)
    return found


def _structural(change: _Change) -> Mutation:
    """Make a change of tokens a mutation of documents, which keep their encoding."""

    def mutation(source: bytes, generator: np.random.Generator) -> bytes:
        codec = next((c for mark, c in _MARKED.items() if source.startswith(mark)), "utf-8")
        text = source.decode(codec, "surrogateescape" if codec == "utf-8" else "replace")
        tokens = change(_TOKEN.findall(text), generator)
        return "".join(tokens).encode(codec, "surrogateescape" if codec == "utf-8" else "replace")

    return mutation


_MARKED = {codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be"}


def _one(values: Sequence[str], generator: np.random.Generator) -> str:
    return values[int(generator.integers(len(values)))]


def _some(tokens: Sequence[str], generator: np.random.Generator) -> Span:
    found = spans(tokens)
    return found[int(generator.integers(len(found)))] if found else Span(0, len(tokens))


def _delete(tokens: list[str], generator: np.random.Generator) -> list[str]:
    span = _some(tokens, generator)
    return tokens[: span.start] + tokens[span.end :]


def _repeat(tokens: list[str], generator: np.random.Generator) -> list[str]:
    span = _some(tokens, generator)
    length = sum(map(len, tokens[span.start : span.end])) + 1
    times = min(int(2 ** generator.uniform(0, 12)), 1 + 100_000 // length)
    return tokens[: span.end] + tokens[span.start : span.end] * times + tokens[span.end :]


def _move(tokens: list[str], generator: np.random.Generator) -> list[str]:
    span = _some(tokens, generator)
    rest = tokens[: span.start] + tokens[span.end :]
    at = int(generator.integers(len(rest) + 1))
    return rest[:at] + tokens[span.start : span.end] + rest[at:]


def _swap(tokens: list[str], generator: np.random.Generator) -> list[str]:
    one, other = sorted((_some(tokens, generator), _some(tokens, generator)), key=lambda span: span.start)
    if one.end > other.start:
        return tokens
    first, second = tokens[one.start : one.end], tokens[other.start : other.end]
    return tokens[: one.start] + second + tokens[one.end : other.start] + first + tokens[other.end :]


def _nest(tokens: list[str], generator: np.random.Generator) -> list[str]:
    span = _some(tokens, generator)
    depth = int(2 ** generator.uniform(0, 11))
    if not tokens:
        return tokens
    opening = tokens[span.start].rstrip("/>") + ">"
    name = _NAME.match(opening)
    if name is None:
        return tokens
    closing = f"</{name[1]}>"
    inside = tokens[span.start : span.end]
    return [*tokens[: span.start], *[opening] * depth, *inside, *[closing] * depth, *tokens[span.end :]]


def _rename(tokens: list[str], generator: np.random.Generator) -> list[str]:
    span, name = _some(tokens, generator), _one(ELEMENTS, generator)
    changed = list(tokens)
    for index in {span.start, span.end - 1} if tokens else ():
        changed[index] = _NAME.sub(lambda m: m[0][: m.start(1) - m.start()] + name, changed[index], count=1)
    return changed


def _insert(tokens: list[str], generator: np.random.Generator) -> list[str]:
    at = int(generator.integers(len(tokens) + 1))
    return [*tokens[:at], _one(INSIDES, generator), *tokens[at:]]


def _begin(tokens: list[str], generator: np.random.Generator) -> list[str]:
    kept = tokens[1:] if generator.random() < 0.5 else tokens
    return [_one(PROLOGUES, generator), *kept]


def _on_attribute(change: Callable[[str, str, np.random.Generator], str]) -> _Change:
    """Make a change of one attribute (name and value) a change of tokens."""

    def changed(tokens: list[str], generator: np.random.Generator) -> list[str]:
        places = [(i, m) for i, token in enumerate(tokens) for m in _ATTRIBUTE.finditer(token)]
        if not places:
            return tokens
        index, match = places[int(generator.integers(len(places)))]
        new = change(match[1], match[2][1:-1], generator)
        tag = tokens[index]
        return [*tokens[:index], tag[: match.start()] + new + tag[match.end() :], *tokens[index + 1 :]]

    return changed


def _numbered(name: str, value: str, generator: np.random.Generator) -> str:
    return f' {name}="{_one(NUMBERS, generator)}"'


def _reworded(name: str, value: str, generator: np.random.Generator) -> str:
    return f' {name}="{_one(TEXTS, generator)}"'


def _spliced(name: str, value: str, generator: np.random.Generator) -> str:
    at = int(generator.integers(len(value) + 1))
    return f' {name}="{value[:at]}{_one(TEXTS, generator)}{value[at:]}"'


def _renamed(name: str, value: str, generator: np.random.Generator) -> str:
    return f' {_one(ATTRIBUTES, generator)}="{value}"'


def _added(name: str, value: str, generator: np.random.Generator) -> str:
    text = _one(TEXTS if generator.random() < 0.5 else NUMBERS, generator)
    return f' {name}="{value}" {_one(ATTRIBUTES, generator)}="{text}"'


def _dropped(name: str, value: str, generator: np.random.Generator) -> str:
    return ""


def _at_two(source: bytes, generator: np.random.Generator) -> tuple[int, int]:
    one, other = sorted(int(i) for i in generator.integers(len(source) + 1, size=2))
    return one, min(other, one + 1 + int(2 ** generator.uniform(0, 12)))


def _flip(source: bytes, generator: np.random.Generator) -> bytes:
    changed = bytearray(source)
    for _ in range(int(generator.integers(1, 9)) if changed else 0):
        changed[int(generator.integers(len(changed)))] ^= 1 << int(generator.integers(8))
    return bytes(changed)


def _cut(source: bytes, generator: np.random.Generator) -> bytes:
    start, end = _at_two(source, generator)
    return source[:start] + source[end:]


def _end(source: bytes, generator: np.random.Generator) -> bytes:
    return source[: int(generator.integers(len(source) + 1))]


def _double(source: bytes, generator: np.random.Generator) -> bytes:
    start, end = _at_two(source, generator)
    return source[:end] + source[start:end] * int(generator.integers(1, 50)) + source[end:]


def _add(source: bytes, generator: np.random.Generator) -> bytes:
    at = int(generator.integers(len(source) + 1))
    return source[:at] + generator.bytes(int(generator.integers(1, 9))) + source[at:]


def _mark(source: bytes, generator: np.random.Generator) -> bytes:
    return MARKS[int(generator.integers(len(MARKS)))] + source


def _encode(source: bytes, generator: np.random.Generator) -> bytes:
    text, codec = source.decode("utf-8", "replace"), _one(CODECS, generator)
    if generator.random() < 0.7:
        text = re.sub(r"encoding=(\"[^\"]*\"|'[^']*')", f'encoding="{codec}"', text, count=1)
    return text.encode(codec, "xmlcharrefreplace" if codec not in ("utf-7", "utf-8") else "replace")


def _line_ends(source: bytes, generator: np.random.Generator) -> bytes:
    end = (b"\r", b"\r\n", b"\n\r", b"", b" ", b"\xc2\x85")[int(generator.integers(6))]
    return source.replace(b"\n", end)


STRUCTURE = tuple(map(_structural, (_delete, _repeat, _move, _swap, _nest, _rename, _insert, _begin)))
VALUES = tuple(
    _structural(_on_attribute(change))
    for change in (_numbered, _reworded, _spliced, _renamed, _added, _dropped)
)
BYTES: tuple[Mutation, ...] = (_flip, _cut, _end, _double, _add, _mark, _encode, _line_ends)
#: Twice as often to what is meant as to how it is written.
MUTATIONS = STRUCTURE * 2 + VALUES * 3 + BYTES
