"""Documents that stand in texts: code blocks of Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePath

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.documents.grammar import FACADE, LAYOUT, MASS, SESSION
from layoutkit.documents.operation_grammar import OPERATIONS
from layoutkit.documents.scene_grammar import PLACEMENT_MODEL, SCENE
from layoutkit.documents.source import Source

_SUFFIXES = (".md", ".markdown")
_LINE_END = re.compile(r"\r\n|\r|\n")
_OPENING = re.compile(r"[ \t>]*(?P<fence>`{3,}|~{3,})[ \t]*xml\b[^`]*", re.IGNORECASE)
#: The first tag of a document of ours, whatever its prefix; before it only comments and instructions.
_ROOTS = "|".join(root.name for root in (FACADE, LAYOUT, MASS, SESSION, SCENE, PLACEMENT_MODEL, OPERATIONS))
_DOCUMENT = re.compile(rf"\s*(?:<\?.*?\?>\s*|<!--.*?-->\s*)*<(?:[\w.-]+:)?(?:{_ROOTS})[\s/>]", re.DOTALL)


def is_text(file: str) -> bool:
    """Tell by its name whether a file is a text that documents may stand in."""
    return PurePath(file).suffix.lower() in _SUFFIXES


def fragments(source: Source) -> tuple[Source, ...]:
    """Return the documents in a text: each fenced block of XML whose root element is one of ours.

    Their places are those in the text.

    Raises
    ------
    Faulty
        If the text is not UTF-8 (LK003), or holds no document (LK101).
    """
    try:
        text = source.whole().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        hint = "save it as UTF-8"
        message = f"the text is not UTF-8: {error.reason}"
        raise Faulty([Diagnostic("LK003", message, Place(source.file), hint, topic="xml")]) from error
    found = tuple(_blocks(text, source.file))
    if not found:
        hint = "documents stand in code blocks that begin with ```xml"
        raise Faulty([Diagnostic("LK101", "the text holds no document", Place(source.file), hint)])
    return found


def _blocks(text: str, file: str) -> Iterator[Source]:
    lines = _lines(text)
    for number, (_, line) in enumerate(lines):
        if (opening := _OPENING.fullmatch(line)) and number + 1 < len(lines):
            closing = re.compile(rf"[ \t>]*{opening['fence']}{opening['fence'][0]}*[ \t]*")
            rest = lines[number + 1 :]
            end = next((start for start, other in rest if closing.fullmatch(other)), len(text))
            block = text[rest[0][0] : end]
            if _DOCUMENT.match(block):
                shown = len(block) - len(block.lstrip())
                before = _lines(block[:shown])
                yield Source.part(block[shown:], file, number + 1 + len(before), shown - before[-1][0] + 1)


def _lines(text: str) -> list[tuple[int, str]]:
    """Return where each line begins, and the line without its end."""
    ends = list(_LINE_END.finditer(text))
    starts, stops = [0, *(end.end() for end in ends)], [*(end.start() for end in ends), len(text)]
    return [(start, text[start:stop]) for start, stop in zip(starts, stops, strict=True)]
