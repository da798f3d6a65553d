"""Namespaces: what keeps the elements of one package's constraints apart from those of another."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Namespace:
    """The XML namespace of the constraints that a package adds; all of them share it.

    Attributes
    ----------
    prefix
        What documents commonly write before the names of its elements, as ``golden`` in ``golden:ratio``;
        messages and lists name the constraints so. Empty for layoutkit's own.
    uri
        What makes it the only one of its kind, e.g. ``urn:golden:1`` or ``https://example.org/golden``.
    """

    prefix: str
    uri: str

    def named(self, name: str) -> str:
        """Return an element's name with the usual prefix."""
        return f"{self.prefix}:{name}" if self.prefix else name


#: The namespace of documents, and of the constraints that are built in.
CORE = Namespace("", "urn:layoutkit:1")
