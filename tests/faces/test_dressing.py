"""A design over the faces of a mass: what its constraints come to within faces, and across them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any, ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st
from walls import DESIGN, Wall, building, design, mass, walls

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    Repetition,
    Replication,
    Reuse,
    SameArrangement,
    SameSize,
    Sequence,
    Size,
    Symmetry,
)
from layoutkit.constraints.attributes import PATH, AttributeType, attribute
from layoutkit.constraints.dressing import dressed, dressing_faults, root_symbol
from layoutkit.constraints.pattern import Pattern
from layoutkit.constraints.references import unknown_path
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.model import (
    Block,
    Box,
    Extent,
    Facade,
    Layout,
    Mass,
    Measure,
    RegionSet,
    Violation,
    Word,
    place,
)

S, W, E = RegionSet.parse, Word.parse, Extent.parse

#: Of every kind, with paths, labels, symbols, words, extents and enclosing regions.
FACE_RULES: list[Constraint] = [
    Size(of=S("H/F"), max=Measure(3.0)),
    Size(of=S("@Pier - H/G/*"), max=Measure(1.0)),
    Size(of=S("@Window"), max=Measure(2.0)),
    Frequency(of=S("@Door"), within="H", min=Measure(1.0), max=Measure(1.0)),
    Frequency(of=S("F"), within="H", max=Measure(1.0, relative=True)),
    Frequency(of=S("W | D"), within="H/G", min=Measure(1.0, relative=True)),
    Alignment(first=S("@Window"), second=S("@Door"), lines=("bottom",)),
    Alignment(first=S("@Window"), second=S("@Window"), lines=("top",), within="H"),
    SameSize(first=E("H/F"), second=E("@Floor"), dimension="height"),
    SameSize(first=E("H: F G"), dimension="height"),
    SameArrangement(of=("H/G",)),
    Sequence(within=("H/G",), word=W("⊢ P {W D} P W P D P ⊣")),
    Sequence(within=("H/F",), word=W("⊢ P W P ⊣")),
    Replication(within=("H/G",)),
    Repetition(within=("H/F",), pattern=Pattern.parse("P (W P)+")),
    Instances(of=S("H/F"), max=Measure(1.0)),
    Symmetry(of=("H/G",)),
    Lock(of=S("H/G"), keep=("size",)),
    Lock(of=S("H/G/D"), keep=("place",)),
    Lock(of=S("H/F"), keep=("inside",)),
]


@given(walls(), st.sampled_from(FACE_RULES))
def test_within_faces_a_constraint_holds_for_each_alone(parts: list[Wall], rule: Constraint) -> None:
    facade, layout = building(parts, rule)
    broken = {faces_of(v) for v in own(layout.violations(), facade)}
    alone = [Layout("alone", "m", wall.root, design(rule)) for wall in parts]
    expected = {n for n, one in enumerate(alone, 1) if own(one.violations(), design(rule))}
    assert broken == {frozenset({n}) for n in expected}


def own(violations: tuple[Violation, ...], facade: Facade) -> list[Violation]:
    return [v for v in violations if v.constraint in facade.constraints]


def faces_of(violation: Violation) -> frozenset[int]:
    return frozenset({int(violation.path.split("/")[1].removeprefix("Wall"))})


def across(rule: Constraint, parts: list[Wall]) -> bool:
    """Tell whether walls keep a rule across them all."""
    facade, layout = building(parts, replace(rule, scope="building"))
    return not own(layout.violations(), facade)


def test_generators_are_carried_over_as_what_they_say_of_the_design() -> None:
    like = Reuse(within=S("@Floor - H/G"), like="H/G", symbols=(("D", "W"),))
    given_ = design(Replication(within=("H/G",)), like)
    block = Mass((Block(width=9.0, depth=6.0, height=8.0),))
    found = dressed(given_, block).constraints
    assert all(isinstance(constraint, Sequence) for constraint in found)
    paths = {path for c in found if isinstance(c, Sequence) for path in c.within}
    names = [face.name for face in block.faces]
    assert paths == {f"Building/{name}/{floor}" for name in names for floor in "FG"}


@given(walls())
def test_across_faces_one_door_is_one_in_the_whole_building(parts: list[Wall]) -> None:
    rule = Frequency(of=S("@Door"), within="H", min=Measure(1.0), max=Measure(1.0))
    doors = sum(wall.bays.count("D") for wall in parts)
    assert across(rule, parts) == (doors == 1)
    assert across(replace(rule, within="H/G", of=S("D")), parts) == (doors == 1)
    assert across(replace(rule, within="H/F"), parts) is False  # none of them is upstairs


@given(walls())
def test_across_faces_shares_are_of_all_that_the_design_would_have(parts: list[Wall]) -> None:
    rule = Frequency(of=S("F"), within="H", max=Measure(1.0, relative=True))
    perimeter = sum(wall.root.width for wall in parts)
    allowed = 2 * perimeter / DESIGN.root.width  # two floors in the input's face
    assert across(rule, parts) == (sum(len(wall.storeys) for wall in parts) <= allowed + 1e-6)


@given(walls())
def test_across_faces_sizes_are_equal_all_round(parts: list[Wall]) -> None:
    heights = {height for wall in parts for height in wall.storeys}
    assert across(SameSize(first=E("H/F"), dimension="height"), parts) == (len(heights) == 1)
    inside = SameSize(first=E("@Pier"), dimension="width", within="H/F")
    assert across(inside, parts) == (len({wall.pier for wall in parts}) == 1)
    runs = SameSize(first=E("H: F G"), dimension="height")
    assert across(runs, parts) == (len(heights) == 1)


@given(walls(min_size=2, max_size=3))
def test_across_faces_lines_are_level_at_their_elevations(parts: list[Wall]) -> None:
    rule = Alignment(first=S("@Floor"), second=S("@Floor"), lines=("top", "bottom"))
    spans = [span for wall in parts for span in floors(wall)]
    level = all(a == b for a, b in combinations(spans, 2) if min(a[1], b[1]) > max(a[0], b[0]))
    assert across(rule, parts) == level
    assert across(replace(rule, within="H"), parts) == level


def floors(wall: Wall) -> list[tuple[float, float]]:
    found, at = [(wall.base, wall.base + 3.5)], wall.base + 3.5
    for height in wall.storeys:
        found.append((at, at + height))
        at += height
    return found


@given(walls())
def test_across_faces_words_agree_all_round(parts: list[Wall]) -> None:
    same = len({wall.bays for wall in parts}) == 1
    assert across(SameArrangement(of=("H/G",)), parts) == same


@given(walls())
def test_a_layout_that_is_as_the_mass_asks_breaks_no_rule_of_layouts(parts: list[Wall]) -> None:
    _, layout = building(parts)
    assert not [v for v in layout.violations() if v.constraint is None]
    for placed, box in zip(
        (p for p in place(layout.root) if p.path.count("/") == 1), layout.mass.boxes, strict=True
    ):
        assert placed.box == pytest.approx(box)


@pytest.mark.parametrize("change", [{"width": 9.0}, {"height": 8.0}, {"base": 1.0}])
def test_a_face_of_another_size_is_a_violation(change: dict[str, Any]) -> None:
    _, layout = building([DESIGN, DESIGN])
    for number in (0, 1):
        faces = list(layout.root.children)
        faces[number] = replace(faces[number], **change)
        moved = replace(layout, root=replace(layout.root, children=tuple(faces)))
        found = [v for v in moved.violations() if v.constraint is None]
        assert f"Building/Wall{number + 1}" in {v.path for v in found}


def test_the_copies_have_the_designs_size_and_the_faces_their_own() -> None:
    facade = dressed(design(), Mass((Block(width=20.0, depth=10.0, height=12.0, base=2.0),)))
    assert facade.root.split == "faces"
    assert facade.root.word == ("South", "East", "North", "West")
    assert {(f.width, f.height) for f in facade.root.children} == {(DESIGN.root.width, DESIGN.root.height)}
    assert facade.faces["Building/East"] == Box(20.0, 0.0, 30.0, 12.0)
    assert facade.regions["Building/West/G/D/Door"].depth == -0.25
    assert not design().faces


def test_a_root_called_building_keeps_its_paths_apart() -> None:
    inner = Facade("b", "m", replace(DESIGN.root, symbol="Building"))
    rule = Frequency(of=S("G"), within="Building", max=Measure(1.0), scope="building")
    facade = dressed(replace(inner, constraints=(rule,)), mass([DESIGN, DESIGN]))
    (carried,) = facade.constraints
    assert root_symbol(inner) == "Whole"
    assert str(carried) == (
        'frequency of="Whole/Wall1/G | Whole/Wall2/G" within="Whole" max="1" scope="building"'
    )


@dataclass(frozen=True, kw_only=True)
class Alone(Constraint):
    """A plugin's kind that speaks of one region."""

    kind: ClassVar[str] = "alone"
    summary: ClassVar[str] = "One region is there."
    of: str = attribute(PATH, "The region.")

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        yield from unknown_path(self, self.of, facade)


