"""What a misspelt name surely means."""

from __future__ import annotations

import re
from collections.abc import Iterable

from layoutkit.documents.grammar import NAMESPACE

#: Names whose lengths differ by more than so many signs are not compared: they are further apart than any
#: that `meant` tells apart.
_FARTHEST = 4
#: Our namespace, with a number behind it that says its version.
_STEM, _, _OWN_VERSION = NAMESPACE.rpartition(":")
_VERSION = re.compile(rf"\s*{_STEM}[:/]?v?(?P<number>\d[\d.]*)/?\s*", re.IGNORECASE)


def meant(name: str, known: Iterable[str]) -> str | None:
    """Return the known name that a misspelt one means, or None where that is open.

    It is the only one that differs in case alone; or the nearest, by characters added, dropped, exchanged or
    transposed, if it is near (one step in words of four letters, two from six on), and every other known name
    is at least two steps further off.
    """
    names = sorted(set(known))
    folded = [one for one in names if one.casefold() == name.strip().casefold()]
    if len(folded) == 1:
        return folded[0]
    steps = sorted((_steps(name.casefold(), one.casefold()), one) for one in names)
    if not steps or steps[0][0] > _tolerated(name, steps[0][1]):
        return None
    if len(steps) > 1 and steps[1][0] < steps[0][0] + 2:
        return None
    return steps[0][1]


def near_namespace(namespace: str) -> bool:
    """Tell whether a namespace is nearly ours, and not ours: misspelt, or another version of it."""
    return _other_version(namespace) or misspelt_namespace(namespace)


def misspelt_namespace(namespace: str) -> bool:
    """Tell whether a namespace surely means ours, and is not ours.

    Another version of it does not: there, the same names may mean other things.
    """
    other = namespace != NAMESPACE and not _other_version(namespace)
    return other and meant(namespace, (NAMESPACE,)) is not None


def _other_version(namespace: str) -> bool:
    version = _VERSION.fullmatch(namespace)
    return version is not None and version["number"] != _OWN_VERSION


def _tolerated(name: str, other: str) -> int:
    length = max(len(name), len(other))
    return 0 if length < 4 else 1 if length < 6 else 2


def _steps(one: str, other: str) -> int:
    """Return how many steps lead from one word to the other (optimal string alignment).

    Of words of very different lengths it is the difference, which is less.
    """
    if abs(len(one) - len(other)) > _FARTHEST:
        return abs(len(one) - len(other))
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, a in enumerate(one, 1):
        last, before, row = before, row, [i]
        for j, b in enumerate(other, 1):
            step = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == other[j - 2] and one[i - 2] == b:
                step = min(step, last[j - 2] + 1)
            row.append(step)
    return row[-1]
