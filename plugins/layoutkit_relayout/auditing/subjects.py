"""What constraints speak of, by the types of their attributes: built-in kinds and plugins' alike."""

from __future__ import annotations

from collections.abc import Mapping

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import Attribute
from layoutkit.constraints.defaults import InputWord
from layoutkit.model import Extent, Facade, RegionSet

#: The type of attributes that only say where a constraint holds.
_ENCLOSING = "enclosing path"


def subjects(constraint: Constraint, facade: Facade) -> Mapping[str, tuple[str, ...]]:
    """Return the symbol paths that each attribute of a constraint names, by the attribute's name.

    Attributes that name no regions, and such as are left out, are not in it.
    """
    if isinstance(constraint, InputWord):  # in no document, and so without attributes
        return {"path": (constraint.path,)}
    around = enclosing(constraint)
    found = {a.field_name: _paths(a, constraint, facade, around) for a in constraint.attributes()}
    return {name: paths for name, paths in found.items() if paths is not None}


def enclosing(constraint: Constraint) -> str | None:
    """Return the path of the region in which a constraint holds; None where it holds anywhere."""
    values = [getattr(constraint, a.field_name) for a in constraint.attributes() if a.type.name == _ENCLOSING]
    return next((value for value in values if isinstance(value, str)), None)


def _paths(
    attribute: Attribute, constraint: Constraint, facade: Facade, around: str | None
) -> tuple[str, ...] | None:
    value = getattr(constraint, attribute.field_name)
    if isinstance(value, Extent):
        return value.paths if value.regions is None else facade.select(value.regions)
    if isinstance(value, RegionSet):
        return facade.select(value, around if attribute.type.name == "members" else None)
    if attribute.type.name == "path" and isinstance(value, str):
        return (value,)
    return tuple(value) if attribute.type.name == "paths" and value else None
