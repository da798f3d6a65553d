"""What hooks may return: each check says what is wrong with one item, or nothing."""

from __future__ import annotations

import dataclasses
import inspect
import re
from typing import TYPE_CHECKING

from layoutkit.diagnostics.origin import PROJECT, Origin

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.operations import Operation

#: What a name may be: an element's name in documents, a word on the command line.
_NAME = re.compile(r"[a-z][a-z0-9-]*")
#: Prefixes that schemas and their files use otherwise; all that begin with "xml" are XML's own.
_TAKEN = ("layoutkit", "xs", "xsi")


def constraint_fault(item: object) -> str:
    """Say why `item` is no constraint kind; empty if it is one."""
    from layoutkit.constraints import Constraint
    from layoutkit.constraints.namespace import CORE

    if not (isinstance(item, type) and issubclass(item, Constraint)):
        return f"{item!r} is no subclass of Constraint"
    if fault := _name_fault(item, "kind"):
        return fault
    if fault := _frozen_fault(item):
        return fault
    declared = {a.field_name for a in item.attributes()} | {"place", "comment"}
    if undeclared := [f.name for f in dataclasses.fields(item) if f.name not in declared]:
        return f"{item.__name__}.{undeclared[0]} is not declared with attribute()"
    if item.violations is Constraint.violations:
        return f"{item.__name__} has no violations(): nothing would check it"
    if item.namespace == CORE and item.__module__.partition(".")[0] != PROJECT:
        return _taken(item)
    return _namespace_fault(item)


def operation_fault(item: object) -> str:
    """Say why `item` is no kind of operation; empty if it is one."""
    from layoutkit.documents.operation_grammar import BRANCH, HELD_ELEMENTS
    from layoutkit.operations import Operation

    if not (isinstance(item, type) and issubclass(item, Operation)):
        return f"{item!r} is no subclass of Operation"
    if fault := _name_fault(item, "kind") or _frozen_fault(item):
        return fault
    if item.kind in (BRANCH.name, *HELD_ELEMENTS):
        return f"{item.__name__}.kind is {item.kind!r}, which is the name of another element of operations"
    if abstract := sorted(item.__abstractmethods__):
        return f"{item.__name__} has no {abstract[0]}()"
    return _field_fault(item) or _namespace_fault(item)


def _field_fault(kind: type[Operation]) -> str:
    """Say which field of a kind of operation is not declared as documents need it; empty if each is."""
    from layoutkit.documents.operation_grammar import HELD_ELEMENTS
    from layoutkit.operations import Named
    from layoutkit.operations.attributes import HELD

    declared, free = {a.field_name for a in kind.attributes()} | {"place"}, set(HELD_ELEMENTS)
    for own in dataclasses.fields(kind):
        element, who = own.metadata.get(HELD), f"{kind.__name__}.{own.name}"
        if element is None and own.name not in declared:
            return f"{who} is not declared with attribute() or held()"
        if element is not None and element not in free:
            known = ", ".join(HELD_ELEMENTS)
            return f"{who} is held as {element!r}: each of {known} may be held once, and nothing else"
        if isinstance(own.default, Named):
            return f"{who} has a file for its default: files are named in documents"
        free.discard(element)
    return ""


def core_claim(kind: type[Operation], origin: Origin) -> str:
    """Say that a kind takes layoutkit's own namespace, and comes from elsewhere; empty if not."""
    from layoutkit.constraints.namespace import CORE

    return "" if kind.namespace != CORE or origin.ours else _taken(kind)


def _frozen_fault(item: type) -> str:
    frozen = "__dataclass_params__" in vars(item) and vars(item)["__dataclass_params__"].frozen
    return "" if frozen else f"{item.__name__} is no frozen dataclass"


