"""What a sequence generator is (Bao et al. 2013, section 5.2, shortcuts).

A generator stands for the sequences that it adds to its regions: `layoutkit.constraints.expansion` puts these
in its place. They stand beside the regions' other sequences, and all of them together say which arrangements
are valid. The built-in ones are in `layoutkit.constraints.generated`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from layoutkit.constraints.attributes import WEIGHT, attribute
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.model import Facade, Violation, Word

#: The words of all sequences of each region that has some, by its path.
Given = Mapping[str, tuple[Word, ...]]


@dataclass(frozen=True, kw_only=True)
class Generator(Constraint):
    """Adds sequences to regions.

    A kind of one's own says which regions (`targets`) and which words (`words`); parsing, search, sizing and
    checking then follow from its sequences.

    Attributes
    ----------
    weight
        That of each of its sequences. Like them, it is a permission, and never soft.
    """

    weight: float = attribute(
        WEIGHT, "The weight of each of its sequences. It is a permission like them, never soft.", 1.0
    )

    @property
    def soft(self) -> bool:
        """False: what is permitted is not taken back."""
        return False

    def targets(self, facade: Facade) -> tuple[str, ...]:
        """Return the paths of the regions that it adds sequences to."""
        raise NotImplementedError(f"the generator {self.qualified_name()!r} does not say what it speaks of")

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the sequences that it adds to one of its targets.

        Parameters
        ----------
        given
            The sequences that are known of, those that it adds itself among them.

        Raises
        ------
        Faulty
            If it cannot say; with the reasons.
        """
        raise NotImplementedError(f"the generator {self.qualified_name()!r} does not say what it adds")

    def unknown(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield the names that the facade lacks, whatever other constraints there are."""
        raise NotImplementedError(f"the generator {self.qualified_name()!r} does not check its names")

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, and why sequences cannot be made."""
        # Expansion looks at generators, and they at it: what others add may be what this one goes by.
        from layoutkit.constraints.expansion import given_sequences

        yield from (unknown := list(self.unknown(facade)))
        for path in () if unknown else self.targets(facade):
            try:
                self.words(facade, path, given_sequences(facade))
            except Faulty as error:
                yield from error.diagnostics

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield nothing: its sequences are checked in its place."""
        return iter(())

    def fault(self, code: str, message: str, hint: str, *details: str) -> Faulty:
        """Return an error at the generator's place."""
        about = Diagnostic(code, message, self.place, hint, topic="reference", details=details)
        return Faulty([about])
