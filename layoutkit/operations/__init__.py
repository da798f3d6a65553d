"""Operations trees: what an operation is, what it works on, and how operations hang together."""

from layoutkit.operations.context import Context
from layoutkit.operations.operation import Operation, Result
from layoutkit.operations.resources import Design, Steps
from layoutkit.operations.site import Dressing, Element, Site, Solid, Surface
from layoutkit.operations.tree import Branch, Node, Operations

__all__ = [
    "Branch",
    "Context",
    "Design",
    "Dressing",
    "Element",
    "Node",
    "Operation",
    "Operations",
    "Result",
    "Site",
    "Solid",
    "Steps",
    "Surface",
]
