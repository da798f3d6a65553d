"""Operations documents: trees of operations, with all that they hold and all files that they name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.diagnostics.blame import ANYTHING, Misbehaviour, bounded
from layoutkit.documents.beside import DISK, Kept, Sent
from layoutkit.documents.kind_elements import KindReader
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.named_files import NamedFiles
from layoutkit.documents.operation_grammar import BRANCH, HELD_ELEMENTS, OPERATIONS, OperationKinds, holdings
from layoutkit.documents.placement_models import placement_model_of
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted, opened
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.operations import Branch, Named, Node, Operation, Operations

#: Reads what operations hold, by the name of its element.
_HELD: Mapping[str, Callable[[Element, Reading], Any]] = {"placement-model": placement_model_of}


@dataclass(frozen=True)
class OperationsDocument:
    """An operations document that was read.

    Attributes
    ----------
    diagnostics
        Remarks on it and on the files that it names, in document order; none is an error.
    files
        All that was read: the document itself, facades with their pictures, and sessions; by their paths from
        the folder that it is in, with slashes. `read_operations_files` reads the same from them.
    """

    operations: Operations
    diagnostics: tuple[Diagnostic, ...]
    files: Mapping[str, bytes]


def is_operations(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is an operations tree; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, OPERATIONS)


def read_operations(
    document: Path | str | Source, kinds: OperationKinds, constraints: Kinds
) -> OperationsDocument:
    """Read an operations document, and the files that it names.

    Parameters
    ----------
    kinds
        Kinds of operations by the name of their element.
    constraints
        Constraint kinds by the name of their element, for facades.

    Raises
    ------
    Faulty
        If it or a file that it names has errors, or a file is not there; all of them are in it.
    """
    source = document if isinstance(document, Source) else Source.of(document)
    return _read(source, kinds, constraints, Kept(DISK, Path(source.file).parent))


def read_operations_files(
    files: Mapping[str, bytes], name: str, kinds: OperationKinds, constraints: Kinds
) -> OperationsDocument:
    """Read an operations document from memory, as `read_operations` does from a folder.

    Parameters
    ----------
    files
        What stands in the folder, by its path with slashes: `OperationsDocument.files`.
    name
        Which of them the document is.
    kinds, constraints
        As for `read_operations`.

    Raises
    ------
    Faulty
        As `read_operations`.
    """
    if name not in files:
        message = "the file cannot be read: it is not among those that were sent"
        raise Faulty([Diagnostic("LK001", message, Place(name), topic="file")])
    return _read(Source(name, files[name]), kinds, constraints, Kept(Sent(files), Path(name).parent))


def _read(source: Source, kinds: OperationKinds, constraints: Kinds, files: Kept) -> OperationsDocument:
    held = replace(source, data=source.whole())
    files.found[Path(source.file).name] = held.whole()
    hint = "a session of modelling is told by <operations>, which holds operations"
    root, reading = opened(held, OPERATIONS, hint)
    values = reading.values(root, OPERATIONS)
    named = NamedFiles(files, Path(source.file).parent, constraints, reading)
    reader = _Reader(kinds, reading, named)
    roots = tuple(reader.nodes(root.children, root))
    reader.ask()
    if reading.diagnostics.erroneous:
        raise Faulty(reading.ordered())
    operations = Operations(values["name"], values["units"], roots, values.get("sites", ()))
    return OperationsDocument(operations, reading.ordered(), files.found)


class _Reader:
    """Reads operations and what stands in them."""

    def __init__(self, kinds: OperationKinds, reading: Reading, named: NamedFiles) -> None:
        self._kinds = KindReader(kinds, reading, "operation", "operations")
        self._reading, self._named = reading, named
        self._made: list[tuple[Operation, Element]] = []

    def nodes(self, elements: Iterable[Element], parent: Element) -> Iterator[Node]:
        """Yield the operations among some of the children of an element, as far as they could be read."""
        for child in elements:
            kind = self._kinds.kind_of(child)
            if kind is None:
                self._unknown(child, parent)
                kind = self._kinds.meant_by(child)
            if kind is not None:
                yield from self._node(child, kind)

    def ask(self) -> None:
        """Record what the operations that were read have to say against themselves."""
        for operation, element in self._made:
            try:
                self._reading.diagnostics += _faults(operation, element)
            except ANYTHING as error:  # whatever a plugin raises is laid at its door
                self._kinds.failed(type(operation), error, element)

    def _node(self, element: Element, kind: type[Operation]) -> Iterator[Node]:
        """Yield the operation of an element, if it can be read, with what stands in it."""
        fields = self._kinds.fields_of(element, kind)
        held, inside, branches = self._parts(element, kind)
        children = tuple(self.nodes(inside, element))
        ways = tuple(map(self._branch, branches))
        if fields is None or held is None:
            return
        named = self._with_files(fields, element)
        operation = None if named is None else self._kinds.made(element, kind, {**named, **held})
        if operation is not None:
            self._made.append((operation, element))
            yield Node(operation, children, ways)

    def _parts(
        self, element: Element, kind: type[Operation]
    ) -> tuple[dict[str, Any] | None, list[Element], list[Element]]:
        """Return what an operation holds by field, operations and branches; their order is checked."""
        allowed = {own.element: own.field_name for own in holdings(kind)}
        held: dict[str, Any] = {}
        inside: list[Element] = []
        branches: list[Element] = []
        for child in element.children:
            name = child.name if child.namespace == self._reading.namespace else ""
            if name in HELD_ELEMENTS:
                if self._reading.name_of(child, element, tuple(allowed)) is None:
                    continue
                if allowed[name] in held:
                    self._misplaced(child, f"stands a second time in <{element.name}>", allowed)
                elif inside or branches:
                    self._misplaced(child, f"stands too late in <{element.name}>", allowed)
                held[allowed[name]] = _HELD[name](child, self._reading)
            elif name == BRANCH.name:
                branches.append(child)
            else:
                if branches:
                    self._misplaced(child, f"stands too late in <{element.name}>", allowed)
                inside.append(child)
        return None if None in held.values() else held, inside, branches

    def _misplaced(self, element: Element, what: str, held: Iterable[str]) -> None:
        order = ", ".join([*(f"<{name}> at most once" for name in held), "operations", f"<{BRANCH.name}>"])
        self._reading.fault("LK108", f"<{element.name}> {what}", element, f"the order is: {order}")

    def _branch(self, element: Element) -> Branch:
        values = self._reading.values(element, BRANCH)
        return Branch(tuple(self.nodes(element.children, element)), values.get("weight") or 1.0)

    def _with_files(self, fields: Mapping[str, Any], element: Element) -> dict[str, Any] | None:
        """Return values with what is in the files that they name; None if one cannot be read."""
        named = {name: value for name, value in fields.items() if isinstance(value, Named)}
        read = {name: self._named.read(value, element) for name, value in named.items()}
        return None if None in read.values() else {**fields, **read}

    def _unknown(self, element: Element, parent: Element) -> None:
        """Record that an element is no operation, or cannot stand where it does."""
        ours = element.namespace == self._reading.namespace
        if ours and element.name in (BRANCH.name, *HELD_ELEMENTS):
            self._reading.name_of(element, parent, self._kinds.core)
            return
        around = self._kinds.kind_of(parent) or self._kinds.meant_by(parent)
        beside = () if around is None else (BRANCH.name, *(own.element for own in holdings(around)))
        self._kinds.unknown(element, parent, beside)


def _faults(operation: Operation, element: Element) -> Iterator[Diagnostic]:
    """Yield what an operation has to say against itself; what it gives no place stands at its own.

    Raises
    ------
    Misbehaviour
        If it answers with something else.
    """
    for fault in bounded(operation.faults(), operation, "faults"):
        if not isinstance(fault, Diagnostic):
            raise Misbehaviour(operation, f"gives {fault!r} for a fault, and no Diagnostic")
        yield fault if fault.place else replace(fault, place=element.place)
