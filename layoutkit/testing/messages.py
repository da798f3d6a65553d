"""Promises about what users read: faults with a place and a hint, violations with a path and an amount."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from math import isfinite

from layoutkit.constraints.answers import faults_of, violations_of
from layoutkit.constraints.attributes import (
    CONTEXT,
    ENCLOSING,
    EXTENT,
    MEMBERS,
    PATH,
    PATHS,
    REGIONS,
    WORD,
    Attribute,
)
from layoutkit.constraints.constraint import Constraint
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import Facade, Violation
from layoutkit.model.selection import SYMBOL
from layoutkit.testing.agreement import Trial
from layoutkit.testing.finding import Finding

#: Types of attributes that name regions.
_NAMING = (CONTEXT, ENCLOSING, EXTENT, MEMBERS, PATH, PATHS, REGIONS, WORD)
#: A name in such an attribute: the last step of a path, or a label.
_NAME = re.compile(rf"(?<![\w@])@?{SYMBOL}(?:/{SYMBOL})*")
#: So many layouts are looked at.
_LOOKED_AT = 200


def faults(trial: Trial) -> Iterator[Finding]:
    """Yield names that the facade lacks and are not refused, and faults without place, hint or message."""
    facade = trial.subject.facade
    for constraint in trial.subject.constraints:
        for fault in faults_of(constraint, facade):
            yield from _fault(fault, constraint)
        for attribute in constraint.attributes():
            if attribute.type in _NAMING and getattr(constraint, attribute.field_name) is not None:
                yield from _misspelt(constraint, attribute, facade)


def _misspelt(constraint: Constraint, attribute: Attribute, facade: Facade) -> Iterator[Finding]:
    """Misspell each name of an attribute in turn."""
    text = attribute.type.text(getattr(constraint, attribute.field_name))
    for name in dict.fromkeys(found.group() for found in _NAME.finditer(text)):
        wrong = f"{name}qx"
        pattern = rf"(?<![\w@/]){re.escape(name)}(?![\w/])"
        changed = re.sub(pattern, wrong, text)
        try:
            value = attribute.type.parse(changed)
        except ValueError:
            continue
        if changed == text:
            continue
        told = list(faults_of(replace(constraint, **{attribute.field_name: value}), facade))
        yield from (finding for fault in told for finding in _fault(fault, constraint))
        errors = [fault for fault in told if fault.severity is Severity.ERROR]
        shown = f'{attribute.name}="{changed}"'
        if not errors:
            message = f"faults() lets {shown} pass, where {wrong!r} is no region, symbol or label"
            yield Finding("messages", message, str(constraint))
        elif not any(_suggests(fault, name) for fault in errors):
            message = f"faults() refuses {shown}, and does not suggest {name!r}: {errors[0].hint!r}"
            yield Finding("messages", message, str(constraint))


def _suggests(fault: Diagnostic, name: str) -> bool:
    return name.lstrip("@").rpartition("/")[2] in fault.hint


def _fault(fault: Diagnostic, constraint: Constraint) -> Iterator[Finding]:
    lacks = [
        what
        for what, there in (
            ("no message", fault.message.strip()),
            ("a message of several lines", "\n" not in fault.message),
            ("no place: give it the constraint's, self.place", fault.place is not None),
            ("no hint", fault.hint.strip() or fault.severity is Severity.NOTE),
            ("no code", fault.code.strip()),
        )
        if not there
    ]
    for lack in lacks:
        yield Finding("messages", f"the fault {fault.message!r} has {lack}", str(constraint))


def violations(trial: Trial) -> Iterator[Finding]:
    """Yield violations that do not name their constraint, a region, or a finite amount above 0."""
    for sample in islice(trial.samples, _LOOKED_AT):
        view = sample.view
        for constraint in trial.subject.constraints:
            for violation in violations_of(constraint, view):
                for lack in _lacks(violation, constraint, set(view.by_path)):
                    message = f"the violation {violation.message!r} of {violation.path} has {lack}"
                    yield trial.finding("messages", message, sample)


def _lacks(violation: Violation, constraint: Constraint, paths: set[str]) -> Iterator[str]:
    if not violation.message.strip() or "\n" in violation.message:
        yield "no message, or one of several lines"
    if violation.path.rstrip("/") not in paths:  # a run of a region's children ends with a slash
        yield "a path that is none of the layout: use the placed region's `path`"
    if not isfinite(violation.amount) or violation.amount <= 0:
        yield f"the amount {violation.amount!r}, and no number above 0"
    if violation.constraint != constraint:
        yield f"another constraint: {violation.constraint}"
