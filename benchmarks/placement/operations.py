"""What is placed, and what stands already when it is placed.

The paper's scenes "represent different stages of their construction" (supplement, section 4). So has each
operation here its stage: all shapes of its own label are taken out, and only what comes before it is left.

Facades: the wall with its mouldings, which part the storeys; then windows and shops; then doors; then sills,
window cornices, balconies and blinds, each without the others; last, decorations, which see all of these and
the pillars.

Rooms: floor, doors and windows; then beds and sofas, kitchen counters and fridges; then what goes with them:
the TV stand before the sofa, the table clear of the counter, the desk and the side table by the bed; last,
chairs about tables and desks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.boxes import box_about

Domain = Literal["facades", "rooms"]

_OPENINGS = ("Wall", "Molding", "Window", "Shop", "Door")
_ATTACHED = ("Sill", "Cornice", "Balcony", "Blind", "Pillar")
_ROOM = ("Floor", "Door", "Window")

#: How shapes are learned in each domain, the same for every method that has the setting. Walls of facades all
#: stand upright, and so do shapes on them; furniture turns to any side of a room, which is all of the scene.
SETTINGS: dict[Domain, LearningSettings] = {
    "facades": LearningSettings(hierarchy=False),
    "rooms": LearningSettings(hierarchy=False, aligned=False),
}


@dataclass(frozen=True, slots=True)
class Operation:
    """One kind of shape to be placed.

    Attributes
    ----------
    label
        What is placed: all polygons of this label, in every scene that has some.
    present
        Labels of what stands there already.
    """

    name: str
    domain: Domain
    label: str
    present: tuple[str, ...]

    @property
    def settings(self) -> LearningSettings:
        """How it is learned."""
        return SETTINGS[self.domain]


OPERATIONS = (
    Operation("doors", "facades", "Door", ("Wall", "Molding", "Window", "Shop")),
    Operation("sills", "facades", "Sill", _OPENINGS),
    Operation("cornices", "facades", "Cornice", _OPENINGS),
    Operation("balconies", "facades", "Balcony", _OPENINGS),
    Operation("blinds", "facades", "Blind", _OPENINGS),
    Operation("decorations", "facades", "Deco", (*_OPENINGS, *_ATTACHED)),
    Operation("beds", "rooms", "Bed", _ROOM),
    Operation("sofas", "rooms", "Sofa", _ROOM),
    Operation("TV stands", "rooms", "TVStand", (*_ROOM, "Bed", "Sofa")),
    Operation("dining tables", "rooms", "DiningTable", (*_ROOM, "Sofa", "CounterTop", "Fridge")),
    Operation("desks", "rooms", "Desk", (*_ROOM, "Bed")),
    Operation("side tables", "rooms", "SideTable", (*_ROOM, "Bed", "Sofa")),
    Operation("chairs", "rooms", "Chair", (*_ROOM, "Bed", "Sofa", "CounterTop", "DiningTable", "Desk")),
)


@dataclass(frozen=True, slots=True)
class Stage:
    """A scene before an operation, and what the operation is to place there.

    Attributes
    ----------
    scene
        Without shapes of the operation's label.
    truths
        Where they stand.
    """

    scene: Scene
    truths: tuple[Placement, ...] = field(repr=False)

    def example(self, number: int) -> Example:
        """Return one of the shapes as an example."""
        return Example(self.scene, self.truths[number])


def stages(operation: Operation, scenes: Sequence[Scene]) -> tuple[Stage, ...]:
    """Return the stages of all scenes that have something to place."""
    found = (stage(operation, scene) for scene in scenes)
    return tuple(each for each in found if each.truths)


def stage(operation: Operation, scene: Scene) -> Stage:
    """Return a scene as it is before an operation."""
    present = tuple(p for p in scene.polygons if not set(p.labels).isdisjoint(operation.present))
    truths = tuple(box_about(p, operation.label) for p in scene.polygons if operation.label in p.labels)
    return Stage(Scene(scene.name, scene.units, present), truths)
