"""Which elements may stand in one another, and what each may hold."""

from __future__ import annotations

from collections.abc import Mapping

from layoutkit.constraints.namespace import CORE
from layoutkit.documents.grammar import (
    AGAIN,
    BOX,
    CONSTRAINTS,
    DRAG,
    EDIT,
    FACADE,
    FOOTPRINT,
    GRID,
    GRIDS,
    LAYOUT,
    LAYOUT_MASS,
    MASS,
    NAMESPACE,
    PICTURE,
    REGION,
    REGION_SIZE,
    RESIZE,
    ROOT_REGION,
    SESSION,
    ElementType,
)
from layoutkit.documents.kind_elements import declared
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending.manuscript import Written
from layoutkit.documents.operation_grammar import OPERATIONS
from layoutkit.documents.scene_grammar import (
    CORNER,
    EDGE,
    EXAMPLE,
    PLACEMENT,
    PLACEMENT_MODEL,
    POLYGON,
    SCENE,
)

ROOTS = {
    element.name: element for element in (FACADE, LAYOUT, MASS, SESSION, SCENE, PLACEMENT_MODEL, OPERATIONS)
}
#: Declarations hold dictionaries, and so cannot be keys.
_CHILDREN = (
    (FACADE, (PICTURE, ROOT_REGION, CONSTRAINTS, GRIDS)),
    (LAYOUT, (PICTURE, LAYOUT_MASS, ROOT_REGION)),
    (MASS, (BOX, FOOTPRINT)),
    (LAYOUT_MASS, (BOX, FOOTPRINT)),
    (ROOT_REGION, (REGION, AGAIN)),
    (REGION, (REGION, AGAIN)),
    (GRIDS, (GRID,)),
    (SESSION, (EDIT, RESIZE, DRAG, REGION_SIZE)),
    (SCENE, (PICTURE, POLYGON, PLACEMENT)),
    (POLYGON, (EDGE, CORNER)),
    (PLACEMENT_MODEL, (EXAMPLE,)),
    (EXAMPLE, (PLACEMENT, POLYGON)),
)


def element_type(element: Written, kinds: Kinds) -> ElementType | None:
    """Return the declaration of an element; None if it is unknown, or not known to stand where it does."""
    return possible(element, kinds).get(element.name)


def possible(element: Written, kinds: Kinds) -> Mapping[str, ElementType]:
    """Return what an element may be in the place where it stands, by name."""
    if element.parent is None:
        return ROOTS if ours(element) else {}
    parent = element_type(element.parent, kinds)
    if parent is CONSTRAINTS:
        own = CORE.uri if ours(element) else element.namespace
        return {kind.kind: declared(kind) for kind in kinds.values() if kind.namespace.uri == own}
    if parent is None or not ours(element):
        return {}
    return {child.name: child for declaration, below in _CHILDREN if declaration is parent for child in below}


def ours(element: Written) -> bool:
    """Tell whether an element is of our namespace, or of none, as the whole document may be by mistake."""
    return element.namespace in ("", NAMESPACE)
