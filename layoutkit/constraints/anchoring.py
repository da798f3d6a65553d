"""Where regions stand along an axis, in the input and in an arrangement."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from itertools import chain, pairwise

from layoutkit.model import Box, Facade
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot


def offset(box: Box, frame: Box, axis: int, share: float) -> float:
    """Return how far a region's line stands behind the frame's own, in reading direction: right, or down.

    Parameters
    ----------
    share
        The line, as a share of the extent: 0 the left or top, 1 the right or bottom.
    """
    if axis == 0:
        return box.x0 - frame.x0 + share * (box.width - frame.width)
    return frame.y1 - box.y1 + share * (box.height - frame.height)


def frame_of(facade: Facade, path: str) -> str:
    """Return the path of what a region's place is seen from: the whole facade; on a building, its face."""
    around = (face for face in facade.faces if path == face or path.startswith(f"{face}/"))
    return next(around, facade.root.symbol)


def input_offsets(facade: Facade, path: str, axis: int, share: float) -> list[float]:
    """Return the distinct offsets of a region's occurrences in the input along an axis, in order.

    Occurrences stand in the same place, or one stands behind the other: half a region's size tells which.
    """
    region = facade.regions[path]
    (frame,) = facade.places[frame_of(facade, path)]
    found = sorted(offset(placed.box, frame.box, axis, share) for placed in facade.places[path])
    apart = (region.width, region.height)[axis] / 2
    return [found[0], *(after for before, after in pairwise(found) if after - before > apart)]


def successive(arrangement: Arrangement, paths: Iterable[str], axis: int) -> list[list[Slot]] | None:
    """Return the places of a region along an axis, one behind the other, each with all slots that are there.

    Parents that stand in the same place along the axis, one above the other as it were, have to agree on how
    many places there are: if they do not, there is no such list, and None is returned.

    Parameters
    ----------
    paths
        Of the region; several where copies of it, or of what it stands in, vary.
    """
    found = [slot for path in paths for slot in arrangement.slots(path, axis)]
    columns: dict[Slot, list[list[Slot]]] = {slot: [[slot]] for slot in found}
    # All are equally deep: level by level, what stands in one parent is put together.
    for _ in range(max((slot.symbol_path.count("/") for slot in found), default=0)):
        inside: defaultdict[Slot, list[list[list[Slot]]]] = defaultdict(list)
        for slot in sorted(columns, key=lambda slot: slot.order):
            assert slot.parent is not None  # only the root has none
            inside[slot.parent].append(columns[slot])
        columns = {}
        for parent, own in inside.items():
            split = arrangement.facade.regions[parent.symbol_path].split or "columns"
            if AXIS[split] == axis:
                columns[parent] = list(chain.from_iterable(own))
            elif len(set(map(len, own))) == 1:
                columns[parent] = [list(chain.from_iterable(slots)) for slots in zip(*own, strict=True)]
            else:
                return None
    return next(iter(columns.values()), [])


def decided(arrangement: Arrangement, paths: Iterable[str]) -> bool:
    """Tell whether all words are known that say how often a region, of one or several paths, occurs."""
    steps = [path.split("/") for path in paths]
    above = ("/".join(own[:number]) for own in steps for number in range(1, len(own)))
    return all(parent in arrangement.words or parent not in arrangement.frames for parent in above)
