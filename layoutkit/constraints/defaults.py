"""What holds where no hard constraint says otherwise: default sizes, the input's words."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence as ListOf
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.claims import permitted, sized, varying
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.expansion import expanded
from layoutkit.constraints.instances import Instances
from layoutkit.constraints.size import Size, axis_of
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, Exactly, WordRule
from layoutkit.model import Facade, Measure, Region, RegionSet, Violation
from layoutkit.sizing.arrangement import AXIS

if TYPE_CHECKING:
    from typing import Self

#: A region without a size constraint keeps to these shares of its input size (Bao et al. 2013, section 5.1:
#: "bounds at a fixed fraction from the center").
_UNDIVIDED = Size(
    of=RegionSet("default"),
    min=Measure(0.5, relative=True),
    max=Measure(2.0, relative=True),
    deviation=Measure(0.1, relative=True),
    comment="default size",
)
#: If something inside divides it, its size comes from there; but not every word need have that inside. If a
#: soft constraint speaks of its size, the default takes its side: it does not forbid what that one asks for.
_FREE = Size(of=RegionSet("default"), deviation=Measure(1.0, relative=True), comment="default size")


@dataclass(frozen=True, kw_only=True)
class InputWord(Constraint):
    """A region that no sequence speaks of keeps the input's word (Bao et al. 2013, section 5.2, replication).

    No document says so: it holds by default.
    """

    kind: ClassVar[str] = "input-word"
    summary: ClassVar[str] = "A region without sequences keeps the input's arrangement."

    path: str

    def __str__(self) -> str:
        return f"{self.path} has no sequence: it keeps the input's arrangement"

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield the one word of each region."""
        for constraint in constraints:
            word = Exactly(facade.regions[constraint.path].word)
            yield Admits(constraint.path, word, (constraint,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every region with another word."""
        for placed in view.places(self.path):
            if placed.region.word != view.facade.regions[self.path].word:
                word = " ".join(placed.region.word)
                yield Violation(
                    self, placed.path, f"has no sequence, and yet another arrangement: {word!r}", 1.0
                )


def default_sizes(facade: Facade) -> tuple[Size, ...]:
    """Return a size constraint for every region that has no hard one.

    One that nothing inside divides keeps between half and twice its input size: such are all terminals, and a
    bay of rows in a floor of columns. A floor's height, on the other hand, comes from what is inside: it is
    only drawn weakly to its input size. A building's faces have the sizes that its mass gives them.
    """
    hard, soft = set[str](), set[str]()
    for constraint in facade.constraints:
        (soft if constraint.soft else hard).update(claim.path for claim in sized(constraint, facade))

    def default(path: str, region: Region) -> Size:
        return _FREE if path in soft or divided(region, axis_of(facade, path)) else _UNDIVIDED

    return tuple(
        replace(default(path, region), of=RegionSet(path))
        for path, region in facade.regions.items()
        if "/" in path and path not in hard and path not in facade.faces
    )


def divided(region: Region, axis: int) -> bool:
    """Tell whether some region inside is split along the axis."""
    if region.split is None:
        return False
    return AXIS[region.split] == axis or any(divided(child, axis) for child in region.children)


def default_words(facade: Facade) -> tuple[InputWord, ...]:
    """Return what keeps the words of the composite regions that no sequence speaks of."""
    # A permission that may be taken back does not free an arrangement: nothing would hold without it.
    hard = (constraint for constraint in expanded(facade) if not constraint.soft)
    spoken = {path for constraint in hard for path in permitted(constraint, facade)}
    return tuple(
        InputWord(path=path) for path, region in facade.regions.items() if region.split and path not in spoken
    )


def default_instances(facade: Facade) -> tuple[Instances, ...]:
    """Return the permission to vary each region of whose instances only soft constraints speak.

    A range that cannot be kept does not turn the region's occurrences into replicas.
    """
    hard = {path for c in facade.constraints if not c.soft for path in varying(c, facade)}
    soft = dict.fromkeys(path for c in facade.constraints if c.soft for path in varying(c, facade))
    return tuple(Instances(of=RegionSet(path)) for path in soft if path not in hard)


def effective_constraints(facade: Facade) -> tuple[Constraint, ...]:
    """Return the facade's constraints, hard and soft, and those that hold by default, which are hard.

    Generators are replaced by their sequences.
    """
    return (
        *expanded(facade),
        *default_sizes(facade),
        *default_words(facade),
        *default_instances(facade),
    )
