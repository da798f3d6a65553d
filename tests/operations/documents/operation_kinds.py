"""Kinds of operations for tests of documents, built in and of another's namespace; files that they name."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints import BUILT_IN
from layoutkit.constraints.attributes import attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.diagnostics import Diagnostic
from layoutkit.documents.grammar import AMOUNT, ANSWER, LABELS, NUMBER, SIZE, TEXT
from layoutkit.model import PlacementModel
from layoutkit.operations import Context, Design, Operation, Result, Site, Steps
from layoutkit.operations.attributes import COLOUR, DESIGN, STEPS, Colour, held
from layoutkit.operations.operation import Scope

ACME = Namespace("acme", "urn:acme:operations")


@dataclass(frozen=True, kw_only=True)
class Still(Operation):
    """An operation that does nothing."""

    kind: ClassVar[str] = "still"
    summary: ClassVar[str] = "Does nothing."

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        return Result(site, scope)


@dataclass(frozen=True, kw_only=True)
class Grow(Still):
    """An operation with attributes of many types, that names files and holds a model."""

    kind: ClassVar[str] = "grow"
    summary: ClassVar[str] = "Makes things larger."

    amount: float = attribute(SIZE, "By how much.")
    labels: tuple[str, ...] = attribute(LABELS, "What.", ())
    random: float = attribute(AMOUNT, "How much the amount varies.", 0.5)
    wide_too: bool = attribute(ANSWER, "Whether in width, too.", False)
    colour: Colour | None = attribute(COLOUR, "What it becomes.", None)
    facade: Design | None = attribute(DESIGN, "What it looks like.", None)
    session: Steps | None = attribute(STEPS, "How that is edited.", None)
    model: PlacementModel | None = held("placement-model", "Where it grows.")

    def faults(self) -> Iterator[Diagnostic]:
        if self.amount == 13:
            yield Diagnostic("LK882", "the amount is 13", hint="choose another")
        if self.amount == 666:
            raise RuntimeError("too much")


@dataclass(frozen=True, kw_only=True)
class Bend(Still):
    """An operation of another package."""

    kind: ClassVar[str] = "bend"
    namespace: ClassVar[Namespace] = ACME
    summary: ClassVar[str] = "Bends things."

    angle: float = attribute(NUMBER, "By how much.", 0.0)
    note: str = attribute(TEXT, "Anything.", "")
    model: PlacementModel | None = held("placement-model", "Where it bends.")

    def __post_init__(self) -> None:
        if self.angle > 90:
            raise ValueError("angle is more than 90")


KINDS = {kind.qualified_name(): kind for kind in (Still, Grow, Bend)}
CONSTRAINTS = {kind.kind: kind for kind in BUILT_IN}

FACADE = (
    '<facade xmlns="urn:layoutkit:1" name="wall" units="m">'
    '{}<region symbol="W" width="2" height="1" split="columns">'
    '<region symbol="A" width="1" labels="Window"/><again symbol="A"/></region>'
    '<grids><grid name="panes" of="W/A"/></grids></facade>'
)
PICTURE = '<picture file="photos/wall.jpg" left="0" top="0" right="20" bottom="10"/>'
SESSION = (
    '<session xmlns="urn:layoutkit:1" name="edits" facade="wall.xml" done="1">'
    '<edit action="remove" axis="columns" grids="panes" source="2"/>'
    '<edit action="remove" axis="columns" grids="panes" source="1"/></session>'
)
LAYOUT = (
    '<layout xmlns="urn:layoutkit:1" name="l" units="m"><region symbol="W" width="2" height="1"/></layout>'
)
#: What operations in the tests may name.
FILES = {
    "walls/wall.xml": FACADE.format(PICTURE).encode(),
    "walls/photos/wall.jpg": b"not looked into",
    "walls/edits.xml": SESSION.encode(),
    "plain.xml": FACADE.format("").encode(),
    "layout.xml": LAYOUT.encode(),
    "faulty.xml": FACADE.format("").replace('width="2"', 'width="3"').encode(),
    "unpictured.xml": FACADE.format(PICTURE).encode(),
}
MODEL = (
    '<placement-model name="sills" units="m" label="Sill">'
    '<example><placement x="0" y="0" width="2" height="1" label="Sill"/>'
    '<polygon points="0,0 1,0 1,1" labels="Window"/></example></placement-model>'
)
