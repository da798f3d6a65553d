"""Regions mended: a split that their children show, sizes said twice, sums off by rounding."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

from layoutkit.documents.grammar import AGAIN, REGION
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending.manuscript import Manuscript, Written
from layoutkit.documents.mending.repair import Repair
from layoutkit.model.region import TILING_TOLERANCE

#: Sums that are off by no more than this share of the whole were rounded, and not meant otherwise.
ROUNDING = 1e-6

_ALONG = {"columns": "width", "rows": "height"}
_ACROSS = {"columns": "height", "rows": "width"}


def split(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK110: children that all have widths and no heights are columns; the other way round, rows."""
    sized = [
        {name for name in ("width", "height") if name in child.attributes}
        for child in element.children
        if child.name == REGION.name
    ]
    if not sized or len(sized[0]) != 1 or any(names != sized[0] for names in sized):
        return
    added = f'split="{next(s for s, name in _ALONG.items() if name in sized[0])}"'
    written = manuscript.attributes(element)
    if written and "split" not in written:
        behind = max(one.end for one in written.values())
        yield Repair("LK110", "", added, (manuscript.edit(element, behind, behind, f" {added}"),))


def said_twice(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK112: a size across the parent's split that is what the parent says."""
    parent = element.parent
    divided = parent.attributes.get("split", "") if parent else ""
    if parent is None or divided not in _ACROSS:
        return
    name, needed = _ACROSS[divided], _ALONG[divided]
    written = manuscript.attributes(element)
    if name not in written or needed not in written:
        return
    own, whole = _number(element.attributes[name]), _extent(parent, name)
    if abs(own - whole) <= TILING_TOLERANCE * whole:
        said = written[name]
        edit = manuscript.edit(element, said.space, said.end, "")
        yield Repair("LK112", f'{name}="{said.raw}"', "", (edit,))


def rounded(element: Written, manuscript: Manuscript, kinds: Kinds) -> Iterator[Repair]:
    """LK212: sums that were rounded: the last child takes what is missing."""
    name = _ALONG.get(element.attributes.get("split", ""))
    chosen = None if name is None else _adjustable(element)
    if name is None or chosen is None:
        return
    sizes: dict[str, float] = {}
    total = 0.0
    for child in element.children:
        symbol = child.attributes["symbol"]
        if child.name == REGION.name:
            sizes[symbol] = _number(child.attributes.get(name, ""))
        total += sizes.get(symbol, math.nan)
    whole = _extent(element, name)
    if not TILING_TOLERANCE * whole < abs(total - whole) <= ROUNDING * whole:
        return
    count = sum(child.attributes["symbol"] == chosen.attributes["symbol"] for child in element.children)
    own = sizes[chosen.attributes["symbol"]]
    text = _shortest(own + (whole - total) / count, TILING_TOLERANCE * whole / (10 * count))
    written = manuscript.attributes(chosen)[name]
    if float(text) > 0:
        edit = manuscript.edit(chosen, written.value, written.value + len(written.raw), text)
        yield Repair("LK212", f'{name}="{written.raw}"', f'{name}="{text}"', (edit,))


def _adjustable(element: Written) -> Written | None:
    """Return the last child that is written out once; before others, one that has no replicas.

    One that is split as its parent is would no longer be the sum of its own children.
    """
    known = all(
        child.name in (REGION.name, AGAIN.name) and "symbol" in child.attributes for child in element.children
    )
    if not known:
        return None
    full = [child for child in element.children if child.name == REGION.name]
    written = Counter(child.attributes["symbol"] for child in full)
    there = Counter(child.attributes["symbol"] for child in element.children)
    single = [child for child in full if written[child.attributes["symbol"]] == 1]

    def suits(child: Written) -> tuple[bool, bool]:
        divided_alike = child.attributes.get("split") == element.attributes["split"]
        return not divided_alike, there[child.attributes["symbol"]] == 1

    return max(reversed(single), key=suits, default=None)


def _extent(element: Written, name: str) -> float:
    """Return a region's width or height, which may follow from regions around it; NaN if it is not known."""
    parent = element.parent
    if name in element.attributes:
        return _number(element.attributes[name])
    if parent is not None and name == _ACROSS.get(parent.attributes.get("split", "")):
        return _extent(parent, name)
    return math.nan


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        return math.nan
    return value if math.isfinite(value) and "_" not in text else math.nan


def _shortest(value: float, tolerance: float) -> str:
    """Return the number of fewest digits that is near enough."""
    texts = (f"{value:.{digits}f}" for digits in range(18))
    return next((text for text in texts if abs(float(text) - value) <= tolerance), repr(value))
