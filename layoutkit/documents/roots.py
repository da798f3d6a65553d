"""The root element of a document, which tells what kind of document it is."""

from __future__ import annotations

import contextlib
from pathlib import Path
from xml.parsers import expat

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.documents.grammar import NAMESPACE, ElementType
from layoutkit.documents.reading import Reading
from layoutkit.documents.source import Source
from layoutkit.documents.spelling import near_namespace
from layoutkit.documents.tree import Element, parse


def is_rooted(document: Path | str | Source, declared: ElementType) -> bool:
    """Tell whether the root of a document has the name of an element; of what is no XML it has not.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    source = document if isinstance(document, Source) else Source.of(document)
    names: list[str] = []
    parser = expat.ParserCreate(source.encoding, namespace_separator=" ")
    parser.StartElementHandler = lambda name, attributes: names.append(name)
    with contextlib.suppress(expat.ExpatError, LookupError, ValueError):  # as the reader will say
        for chunk in source.chunks():
            parser.Parse(chunk, False)
            if names:
                break
    return bool(names) and names[0].rpartition(" ")[2] == declared.name


def opened(document: Path | str | Source, declared: ElementType, hint: str) -> tuple[Element, Reading]:
    """Return the root of a document of some kind, and what is recorded as it is read.

    Raises
    ------
    Faulty
        If the file cannot be read, is no XML, or its root is another element (LK101).
    """
    root = parse(document if isinstance(document, Source) else Source.of(document))
    reading = Reading(root.namespace)
    _check_root(root, declared, hint, reading)
    return root, reading


def _check_root(root: Element, declared: ElementType, hint: str, reading: Reading) -> None:
    """Record that a root has no namespace.

    Raises
    ------
    Faulty
        If it is another element, or of another namespace (LK101).
    """
    if root.name != declared.name or root.namespace not in ("", NAMESPACE):
        message = f"<{root.name}> is no {declared.name}"
        if root.name == declared.name and near_namespace(root.namespace):
            message = f"<{root.name}> is of the namespace {root.namespace!r}"
            hint = f"did you mean {NAMESPACE!r}?"
        raise Faulty([Diagnostic("LK101", message, root.place, hint, topic="schema")])
    if not root.namespace:
        needed = f'write <{root.name} xmlns="{NAMESPACE}" ...>'
        reading.fault("LK101", f"<{root.name}> is of no namespace", root, needed)