def _namespace_fault(kind: type[Constraint] | type[Operation]) -> str:
    """Say what is wrong with a kind's namespace; that layoutkit's own is taken is not looked at."""
    from layoutkit.constraints.namespace import CORE, Namespace

    own, who = kind.namespace, f"{kind.__name__}.namespace"
    if not isinstance(own, Namespace):
        return f"{who} is {own!r}, and no Namespace"
    if own == CORE:
        return ""
    if not _NAME.fullmatch(own.prefix) or own.prefix.startswith("xml") or own.prefix in _TAKEN:
        taken = ", ".join(_TAKEN)
        return f"{who} has the prefix {own.prefix!r}: small letters, digits and hyphens, but not {taken}"
    if not own.uri or own.uri == CORE.uri or any(sign.isspace() for sign in own.uri):
        return f"{who} has the URI {own.uri!r}: one of your own, without blanks"
    return ""


def _taken(kind: type) -> str:
    return f"{kind.__name__}.namespace is layoutkit's own: give it a namespace of your own"


def stage_fault(item: object) -> str:
    """Say why `item` is no stage; empty if it is one."""
    from layoutkit.hooks.specs import Stage

    if not isinstance(item, Stage):
        return f"{item!r} is no instance of Stage"
    if fault := _name_fault(item, "name"):
        return fault
    if not isinstance(getattr(item, "takes", None), type):
        return f"{type(item).__name__}.takes is no class"
    options = getattr(item, "options", None)
    if not (isinstance(options, type) and dataclasses.is_dataclass(options)):
        return f"{type(item).__name__}.options is no dataclass"
    missing = (dataclasses.MISSING, dataclasses.MISSING)
    if bare := [f.name for f in dataclasses.fields(options) if (f.default, f.default_factory) == missing]:
        return f"{options.__name__}.{bare[0]} has no default"
    return ""


def format_fault(item: object) -> str:
    """Say why `item` is no format; empty if it is one."""
    from layoutkit.hooks.specs import Format

    return _name_fault(item, "name") if isinstance(item, Format) else f"{item!r} is no instance of Format"


def scene_format_fault(item: object) -> str:
    """Say why `item` is no format of scenes; empty if it is one."""
    from layoutkit.hooks.specs import SceneFormat

    ours = isinstance(item, SceneFormat)
    return _name_fault(item, "name") if ours else f"{item!r} is no instance of SceneFormat"


def relationship_fault(item: object) -> str:
    """Say why `item` is no relationship function; empty if it is one."""
    from layoutkit.scenes.relationship import FEATURE_TYPES, QUANTITIES, Relationship

    if not isinstance(item, Relationship):
        return f"{item!r} is no instance of Relationship"
    if fault := _name_fault(item, "name"):
        return fault
    own = type(item).__name__
    for attribute, known in (("of", FEATURE_TYPES), ("quantity", QUANTITIES)):
        if (value := getattr(item, attribute, None)) not in known:
            return f"{own}.{attribute} is {value!r}, and none of {', '.join(known)}"
    names = item.values
    if not (isinstance(names, tuple) and names and all(isinstance(name, str) for name in names)):
        return f"{own}.values is {names!r}, and no names"
    return ""


def backend_fault(item: object) -> str:
    """Say why `item` is no QP backend; empty if it is one."""
    from layoutkit.sizing.qp import Backend

    if not isinstance(item, Backend):
        return f"{item!r} is no instance of Backend"
    if not isinstance(getattr(item, "most_variables", None), int):
        return f"{type(item).__name__}.most_variables is no whole number"
    return _name_fault(item, "name")


def _name_fault(item: object, attribute: str) -> str:
    owner = item.__name__ if inspect.isclass(item) else type(item).__name__
    name = getattr(item, attribute, None)
    if not (isinstance(name, str) and _NAME.fullmatch(name)):
        return f"{owner}.{attribute} is {name!r}, not a name of small letters, digits and hyphens"
    if not isinstance(getattr(item, "summary", None), str):
        return f"{owner}.summary is missing"
    return ""
