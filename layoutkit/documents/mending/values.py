"""Values of attributes mended: misspelt choices, sizes with their unit, ends exchanged."""

from __future__ import annotations

import re
from collections.abc import Iterator

from layoutkit.constraints.attributes import AttributeType
from layoutkit.documents.grammar import PICTURE, SIZE
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending.expected import element_type
from layoutkit.documents.mending.manuscript import Attribute, Manuscript, Written
from layoutkit.documents.mending.repair import Edit, Repair
from layoutkit.documents.spelling import meant
from layoutkit.model import Measure

_WITH_UNIT = re.compile(r"(.*[0-9.])\s*([a-z]+)\s*", re.S)


def choices(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK105: values that are nearly one of the words allowed."""
    for name, kind, written in _declared(element, manuscript, kinds):
        if kind.choices and not _readable(kind, written.raw):
            given = written.raw.split() if kind.many else [written.raw]
            words = [meant(word, kind.choices) for word in given]
            becomes = " ".join(word for word in words if word is not None)
            if None not in words and _readable(kind, becomes):
                yield _value("LK105", name, written, becomes, element, manuscript)


def units(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK106: sizes behind which the document's own unit is written."""
    root = element
    while root.parent is not None:
        root = root.parent
    for name, kind, written in _declared(element, manuscript, kinds):
        if kind is SIZE and not _readable(kind, written.raw):
            parts = _WITH_UNIT.fullmatch(written.raw)
            if parts and parts[2] == root.attributes.get("units") and _readable(kind, parts[1]):
                yield _value("LK106", name, written, parts[1], element, manuscript)


def ends(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK202: the least value above the greatest, both absolute or both shares."""
    written = manuscript.attributes(element)
    if "min" not in written or "max" not in written:
        return
    try:
        least, most = (Measure.parse(written[name].raw) for name in ("min", "max"))
    except ValueError:
        return
    if least.relative == most.relative and least.value > most.value:
        yield _exchanged("LK202", ("min", "max"), element, manuscript)


def sides(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK213: a picture's left side to the right of its right one.

    Top and bottom stay: there, y may have been counted upwards, and then both are wrong.
    """
    written = manuscript.attributes(element)
    if element.name != PICTURE.name or not {"left", "right"} <= written.keys():
        return
    try:
        left, right = (float(written[name].raw) for name in ("left", "right"))
    except ValueError:
        return
    if left > right:
        yield _exchanged("LK213", ("left", "right"), element, manuscript)


def _declared(
    element: Written, manuscript: Manuscript, kinds: Kinds
) -> Iterator[tuple[str, AttributeType, Attribute]]:
    """Yield the declared attributes that are written out, without references to characters."""
    declared = element_type(element, kinds)
    if declared is None:
        return
    for name, written in manuscript.attributes(element).items():
        if name in declared.attributes and "&" not in written.raw:
            yield name, declared.attributes[name].type, written


def _readable(kind: AttributeType, text: str) -> bool:
    try:
        kind.parse(text)
    except ValueError:
        return False
    return True


def _value(
    code: str, name: str, written: Attribute, text: str, element: Written, manuscript: Manuscript
) -> Repair:
    return Repair(
        code, f'{name}="{written.raw}"', f'{name}="{text}"', (_edit(written, text, element, manuscript),)
    )


def _exchanged(code: str, names: tuple[str, str], element: Written, manuscript: Manuscript) -> Repair:
    found = manuscript.attributes(element)
    one, other = (found[name] for name in names)
    pairs = sorted(((one, other.raw), (other, one.raw)), key=lambda pair: pair[0].value)
    return Repair(
        code,
        " ".join(f'{name}="{found[name].raw}"' for name in names),
        " ".join(f'{name}="{text}"' for name, text in zip(names, (other.raw, one.raw), strict=True)),
        tuple(_edit(written, text, element, manuscript) for written, text in pairs),
    )


def _edit(written: Attribute, text: str, element: Written, manuscript: Manuscript) -> Edit:
    return manuscript.edit(element, written.value, written.value + len(written.raw), text)
