"""Operations trees: what an operation is, what it works on, and how operations hang together."""

from layoutkit.operations.context import Context
from layoutkit.operations.operation import Operation, Result
from layoutkit.operations.resources import Asset, Design, Named, Steps
from layoutkit.operations.site import Dressing, Element, Looks, Site, Solid, Surface
from layoutkit.operations.tree import Branch, Node, Operations

__all__ = [
    "Asset",
    "Branch",
    "Context",
    "Design",
    "Dressing",
    "Element",
    "Looks",
    "Named",
    "Node",
    "Operation",
    "Operations",
    "Result",
    "Site",
    "Solid",
    "Steps",
    "Surface",
]
