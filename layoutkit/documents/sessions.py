"""Session documents: the edits of a facade, and the facade that they begin with."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean
from layoutkit.documents.beside import DISK, Files
from layoutkit.documents.document import named_facade
from layoutkit.documents.grammar import DRAG, EDIT, REGION_SIZE, RESIZE, SESSION, ElementType
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted, opened
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model import Facade
from layoutkit.model.session import Drag, Edit, RegionSize, Resize, Session, Step

_TYPES: dict[type[Step], ElementType] = {Edit: EDIT, Resize: RESIZE, Drag: DRAG, RegionSize: REGION_SIZE}
_KINDS = {declared.name: kind for kind, declared in _TYPES.items()}
#: What an edit needs besides its axis and its grids, by its action; an element that is moved has no source.
_NEEDED = {"add": ("source", "at"), "remove": ("source",), "move": ("source", "to")}
_NUMBER = re.compile(r"_\d+$")
_DOING = {"add": "adds", "remove": "removes", "move": "moves"}


@dataclass(frozen=True)
class SessionDocument:
    """A session document that was read.

    Attributes
    ----------
    facade
        What its edits begin with.
    diagnostics
        Remarks on it and on its facade, in document order; none is an error.
    """

    session: Session
    facade: Facade
    diagnostics: tuple[Diagnostic, ...]


def is_session(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is a session; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, SESSION)


def read_session(document: Path | str | Source, kinds: Kinds, files: Files = DISK) -> SessionDocument:
    """Read a session document, and the facade that it names.

    That its edits can be made is not checked, as that takes making them.

    Parameters
    ----------
    kinds
        Constraint kinds by the name of their element, for the facade.
    files
        Where the facade is looked for.

    Raises
    ------
    Faulty
        If it or its facade has errors, or the facade is not there; all of them are in it.
    """
    hint = "the edits of a facade are told by <session>"
    root, reading = opened(document, SESSION, hint)
    values = reading.values(root, SESSION)
    steps = tuple(_steps(root, reading))
    count, file = values.get("done"), values.get("facade")
    if count is not None and count > len(root.children):
        message = f"{count} edits are said to be in force, and the session has {len(root.children)}"
        reading.fault("LK105", message, root, "lower the attribute done, or delete it: then all are")
    facade = None if file is None else named_facade(file, root, kinds, reading, Severity.ERROR, files)
    if facade is not None:
        _check_grids(steps, facade, reading)
    if facade is None or reading.diagnostics.erroneous:
        raise Faulty(reading.ordered())
    taken = tuple(step for step, _ in steps)
    done = taken if count is None else taken[:count]
    session = Session(values["name"], values["facade"], done, taken[len(done) :])
    return SessionDocument(session, facade, reading.ordered())


def step_fields(step: Step) -> tuple[ElementType, dict[str, Any]]:
    """Return the element that tells a step, and those of its attributes that are there, by name."""
    declared = _TYPES[type(step)]
    values = {name: getattr(step, name) for name in declared.attributes}
    said = {name: value for name, value in values.items() if value not in (None, ())}
    return declared, {n: v for n, v in said.items() if v != declared.attributes[n].default}


def _steps(root: Element, reading: Reading) -> Iterator[tuple[Step, Element]]:
    """Yield the steps that could be read, each with its element."""
    for child in root.children:
        name = reading.name_of(child, root, tuple(_KINDS))
        if name is None:
            continue
        before = len(reading.diagnostics)
        kind = _KINDS[name]
        values = reading.values(child, _TYPES[kind])
        reading.no_children(child)
        if kind is Edit:
            _check_edit(values, child, reading)
        elif kind is not Drag and not {"width", "height"} & values.keys():
            message = f"<{name}> lacks both the attribute width and the attribute height"
            reading.fault("LK104", message, child, "say at least one of them")
        if len(reading.diagnostics) == before:
            yield kind(**values, place=child.place), child


def _check_edit(values: dict[str, Any], element: Element, reading: Reading) -> None:
    """Record where the attributes of an edit do not go together."""
    action = values.get("action")
    if action is None:
        return
    needed, doing = _NEEDED[action], f"an <edit> that {_DOING[action]}"
    if action == "move" and "element" in values:
        needed, doing = ("element", "to"), "an <edit> that moves an element"
    for name in needed:
        if name not in values:
            hint = EDIT.attributes[name].help
            reading.fault("LK104", f"{doing} lacks the attribute {name}", element, hint)
    for name in ("source", "at", "to", "element", "gap"):
        if name in values and name not in needed and (name != "gap" or action != "remove"):
            reading.fault("LK103", f"{doing} has no attribute {name!r}", element, f"delete {name}")
    _check_numbers(values, needed, element, reading)


def _check_numbers(
    values: dict[str, Any], needed: tuple[str, ...], element: Element, reading: Reading
) -> None:
    """Record that there are not as many places as there are columns or rows that go there."""
    where = needed[-1]
    places, sources = values.get(where), values.get("source") if "source" in needed else (1,)
    if places is not None and sources is not None and len(places) != len(sources):
        message = f"{where} of <edit> has {len(places)} numbers, and {len(sources)} are needed"
        hint = "one number goes with each of source; a single element has one place"
        reading.fault("LK105", message, element, hint)


def _check_grids(steps: tuple[tuple[Step, Element], ...], facade: Facade, reading: Reading) -> None:
    """Record which grids edits name that the facade lacks, and that no edit before can have made.

    Where lines are added, copies of subgrids come with them, called as these are, with a number.
    """
    known = tuple(grid.name for grid in facade.grids)
    added = False
    for step, element in steps:
        for name in step.grids if isinstance(step, Edit) else ():
            stem = _NUMBER.sub("", name)
            if name not in known and not (added and any(_NUMBER.sub("", own) == stem for own in known)):
                message = f"the edit names the grid {name!r}, which the facade lacks"
                hint = (
                    did_you_mean(name, known)
                    if known
                    else "the facade has none: `layoutkit grids` finds some"
                )
                reading.fault("LK246", message, element, hint, "reference")
        added |= isinstance(step, Edit) and step.action == "add"
