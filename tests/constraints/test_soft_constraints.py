"""Soft constraints: kept where they can be, and no fault of a layout where they are not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from houses import floor, house, laid_out, with_rows

from layoutkit.constraints import BUILT_IN, Constraint, Sequence, Size
from layoutkit.constraints.checking import checked
from layoutkit.constraints.defaults import default_sizes
from layoutkit.constraints.generator import Generator
from layoutkit.diagnostics import Severity
from layoutkit.documents import check, facade_bytes, layout_bytes, read, save
from layoutkit.model import Facade, Measure, Region, RegionSet, Word

KINDS: Mapping[str, type[Constraint]] = {kind.kind: kind for kind in BUILT_IN}
CORNICE = Region("C", 7.0, 0.5, labels=("Cornice",))
PIERS = Size(of=RegionSet.parse("@Pier"), max=Measure(0.9))


def test_every_kind_may_be_soft_but_permissions() -> None:
    for kind in BUILT_IN:
        *_, declared = (a for a in kind.attributes()[-2:] if a.name == "weight")
        permission = declared.default == 1.0
        assert permission is issubclass(kind, Sequence | Generator)
        assert (kind.soft is Constraint.soft) is not permission


def test_a_soft_constraint_is_no_fault() -> None:
    soft = replace(PIERS, weight=3.0)
    facade = house(soft)
    assert PIERS in [v.constraint for v in laid_out(house(PIERS), house(PIERS).root).violations()]
    layout = laid_out(facade, facade.root)
    assert layout.violations() == ()
    missed = checked(layout, facade).unkept
    assert {v.constraint for v in missed} == {soft}
    assert {round(v.amount, 9) for v in missed} == {0.1}
    assert len(missed) == 9


def test_kept_soft_constraints_are_not_mentioned() -> None:
    facade = house(replace(PIERS, max=Measure(1.1), weight=1.0), replace(PIERS, max=Measure(0.5), weight=2.0))
    missed = checked(laid_out(facade, facade.root), facade).unkept
    assert {v.constraint for v in missed} == {facade.constraints[1]}


def test_a_sequence_is_never_soft() -> None:
    """Its weight says how likely it is."""
    likely = Sequence(within=("H/F",), word=Word.parse("⊢ P P ⊣"), weight=5.0)
    assert not likely.soft
    facade = house(likely)
    assert likely in [v.constraint for v in laid_out(facade, facade.root).violations()]


@pytest.mark.parametrize("text", ["0", "-1", "nan", "inf", "1e999", "heavy", "", "50%"])
def test_weights_are_above_0(text: str, tmp_path: Path) -> None:
    save(
        tmp_path / "house.xml", facade_bytes(house(PIERS)).replace(b'max="0.9"', f'weight="{text}"'.encode())
    )
    (fault,) = check(tmp_path / "house.xml", KINDS)
    assert fault.code == "LK105"
    assert "weight" in fault.message


def test_weights_are_read_and_written(tmp_path: Path) -> None:
    facade = house(
        replace(PIERS, weight=0.25), PIERS, Sequence(within=("H/F",), word=Word.parse("P"), weight=3.0)
    )
    data = facade_bytes(facade)
    assert b'max="0.9" weight="0.25"/>' in data
    assert b'word="P" weight="3"/>' in data
    save(tmp_path / "house.xml", data)
    again = read(tmp_path / "house.xml", KINDS).model
    assert isinstance(again, Facade)
    assert again.constraints == facade.constraints


def test_validate_remarks_on_what_is_not_kept(tmp_path: Path) -> None:
    facade = house(replace(PIERS, weight=1.0))
    layout = replace(laid_out(facade, facade.root), facade_file="facade.xml")
    save(tmp_path / "facade.xml", facade_bytes(facade))
    save(tmp_path / "layout.xml", layout_bytes(layout))
    remarks = check(tmp_path / "layout.xml", KINDS)
    assert {(d.code, d.severity) for d in remarks} == {("LK506", Severity.NOTE)}
    assert remarks[0].message == "H/F/P: is 1, not between 0.001 and 0.9"
    assert remarks[0].details[0].startswith('size of="@Pier" max="0.9" weight="1"')
    assert remarks[0].details[1] == "off by 0.1"
    assert remarks[0].place is not None
    assert remarks[0].place.line > 1


def test_a_soft_size_takes_the_place_of_the_default_range() -> None:
    """Asked to be three times as wide if it can, a pier is not held to twice; nor without that wish."""
    soft = Size(of=RegionSet("H/F/P"), min=Measure(3.0), weight=1.0)
    facade = house(soft)
    (default,) = [c for c in default_sizes(facade) if str(c.of) == "H/F/P"]
    assert not default.soft
    assert default.bounds(facade, "H/F/P") == (0.001, float("inf"))
    wide = floor("F", "PBPBP", widths={"P": 3.0}), floor("G", "PBPBP", 3.5, {"P": 2.0, "B": 3.5})
    root = with_rows(facade, replace(CORNICE, width=13.0), wide[0], wide[1])
    freed = replace(facade, constraints=(soft, *(Sequence(within=("H",), word=Word.parse("⊢ C F G ⊣")),)))
    assert laid_out(freed, root).violations() == ()
    assert checked(laid_out(freed, root), freed).unkept == ()
    both = house(soft, Size(of=RegionSet("H/F/P"), max=Measure(4.0)))
    assert [c for c in default_sizes(both) if str(c.of) == "H/F/P"] == []
