"""Instances: regions of one symbol that differ, and how many different ones a parent may have."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from houses import broken, floor, house, laid_out, with_rows
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint, Instances, Sequence
from layoutkit.constraints.checking import checked
from layoutkit.constraints.defaults import effective_constraints
from layoutkit.constraints.instances import original
from layoutkit.constraints.word_rules import Bound, Variants
from layoutkit.documents import check, facade_bytes, layout_bytes, read, save
from layoutkit.model import Layout, Measure, Region, RegionSet, Word

CORNICE = Region("C", 7.0, 0.5, labels=("Cornice",))
FREE = [Sequence(within=("H/F",), word=Word.parse(text)) for text in ("⊢ P", "{P B} {P B}", "P ⊣")]
FREE += [Sequence(within=("H",), word=Word.parse(text)) for text in ("⊢ C F", "F F", "F G ⊣")]
GROUND = floor("G", "PBPBP", 3.5)
ONE, OTHER = floor("F", "PBPBP"), floor("F", "PBBPP")
HIGHER, NARROW = floor("F", "PBPBP", 3.5), floor("F", "PBPBP", widths={"P": 1.5, "B": 1.25})


def instances(least: Measure | None = None, most: Measure | None = None, **others: float) -> Instances:
    return Instances(of=RegionSet("H/F"), min=least, max=most, **others)


def messages(*floors: Region, given_: tuple[Constraint, ...] = ()) -> list[tuple[str, str]]:
    """Return what is wrong with a house of these floors F over its ground floor."""
    facade = house(*given_, *FREE)
    found = laid_out(facade, with_rows(facade, CORNICE, *floors, GROUND)).violations()
    return [(v.path, v.message) for v in found]


@pytest.mark.parametrize("second", [OTHER, HIGHER, NARROW], ids=["word", "height", "inside"])
def test_floors_of_one_symbol_are_replicas_unless_they_may_vary(second: Region) -> None:
    assert messages(ONE, second) == [("H/F.2", "is no replica of the first H/F")]
    assert messages(ONE, second, ONE, given_=(instances(),)) == []


def test_what_is_inside_an_instance_is_replicated_in_it() -> None:
    """Floors may differ; the piers of each floor are alike."""
    odd = replace(
        ONE, children=(*ONE.children[:-2], replace(ONE.children[-2], width=2.5), Region("P", 0.5, 3.0))
    )
    found = messages(ONE, odd, given_=(instances(),))
    assert [path for path, message in found if "replica" in message] == ["H/F.2/B.2", "H/F.2/P.3"]
    freed = (instances(), Instances(of=RegionSet.parse("H/F/B | H/F/P")))
    odd = replace(
        odd, children=tuple(replace(c, labels=ONE.children[i].labels) for i, c in enumerate(odd.children))
    )
    assert messages(ONE, odd, given_=freed) == []


def test_replicas_of_a_parent_hold_the_same_instances() -> None:
    """Bays within a floor may vary, but both floors F do so alike."""
    bays = Instances(of=RegionSet("H/F/B"))

    def varied(first: float, second: float) -> Region:
        sizes = (1.0, first, 1.0, second, 1.0)
        parts = zip(ONE.children, sizes, strict=True)
        return replace(ONE, children=tuple(replace(child, width=width) for child, width in parts))

    assert messages(varied(1.5, 2.5), varied(1.5, 2.5), given_=(bays,)) == []
    assert messages(varied(1.5, 2.5), varied(2.5, 1.5), given_=(bays,)) == [
        ("H/F.2", "is no replica of the first H/F")
    ]


@pytest.mark.parametrize(
    ("least", "most", "floors", "expected"),
    [
        (None, Measure(2), [ONE, OTHER, ONE, OTHER], None),
        (None, Measure(2), [ONE, OTHER, NARROW], (3, 1.0)),
        (Measure(2), None, [ONE, OTHER], None),
        (Measure(2), None, [ONE, ONE], (1, 1.0)),
        (Measure(3), None, [ONE, ONE], (1, 2.0)),
        (Measure(1), Measure(1), [ONE, HIGHER], (2, 1.0)),
        (Measure(2), Measure(2), [], None),
    ],
)
def test_how_many_different_floors_there_are(
    least: Measure | None, most: Measure | None, floors: list[Region], expected: tuple[int, float] | None
) -> None:
    constraint = instances(least, most)
    facade = house(constraint, *FREE)
    root = with_rows(facade, CORNICE, *floors, GROUND)
    found = [v for v in broken(facade, root) if v.constraint is constraint]
    assert [(v.path, v.amount) for v in found] == ([("H", expected[1])] if expected else [])
    if expected:
        assert f"has {expected[0]} different F" in found[0].message


def test_a_relative_range_grows_with_the_parent() -> None:
    """The input has two floors F in 10 m; half of that is one, and 1.6 in a house of 16 m."""
    half = instances(most=Measure(0.5, True))
    assert half.ends(house(half), "H/F") == (Bound(0.0, False), Bound(1.0, True))
    facade = house(half, *FREE)
    assert broken(facade, with_rows(facade, CORNICE, *[ONE] * 4, GROUND)) == []
    (found,) = broken(facade, with_rows(facade, CORNICE, ONE, OTHER, ONE, ONE, GROUND))
    assert found.amount == pytest.approx(2 - 1.6)
    plenty = house(instances(most=Measure(1.1, True)), *FREE)
    assert broken(plenty, with_rows(plenty, CORNICE, ONE, OTHER, NARROW, ONE, GROUND)) == [], "3.52 may be"


def test_one_layout_is_always_allowed() -> None:
    """A tenth of two floors is less than one; where there are floors, there is one kind of them."""
    facade = house(instances(most=Measure(0.1, True)), *FREE)
    assert broken(facade, with_rows(facade, CORNICE, ONE, ONE, GROUND)) == []
    assert broken(facade, with_rows(facade, CORNICE, ONE, OTHER, GROUND)) != []


def test_the_word_rule_is_one_for_each_region() -> None:
    constraint = Instances(of=RegionSet.parse("@Floor"), min=Measure(1), max=Measure(0.5, True))
    assert list(Instances.word_rules([constraint], house(constraint))) == [
        Variants("H/F", Bound(1, False), Bound(1.0, True), (constraint,)),
        Variants("H/G", Bound(1, False), Bound(0.5, True), (constraint,)),
    ]


def test_a_soft_range_still_permits_to_vary() -> None:
    """Two kinds of floors at most, if it can be: three are no fault, and the permission holds without it."""
    soft = instances(most=Measure(2), weight=1.0)
    facade = house(soft, *FREE)
    layout = laid_out(facade, with_rows(facade, CORNICE, ONE, OTHER, NARROW, GROUND))
    assert layout.violations() == ()
    assert [(v.constraint, v.amount) for v in checked(layout, facade).unkept] == [(soft, 1.0)]
    defaults = [c for c in effective_constraints(facade) if isinstance(c, Instances) and not c.soft]
    assert [(str(c.of), c.min, c.max) for c in defaults] == [("H/F", None, None)]
    hard = house(instances(), *FREE)
    assert [c for c in effective_constraints(hard) if isinstance(c, Instances)] == [hard.constraints[0]]


@given(st.permutations([ONE, ONE, OTHER, OTHER, NARROW, HIGHER]), st.integers(1, 4))
def test_order_does_not_matter(floors: list[Region], most: int) -> None:
    facade = house(instances(most=Measure(most)), *FREE)
    found = [v for v in broken(facade, with_rows(facade, CORNICE, *floors, GROUND)) if v.constraint]
    assert [v.amount for v in found] == ([4.0 - most] if most < 4 else [])


@pytest.mark.parametrize("most", [2, 3])
def test_documents_hold_different_instances(most: int, tmp_path: Path) -> None:
    facade = house(instances(most=Measure(most)), *FREE)
    layout = laid_out(facade, with_rows(facade, CORNICE, ONE, OTHER, ONE, NARROW, NARROW, GROUND))
    layout = replace(layout, facade_file="facade.xml")
    kinds = {kind.kind: kind for kind in BUILT_IN}
    save(tmp_path / "facade.xml", facade_bytes(facade))
    save(tmp_path / "layout.xml", layout_bytes(layout))
    again = read(tmp_path / "layout.xml", kinds).model
    assert isinstance(again, Layout)
    assert again.root == layout.root
    assert again.violations() == layout.violations()
    assert len(layout.violations()) == (most == 2)
    assert layout_bytes(again) == layout_bytes(layout)
    faults = check(tmp_path / "layout.xml", kinds)
    assert [(d.code, d.place and Path(d.place.file).name) for d in faults] == [("LK502", "layout.xml")] * (
        most == 2
    )


def test_copies_go_by_the_path_of_the_original() -> None:
    assert original("H/F~2/B~13") == "H/F/B"
    assert original("H/F2/B") == "H/F2/B"
