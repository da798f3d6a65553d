"""What `inspect` shows of operations, as lines or as JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from layoutkit.operations import Branch, Node, Operation, Operations


def operations_data(operations: Operations) -> dict[str, Any]:
    """Return operations as JSON-ready data: attributes as documents have them, defaults included."""
    return {
        "kind": "operations",
        "name": operations.name,
        "units": operations.units,
        "sites": list(operations.sites),
        "operations": [_node(node) for node in operations.roots],
    }


def operations_lines(operations: Operations) -> Iterator[str]:
    """Yield operations as lines of an indented tree, each below the one whose output it works on."""
    count = len(operations.nodes)
    sites = "".join(f" @{label}" for label in operations.sites)
    on = f", on each{sites}" if sites else ""
    yield f"operations {operations.name}: {count} operation{'s' * (count != 1)}, {operations.units}{on}"
    yield from _tree(operations.roots, "")


def _node(node: Node) -> dict[str, Any]:
    operation = node.operation
    values = ((a, getattr(operation, a.field_name)) for a in operation.attributes())
    return {
        "kind": operation.qualified_name(),
        "attributes": {a.name: None if value is None else a.type.text(value) for a, value in values},
        **_held(operation),
        "children": [_node(child) for child in node.children],
        "branches": [
            {"weight": branch.weight, "operations": [_node(child) for child in branch.children]}
            for branch in node.branches
        ],
    }


def _held(operation: Operation) -> dict[str, Any]:
    """Return what an operation holds as elements of their own, by the names of these."""
    return {element: held.name for element, held in _holdings(operation)}


def _tree(inside: Sequence[Node | Branch], indent: str) -> Iterator[str]:
    from layoutkit.operations import Branch

    for number, own in enumerate(inside, 1):
        last = number == len(inside)
        below: Sequence[Node | Branch] = own.children
        if isinstance(own, Branch):
            line = f"branch of weight {own.weight:.6g}"
        else:
            line, below = _line(own.operation), (*own.children, *own.branches)
        yield f"{indent}{'└── ' if last else '├── '}{line}"
        yield from _tree(below, indent + ("    " if last else "│   "))


def _line(operation: Operation) -> str:
    """Return an operation's kind and what it says, less defaults."""
    values = ((a, getattr(operation, a.field_name)) for a in operation.attributes())
    shown = (f'{a.name}="{a.type.text(v)}"' for a, v in values if a.required or v not in (None, a.default))
    held = (f"<{element} {own.name!r}>" for element, own in _holdings(operation))
    return " ".join([operation.qualified_name(), *shown, *held])


def _holdings(operation: Operation) -> Iterator[tuple[str, Any]]:
    from layoutkit.documents.operation_grammar import holdings

    for holding in holdings(type(operation)):
        if (held := getattr(operation, holding.field_name)) is not None:
            yield holding.element, held
