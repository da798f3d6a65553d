"""What can be in no layout, whatever its size: as errors where there is none at all, else as warnings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial

from layoutkit.constraints import Constraint
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.model import Facade
from layoutkit.model.conflict import Amount
from layoutkit.sizing.rules import Range
from layoutkit_relayout.auditing.blame import Suspects, lines, places
from layoutkit_relayout.auditing.prospects import Fault, Prospects
from layoutkit_relayout.auditing.rows import contradiction, lasting_rows, missing, own_ranges
from layoutkit_relayout.auditing.subjects import subjects
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.conflict import Parts
from layoutkit_relayout.explanation.units import Unit, flat

#: Contradictions between rows that are told; of more, the first ones.
_MOST = 5
#: Regions of one cause that are named.
_LISTED = 9
_WIDE = ("wide", "high")


@dataclass
class _Group:
    """Faults of which the same constraints are the cause.

    Attributes
    ----------
    first, parts
        A fault, and what takes part in it.
    others
        Those that these constraints show as well.
    """

    first: Fault
    parts: Parts
    others: list[Fault] = field(default_factory=list)

    @property
    def culprits(self) -> list[Unit]:
        """The constraints of the document, other than those that say which arrangements there are."""
        return [unit for unit in self.parts if not unit.by_default and not unit.region]


def faults(prospects: Prospects) -> list[Diagnostic]:
    """Return why regions can be in no layout, each with the least set of constraints that shows it."""
    facade, suspects = prospects.facade, Suspects(prospects.facade)
    severity = Severity.ERROR if prospects.barren else Severity.WARNING
    groups = _grouped(prospects, suspects)
    found = [_told(facade, group.first, group.parts, severity, group.others) for group in groups]
    blamed = {unit for group in groups for unit in group.culprits}
    left = [unit for unit in suspects.units if unit not in blamed]
    if prospects.tractable:
        for diagnostic, units in _crossed(prospects, left):
            found.append(diagnostic)
            left = [unit for unit in left if unit not in units]
    return [*found, *_contradictions(prospects, left)]


def _grouped(prospects: Prospects, suspects: Suspects) -> list[_Group]:
    """Put faults of one cause together: one constraint may speak of many regions."""
    groups: list[_Group] = []
    for fault in prospects.faults():
        shows = partial(_shows, fault)
        known = next((g for g in groups if g.culprits and suspects.enough(shows, g.culprits)), None)
        parts = suspects.at_fault(shows, fault.path) if known is None else {}
        if known is None and not parts:  # that took too long: such faults are told together
            known = next((g for g in groups if not g.parts and g.first.about == fault.about), None)
        if known is None:
            groups.append(_Group(fault, parts))
        else:
            known.others.append(fault)
    return groups


def _crossed(prospects: Prospects, units: Sequence[Unit]) -> Iterator[tuple[Diagnostic, list[Unit]]]:
    """Yield each region of which two constraints ask for sizes that do not meet, with these."""
    facade, size = prospects.facade, max(prospects.facade.root.width, prospects.facade.root.height)
    owners = _owners(units)
    for (path, axis), rows in own_ranges(facade, _constraints(units)).items():
        least, most = max(rows, key=lambda row: row.least), min(rows, key=lambda row: row.most)
        behind = [unit for row in (least, most) for unit in _behind(row, owners, units)]
        if path in prospects.spelling.reached and contradiction([least, most], size) and behind:
            fault = Fault(path, "sizes", axis, (), least.least - most.most, (least.least, most.most))
            severity = Severity.ERROR if path in prospects.required else Severity.WARNING
            yield _told(facade, fault, {unit: unit.constraints for unit in behind}, severity), behind


def _owners(units: Sequence[Unit]) -> dict[int, Unit]:
    return {id(constraint): unit for unit in units for constraint in unit.constraints}


def _constraints(units: Sequence[Unit]) -> list[Constraint]:
    """Return the constraints of units that may ask something of sizes."""
    return [constraint for unit in units if not unit.region for constraint in unit.constraints]


def _shows(fault: Fault, prospects: Prospects) -> bool:
    if not prospects.spelling.tractable(fault.path):
        return False
    state = prospects.state(fault.path)
    return isinstance(state, Fault) and (state.about, state.axis) == (fault.about, fault.axis)


def _told(
    facade: Facade, fault: Fault, parts: Parts, severity: Severity, others: Sequence[Fault] = ()
) -> Diagnostic:
    said = _sizes(facade, fault, parts) if fault.about == "sizes" else _words(facade, fault, parts)
    code, message, hint, further, short = said
    if severity is not Severity.ERROR:
        message += f"; {fault.path} is in no layout"
    further += tuple(f"likewise in {o.path}" + _short_by(facade, o) for o in others[:_LISTED])
    further += (f"and in {len(others) - _LISTED} more",) if len(others) > _LISTED else ()
    return _diagnostic(code, message, hint, facade, parts, short, severity, further)


def _short_by(facade: Facade, fault: Fault) -> str:
    if fault.short <= 0:
        return ""
    units = facade.units if fault.about == "sizes" else "regions"
    return f": short by {wording.amount(Amount(fault.short, units), facade)}"


_Said = tuple[str, str, str, tuple[str, ...], tuple[Amount, ...]]


def _sizes(facade: Facade, fault: Fault, parts: Parts) -> _Said:
    short = (Amount(fault.short, facade.units),)
    ends = [wording.length(end, facade) for end in fault.sizes]
    gap, wide = wording.amount(short[0], facade), _WIDE[fault.axis]
    message = f"would have to be at least {ends[0]} {wide}, and may be at most {ends[1]}"
    hint = f"raise the maximum, or lower the minimum, by {gap}"
    if _about_one(fault.path, facade, parts):
        return "LK226", f"the sizes of {fault.path} contradict each other: it {message}", hint, (), short
    hint = f"raise maxima, or lower minima, by {gap} in all"
    return "LK224", f"the sizes in {fault.path} cannot add up: it {message}", hint, (), short


def _about_one(path: str, facade: Facade, parts: Parts) -> bool:
    """Tell whether all that takes part speaks of the region itself, and no arrangement does."""
    spoken = ({p for own in subjects(c, facade).values() for p in own} for c in flat(parts))
    return bool(parts) and all(path in own for own in spoken) and not any(unit.region for unit in parts)


def _words(facade: Facade, fault: Fault, parts: Parts) -> _Said:
    short = (Amount(fault.short, "regions"),) if fault.short > 0 else ()
    by = f" by {wording.amount(short[0], facade)}" if short else ""
    spelling = [unit for unit in parts if unit.region]
    if len(parts) == 1 and spelling:
        hint = "add a sequence that closes the gap: each overlaps the one before in a subregion"
        message = f"the sequences of {fault.path} admit no arrangement at all"
        return "LK225", message, hint, tuple(_gaps(facade, spelling[0])), ()
    if len(parts) == 1:
        kind = next(iter(parts)).constraints[0].qualified_name()
        return "LK225", f"no arrangement of {fault.path} satisfies this {kind}", f"loosen it{by}", (), short
    if not spelling:
        return (
            "LK226",
            f"these constraints on {fault.path} contradict each other",
            f"loosen one{by}",
            (),
            short,
        )
    hint = f"allow more arrangements of {fault.path} by a further sequence, or loosen what else is asked{by}"
    which = (
        f"of {fault.path}" if not fault.together else f"is the same in {' and '.join(fault.together)}, and"
    )
    return "LK225", f"no arrangement {which} satisfies all that is asked of it", hint, (), short


def _gaps(facade: Facade, unit: Unit) -> Iterator[str]:
    """Yield what is missing for a chain of sequences from end to end."""
    own = [c for c in unit.constraints if isinstance(c, SequenceConstraint)]
    if own and not any(c.word.at_start for c in own):
        yield "no sequence begins with ⊢"
    if own and not any(c.word.at_end for c in own):
        yield "no sequence ends with ⊣"


def _contradictions(prospects: Prospects, units: Sequence[Unit]) -> Iterator[Diagnostic]:
    """Yield the constraints whose rows on sizes cannot hold together in any layout."""
    facade, size = prospects.facade, max(prospects.facade.root.width, prospects.facade.root.height)
    left = list(units)
    for _ in range(_MOST):
        owners, rows = _owners(left), lasting_rows(prospects, _constraints(left))
        rows = _least(contradiction(rows, size), size)
        if not rows:
            return
        parts: Parts = {}
        for row in rows:
            for unit in _behind(row, owners, left):
                parts[unit] = unit.constraints
        ordered: Parts = {unit: parts[unit] for unit in left if unit in parts}
        gap = Amount(missing(rows, size), facade.units)
        hint = f"loosen one of them by {wording.amount(gap, facade)}"
        message = "these constraints contradict each other at any size"
        yield _diagnostic("LK226", message, hint, facade, ordered, (gap,), Severity.ERROR, ())
        given_up = [unit for unit in ordered if not unit.region and not unit.by_default]
        left = [unit for unit in left if unit not in (given_up or list(ordered))]


def _least(rows: Sequence[Range], size: float) -> list[Range]:
    """Leave out each row without which the others still contradict each other."""
    found = list(rows)
    for row in rows:
        rest = [other for other in found if other is not row]
        if contradiction(rest, size):
            found = rest
    return found


def _behind(row: Range, owners: dict[int, Unit], units: Sequence[Unit]) -> Iterator[Unit]:
    """Yield the unit that asks for a row; for one that makes children fill a parent, its arrangement."""
    if row.origin is not None:
        yield from (unit for unit in [owners.get(id(row.origin))] if unit is not None)
    else:
        yield from (unit for unit in units if unit.region and unit.region in (row.words or ()))


def _diagnostic(
    code: str,
    message: str,
    hint: str,
    facade: Facade,
    parts: Parts,
    short: tuple[Amount, ...],
    severity: Severity,
    further: tuple[str, ...],
) -> Diagnostic:
    related: tuple[Place, ...] = places(facade, parts)
    return Diagnostic(
        code,
        message,
        related[0] if related else None,
        hint,
        severity,
        "semantics",
        (*lines(facade, parts, short), *further),
        related if len(related) > 1 else (),
    )
