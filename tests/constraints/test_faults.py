"""Faults of constraints themselves: each names what is wrong, where, and the nearest that is right."""

from __future__ import annotations

import pytest
from houses import floor, house, stacked

from layoutkit.constraints import (
    BUILT_IN,
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    SameArrangement,
    SameSize,
    Sequence,
    Size,
    Symmetry,
)
from layoutkit.constraints.generator import Generator
from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.model import Extent, Facade, Measure, RegionSet, Word

HERE = Place("house.xml", 12, 3)


def faults(constraint: Constraint, facade: Facade | None = None) -> list[Diagnostic]:
    return list(constraint.faults(facade or house()))


def regions(text: str) -> RegionSet:
    return RegionSet.parse(text)


SOUND: list[Constraint] = [
    Size(of=regions("@Window | H/F"), min=Measure(0.5, True), max=Measure(4.0)),
    Size(of=regions("H/C")),
    Size(of=regions("H/C"), min=Measure(0.2), max=Measure(1.0), distribution="triangular", bias=0.5),
    Size(of=regions("H/C"), min=Measure(0.2), max=Measure(1.0), distribution="uniform", weight=2.0),
    Size(of=regions("H/C"), min=Measure(0.2), bias=-1.0),
    Sequence(within=("H/F", "H/G"), word=Word.parse("⊢ P {B @Window} ⊣")),
    Frequency(of=regions("B | @Pier"), within="H/F", min=Measure(1.0), max=Measure(1.2, True)),
    Frequency(of=regions("@Window"), within="H", min=Measure(3.0), max=Measure(0.5, True)),
    Alignment(first=regions("H/F/B"), second=regions("@Window"), lines=("left", "right"), within="H"),
    Alignment(first=regions("H/F"), second=regions("H/G"), lines=("top",)),
    SameSize(first=Extent.parse("H/F: P B"), second=Extent.parse("@Pier"), dimension="width", within="H/F"),
    SameSize(first=Extent.parse("H/F"), dimension="height"),
    Alignment(
        first=regions("H/F/B"),
        second=regions("@Bay"),
        lines=("center",),
        first_before=Word.context("⊢ @Pier"),
        first_after=Word.context("P B P ⊣"),
        second_before=Word.context("{P B}"),
    ),
    SameSize(
        first=Extent.parse("H/F: B"),
        second=Extent.parse("H/F/P"),
        dimension="width",
        first_before=Word.context("⊢ P"),
        second_after=Word.context("⊣"),
    ),
    Instances(of=regions("H/F"), min=Measure(1.0), max=Measure(0.5, True)),
    Instances(of=regions("@Bay"), weight=0.5),
    Symmetry(of=("H/F", "H/G")),
    Symmetry(of=("H/F",), pairs=(("P", "B"),)),
    Lock(of=regions("H/F/P | @Bay"), keep=("place", "size"), anchor=("right", "middle")),
    Lock(of=regions("H/F | @Bay"), keep=("inside",)),
    SameArrangement(of=("H/F", "H/G")),
]


@pytest.mark.parametrize("constraint", SOUND, ids=str)
def test_sound_constraints_have_no_faults(constraint: Constraint) -> None:
    assert faults(constraint) == []


