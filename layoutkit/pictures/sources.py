"""Where in the input the picture of each region of a layout comes from."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.model import Box, Facade, Piece, PlacedRegion, Region, place
from layoutkit.model.region import TILING_TOLERANCE, place_children

#: What a terminal of an edited facade shows: at least one piece.
Pieces = tuple[Piece, ...]
_Children = Mapping[str, Sequence[PlacedRegion]]


def sources(root: Region, facade: Facade) -> Iterator[tuple[PlacedRegion, PlacedRegion]]:
    """Yield every terminal of a layout with the place in the facade that its picture comes from.

    Sources are chosen from the root down: a region's source lies inside its parent's, so that a replicated
    bay or floor comes whole from one bay or floor of the input. Among like siblings, the k-th of a layout
    takes the k-th of the input, counted round where the input has fewer. A layout with the input's own words
    therefore shows the input. Each face of a building shows the whole design.

    Parameters
    ----------
    root
        The layout's root region; the facade's own is allowed.
    facade
        What it is a variation of; of a building, the design.

    Raises
    ------
    Faulty
        If the layout has a region that the facade lacks (LK501).
    """
    whole, design = _placed_root(root), _placed_root(facade.root)
    if root.split != "faces" and root.symbol != facade.root.symbol:
        raise _unknown(root.symbol, root.symbol, facade)

    # Layouts hold many replicas: their sources are few, and each is split once.
    inside: dict[str, _Children] = {}
    pending = [(whole, design)]
    if root.split == "faces":
        pending = [(face, design) for face in reversed(list(place_children(whole)))]
    while pending:
        placed, source = pending.pop()
        if placed.region.terminal:
            yield placed, source
            continue
        if source.path not in inside:
            inside[source.path] = _children_by_symbol(source)
        seen: Counter[str] = Counter()
        pairs = []
        for child in place_children(placed):
            symbol = child.region.symbol
            like = inside[source.path].get(symbol)
            if like is None:
                raise _unknown(child.symbol_path, child.path, facade)
            pairs.append((child, like[seen[symbol] % len(like)]))
            seen[symbol] += 1
        pending.extend(reversed(pairs))


def known_sources(
    root: Region, facade: Facade, origins: Mapping[str, Pieces]
) -> Iterator[tuple[PlacedRegion, Pieces]]:
    """Yield every terminal of an edited facade with the pieces of the original that its picture is made of.

    Parameters
    ----------
    root
        The edited facade's root region.
    facade
        What editing began with.
    origins
        For each terminal, by its unique path, its pieces.

    Raises
    ------
    Faulty
        If a terminal has no pieces, or one from outside the facade (LK501).
    """
    for placed in place(root):
        if placed.region.terminal:
            pieces = origins.get(placed.path)
            if not pieces:
                raise _unknown(placed.path, placed.path, facade)
            for piece in pieces:
                _check_inside(piece.source, placed.path, facade)
            yield placed, pieces


def _check_inside(source: Box, path: str, facade: Facade) -> None:
    width, height = facade.root.width, facade.root.height
    allowed = TILING_TOLERANCE * max(width, height)
    inside = source.x0 >= -allowed and source.y0 >= -allowed
    inside = inside and source.x1 <= width + allowed and source.y1 <= height + allowed
    if not (inside and source.width > 0 and source.height > 0):
        box = " ".join(f"{edge:.9g}" for edge in source)
        message = f"{path} has no picture: {box} is no part of the facade {facade.name!r}"
        hint = "the source of a piece is a box in the facade, in its units, y up"
        raise Faulty([Diagnostic("LK501", message, hint=hint, topic="picture")])


def _placed_root(root: Region) -> PlacedRegion:
    return PlacedRegion(root.symbol, root.symbol, root, Box(0.0, 0.0, root.width, root.height))


def _children_by_symbol(parent: PlacedRegion) -> _Children:
    found: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
    for child in place_children(parent):
        found[child.region.symbol].append(child)
    return found


def _unknown(symbol_path: str, path: str, facade: Facade) -> Faulty:
    return Faulty(
        [
            Diagnostic(
                "LK501",
                f"{path} has no picture: the facade {facade.name!r} has no region {symbol_path}",
                hint=did_you_mean(symbol_path, facade.regions),
                topic="picture",
            )
        ]
    )
