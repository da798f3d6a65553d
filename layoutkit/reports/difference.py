"""What changes in a document, as a unified diff."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

_LINE = re.compile(r"[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+")
#: Lines shown around a change.
_AROUND = 3
#: As many lines further on, and so many in a row, it is looked for where two texts agree again.
_AHEAD, _AGREEING = 64, 3

#: Lines from `start` to `end` of the one text stand where the other has those from `start` to `end`.
Change = tuple[int, int, int, int]


def difference(before: bytes, after: bytes, codec: str, file: str) -> str:
    """Return a unified diff of two versions of a document that differ in few places.

    Time and memory grow with the length of the document, and not with its square.

    Parameters
    ----------
    before, after
        The versions.
    codec
        Python's name of their encoding.
    file
        The document's name.
    """
    old, new = (_LINE.findall(version.decode(codec)) for version in (before, after))
    changes = list(_changes(old, new))
    if not changes:
        return ""
    lines = [f"--- {file}", f"+++ {file}"]
    for group in _grouped(changes):
        lines += _hunk(old, new, group)
    return "".join(f"{line}\n" for line in lines)


def _changes(old: Sequence[str], new: Sequence[str]) -> Iterator[Change]:
    i = j = 0
    while i < len(old) or j < len(new):
        if i < len(old) and j < len(new) and old[i] == new[j]:
            i, j = i + 1, j + 1
            continue
        a, b = _meeting(old, new, i, j)
        yield i, a, j, b
        i, j = a, b


def _meeting(old: Sequence[str], new: Sequence[str], i: int, j: int) -> tuple[int, int]:
    """Return where the texts agree again, as near as possible; their ends where they do not."""
    if old[i + 1 : i + 2] == new[j + 1 : j + 2] and i < len(old) and j < len(new):
        return i + 1, j + 1  # one line for another, as most repairs are
    for steps in range(1, 2 * _AHEAD):
        for a in range(max(0, steps - _AHEAD), min(steps, _AHEAD) + 1):
            b = steps - a
            left, right = old[i + a : i + a + _AGREEING], new[j + b : j + b + _AGREEING]
            if left == right and i + a <= len(old) and j + b <= len(new):
                return i + a, j + b
    return len(old), len(new)


def _grouped(changes: Sequence[Change]) -> list[list[Change]]:
    """Return the changes in groups that are far enough apart for hunks of their own."""
    groups: list[list[Change]] = []
    for change in changes:
        if groups and change[0] - groups[-1][-1][1] <= 2 * _AROUND:
            groups[-1].append(change)
        else:
            groups.append([change])
    return groups


def _hunk(old: Sequence[str], new: Sequence[str], group: Sequence[Change]) -> Iterator[str]:
    lead = min(_AROUND, group[0][0])
    start, first = group[0][0] - lead, group[0][2] - lead
    end = min(group[-1][1] + _AROUND, len(old))
    last = group[-1][3] + end - group[-1][1]
    yield f"@@ -{_range(start, end)} +{_range(first, last)} @@"
    at = start
    for i, a, j, b in group:
        yield from _marked(" ", old[at:i])
        yield from _marked("-", old[i:a])
        yield from _marked("+", new[j:b])
        at = a
    yield from _marked(" ", old[at:end])


def _range(start: int, end: int) -> str:
    return f"{start + 1},{end - start}" if end > start else f"{start},0"


def _marked(sign: str, lines: Sequence[str]) -> Iterator[str]:
    for line in lines:
        text = line.rstrip("\r\n")
        yield f"{sign}{text}{line[len(text) : -1]}" if line != text else f"{sign}{text}"
        if line == text:
            yield "\\ No newline at end of file"