UNKNOWN: list[tuple[Constraint, str, str]] = [
    (Size(of=regions("@Windo"), place=HERE), "'Windo'", "did you mean 'Window'?"),
    (Size(of=regions("H/F/BB | H/G/Q"), place=HERE), "'H/F/BB'", "did you mean"),
    (Sequence(within=("H/FF",), word=Word.parse("P"), place=HERE), "'H/FF'", "did you mean 'H/F'?"),
    (Sequence(within=("H/F",), word=Word.parse("P @Bays"), place=HERE), "'@Bays'", "did you mean '@Bay'?"),
    (Frequency(of=regions("@Windows"), within="H/F", place=HERE), "'Windows'", "did you mean 'Window'?"),
    (Frequency(of=regions("X"), within="H/F", place=HERE), "'X'", "known are: B, P"),
    (Frequency(of=regions("B"), within="H/H", place=HERE), "'H/H'", "did you mean"),
    (Alignment(first=regions("H/F/Bay"), second=regions("@Bay"), lines=("left",), place=HERE), "'H/F/Bay'",
     "did you mean 'H/F/B'?"),
    (Alignment(first=regions("@Bay"), second=regions("@Bay"), lines=("left",), within="H/f", place=HERE),
     "'H/f'", "did you mean 'H/"),
    (SameSize(first=Extent.parse("@Peer"), dimension="width", place=HERE), "'Peer'", "did you mean 'Pier'?"),
    (SameSize(first=Extent.parse("H/F: P X"), dimension="width", place=HERE), "'X'", "known are:"),
    (SameSize(first=Extent.parse("H/F"), dimension="width", within="H/K", place=HERE), "'H/K'",
     "did you mean"),
    (SameArrangement(of=("H/F", "H/GG"), place=HERE), "'H/GG'", "did you mean 'H/G'?"),
    (Alignment(first=regions("@Bay"), second=regions("@Bay"), lines=("left",), second_after=Word.context("Q"),
               place=HERE), "'Q'", "known are: @Bay"),
    (SameSize(first=Extent.parse("H/F: P"), dimension="width", first_before=Word.context("⊢ @Bai"),
              place=HERE), "'@Bai'", "did you mean '@Bay'?"),
    (Instances(of=regions("@Flor"), place=HERE), "'Flor'", "did you mean 'Floor'?"),
    (Symmetry(of=("H/E",), place=HERE), "'H/E'", "did you mean"),
    (Symmetry(of=("H/F",), pairs=(("P", "Q"),), place=HERE), "'Q'", "known are: B, P"),
    (Lock(of=regions("H/F/B | H/f"), keep=("size",), place=HERE), "'H/f'", "did you mean"),
]  # fmt: skip


@pytest.mark.parametrize(("constraint", "name", "hint"), UNKNOWN, ids=[str(c) for c, _, _ in UNKNOWN])
def test_unknown_names_suggest_the_nearest(constraint: Constraint, name: str, hint: str) -> None:
    first = faults(constraint)[0]
    assert first.code == "LK201"
    assert name in first.message
    assert hint in first.hint
    assert first.place == HERE


def test_every_unknown_name_is_reported() -> None:
    assert len(faults(Size(of=regions("@Dor | @Windo - H/X")))) == 3
    both = Alignment(first=regions("@X"), second=regions("@Y"), lines=("left",), within="Z")
    assert len(faults(both)) == 3


