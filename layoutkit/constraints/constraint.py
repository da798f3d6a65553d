"""What a constraint is: the one interface that built-in kinds and plugins share.

A kind is a frozen dataclass. Its attributes are declared with `attribute`; parsing, writing, the schema and
the reference follow from the declaration. What it means is said four times, for four readers: `faults`
(the document), `word_rules` (the search), `size_rules` (sizing) and `violations` (the checker, which must
not rely on the other two).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import Attribute, attributes_of
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.model import Facade, Violation

if TYPE_CHECKING:
    from typing import Self

    from layoutkit.constraints.view import LayoutView
    from layoutkit.constraints.word_rules import WordRule
    from layoutkit.sizing.arrangement import Arrangement
    from layoutkit.sizing.rules import SizeRule


@dataclass(frozen=True, kw_only=True)
class Constraint:
    """Something that every variation of a facade must keep.

    Attributes
    ----------
    kind
        The name of its element in documents.
    summary
        What it demands, in one sentence, for the reference and the schema.
    place
        Where in its document it stands.
    comment
        Why it is there; written above it.
    """

    kind: ClassVar[str]
    summary: ClassVar[str]

    place: Place | None = field(default=None, compare=False, repr=False)
    comment: str = field(default="", compare=False, repr=False)

    @classmethod
    def attributes(cls) -> tuple[Attribute, ...]:
        """Return the declared attributes, in order."""
        return attributes_of(cls)

    def __str__(self) -> str:
        values = ((a.name, getattr(self, a.field_name), a) for a in self.attributes())
        shown = [f'{name}="{a.type.text(value)}"' for name, value, a in values if value != a.default]
        return " ".join([self.kind, *shown])

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield what is wrong with the constraint itself, given the regions it speaks of."""
        return iter(())

    @classmethod
    def word_rules(cls, constraints: Sequence[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield the rules that all constraints of this kind together put on arrangements."""
        return iter(())

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield, for each axis, the symbol paths whose sizes or places the constraint ties to each other.

        The search looks for dead ends there as soon as the words are chosen; what is not said is found at the
        end.
        """
        return iter(())

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the rules that the constraint puts on sizes, once the words are chosen."""
        return iter(())

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every way in which a layout breaks the constraint."""
        raise NotImplementedError(f"the constraint kind {self.kind!r} does not say how it is checked")
