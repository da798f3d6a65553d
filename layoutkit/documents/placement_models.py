"""Placement models: documents of what was learned from examples."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted, opened
from layoutkit.documents.scene_grammar import EXAMPLE, PLACEMENT, PLACEMENT_MODEL, POLYGON, SETTINGS
from layoutkit.documents.scenes import read_shapes
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model.facade import Units
from layoutkit.model.learning import Example, LearningSettings, PlacementModel
from layoutkit.model.scene import Scene


@dataclass(frozen=True)
class PlacementModelDocument:
    """The document of a placement model that was read.

    Attributes
    ----------
    diagnostics
        Remarks on it, in document order; none is an error.
    """

    model: PlacementModel
    diagnostics: tuple[Diagnostic, ...]


def is_placement_model(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is a placement model; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, PLACEMENT_MODEL)


def read_placement_model(document: Path | str | Source) -> PlacementModelDocument:
    """Read a placement model's document.

    Raises
    ------
    Faulty
        If it has errors; all of them are in it.
    """
    hint = "what was learned from examples is described by <placement-model>, which holds them"
    root, reading = opened(document, PLACEMENT_MODEL, hint)
    model = placement_model_of(root, reading)
    if model is None or reading.diagnostics.erroneous:
        raise Faulty(reading.ordered())
    return PlacementModelDocument(model, reading.ordered())


def placement_model_of(element: Element, reading: Reading) -> PlacementModel | None:
    """Return the model that an element describes; None if it cannot be read. Faults are recorded."""
    before = reading.diagnostics.errors
    values = reading.values(element, PLACEMENT_MODEL)
    found = tuple(_examples(element, values.get("units") or "m", values.get("label"), reading))
    if not element.children:
        reading.fault("LK107", "<placement-model> has no <example>", element, "add what it was learned from")
    if reading.diagnostics.errors > before:
        return None
    settings = {setting.field_name: values[setting.name] for setting in SETTINGS if setting.name in values}
    learning = LearningSettings(**settings)
    return PlacementModel(values["name"], values["units"], values["label"], found, learning)


def model_fields(model: PlacementModel) -> dict[str, Any]:
    """Return the attributes of a model's element by name."""
    settings = {setting.name: getattr(model.settings, setting.field_name) for setting in SETTINGS}
    return {"name": model.name, "units": model.units, "label": model.label, **settings}


def _examples(root: Element, units: Units, label: str | None, reading: Reading) -> Iterator[Example]:
    """Yield the examples that could be read."""
    for child in root.children:
        if reading.name_of(child, root, (EXAMPLE.name,)) is None:
            continue
        values = reading.values(child, EXAMPLE)
        found = read_shapes(child.children, child, (PLACEMENT.name, POLYGON.name), reading)
        written = sum(each.name == PLACEMENT.name for each in child.children)
        if not written:
            hint = "the first one is the example, others stand beside it"
            reading.fault("LK107", "<example> has no placement", child, hint)
        polygons = found.settle(reading)
        for placement in found.placements:
            if label and placement.label != label:
                message = f"the example places {placement.label or 'what has no label'}, the model {label}"
                reading.diagnostics.append(
                    Diagnostic("LK105", message, placement.place, f'write label="{label}"', topic="schema")
                )
        if found.placements:
            first, *beside = found.placements
            yield Example(Scene(values.get("name") or "", units, polygons), first, tuple(beside))
