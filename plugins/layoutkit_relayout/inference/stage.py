"""The stage that adds inferred constraints to a facade."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.constraints import Constraint
from layoutkit.constraints.view import LayoutView
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Facade, Layout
from layoutkit_relayout.inference.bays import bays
from layoutkit_relayout.inference.doors import doors
from layoutkit_relayout.inference.freedom import LEVELS, Freedom, Level
from layoutkit_relayout.inference.lines import lines
from layoutkit_relayout.inference.sizes import sizes
from layoutkit_relayout.inference.storeys import storeys


@dataclass(frozen=True)
class InferOptions:
    """Options of the infer stage.

    Attributes
    ----------
    freedom
        How much the constraints leave open.
    """

    freedom: Level = "medium"


class Infer(Stage):
    """Reads constraints off a segmentation."""

    name: ClassVar[str] = "infer"
    summary: ClassVar[str] = "Adds constraints read off the segmentation, each with a comment of why."
    options: ClassVar[type] = InferOptions

    def run(self, facade: Facade, options: InferOptions) -> Iterator[Outcome]:
        """Yield the facade with its own constraints and the inferred ones."""
        start = time.perf_counter()
        found = inferred(facade, LEVELS[options.freedom])
        document = replace(facade, constraints=(*facade.constraints, *found))
        yield Outcome("found", document, seconds=time.perf_counter() - start)


def inferred(facade: Facade, freedom: Freedom) -> tuple[Constraint, ...]:
    """Return constraints that the input itself keeps.

    An alignment is read off one bay of each kind; where a second occurrence stands otherwise, it is left out.
    """
    input_view = LayoutView(Layout(facade.name, facade.units, facade.root), facade)
    return (
        *sizes(facade, freedom),
        *storeys(facade, freedom),
        *bays(facade, freedom),
        *doors(facade),
        *(line for line in lines(facade, freedom) if not any(line.violations(input_view))),
    )
