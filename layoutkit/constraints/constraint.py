"""What a constraint is: the one interface that built-in kinds and plugins share.

A kind is a frozen dataclass. Its attributes are declared with `attribute`; parsing, writing, the schema and
the reference follow from the declaration. What it means is said four times, for four readers: `faults`
(the document), `word_rules` (the search), `size_rules` (sizing) and `violations` (the checker, which must
not rely on the other two). The rest is optional: `ties` and `claims` let the search see more ahead,
`relations` lets counts be exact, `parts`, `altered` and `idle` let explanations say more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, ClassVar

from layoutkit.constraints.attributes import WEIGHT, Attribute, attribute, attributes_of, choice
from layoutkit.constraints.namespace import CORE, Namespace
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.model import Facade, Violation

if TYPE_CHECKING:
    from typing import Self

    from layoutkit.constraints.claims import Claim, Relates
    from layoutkit.constraints.view import LayoutView
    from layoutkit.constraints.word_rules import WordRule
    from layoutkit.sizing.arrangement import Arrangement
    from layoutkit.sizing.rules import SizeRule


@dataclass(frozen=True, kw_only=True)
class Constraint:
    """Something that every variation of a facade keeps: must keep, where it is hard.

    Attributes
    ----------
    kind
        The name of its element in documents.
    namespace
        Whose element it is: one of the package's own, except for what is built in.
    summary
        What it demands, in one sentence, for the reference and the schema.
    place
        Where in its document it stands.
    scope
        On a building: whether it holds within each face, or across all (Bao et al. 2013, section 9.1).
    weight
        None for a hard constraint. A soft one is kept unless it cannot be kept together with the hard ones
        and with the soft ones of greater weight; of those that weigh alike, earlier ones in the document go
        first.
    comment
        Why it is there; written above it.
    """

    kind: ClassVar[str]
    namespace: ClassVar[Namespace] = CORE
    summary: ClassVar[str]

    scope: str = attribute(
        choice("scope", "face", "building"),
        "On a building with several faces: whether it holds within each face, or across all of them.",
        "face",
    )
    weight: float | None = attribute(
        WEIGHT,
        "Left out, the constraint is hard. A soft one is kept unless it cannot be kept together with the "
        "hard ones and with the soft ones of greater weight (ties: document order).",
        None,
    )
    place: Place | None = field(default=None, compare=False, repr=False)
    comment: str = field(default="", compare=False, repr=False)

    @classmethod
    def qualified_name(cls) -> str:
        """Return what users call the kind: the name of its element, with the prefix of its namespace."""
        return cls.namespace.named(cls.kind)

    @classmethod
    def attributes(cls) -> tuple[Attribute, ...]:
        """Return the declared attributes, in order; those that all kinds have come last."""
        shared = {a.field_name for a in attributes_of(Constraint)}
        return tuple(sorted(attributes_of(cls), key=lambda a: a.field_name in shared))

    @property
    def soft(self) -> bool:
        """Whether a variation may break it where it cannot be kept."""
        return self.weight is not None

    def __str__(self) -> str:
        values = ((a.name, getattr(self, a.field_name), a) for a in self.attributes())
        shown = [f'{name}="{a.type.text(value)}"' for name, value, a in values if value != a.default]
        return " ".join([self.qualified_name(), *shown])

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

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield what the constraint says of itself before words are chosen, so that more can be made of it.

        All of it follows from its rules. What is not claimed is found out later, or not told apart.
        """
        return iter(())

    def relations(self, facade: Facade) -> Iterable[Relates] | None:
        """Return what the constraint's rules on sizes relate, so that arrangements can be counted exactly.

        Returns
        -------
        iterable or None
            Nothing, if each rule is about one region's own size; None where that is not known, or some rule
            is convex, or relates widths to heights: everything is then taken to be related to everything.
        """
        return None if type(self).size_rules is not Constraint.size_rules else ()

    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        """Return the constraint region by region, where it demands of each by itself what it demands of all.

        Returns
        -------
        mapping
            By a region's path, the constraint on that region alone; empty where it cannot be divided.
        """
        return {}

    def altered(self, **values: Any) -> Self:
        """Return the constraint with other values of some attributes, and what else these make necessary."""
        return replace(self, **values)

    @property
    def idle(self) -> bool:
        """Whether it demands nothing as it stands, and only says how variations begin."""
        return False

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every way in which a layout breaks the constraint."""
        raise NotImplementedError(
            f"the constraint kind {self.qualified_name()!r} does not say how it is checked"
        )
