"""From the grids of documents to lattices of nodes, and whether sizes keep a lattice."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.model import Box, Grid
from layoutkit.model.grid import OVERLAP_TOLERANCE, arranged
from layoutkit_editing.original import Original
from layoutkit_editing.state import Lattice, Matrix


def lattice_of(original: Original, grid: Grid) -> Lattice:
    """Return a grid of a facade as rows and columns of the nodes of `Tree.of`: of sources.

    Raises
    ------
    Faulty
        If the grid has no elements, names what is not there, or has elements inside others.
    """
    sources = _sources(original, grid)
    if faults := [*_faults(original, grid, sources)]:
        raise Faulty(faults)
    return Lattice(grid.name, cells_of(original, sources))


def cells_of(original: Original, sources: Sequence[int]) -> Matrix:
    """Return rows and columns of sources, none of them inside another."""
    boxes = [original.places[source].box for source in sources]
    root = original.facade.root
    cells = arranged(boxes, OVERLAP_TOLERANCE * max(root.width, root.height))
    return tuple(tuple(None if index is None else sources[index] for index in row) for row in cells)


def as_arranged(lattice: Lattice, boxes: Mapping[int, Box], tolerance: float) -> bool:
    """Tell whether elements stand in the rows and columns of their lattice.

    Rows and columns of phantoms alone do not count.

    Parameters
    ----------
    boxes
        Where each element stands, in document units, y up.
    tolerance
        Overlaps up to this are none.
    """
    elements = tuple(lattice.elements)
    cells = arranged([boxes[own] for own in elements], tolerance)
    found = tuple(tuple(None if index is None else elements[index] for index in row) for row in cells)
    return found == _without_phantom_lines(lattice.cells)


def _without_phantom_lines(cells: Matrix) -> Matrix:
    rows = [row for row in cells if any(own is not None for own in row)]
    columns = [column for column in zip(*rows, strict=True) if any(own is not None for own in column)]
    return tuple(zip(*columns, strict=True))


def _sources(original: Original, grid: Grid) -> tuple[int, ...]:
    """Return the elements of a grid, in document order."""
    return tuple(sorted(original.by_path[placed.path] for placed in grid.members(original.facade)))


def _faults(original: Original, grid: Grid, sources: Sequence[int]) -> Iterator[Diagnostic]:
    """Yield what is wrong with a grid. Those read from documents have been checked."""
    paths = original.by_path
    unknown = [path for path in grid.elements if path not in paths]
    for path in unknown:
        message = f"the grid {grid.name} names the region {path!r}, which is not there"
        yield _fault(grid, "LK241", message, did_you_mean(path, paths))
    if not sources and not unknown:
        yield _fault(grid, "LK244", f"the grid {grid.name} has no elements", "name at least one region")
    chosen = dict.fromkeys(original.places[source].path for source in sources)
    for path in chosen:
        outer = path.rpartition("/")[0]
        while outer and outer not in chosen:
            outer = outer.rpartition("/")[0]
        if outer:
            message = f"in the grid {grid.name}, the element {path} is inside the element {outer}"
            yield _fault(grid, "LK243", message, "keep the outer or the inner ones")


def _fault(grid: Grid, code: str, message: str, hint: str) -> Diagnostic:
    return Diagnostic(code, message, grid.place, hint, topic="editing")
