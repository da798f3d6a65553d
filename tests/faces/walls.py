"""A small design, walls of any size to put it on, and their layouts by hand."""

from __future__ import annotations

from dataclasses import dataclass, replace

from hypothesis import strategies as st

from layoutkit.constraints import Constraint
from layoutkit.constraints.dressing import dressed
from layoutkit.model import Facade, Footprint, Layout, Mass, Region


@dataclass(frozen=True)
class Wall:
    """How one face is laid out.

    Attributes
    ----------
    storeys
        The heights of the upper floors.
    bays
        What stands between piers on each floor: windows W and, on the ground floor, doors D.
    pier
        Their width.
    base
        Elevation of the wall's foot.
    """

    storeys: tuple[float, ...]
    bays: str
    pier: float = 1.0
    base: float = 0.0

    @property
    def root(self) -> Region:
        """The wall as a layout of the design."""
        floors = tuple(floor("F", self.bays.replace("D", "W"), height, self.pier) for height in self.storeys)
        rows = (*floors, floor("G", self.bays, 3.5, self.pier))
        return Region("H", rows[0].width, sum(r.height for r in rows), "rows", rows)


def floor(symbol: str, bays: str, height: float, pier: float) -> Region:
    """A floor of bays between piers."""
    parts = [Region("P", pier, height, labels=("Pier",))]
    for kind in bays:
        opening = Region(
            "Door" if kind == "D" else "Window", 1.5, height - 1.0, depth=-0.25, material="glass"
        )
        opening = replace(opening, labels=(opening.symbol,))
        over = Region("Over", 1.5, 1.0, labels=("Wall",))
        parts.append(Region(kind, 1.5, height, "rows", (over, opening), ("Bay",)))
        parts.append(Region("P", pier, height, labels=("Pier",)))
    return Region(symbol, sum(p.width for p in parts), height, "columns", tuple(parts), ("Floor",))


DESIGN = Wall((3.0, 3.0), "WDW")


def design(*constraints: Constraint) -> Facade:
    """The design with constraints: two upper floors, a door on the ground floor."""
    return Facade("design", "m", DESIGN.root, constraints=constraints)


def mass(walls: list[Wall]) -> Mass:
    """One free wall behind the other, each as large as it is laid out."""
    parts = []
    for number, wall in enumerate(walls, 1):
        line = ((0.0, 5.0 * number), (wall.root.width, 5.0 * number))
        parts.append(
            Footprint(
                name=f"Wall{number}", points=line, around=False, height=wall.root.height, base=wall.base
            )
        )
    return Mass(tuple(parts))


def building(walls: list[Wall], *constraints: Constraint) -> tuple[Facade, Layout]:
    """The dressed facade, and the walls as its layout."""
    model = mass(walls)
    facade = dressed(design(*constraints), model)
    faces = tuple(
        replace(wall.root, symbol=face.name, width=box.width, height=box.height, base=box.y0)
        for wall, face, box in zip(walls, model.faces, model.boxes, strict=True)
    )
    width, height = model.boxes[-1].x1, max(box.y1 for box in model.boxes)
    root = Region("Building", width, height, "faces", faces)
    return facade, Layout("laid out", "m", root, facade, mass=model)


def walls(**sizes: int) -> st.SearchStrategy[list[Wall]]:
    """Some walls; all sizes are sums of quarters, so that what is equal is exactly so."""
    quarters = st.sampled_from([2.75, 3.0, 3.25])
    wall = st.builds(
        Wall,
        st.lists(quarters, min_size=1, max_size=3).map(lambda heights: (heights[0],) * len(heights)),
        st.text("WWD", min_size=1, max_size=3),
        st.sampled_from([1.0, 1.25]),
        st.sampled_from([0.0, 0.0, 0.25, 3.0]),
    )
    return st.lists(wall, **(sizes or {"min_size": 1, "max_size": 3}))
