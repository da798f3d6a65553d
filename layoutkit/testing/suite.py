"""The conformance suite as a class of tests, for pytest or any runner that collects ``test_`` methods."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from layoutkit.testing.conformance import Conformance
from layoutkit.testing.subjects import Kind


class ConstraintSuite:
    """Tests that a constraint kind keeps its promises, one method a promise.

    A subclass whose name begins with ``Test`` is all that a test file needs::

        class TestRatio(ConstraintSuite):
            kind = Ratio
            elements = ['<golden:ratio of="@Window"/>']

    Attributes
    ----------
    kind, elements, documents, seed
        As for `layoutkit.testing.Conformance`.
    """

    kind: ClassVar[Kind]
    elements: ClassVar[Sequence[str]] = ()
    documents: ClassVar[Sequence[str | Path]] = ()
    seed: ClassVar[int] = 0

    @classmethod
    def conformance(cls) -> Conformance:
        """Return what the kind is tried with; made once."""
        key = "_conformance"
        if key not in vars(cls):
            setattr(cls, key, Conformance(cls.kind, tuple(cls.elements), tuple(cls.documents), cls.seed))
        found: Conformance = vars(cls)[key]
        return found

    def _keeps(self, promise: str) -> None:
        findings = self.conformance().findings(promise)
        assert not findings, "\n".join(["", *map(str, findings)])

    def test_declaration(self) -> None:
        """The class is declared as the host asks for it; what is written can be read again."""
        self._keeps("declaration")

    def test_messages(self) -> None:
        """Unknown names are refused with a place and a suggestion; violations say where and by how much."""
        self._keeps("messages")

    def test_rules(self) -> None:
        """Rules have their constraint as origin, finite numbers, arrays of the right shape, few states."""
        self._keeps("rules")

    def test_prunings(self) -> None:
        """No arrangement is pruned of which there is a layout without violations."""
        self._keeps("prunings")

    def test_rows(self) -> None:
        """What keeps all rules has no violations, and what has no violations keeps all rows."""
        self._keeps("rows")

    def test_beginnings(self) -> None:
        """What is asked while some words are undecided is kept whatever they come to be."""
        self._keeps("beginnings")

    def test_claims(self) -> None:
        """What it claims beforehand follows from what it demands; its parts together are the whole."""
        self._keeps("claims")

    def test_determinism(self) -> None:
        """The same question has the same answer, in any process."""
        self._keeps("determinism")

    def test_state(self) -> None:
        """Nothing is remembered outside the facade, and nothing that is given is changed."""
        self._keeps("state")
