"""What constraint kinds answer when they are asked for rules on words, faults and violations: looked over.

Nothing is taken from a kind, whoever wrote it, without a look: what makes no sense is told of here, where it
is known whose it is. (Rules on sizes: `layoutkit.sizing.answers`.)
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isnan
from typing import TYPE_CHECKING

from layoutkit.constraints.word_rules import (
    Admits,
    Agree,
    Bound,
    Counts,
    Mirrored,
    Variants,
    WordRule,
)
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.diagnostics.blame import Misbehaviour, bounded, diagnosed
from layoutkit.model import Facade, Violation

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint
    from layoutkit.constraints.view import LayoutView


def word_rules_of(facade: Facade, constraints: Sequence[Constraint]) -> list[WordRule]:
    """Return what all constraints, kind by kind, ask of arrangements.

    Raises
    ------
    Misbehaviour
        If a kind answers with something else than rules, or with rules of which nothing can be made.
    """
    kinds: defaultdict[type[Constraint], list[Constraint]] = defaultdict(list)
    for constraint in constraints:
        kinds[type(constraint)].append(constraint)
    found: list[WordRule] = []
    for kind, own in kinds.items():
        for rule in bounded(kind.word_rules(own, facade), own[0], "rules on words"):
            if wrong := _wrong(rule, facade):
                raise Misbehaviour(own[0], f"gives a rule on words that {wrong}")
            found.append(rule)
    return found


def ties_of(constraint: Constraint, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
    """Yield what a constraint ties together.

    Raises
    ------
    Misbehaviour
        If it ties regions that are not there, or along no axis.
    """
    for axis, paths in bounded(constraint.ties(facade), constraint, "ties"):
        unknown = [path for path in paths if path not in facade.regions]
        if axis not in (0, 1) or unknown:
            what = f"{unknown[0]!r}, which is not there" if unknown else f"along the axis {axis!r}"
            raise Misbehaviour(constraint, f"ties regions {what}")
        yield axis, paths


def faults_of(constraint: Constraint, facade: Facade) -> Iterator[Diagnostic]:
    """Yield what a constraint has to say against itself; what it gives no place stands at its own.

    Raises
    ------
    Misbehaviour
        If it answers with something else.
    """
    for fault in bounded(constraint.faults(facade), constraint, "faults"):
        if not isinstance(fault, Diagnostic):
            raise Misbehaviour(constraint, f"gives {fault!r} for a fault, and no Diagnostic")
        yield fault


def violations_of(constraint: Constraint, view: LayoutView) -> Iterator[Violation]:
    """Yield every way in which a layout breaks a constraint.

    Raises
    ------
    Misbehaviour
        If it answers with something else, or with an amount that is none.
    """
    for violation in bounded(constraint.violations(view), constraint, "violations"):
        if not isinstance(violation, Violation):
            raise Misbehaviour(constraint, f"gives {violation!r} for a violation, and no Violation")
        if isnan(violation.amount):
            raise Misbehaviour(
                constraint, f"gives a violation whose amount is no number: {violation.message}"
            )
        yield violation


def failure(kind: type[Constraint], error: BaseException, place: Place | None) -> Diagnostic:
    """Return the diagnostic of a constraint kind that failed: whose it is, and where its element stands."""
    return diagnosed(error, kind, f"the constraint kind {kind.qualified_name()!r}", place)


def _wrong(rule: object, facade: Facade) -> str:
    """Say what is wrong with a rule on words; empty if nothing is."""
    if isinstance(rule, Admits):
        missing = [
            name for name in ("start", "step", "accepts") if not callable(getattr(rule.automaton, name, None))
        ]
        if missing:
            return f"has no automaton: {rule.automaton!r} has no {missing[0]}()"
        return _no_composite(rule.path, facade)
    if isinstance(rule, Counts):
        unknown = [path for path in rule.counted if path not in facade.regions]
        if unknown:
            return f"counts {unknown[0]!r}, which the facade has not"
        return _no_composite(rule.path, facade) or _no_bounds((rule.least, rule.most))
    if isinstance(rule, Agree):
        return _no_symbols(rule.symbols, facade)
    if isinstance(rule, Mirrored):
        return _no_composite(rule.path, facade)
    if isinstance(rule, Variants):
        if rule.path not in facade.regions or "/" not in rule.path:
            return f"lets {rule.path!r} vary, which stands in no region"
        return _no_bounds((rule.least, rule.most))
    return f"is none: {rule!r}"


def _no_composite(path: object, facade: Facade) -> str:
    region = facade.regions.get(path) if isinstance(path, str) else None
    return "" if region is not None and region.split else f"speaks of {path!r}, which is no divided region"


def _no_bounds(bounds: Iterable[Bound]) -> str:
    for bound in bounds:
        if not isinstance(bound, Bound) or isnan(bound.value):
            return f"has {bound!r} for a bound"
    return ""


def _no_symbols(symbols: Mapping[str, Mapping[str, str]], facade: Facade) -> str:
    for path, names in symbols.items():
        if wrong := _no_composite(path, facade):
            return wrong
        own = {child.symbol for child in facade.regions[path].children}
        if unknown := [symbol for symbol in names.values() if symbol not in own]:
            return f"names {unknown[0]!r}, which {path} has not"
    return ""
