"""Facades on surfaces made ready to be built: panels, what they look like, and which are of openings."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from layoutkit.model import Opening, place
from layoutkit.operations import Design, Surface
from layoutkit.pictures.glb import walls
from layoutkit.pictures.photo import Photo
from layoutkit_operations.finishing.strips import Dressed

#: Labels of regions that one looks or goes through, in lower case.
OPENINGS = frozenset({"window", "door", "shop", "gate", "entrance"})


@dataclass
class Photos:
    """Pictures of designs, each decoded once.

    Attributes
    ----------
    known
        By the design's file; None where it names no picture.
    """

    known: dict[str, Photo | None] = field(default_factory=dict)

    def of(self, design: Design) -> Photo | None:
        """Return a design's picture, or None where it has none."""
        if design.file not in self.known:
            self.known[design.file] = _photo(design)
        return self.known[design.file]

    def files(self, shown: Collection[str]) -> Mapping[str, bytes]:
        """Return the pictures that are shown as PNG files, by the designs' files."""
        from layoutkit.pictures import png_bytes

        known = ((file, photo) for file, photo in self.known.items() if photo is not None)
        return {file: png_bytes(photo.image) for file, photo in known if file in shown}


def dressed(number: int, surface: Surface, photos: Photos) -> Dressed:
    """Return the facade of a surface, ready to be built.

    Parameters
    ----------
    number
        Of the surface, among those of its solid.
    """
    dressing = surface.dressing
    assert dressing is not None  # which the caller knows
    (wall,) = walls(dressing.layout, photos.of(dressing.design), dressing.pictured)
    paths = tuple(p.path for p in place(dressing.layout.root) if p.region.terminal)
    return Dressed(number, surface, wall, paths)


def openings_of(part: Dressed) -> Iterator[tuple[str, Opening]]:
    """Yield the windows and doors of a facade, the outermost region of each, with its path."""
    depths, taken = {"": 0.0}, ""
    x, y = part.dressing.x, part.dressing.y
    for placed in place(part.layout.root):
        depths[placed.path] = depths[placed.path.rpartition("/")[0]] + placed.region.depth
        labels = {label.lower() for label in placed.region.labels}
        inside = taken and placed.path.startswith(f"{taken}/")
        if not inside and not labels.isdisjoint(OPENINGS):
            taken = placed.path
            x0, y0, x1, y1 = placed.box
            corners = ((x0 + x, y0 + y), (x1 + x, y0 + y), (x1 + x, y1 + y), (x0 + x, y1 + y))
            name = f"{part.surface.name}.{placed.path.partition('/')[2].replace('/', '.')}"
            depth = depths[placed.path]
            yield placed.path, Opening(name, placed.region.labels, part.number, corners, depth)


def _photo(design: Design) -> Photo | None:
    """Return a design's photo, decoded."""
    if design.facade is None or design.facade.picture is None:
        return None
    file = Path(design.file).parent / design.facade.picture.file
    return Photo.decoded(design.facade, design.picture, file)
