"""What the command `explain` found, as data for other programs and as marks on a picture."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from layoutkit.model import Box, Layout, Violation, place

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint
    from layoutkit.model.conflict import Amount, Conflict, Explanation, Member, Remedy
    from layoutkit.pictures.marks import Mark


def conflict_data(conflict: Conflict) -> dict[str, Any]:
    """Return a conflict as JSON-ready data."""
    return {
        "minimal": conflict.minimal,
        "short": [_amount(some) for some in conflict.short],
        "members": [_member(member) for member in conflict.members],
        "remedies": [_remedy(remedy) for remedy in conflict.remedies],
        "spared": conflict.spared,
    }


def violation_data(violation: Violation) -> dict[str, Any]:
    """Return a violation as JSON-ready data."""
    return {
        "path": violation.path,
        "message": violation.message,
        "amount": violation.amount,
        "constraint": None if violation.constraint is None else _constraint(violation.constraint),
    }


def _member(member: Member) -> dict[str, Any]:
    return {
        "subject": member.subject,
        "demand": member.demand,
        "regions": list(member.regions),
        "constraints": [_constraint(constraint) for constraint in member.constraints],
        "by_default": member.by_default,
        "needed": member.needed,
    }


def _remedy(remedy: Remedy) -> dict[str, Any]:
    return {
        "text": remedy.text,
        "member": remedy.member,
        "removed": [_constraint(constraint) for constraint in remedy.removed],
        "added": [_constraint(constraint) for constraint in remedy.added],
        "size": None if remedy.size is None else list(remedy.size),
        "amount": None if remedy.amount is None else _amount(remedy.amount),
    }


def _constraint(constraint: Constraint) -> dict[str, Any]:
    """Return a constraint by the text of its element, if it can be written as one, and where it stands."""
    from layoutkit.constraints.defaults import InputWord
    from layoutkit.documents.writing import constraint_lines

    element = None
    if not isinstance(constraint, InputWord):
        *_, element = constraint_lines([constraint])
    where = None if constraint.place is None else asdict(constraint.place)
    return {"kind": constraint.qualified_name(), "element": element, "place": where}


def _amount(some: Amount) -> dict[str, Any]:
    # What a subtraction leaves behind is no news to anyone.
    return {"value": round(some.value, 9), "units": some.units}


def marks_of(explanation: Explanation, layout: Layout) -> list[Mark]:
    """Return what to mark on a best effort: what is broken, then what else takes part in conflicts."""
    from layoutkit.pictures.marks import Mark

    boxes = {placed.path: placed.box for placed in place(layout.root)}
    broken = dict(_broken(layout.violations()))
    marks = [Mark(tuple(_boxes(paths, boxes)), text, True) for text, paths in broken.items()]
    lost = {id(v.constraint) for v in layout.violations()}
    others = dict.fromkeys(m for c in explanation.conflicts for m in c.members)
    for member in others:
        if not any(id(constraint) in lost for constraint in member.constraints):
            places = [p.box for p in place(layout.root) if p.symbol_path in member.regions]
            marks.append(Mark(tuple(places), f"{member.subject}: {member.demand}{_lines(member)}", False))
    return marks


def _lines(member: Member) -> str:
    lines = sorted({c.place.line for c in member.constraints if c.place is not None})
    return (
        f" (line{'s' if len(lines) > 1 else ''} {', '.join(map(str, lines))})" if lines else " (by default)"
    )


def _boxes(paths: Iterable[str], boxes: dict[str, Box]) -> Iterable[Box]:
    return (boxes[path.rstrip("/")] for path in paths if path.rstrip("/") in boxes)


def _broken(violations: Sequence[Violation]) -> Iterable[tuple[str, list[str]]]:
    """Yield a text for each broken constraint, and the paths of the regions where it is."""
    groups: dict[int, list[Violation]] = {}
    for violation in violations:
        groups.setdefault(id(violation.constraint), []).append(violation)
    for group in groups.values():
        yield broken_text(group), [violation.path for violation in group]


def broken_text(group: Sequence[Violation]) -> str:
    """Return one constraint's violations in a line: the gravest, and how many others there are."""
    worst = max(group, key=lambda violation: violation.amount)
    constraint = worst.constraint
    what = "a rule of every layout" if constraint is None else constraint.qualified_name()
    line = f" (line {constraint.place.line})" if constraint and constraint.place else ""
    more = f", and {len(group) - 1} more of the kind" if len(group) > 1 else ""
    return f"{what}{line} is broken: {worst.path} {worst.message}{more}"
