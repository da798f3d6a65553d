"""Region elements to regions, tag by tag."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, Protocol, get_args

from layoutkit.diagnostics import Faulty, Place, did_you_mean
from layoutkit.documents.frames import Frame, Leaf
from layoutkit.documents.grammar import AGAIN, REGION, ROOT_REGION
from layoutkit.documents.makers import Maker, Node
from layoutkit.documents.parsing import DEPTH_LIMIT, too_deep
from layoutkit.documents.reading import Reading
from layoutkit.documents.tags import Met, Tag, Tags
from layoutkit.documents.tree import Element, element_of
from layoutkit.model import Split
from layoutkit.model.region import TILING_TOLERANCE

#: Regions that a layout may stand for beyond those that are written out.
REPLICA_LIMIT = 2_000_000

#: What a region that is split into columns or rows holds.
_CHILDREN: tuple[str, ...] = (REGION.name, AGAIN.name)
#: Regions within regions: the document is around them.
_DEEPEST = DEPTH_LIMIT - 1
#: The symbol of a replica that does not say of what; no region has it.
_UNREAD = "?"
#: What nobody looks into: it stands where it cannot.
_NOTHING = Met("", math.nan, None, {}, False)


class Cursor(Protocol):
    """Tells where in the document the reader is: the parser, or what stands in for it."""

    CurrentLineNumber: int
    CurrentColumnNumber: int


class RegionReader(Generic[Node]):
    """Reads a region with all that is inside it, tag by tag, and finds what is wrong with it.

    Only what is open is kept, so that a document of any length can be read. A size that cannot be read is
    NaN: no comparison with it is ever a fault.

    Attributes
    ----------
    names_known
        Whether each symbol and label of the tree could be read, so that any other name is surely unknown.
    open
        The elements that have begun and not yet ended: a frame for each that may hold something, and for
        others what there is to know of them.
    node
        What was made of the whole tree, once it has ended.
    ended
        Called then.

    Parameters
    ----------
    reading
        Takes the faults.
    maker
        Makes something of each region.
    cursor
        Where each tag begins.
    place
        Returns the place that a cursor's line and column mean.
    """

    def __init__(
        self, reading: Reading, maker: Maker[Node], cursor: Cursor, place: Callable[[int, int], Place]
    ) -> None:
        self.reading, self.names_known = reading, True
        self.open: list[Frame[Node] | Leaf] = []
        self.node: Node | None = None
        self.ended: Callable[[], None] = lambda: None
        self._maker, self._leaf = maker, maker.leaf
        self._cursor, self._place = cursor, place
        self._tags: Mapping[Split, Tags] = {split: Tags(split) for split in get_args(Split)}
        self._frame: Frame[Node]
        self._texted: object = None

    def start(self, name: str, given: Sequence[str]) -> None:
        """Take a start tag: the name as the parser has it, then names and values of attributes."""
        opened, cursor = self.open, self._cursor
        if len(opened) == _DEEPEST:
            raise Faulty([too_deep(self._place(cursor.CurrentLineNumber, cursor.CurrentColumnNumber))])
        if not opened:
            self._begin((name, *given))
            return
        last = opened[-1]
        if isinstance(last, tuple):
            self._widen(last)
        frame, tag = self._frame, (name, *given)
        met = frame.tags.known.get(tag) or frame.tags.resized(tag) or self._meet(tag, frame)
        leaf = (tag, cursor.CurrentLineNumber, cursor.CurrentColumnNumber, met)
        if met.split is None:
            opened.append(leaf)
        else:
            self._push(leaf, _size(met, frame))

    def end(self, name: str = "") -> None:
        """Take the end tag of the innermost element."""
        last = self.open.pop()
        if not isinstance(last, tuple):
            self._close(last)
            return
        met, frame = last[3], self._frame
        if met.extent is None:
            if repeated := frame.known.get(met.symbol):
                frame.extent += repeated[0]
                frame.children.append(repeated[1])
            else:
                self._miss(last, frame)
        elif met is not _NOTHING:
            node = self._leaf or self._maker.make(met.values, _size(met, frame))
            self._add(last, node, met.sound)

    def text(self, place: Place) -> None:
        """Take text that is not white space; the first one in an element is a fault."""
        last = self.open[-1]
        if isinstance(last, tuple):
            known, self._texted = last is self._texted, last
            tag, _, _, met = last
        else:
            known, last.text = last.text, True
            tag, _, _, met = last.leaf
        if not known and met is not _NOTHING:
            self.reading.stray_text(tag[0].rpartition(" ")[2], place)

    def innermost(self) -> tuple[str, int]:
        """Return the name of the innermost open element, and the line in which it begins."""
        last = self.open[-1]
        element = self._element(last if isinstance(last, tuple) else last.leaf)
        return element.name, element.line

    def _element(self, leaf: Leaf) -> Element:
        tag, line, column, _ = leaf
        return element_of(tag[0], tag[1:], self._place(line, column))

    def _begin(self, tag: Tag) -> None:
        line, column = self._cursor.CurrentLineNumber, self._cursor.CurrentColumnNumber
        values = self.reading.attributes(self._element((tag, line, column, _NOTHING)), ROOT_REGION)
        width, height = (known_size(values.get(name)) for name in ("width", "height"))
        self._push((tag, line, column, self._met(values, math.nan, True)), (width, height))

    def _push(self, leaf: Leaf, size: tuple[float, float]) -> None:
        """Open an element that holds something, or is to hold something."""
        met, allowed = leaf[3], _CHILDREN
        if met is _NOTHING or met.extent is None:
            allowed = ()
        elif met.split == "faces":
            allowed = (REGION.name,)
        tags = self._tags[met.split] if met.split else Tags(None)
        found = len(self.reading.diagnostics)
        self._frame = Frame(leaf, size, allowed, met.split, met.split is not None, tags, found)
        self.open.append(self._frame)

    def _widen(self, leaf: Leaf) -> None:
        """Open the innermost element anew: it was taken for one that holds nothing."""
        self.open.pop()
        self._push(leaf, _size(leaf[3], self._frame))
        self._frame.text = leaf is self._texted

    def _close(self, frame: Frame[Node]) -> None:
        """Make something of an element whose inside is all known."""
        met = frame.leaf[3]
        if not self.open:
            self.node = self._made(frame)
            self.ended()
            return
        parent = self.open[-1]
        assert not isinstance(parent, tuple)  # it holds an element
        self._frame = parent
        if met is _NOTHING:
            return
        if met.extent is None:
            self.open.append(frame.leaf)
            self.end()
            return
        node = self._made(frame)
        parent.written += frame.written + len(frame.children)
        sound = met.sound and len(self.reading.diagnostics) == frame.found
        self._add(frame.leaf, node, sound)

    def _made(self, frame: Frame[Node]) -> Node:
        values = frame.leaf[3].values
        if frame.whole and not frame.children:
            if frame.split:
                message = (
                    f"the region {values.get('symbol')} is split into {frame.split}, and has no children"
                )
                hint = "delete the split, or add children"
                self.reading.fault("LK111", message, self._element(frame.leaf), hint)
                self.names_known = False
            return self._maker.make(values, frame.size)
        if frame.whole and frame.judged:
            self._check_tiling(frame)
        node = self._maker.make(values, frame.size, frame.split, frame.children)
        self._check_count(frame, self._maker.count(node))
        return node

    def _add(self, leaf: Leaf, node: Node, sound: bool) -> None:
        """Take a region as the next child of the innermost frame."""
        frame, met = self._frame, leaf[3]
        symbol, extent = met.symbol, met.extent
        assert extent is not None
        frame.known[symbol] = extent, node
        frame.children.append(node)
        frame.extent += extent
        if frame.split == "faces":
            top = (met.values.get("base") or 0.0) + known_size(met.values.get("height"))
            frame.top = top if math.isnan(top) else max(frame.top, top)

    def _miss(self, leaf: Leaf, frame: Frame[Node]) -> None:
        """Say of what a replica there is none."""
        symbol = leaf[3].symbol
        frame.whole = self.names_known = False
        # A sibling whose symbol could not be read (it goes by the empty one) may be the one that is meant.
        if symbol != _UNREAD and "" not in frame.known:
            message = f"no earlier sibling has the symbol {symbol!r}"
            hint = did_you_mean(symbol, frame.known)
            self.reading.fault("LK211", message, self._element(leaf), hint, topic="reference")

    def _meet(self, tag: Tag, frame: Frame[Node]) -> Met:
        """Read a start tag that is met for the first time, or has faults."""
        if frame.leaf[3] is _NOTHING:
            return _NOTHING
        if frame.split is None and frame.allowed:
            self._infer_split(frame, tag)
        reading, cursor = self.reading, self._cursor
        element = self._element((tag, cursor.CurrentLineNumber, cursor.CurrentColumnNumber, _NOTHING))
        name = reading.name_of(element, self._element(frame.leaf), frame.allowed)
        before = len(reading.diagnostics)
        if name is None:
            if frame.allowed:
                frame.whole = self.names_known = False
            return _NOTHING
        if name == AGAIN.name:
            symbol = reading.attributes(element, AGAIN).get("symbol")
            met = Met(symbol or _UNREAD, None, None, {}, True)
        else:
            values, extent = self._child(element, frame)
            met = self._met(values, extent, len(reading.diagnostics) == before)
        if frame.judged and name == element.name and len(reading.diagnostics) == before:
            frame.tags.learn(tag, met)
        return met

    def _met(self, values: Mapping[str, Any], extent: float, sound: bool) -> Met:
        symbol, labels = values.get("symbol"), values.get("labels", ())
        if symbol is None or labels is None:
            self.names_known = False
        return Met(symbol or "", extent, values.get("split"), values, sound)

    def _infer_split(self, frame: Frame[Node], first: Tag) -> None:
        """Split a region that does not say how as its first child has it."""
        frame.split = "columns" if "width" in first[1::2] else "rows"
        values = frame.leaf[3].values
        if "split" not in values:
            message = f"the region {values.get('symbol')} has children, and does not say how it is split"
            element = self._element(frame.leaf)
            self.reading.fault("LK110", message, element, f'add split="{frame.split}"')

    def _child(self, element: Element, frame: Frame[Node]) -> tuple[Mapping[str, Any], float]:
        """Return the attributes of a region, and its size along its parent's split."""
        values, split = self.reading.attributes(element, REGION), frame.split
        if split == "faces":
            return values, self._face(element, values)
        if "base" in values:
            message = f"base of <region>: its place follows from the parent, which is split into {split}"
            self.reading.fault("LK112", message, element, "delete base: only a building's faces have one")
        along, across = ("width", "height") if split == "columns" else ("height", "width")
        if frame.judged and across in values:
            hint = f"delete {across}" if along in values else f"write {along} instead of {across}"
            message = f"{across} of <region>: it follows from the parent, which is split into {split}"
            self.reading.fault("LK112", message, element, hint)
        elif frame.judged and along not in values:
            message = f"<region> lacks the attribute {along}"
            hint = f"its parent is split into {split}: write its {along}"
            self.reading.fault("LK104", message, element, hint)
        return values, known_size(values.get(along))

    def _face(self, element: Element, values: Mapping[str, Any]) -> float:
        for name in ("width", "height"):
            if name not in values:
                message = f"<region> lacks the attribute {name}"
                self.reading.fault("LK104", message, element, "a face has a width and a height of its own")
        return known_size(values.get("width"))

    def _check_tiling(self, frame: Frame[Node]) -> None:
        split, size, total = frame.split, frame.size, frame.extent
        name, own = ("height", size[1]) if split == "rows" else ("width", size[0])
        difference = total - own
        top = frame.top
        if split == "faces" and abs(top - size[1]) > TILING_TOLERANCE * size[1]:
            message = f"the faces reach up to {top:.12g}, the height of the whole is {size[1]:.12g}"
            hint = f"make the root's height {top:.12g}"
            self._misfit(frame, message, hint)
        if abs(difference) > TILING_TOLERANCE * own:
            message = f"the {name}s of the children add up to {total:.12g}, the parent's is {own:.12g}"
            amount = f"{abs(difference):.6g}"
            change = f"take {amount} off" if difference > 0 else f"add {amount} to"
            self._misfit(frame, message, f"{change} the children, or make the parent's {name} {total:.12g}")

    def _misfit(self, frame: Frame[Node], message: str, hint: str) -> None:
        self.reading.fault("LK212", message, self._element(frame.leaf), hint, topic="reference")

    def _most_replicas(self) -> int:
        return REPLICA_LIMIT

    def _check_count(self, frame: Frame[Node], count: int) -> None:
        """Stop before replicas of replicas grow beyond what any later step could take."""
        limit = self._most_replicas()
        if count - frame.written - len(frame.children) > limit:
            message = f"the document stands for more than {limit:,} regions that are not written out"
            element = self._element(frame.leaf)
            self.reading.fault("LK006", message, element, "let <again> repeat fewer nested regions")
            raise Faulty(self.reading.ordered())


def _size(met: Met, frame: Frame[Any]) -> tuple[float, float]:
    """Return the size of a child of a frame."""
    if frame.split == "faces":
        return known_size(met.values.get("width")), known_size(met.values.get("height"))
    extent = math.nan if met.extent is None else met.extent
    return (extent, frame.size[1]) if frame.split == "columns" else (frame.size[0], extent)


def known_size(value: float | None) -> float:
    """Return a size, NaN for one that could not be read."""
    return math.nan if value is None else value