MEANINGLESS: list[tuple[Constraint, str, str]] = [
    (Size(of=regions("H/F/B"), min=Measure(3.0), max=Measure(2.0), place=HERE), "LK202", "3 > 2"),
    (Size(of=regions("H/F"), min=Measure(1.2, True), max=Measure(3.5), place=HERE), "LK202", "H/F"),
    (Frequency(of=regions("B"), within="H/F", min=Measure(3.0), max=Measure(2.0), place=HERE),
     "LK202", "3 > 2"),
    (Frequency(of=regions("B"), within="H/F", min=Measure(2.0, True), max=Measure(1.5, True), place=HERE),
     "LK202", "200% > 150%"),
    (Sequence(within=("H/C",), word=Word.parse("P"), place=HERE), "LK205", "H/C"),
    (Frequency(of=regions("@Pier"), within="H/F/P", place=HERE), "LK205", "H/F/P"),
    (SameArrangement(of=("H/F", "H/C"), place=HERE), "LK205", "H/C"),
    (Alignment(first=regions("@Bay"), second=regions("@Bay"), lines=("left", "top"), place=HERE), "LK206",
     "left top"),
    (SameSize(first=Extent.parse("H/F: P B"), dimension="height", place=HERE), "LK207", "H/F"),
    (Size(of=regions("H/C"), distribution="uniform", max=Measure(1.0), place=HERE), "LK214",
     "runs from min to max, and min is not given"),
    (Size(of=regions("H/C"), distribution="triangular", place=HERE), "LK214", "min and max is not given"),
    (Size(of=regions("H/C"), bias=0.5, min=Measure(0.1), place=HERE), "LK214", "max is not given"),
    (Size(of=regions("H/C"), bias=-0.5, max=Measure(1.0), place=HERE), "LK214", "min is not given"),
    (Size(of=regions("H/C"), bias=1.0, distribution="uniform", min=Measure(0.1), max=Measure(1.0),
          place=HERE), "LK214", "no centre"),
    (Alignment(first=regions("@Bay"), second=regions("@Bay"), lines=("left",),
               first_before=Word.context("P ⊣"), place=HERE), "LK215", "P ⊣"),
    (Alignment(first=regions("@Bay"), second=regions("@Bay"), lines=("left",), first_after=Word.context("⊢"),
               place=HERE), "LK215", "⊢"),
    (SameSize(first=Extent.parse("H/F/B"), dimension="width", second_before=Word.context("P"), place=HERE),
     "LK215", "no second"),
    (Instances(of=regions("H"), place=HERE), "LK216", "H"),
    (Instances(of=regions("H/F"), min=Measure(3.0), max=Measure(2.0), place=HERE), "LK202", "3 > 2"),
    (Instances(of=regions("H/F"), max=Measure(0.0), place=HERE), "LK202", "is 0"),
    (Symmetry(of=("H/C",), place=HERE), "LK205", "H/C"),
    (Symmetry(of=("H/F",), pairs=(("P", "B"), ("B", "P")), place=HERE), "LK217", "stands in the pairs"),
    (Symmetry(of=("H/F",), pairs=(("P", "P"),), place=HERE), "LK217", "P"),
    (Lock(of=regions("H/F/P"), keep=("inside",), place=HERE), "LK205", "H/F/P"),
    (Lock(of=regions("H/F"), keep=("place",), anchor=("left", "right"), place=HERE), "LK218", "left right"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("constraint", "code", "shown"), MEANINGLESS, ids=[str(c) for c, _, _ in MEANINGLESS]
)
def test_what_can_mean_nothing(constraint: Constraint, code: str, shown: str) -> None:
    fault, *others = faults(constraint)
    assert {other.code for other in others} <= {code}, "one fault, of two symbols at most"
    assert (fault.code, fault.place) == (code, HERE)
    assert shown in fault.message
    assert fault.hint


def test_regions_of_other_symbols_have_no_common_arrangement() -> None:
    root = stacked(floor("F", "PBPBP"), floor("G", "PDPBP", widths={"D": 2.0}))
    (fault,) = faults(SameArrangement(of=("H/F", "H/G"), place=HERE), Facade("f", "m", root))
    assert (fault.code, fault.place) == ("LK208", HERE)
    assert "D" in fault.message


def test_every_kind_is_tried_here() -> None:
    tried = {type(c) for c, *_ in (*UNKNOWN, *MEANINGLESS)}
    kinds = {kind for kind in BUILT_IN if not issubclass(kind, Generator)}  # those are tried by themselves
    assert tried == kinds
    assert {type(c) for c in SOUND} == kinds


@pytest.mark.parametrize("constraint", SOUND, ids=str)
def test_constraints_read_like_documents(constraint: Constraint) -> None:
    """Their text names the kind, and the attributes that are not at their defaults."""
    text = str(constraint)
    assert text.startswith(f"{constraint.kind} ")
    for declared in constraint.attributes():
        value = getattr(constraint, declared.field_name)
        shown = f'{declared.name}="'
        assert (shown in text) is (value != declared.default or declared.required)
        if value is not None:
            assert declared.type.parse(declared.type.text(value)) == value
