"""What a propagation needs, made once: queries, areas, the grid, and what stands where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.examples import shapes_of, without
from layoutkit_placement.grid import Grid
from layoutkit_placement.propagation.lattice import lattice_over
from layoutkit_placement.propagation.query import Query
from layoutkit_placement.propagation.scopes import Scopes
from layoutkit_placement.propagation.selecting import Rules
from layoutkit_placement.propagation.settings import PropagationSettings
from layoutkit_placement.propagation.validation import Occupied, Standing


@dataclass(frozen=True)
class Task:
    """What is to be propagated where.

    Attributes
    ----------
    source
        The scene in which the shapes stand. Other shapes of their labels are not looked at.
    target
        The scene in which places are looked for; it may be the same.
    shapes
        What is propagated.
    functions
        The functions of points that relate shapes to what stands about them.
    settings
        What it goes by.
    clearances
        By how much polygons of a label are enlarged where overlaps are looked for.
    alternatives
        Polygons that stand for those of the same names where overlaps are looked for.
    generator
        Where chance comes from.
    """

    source: Scene
    target: Scene
    shapes: tuple[Placement, ...]
    functions: tuple[Relationship, ...]
    settings: PropagationSettings
    clearances: Mapping[str, float]
    alternatives: tuple[Polygon, ...]
    generator: np.random.Generator


@dataclass(frozen=True)
class Prepared:
    """A task, and what follows from it. Shapes go by their numbers."""

    task: Task

    @cached_property
    def queries(self) -> tuple[Query, ...]:
        """Every shape in the area that it stands in."""
        task = self.task
        areas = self._areas(task.source)
        return tuple(
            Query(shape, _around(areas[shape.label], shape), task.functions) for shape in task.shapes
        )

    def targets(self, shape: int) -> list[Area]:
        """Return the areas like the one that a shape stands in, drawn scopes alone."""
        query = self.queries[shape]
        found = self._targets[query.placement.label].of_labels(frozenset([query.area.labels]))
        scope = self.task.settings.scope
        if not scope:
            return found
        return [
            area
            for area in found
            if (name := self._scopes.of(area, scope)) is None or self._drawn[name] == shape
        ]

    def scope(self, area: Area) -> str:
        """Return the name of the polygon in which shapes of an area are counted."""
        label = self.task.settings.matches_in
        own = area.polygons[0].name if area.parent else ""
        return (self._scopes.of(area, label) if label else None) or own

    def rules(self, shape: int, area: Area, occupied: Occupied | None) -> Rules:
        """Return what poses of a shape in an area have to keep to.

        They may be inside what the area is inside of, such as the house, though the example stands in none.
        """
        task, query = self.task, self.queries[shape]
        own = query.placement.label
        return Rules(
            None if task.settings.crossing else self._standing_in_target[own],
            self._overlaps[shape] | {(label, False) for label in self._scopes.around(area)},
            None if task.settings.overlapping else occupied,
            task.settings.density * query.diagonal,
            ((query.placement.x, query.placement.y),) if self._within else (),
        )

    @cached_property
    def occupied(self) -> Occupied:
        """Where shapes of the labels stand in the target."""
        labels = dict.fromkeys(shape.label for shape in self.task.shapes)
        standing = [placed for label in labels for placed in shapes_of(self.task.target, label)]
        standing += self.task.shapes if self._within else ()
        return Occupied(max(query.diagonal for query in self.queries), standing)

    @cached_property
    def lattice(self) -> Grid:
        """The grid over all areas that any shape may go to."""
        every = [(query, area) for k, query in enumerate(self.queries) for area in self.targets(k)]
        boxes = np.array([area.extent for _, area in every])
        (x0, y0), (x1, y1) = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
        room = max((query.outside for query, area in every if not area.parent), default=0.0)
        extent = float(x0 - room), float(y0 - room), float(x1 + room), float(y1 + room)
        return lattice_over(extent, self.task.settings.points)

    @cached_property
    def _within(self) -> bool:
        """Whether shapes are propagated within one scene, where they stand already."""
        return self.task.source == self.task.target

    def _areas(self, scene: Scene) -> Mapping[str, Areas]:
        """Return a scene's areas by the label that is propagated, without what has it."""
        nested = self.task.settings.hierarchy
        return {label: Areas(without(scene, label), nested) for label in self._labels}

    @property
    def _labels(self) -> Sequence[str]:
        return tuple(dict.fromkeys(shape.label for shape in self.task.shapes))

    @cached_property
    def _targets(self) -> Mapping[str, Areas]:
        return self._areas(self.task.target)

    @cached_property
    def _scopes(self) -> Scopes:
        return Scopes(self.task.target.settled().polygons)

    @cached_property
    def _drawn(self) -> Mapping[str, int]:
        return self._scopes.draws(self.task.settings.scope, len(self.task.shapes), self.task.generator)

    def _standing(self, scene: Scene) -> Mapping[str, Standing]:
        task = self.task
        return {
            label: Standing(without(scene, label).polygons, task.alternatives, task.clearances)
            for label in self._labels
        }

    @cached_property
    def _standing_in_target(self) -> Mapping[str, Standing]:
        return self._standing(self.task.target)

    @cached_property
    def _overlaps(self) -> list[frozenset[tuple[str, bool]]]:
        standing = self._standing(self.task.source)
        return [standing[shape.label].overlaps([shape])[0] for shape in self.task.shapes]


def _around(areas: Areas, shape: Placement) -> Area:
    """Return the area in which a shape stands."""
    return areas.around([shape])[0] if areas.scene.polygons else Area((), False)