@dataclass(frozen=True, kw_only=True)
class Opaque(Alone):
    """The same with a type of attribute that nobody else knows."""

    kind: ClassVar[str] = "opaque"
    of: str = attribute(AttributeType("spot", str), "The region.")


@dataclass(frozen=True, kw_only=True)
class Failing(Alone):
    """A kind that cannot live with faces."""

    kind: ClassVar[str] = "failing"

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        if facade.building is not None:
            raise RuntimeError("no faces, please")
        return iter(())


@dataclass(frozen=True, kw_only=True)
class Picky(Alone):
    """A kind that knows what its paths begin with."""

    kind: ClassVar[str] = "picky"

    def __post_init__(self) -> None:
        if not self.of.startswith("H"):
            raise ValueError("no such path")


PLACE = Place("h.xml", 7, 3)


@pytest.mark.parametrize(
    ("rule", "code", "severity"),
    [
        (Alone(of="H/G", scope="building", place=PLACE), "LK804", Severity.WARNING),
        (Opaque(of="H/G", place=PLACE), "LK805", Severity.ERROR),
        (Failing(of="H/G", place=PLACE), "LK407", Severity.ERROR),
        (Picky(of="H/G", place=PLACE), "LK407", Severity.ERROR),
    ],
    ids=lambda value: getattr(value, "kind", value),
)
def test_what_cannot_be_carried_over_is_said(rule: Constraint, code: str, severity: Severity) -> None:
    model = mass([DESIGN, DESIGN])
    (found,) = dressing_faults(design(rule), model)
    assert (found.code, found.severity, found.place) == (code, severity, PLACE)


@pytest.mark.parametrize("scope", ["face", "building"])
def test_built_in_kinds_are_carried_without_a_word(scope: str) -> None:
    rules = (*(replace(rule, scope=scope) for rule in FACE_RULES), Alone(of="H/G"))
    assert not list(dressing_faults(design(*rules), mass([DESIGN, DESIGN])))
