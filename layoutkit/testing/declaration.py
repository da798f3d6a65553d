"""Promises about the class: what the host asks of it, and that its constraints survive being written."""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterator

from layoutkit.constraints import BUILT_IN
from layoutkit.constraints.attributes import Attribute
from layoutkit.constraints.constraint import Constraint
from layoutkit.diagnostics import Faulty
from layoutkit.documents import facade_bytes
from layoutkit.hooks.checks import constraint_fault
from layoutkit.testing.finding import Finding, raised
from layoutkit.testing.subjects import Kind, Subject, own_constraints, read_facade

#: What no attribute may choke on: it is refused with a ValueError, or taken.
_ODD = ("", " ", "nan", "-1", "1e999", "§", "a b c", "@", "((", "0%", "𝔘", "9" * 400, "|" * 50)


def declared(kind: Kind) -> Iterator[Finding]:
    """Yield what the host would not take, what is not said, and texts that an attribute chokes on."""
    if fault := constraint_fault(kind):
        yield Finding("declaration", fault)
        return
    if not kind.summary.strip():
        yield Finding("declaration", f"{kind.__name__}.summary says nothing")
    taken = {k.qualified_name() for k in BUILT_IN if k is not kind}
    if kind.qualified_name() in taken:
        yield Finding("declaration", f"{kind.qualified_name()!r} is the name of a built-in kind")
    for attribute in kind.attributes():
        if not attribute.help.strip():
            yield Finding("declaration", f"the attribute {attribute.name} has no help")
        if not attribute.required and attribute.default is not None:
            yield from _read_back(attribute, attribute.default, "its default")
        for text in _ODD:
            yield from _odd(attribute, text)


def _odd(attribute: Attribute, text: str) -> Iterator[Finding]:
    """Parse what users may write by mistake."""
    try:
        value = attribute.type.parse(text)
    except ValueError as error:
        if not str(error):
            shown = f"the attribute {attribute.name} refuses {text[:20]!r} and does not say why"
            yield Finding("declaration", shown)
        return
    except Exception as error:  # whatever is raised is the finding
        shown = f"the attribute {attribute.name} raises, at {text[:20]!r}, no ValueError: {raised(error)}"
        yield Finding("declaration", shown)
        return
    yield from _read_back(attribute, value, f"{text[:20]!r}")


def _read_back(attribute: Attribute, value: object, what: str) -> Iterator[Finding]:
    try:
        text = attribute.type.text(value)
        same = attribute.type.parse(text) == value
    except Exception as error:  # whatever is raised is the finding
        shown = f"the attribute {attribute.name} cannot read back what it writes of {what}: {raised(error)}"
        yield Finding("declaration", shown)
        return
    if attribute.type.pattern and not re.fullmatch(attribute.type.pattern, text):
        shown = f"the attribute {attribute.name} writes {what} as {text!r}, which its own pattern refuses"
        yield Finding("declaration", shown)
    if not same:
        shown = f"the attribute {attribute.name} writes {what} as {text!r}, and reads that as something else"
        yield Finding("declaration", shown)


def written(subject: Subject) -> Iterator[Finding]:
    """Yield constraints that differ from what is written of them, or cannot be hashed or pickled."""
    for constraint in subject.constraints:
        yield from _kept(constraint, str(subject))
        for attribute in constraint.attributes():
            value = getattr(constraint, attribute.field_name)
            if value is not None:
                yield from _read_back(attribute, value, str(value))
    try:
        text = facade_bytes(subject.facade).decode()
        again = own_constraints(read_facade(text, subject.name, subject.kind), subject.kind)
    except (Faulty, ValueError) as error:
        yield Finding("declaration", f"a document with it cannot be written and read: {raised(error)}")
        return
    if again != subject.constraints:
        details = tuple(map(str, again))
        message = "a document that is written and read again has other constraints in it"
        yield Finding("declaration", message, str(subject), details)


def _kept(constraint: Constraint, subject: str) -> Iterator[Finding]:
    try:
        hash(constraint)
    except TypeError as error:
        yield Finding("declaration", f"it cannot be hashed: {error}; use tuples for lists", subject)
    try:
        copy = pickle.loads(pickle.dumps(constraint))
    except Exception as error:  # whatever is raised is the finding
        yield Finding("declaration", f"it cannot be pickled: {raised(error)}", subject)
        return
    if copy != constraint:
        yield Finding("declaration", "it is not equal to a pickled copy of itself", subject)
