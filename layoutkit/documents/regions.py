"""Region elements to regions."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from layoutkit.diagnostics import Faulty, did_you_mean
from layoutkit.documents.grammar import AGAIN, REGION, ROOT_REGION
from layoutkit.documents.reading import Reading
from layoutkit.documents.tree import ELEMENT_LIMIT, Element
from layoutkit.model import Region, Split
from layoutkit.model.region import TILING_TOLERANCE

#: What a region that is split into columns or rows holds.
_CHILDREN = (REGION.name, AGAIN.name)


class RegionReader:
    """Builds the region tree of a document, and finds what is wrong with it.

    A size that cannot be read is NaN: no comparison with it is ever a fault.

    Attributes
    ----------
    reading
        Takes the faults.
    names_known
        Whether each symbol and label of the tree could be read, so that any other name is surely unknown.
    instances
        Elements whose region differs from that of the first sibling of its symbol: a fault in facades, but
        not in layouts.
    """

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.names_known = True
        self.instances: list[Element] = []
        self._placed: dict[int, int] = {}

    def root(self, element: Element) -> Region:
        """Return the whole tree.

        Raises
        ------
        Faulty
            If it stands for more than `ELEMENT_LIMIT` regions (LK006).
        """
        values = self.reading.values(element, ROOT_REGION)
        width, height = (_known_size(values.get(name)) for name in ("width", "height"))
        return self._region(element, values, width, height)

    def _region(self, element: Element, values: dict[str, Any], width: float, height: float) -> Region:
        symbol, labels = values.get("symbol"), values.get("labels", ())
        if symbol is None or labels is None:
            self.names_known = False
        split = self._split(element, values)
        judged = values.get("split") is not None
        children = self._children(element, split, (width, height), judged) if split else ()
        region = Region(
            symbol or "",
            width,
            height,
            split,
            children,
            labels or (),
            values.get("fill") or "stretch",
            values.get("depth") or 0.0,
            values.get("material") or "",
        )
        if split:
            self._check_count(region, element)
        return region

    def _split(self, element: Element, values: dict[str, Any]) -> Split | None:
        split: Split | None = values.get("split")
        if split and not element.children:
            self.reading.fault(
                "LK111",
                f"the region {values.get('symbol')} is split into {split}, and has no children",
                element,
                "delete the split, or add children",
            )
            self.names_known = False
        if split or not element.children:
            return split if element.children else None
        meant: Split = "columns" if "width" in element.children[0].attributes else "rows"
        if "split" not in values:
            self.reading.fault(
                "LK110",
                f"the region {values.get('symbol')} has children, and does not say how it is split",
                element,
                f'add split="{meant}"',
            )
        return meant

    def _children(
        self, element: Element, split: Split, size: tuple[float, float], judged: bool
    ) -> tuple[Region, ...]:
        children: list[Region] = []
        known: dict[str, Region] = {}
        first: dict[str, tuple[Region, bool]] = {}
        whole = True
        for child in element.children:
            name = self.reading.name_of(child, element, ("region",) if split == "faces" else _CHILDREN)
            before = len(self.reading.diagnostics)
            if name == "region":
                region = self._child(child, split, size, judged)
                sound = len(self.reading.diagnostics) == before
                original, original_sound = first.setdefault(region.symbol, (region, sound))
                if sound and original_sound and region != original:
                    self.instances.append(child)
                known[region.symbol] = region
                children.append(region)
            elif name == "again" and (repeated := self._repeated(child, known)):
                children.append(repeated)
            else:
                whole = self.names_known = False
        if whole and judged:
            self._check_tiling(element, split, size, children)
        return tuple(children)

    def _child(self, element: Element, split: Split, size: tuple[float, float], judged: bool) -> Region:
        values = self.reading.values(element, REGION)
        if split == "faces":
            return self._face(element, values)
        if "base" in values:
            message = f"base of <region>: its place follows from the parent, which is split into {split}"
            self.reading.fault("LK112", message, element, "delete base: only a building's faces have one")
        along, across = ("width", "height") if split == "columns" else ("height", "width")
        if judged and across in values:
            hint = f"delete {across}" if along in values else f"write {along} instead of {across}"
            message = f"{across} of <region>: it follows from the parent, which is split into {split}"
            self.reading.fault("LK112", message, element, hint)
        elif judged and along not in values:
            message = f"<region> lacks the attribute {along}"
            hint = f"its parent is split into {split}: write its {along}"
            self.reading.fault("LK104", message, element, hint)
        own = _known_size(values.get(along))
        return self._region(element, values, *((own, size[1]) if split == "columns" else (size[0], own)))

    def _face(self, element: Element, values: dict[str, Any]) -> Region:
        for name in ("width", "height"):
            if name not in values:
                message = f"<region> lacks the attribute {name}"
                self.reading.fault("LK104", message, element, "a face has a width and a height of its own")
        width, height = (_known_size(values.get(name)) for name in ("width", "height"))
        return replace(self._region(element, values, width, height), base=values.get("base") or 0.0)

    def _repeated(self, element: Element, known: dict[str, Region]) -> Region | None:
        symbol = self.reading.values(element, AGAIN).get("symbol")
        self.reading.no_children(element)
        # A sibling whose symbol could not be read (it goes by the empty one) may be the one that is meant.
        if symbol is not None and symbol not in known and "" not in known:
            message = f"no earlier sibling has the symbol {symbol!r}"
            self.reading.fault("LK211", message, element, did_you_mean(symbol, known), topic="reference")
        return known.get(symbol) if symbol is not None else None

    def _check_tiling(
        self, element: Element, split: Split, size: tuple[float, float], children: list[Region]
    ) -> None:
        name, own = ("height", size[1]) if split == "rows" else ("width", size[0])
        total = sum(child.extent(split) for child in children)
        difference = total - own
        if split == "faces" and abs((top := _top(children)) - size[1]) > TILING_TOLERANCE * size[1]:
            message = f"the faces reach up to {top:.12g}, the height of the whole is {size[1]:.12g}"
            hint = f"make the root's height {top:.12g}"
            self.reading.fault("LK212", message, element, hint, topic="reference")
        if abs(difference) > TILING_TOLERANCE * own:
            message = f"the {name}s of the children add up to {total:.12g}, the parent's is {own:.12g}"
            amount = f"{abs(difference):.6g}"
            change = f"take {amount} off" if difference > 0 else f"add {amount} to"
            hint = f"{change} the children, or make the parent's {name} {total:.12g}"
            self.reading.fault("LK212", message, element, hint, topic="reference")

    def _check_count(self, region: Region, element: Element) -> None:
        """Stop before replicas of replicas grow beyond what any later step could take."""
        count = 1 + sum(self._placed.get(id(child), 1) for child in region.children)
        if count > ELEMENT_LIMIT:
            message = f"the document stands for more than {ELEMENT_LIMIT:,} regions, replicas counted"
            self.reading.fault("LK006", message, element, "let <again> repeat fewer nested regions")
            raise Faulty(self.reading.ordered())
        self._placed[id(region)] = count


def _top(faces: list[Region]) -> float:
    return max((face.base + face.height for face in faces), default=math.nan)


def _known_size(value: float | None) -> float:
    return math.nan if value is None else value
