"""What operations documents are made of, declared once, besides the kinds of operations themselves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from types import MappingProxyType
from typing import NamedTuple

from layoutkit.documents.grammar import (
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
    LABELS,
    SIZE,
    ElementType,
    element_type,
    optional,
)
from layoutkit.documents.scene_grammar import PLACEMENT_MODEL
from layoutkit.operations import Operation
from layoutkit.operations.attributes import HELD

OPERATIONS = element_type(
    "operations",
    "A session of modelling that can be made again in other scenes: each operation works on what the one "
    "that it stands in has made or chosen.",
    DOCUMENT_NAME,
    DOCUMENT_UNITS,
    optional(
        "sites",
        LABELS,
        "Labels of polygons that are built on each by itself, with what is in it and nothing else. Left out: "
        "a scene is worked on as a whole.",
        (),
    ),
)
BRANCH = element_type(
    "branch",
    "One of several ways on: what the operation made is dealt out among its branches at random. An empty one "
    "leaves its part as it is.",
    optional("weight", SIZE, "How likely it is, compared with the other branches.", 1.0),
)

OperationKinds = Mapping[str, type[Operation]]
NO_OPERATIONS: OperationKinds = MappingProxyType({})

#: What operations may hold as elements of their own, by name.
HELD_ELEMENTS: dict[str, ElementType] = {PLACEMENT_MODEL.name: PLACEMENT_MODEL}


class Holding(NamedTuple):
    """What a kind of operation holds as an element of its own, and the field that it is read into."""

    element: str
    field_name: str
    help: str


def holdings(kind: type[Operation]) -> tuple[Holding, ...]:
    """Return what a kind declares with `layoutkit.operations.attributes.held`, in order."""
    return tuple(
        Holding(own.metadata[HELD], own.name, own.metadata["help"])
        for own in fields(kind)
        if HELD in own.metadata
    )
