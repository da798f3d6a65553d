"""What a constraint kind is tried with: facades with constraints of the kind in them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.diagnostics import Faulty, Severity
from layoutkit.documents.document import open_document
from layoutkit.documents.source import Source
from layoutkit.model import Facade, Region
from layoutkit.testing.finding import Finding
from layoutkit.testing.houses import HOUSES, document

Kind = type[Constraint]

#: By how much the facade grows that the same constraints are tried on.
_GROWTH = 1.5


@dataclass(frozen=True, eq=False)
class Subject:
    """A facade document with constraints of the kind that is tried.

    Attributes
    ----------
    name
        What findings call it.
    text
        The document.
    """

    kind: Kind
    name: str
    text: str

    @cached_property
    def facade(self) -> Facade:
        """What the document says."""
        return self.again()

    @property
    def constraints(self) -> tuple[Constraint, ...]:
        """The constraints of the kind."""
        return own_constraints(self.facade, self.kind)

    def again(self) -> Facade:
        """Return the facade read anew: nothing is remembered of it."""
        return read_facade(self.text, self.name, self.kind)

    def __str__(self) -> str:
        return " + ".join([self.name, *map(str, self.constraints)])


def own_constraints(facade: Facade, kind: Kind) -> tuple[Constraint, ...]:
    """Return a facade's constraints of a kind."""
    return tuple(c for c in facade.constraints if type(c) is kind)


def read_facade(text: str, name: str, kind: Kind) -> Facade:
    """Return the facade that a document describes.

    Raises
    ------
    Faulty
        If it has errors, or is no facade.
    """
    kinds = {k.qualified_name(): k for k in (*BUILT_IN, kind)}
    opened = open_document(Source.part(text, name, 1, 1), kinds)
    if errors := [d for d in opened.diagnostics if d.severity is Severity.ERROR]:
        raise Faulty(errors)
    if not isinstance(opened.model, Facade):
        raise TypeError(f"{name} is no facade")
    return opened.model


def grown(facade: Facade, constraints: Sequence[Constraint]) -> Facade:
    """Return a facade of the same regions, each larger by the same factor, with other constraints."""
    return replace(facade, root=_grown(facade.root), constraints=tuple(constraints))


def _grown(region: Region) -> Region:
    children = tuple(map(_grown, region.children))
    return replace(region, width=_GROWTH * region.width, height=_GROWTH * region.height, children=children)


def subjects(
    kind: Kind, elements: Sequence[str], documents: Sequence[str | Path]
) -> tuple[list[Subject], list[Finding]]:
    """Return what a kind is tried with, and what is wrong with that.

    Parameters
    ----------
    elements
        Constraints of the kind as they stand in documents: each is tried by itself, and all together, in
        every facade of `HOUSES` in which it has no faults.
    documents
        Facades of the author's own: the text of a document, or its file.
    """
    found: list[Subject] = []
    wrong: list[Finding] = []
    for element in elements:
        tried = [_subject(kind, house, element) for house in HOUSES]
        good = [one for one in tried if isinstance(one, Subject)]
        found += good
        if not good:
            why = tuple(str(one) for one in tried if not isinstance(one, Subject))
            message = f"this element can be used in none of the facades {', '.join(HOUSES)}: {element}"
            wrong.append(Finding("declaration", message, details=why))
    if len(elements) > 1:
        together = (_subject(kind, house, "\n    ".join(elements)) for house in HOUSES)
        found += [one for one in together if isinstance(one, Subject)]
    for number, given in enumerate(documents, 1):
        name, text = _text(given, number)
        one = _tried(kind, name, text)
        if isinstance(one, Subject):
            found.append(one)
        else:
            wrong.append(Finding("declaration", f"the document {name} has faults", details=(str(one),)))
    if not found and not wrong:
        message = f"there is nothing to try {kind.qualified_name()} with: give elements or documents"
        wrong.append(Finding("declaration", message))
    return found, wrong


def facade_with(kind: Kind, elements: str, house: str = "row") -> Facade:
    """Return one of the facades of `HOUSES` with constraints in it.

    Parameters
    ----------
    elements
        Constraints as they stand in documents, of the kind and built-in ones; the prefix of the kind's
        namespace is declared.

    Raises
    ------
    Faulty
        If they have faults.
    """
    return read_facade(_written(kind, house, elements), house, kind)


def _written(kind: Kind, house: str, elements: str) -> str:
    spaces: Mapping[str, str] = {kind.namespace.prefix: kind.namespace.uri}
    return document(house, HOUSES[house], elements, spaces)


def _text(given: str | Path, number: int) -> tuple[str, str]:
    if isinstance(given, Path):
        return given.name, given.read_text(encoding="utf-8")
    return f"document {number}", given


def _subject(kind: Kind, house: str, elements: str) -> Subject | Exception:
    return _tried(kind, house, _written(kind, house, elements))


def _tried(kind: Kind, name: str, text: str) -> Subject | Exception:
    """Return what the document says, or why it cannot be used."""
    subject = Subject(kind, name, text)
    try:
        if not subject.constraints:
            return ValueError(f"it has no {kind.qualified_name()} in it")
    except (Faulty, TypeError) as error:
        return error
    return subject
