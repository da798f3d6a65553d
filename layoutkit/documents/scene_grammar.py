"""What scene documents and placement models are made of, declared once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.documents.grammar import (
    AMOUNT,
    ANSWER,
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
    KEYS,
    LABELS,
    NAME,
    NUMBER,
    OUTLINE,
    POSITIONS,
    SIZE,
    TEXT,
    WHOLE,
    element_type,
    optional,
    required,
)
from layoutkit.model.learning import LearningSettings

SCENE = element_type(
    "scene",
    "Labelled polygons in the plane, x to the right and y up; which contains which follows from that.",
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
)
_LABELS_HELP = "Semantic classes, separated by spaces. Only features of equal labels are compared."
POLYGON = element_type(
    "polygon",
    "A simple polygon without holes. Its edges and corners have its labels, unless they have their own.",
    optional("name", TEXT, "What it is called, each by another name; left out, its label and a number."),
    required("points", OUTLINE, "Its points, x,y each, in either direction; the first is not repeated."),
    optional("labels", LABELS, _LABELS_HELP, ()),
    optional(
        "angle",
        NUMBER,
        "Direction of its own x axis, in degrees counter-clockwise; left out, as its longest edges run.",
    ),
)
_OWN = required("labels", LABELS, "Labels instead of those of the polygon; may be empty.")
EDGE = element_type(
    "edge",
    "Edges of the polygon with labels of their own.",
    required("at", POSITIONS, "Which points they begin with, counted from 1, separated by blanks."),
    _OWN,
)
CORNER = element_type(
    "corner",
    "Corners of the polygon with labels of their own.",
    required("at", POSITIONS, "Which points they are, counted from 1, separated by blanks."),
    _OWN,
)
PLACEMENT = element_type(
    "placement",
    "A shape that is placed in the scene: an oriented box.",
    required("x", NUMBER, "Where its centre is."),
    required("y", NUMBER, "Where its centre is, upwards."),
    required("width", SIZE, "Its extent along its own x axis."),
    required("height", SIZE, "Its extent along its own y axis."),
    optional("angle", NUMBER, "Direction of its own x axis, in degrees counter-clockwise.", 0.0),
    optional("label", NAME, "What is placed."),
    optional("score", NUMBER, "How well it was found to fit."),
    optional("mirrored", ANSWER, "Whether it is mirrored about its own x axis.", False),
    optional(
        "target", AMOUNT, "Of an example: how good a place it shows, from 1 down to 0, a wrong one.", 1.0
    ),
)
#: How values of settings are written, by their type.
_SETTINGS: Mapping[type, AttributeType] = {
    float: AMOUNT,
    int: WHOLE,
    bool: ANSWER,
    str: TEXT,
    tuple: KEYS,
}


def _setting(name: str, default: Any, help: str) -> Attribute:
    return Attribute(name.replace("_", "-"), name, _SETTINGS[type(default)], help, False, default)


#: What learning goes by: one attribute for each field, as these are declared in the model.
SETTINGS: tuple[Attribute, ...] = tuple(
    _setting(field.name, field.default, field.metadata["help"]) for field in fields(LearningSettings)
)
PLACEMENT_MODEL = element_type(
    "placement-model",
    "Placements of a shape, learned from examples: enough to rate others in any scene.",
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
    required("label", NAME, "What is placed."),
    *SETTINGS,
)
EXAMPLE = element_type(
    "example",
    "A placement that was shown, others of its kind beside it, and the polygons about it.",
    optional("name", TEXT, "What its scene is called.", ""),
)
