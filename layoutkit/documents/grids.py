"""The grids of facade documents, and what may be wrong with them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from layoutkit.constraints.references import missing_names
from layoutkit.diagnostics import Place, did_you_mean, nearest
from layoutkit.documents.findings import KEPT
from layoutkit.documents.grammar import GRID, GRIDS
from layoutkit.documents.reading import Reading
from layoutkit.documents.tree import Element
from layoutkit.model import Facade, Grid, PlacedRegion


def read_grids(element: Element, reading: Reading) -> tuple[tuple[Grid, Element], ...]:
    """Return the grids that could be read, each with its element."""
    reading.values(element, GRIDS)
    found = []
    for child in element.children:
        if reading.name_of(child, element, (GRID.name,)) is not None and (grid := _grid(child, reading)):
            found.append((grid, child))
    _check_names(found, reading)
    return tuple(found)


def check_grids(facade: Facade, found: tuple[tuple[Grid, Element], ...], reading: Reading) -> None:
    """Record what is wrong with grids, given the facade: every region that they name has to be there."""
    if not found:
        return
    places = {placed.path: placed for places in facade.places.values() for placed in places}
    tree = _Children(places)
    for grid, element in found:
        before = len(reading.diagnostics)
        for message, hint in _unknown(grid, facade, places, tree):
            reading.fault("LK241", f"the grid {grid.name} {message}", element, hint, "reference")
        _check_repeats(grid, element, reading)
        if len(reading.diagnostics) == before:
            _check_elements(grid, facade, places, element, reading)


def grid_attributes(grid: Grid) -> Mapping[str, str]:
    """Return the attributes of a grid's element."""
    values: dict[str, Any] = {"name": grid.name, "of": grid.of, "elements": grid.elements or None}
    shown = ((name, GRID.attributes[name].type, value) for name, value in values.items() if value is not None)
    return {name: kind.text(value) for name, kind, value in shown}


def _grid(element: Element, reading: Reading) -> Grid | None:
    before = len(reading.diagnostics)
    values = reading.values(element, GRID)
    reading.no_children(element)
    if not {"of", "elements"} & values.keys():
        hint = 'name its elements: of="@Window", or elements="House/Floor/Window House/Floor/Window.2"'
        reading.fault("LK104", "<grid> lacks both the attribute of and the attribute elements", element, hint)
    if len(reading.diagnostics) > before:
        return None
    return Grid(values["name"], values.get("of"), values.get("elements") or (), place=element.place)


def _check_names(found: list[tuple[Grid, Element]], reading: Reading) -> None:
    taken: dict[str, Place] = {}
    for grid, element in found:
        first = taken.setdefault(grid.name, element.place)
        if first != element.place:
            message = f"two grids are called {grid.name}: this one, and the one in line {first.line}"
            reading.fault("LK245", message, element, "give each a name of its own", "reference")


def _unknown(
    grid: Grid, facade: Facade, places: Mapping[str, PlacedRegion], tree: _Children
) -> Iterator[tuple[str, str]]:
    """Yield what a grid names that is not there, and a hint."""
    for missing in missing_names(grid.of, facade) if grid.of is not None else ():
        yield missing.message, did_you_mean(missing.name, missing.known)
    unknown = [path for path in grid.elements if path not in places]
    for number, path in enumerate(unknown):
        # Beyond so many they are only counted.
        yield f"names the region {path!r}, which is not there", tree.hint(path) if number < KEPT else ""


def _check_repeats(grid: Grid, element: Element, reading: Reading) -> None:
    seen: set[str] = set()
    repeated: dict[str, None] = {}
    for path in grid.elements:
        if path in seen:
            repeated[path] = None
        seen.add(path)
    for path in repeated:
        message = f"the grid {grid.name} names the element {path} more than once"
        reading.fault("LK242", message, element, "name it once: repeats are told by numbers", "reference")


def _check_elements(
    grid: Grid, facade: Facade, places: Mapping[str, PlacedRegion], element: Element, reading: Reading
) -> None:
    """Record that a grid has no elements, or that some of them are inside others."""
    symbols = facade.select(grid.of) if grid.of is not None else ()
    if not symbols and not grid.elements:
        hint = "name at least one region, or delete the grid"
        reading.fault("LK244", f"the grid {grid.name} has no elements", element, hint, "reference")
    if found := _nested(symbols, [places[path] for path in grid.elements], facade):
        message = f"in the grid {grid.name}, the element {found[0]} is inside the element {found[1]}"
        hint = "keep the outer or the inner ones; a grid of the inner ones is a subgrid by itself"
        reading.fault("LK243", message, element, hint, "reference")


def _nested(
    symbols: Sequence[str], elements: Sequence[PlacedRegion], facade: Facade
) -> tuple[str, str] | None:
    """Return the paths of an element and of another one that it is inside of; None if there are none.

    Regions of one symbol are identical, so that symbol paths tell of all places in a set at once.

    Parameters
    ----------
    symbols
        Symbol paths, all places of which are elements.
    elements
        Further elements.
    """
    whole = {path: facade.places[path][0].path for path in symbols}
    paths = {placed.path: placed.path for placed in elements}
    either = {placed.symbol_path: placed.path for placed in elements} | whole
    for path in symbols:
        if outer := _outer(path, either):
            return either[outer] + path.removeprefix(outer), either[outer]
    for placed in elements:
        if outer := _outer(placed.path, paths):
            return placed.path, outer
        if outer := _outer(placed.symbol_path, whole):
            levels = placed.symbol_path.count("/") - outer.count("/")
            return placed.path, placed.path.rsplit("/", levels)[0]
    return None


def _outer(path: str, known: Mapping[str, str]) -> str | None:
    """Return which of some regions a region is inside of, the innermost; None if there is none."""
    outer = path.rpartition("/")[0]
    while outer and outer not in known:
        outer = outer.rpartition("/")[0]
    return outer or None


class _Children:
    """What stands in each region, by unique paths; looked up for hints alone."""

    def __init__(self, places: Mapping[str, PlacedRegion]) -> None:
        self._places = places
        self._steps: dict[str, tuple[str, ...]] = {}

    def hint(self, path: str) -> str:
        """Return what to do about a path that is not there: correct its first step that is wrong."""
        known, step, rest = self._parted(path)
        steps = self._inside(known)
        if not steps:
            return f"{known} is not divided: name it, or another region"
        near = nearest(step, steps)
        if near is None:
            return did_you_mean(step, steps)
        right = "/".join(filter(None, (known, near)))
        whole = f"{right}/{rest}" if rest else right
        return f"did you mean {whole if whole in self._places else right!r}?"

    def _parted(self, path: str) -> tuple[str, str, str]:
        """Return the part of a path that is there, the step behind it, and the rest."""
        steps = path.split("/")
        count = next(n for n in range(len(steps)) if "/".join(steps[: n + 1]) not in self._places)
        return "/".join(steps[:count]), steps[count], "/".join(steps[count + 1 :])

    def _inside(self, path: str) -> tuple[str, ...]:
        if not self._steps:
            found: dict[str, list[str]] = {}
            for known in self._places:
                outer, _, step = known.rpartition("/")
                found.setdefault(outer, []).append(step)
            self._steps = {outer: tuple(steps) for outer, steps in found.items()}
        return self._steps.get(path, ())
