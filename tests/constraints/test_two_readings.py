"""Search and sizing read a constraint by its rules, the checker by itself: they agree on every layout."""

from __future__ import annotations

from dataclasses import replace

from houses import floor, house, laid_out, stacked
from hypothesis import event, given, settings
from hypothesis import strategies as st
from readings import kept_by_rules

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Lock,
    SameArrangement,
    SameSize,
    Sequence,
    Size,
    Symmetry,
)
from layoutkit.model import Extent, Measure, Region, RegionSet, Word

#: Floors of 7 m: their words, and how wide piers and bays are in them.
FLOORS = [
    *((word, {"P": 1.0, "B": 2.0}) for word in ("PBPBP", "BPPPB", "PPBBP", "BBBP", "BPPBP")),
    *((word, {"P": 1.4, "B": 1.4}) for word in ("PBPBP", "BPBPB", "PPBBP", "BPPPP")),
    *((word, {"P": 0.5, "B": 3.0}) for word in ("PBPB", "PPBB", "BPPB")),
]
HEIGHTS = {"C": (0.5, 1.0), "F": (3.0, 3.25), "G": (3.5, 3.0)}


def context(text: str) -> st.SearchStrategy[Word | None]:
    """One of the words; most often none."""
    words = [Word.context(word) for word in text.split(", ")]
    return st.sampled_from([None] * 3 * len(words) + words)


@st.composite
def layouts(draw: st.DrawFn) -> Region:
    """Storeys in any order and number; floors of one symbol are alike."""
    made: dict[str, Region] = {}
    for symbol in "FG":
        word, widths = draw(st.sampled_from(FLOORS))
        made[symbol] = floor(symbol, word, draw(st.sampled_from(HEIGHTS[symbol])), widths)
    made["C"] = Region("C", 7.0, draw(st.sampled_from(HEIGHTS["C"])), labels=("Cornice",))
    rows = draw(st.sampled_from(["CFFG", "CFFG", "CGFF", "CFG", "CG", "FFCGFF", "FGF", "FCF"]))
    return stacked(*(made[symbol] for symbol in rows))


SETS = st.sampled_from(["H/F/B", "H/F/P", "H/G/B", "@Pier", "@Window", "H/F", "H/G | H/C"]).map(
    RegionSet.parse
)
RUNS = st.sampled_from(["H/F: P B", "H/F: B P", "H/G: ⊢ P", "H/F: P P", "H/G: B ⊣"]).map(Extent.parse)
EXTENTS = SETS.map(Extent) | RUNS
COLUMNS = st.sampled_from(["H/F/B", "H/G/B", "H/G/P", "@Pier", "@Window"]).map(RegionSet.parse)
WITHIN = st.sampled_from([None, "H", "H/F", "H/G"])
BEFORE, AFTER = context("⊢, P, ⊢ P, B, {P F}, ⊢ C"), context("⊣, P, P ⊣, {P B}, G ⊣")
CONTEXTS = {"first_before": BEFORE, "first_after": AFTER, "second_before": BEFORE, "second_after": AFTER}
LINES = st.sampled_from([("left",), ("center",), ("left", "right"), ("top",), ("middle", "bottom")])
KEEPS = st.lists(st.sampled_from(["place", "size", "inside"]), min_size=1, unique=True).map(tuple)
ANCHORS = st.sampled_from([("left", "bottom"), ("right", "top"), ("center", "middle"), ("top",)])
MEASURES = st.none() | st.sampled_from([Measure(1.0), Measure(2.0), Measure(0.8, True), Measure(3.0)])

CONSTRAINTS: st.SearchStrategy[Constraint] = st.one_of(
    st.builds(Size, of=SETS, min=MEASURES, max=MEASURES),
    st.builds(Alignment, first=SETS, second=SETS, lines=LINES, within=WITHIN, **CONTEXTS),
    st.builds(Alignment, first=COLUMNS, second=COLUMNS, lines=LINES, **CONTEXTS),
    st.builds(SameSize, first=EXTENTS, second=EXTENTS, dimension=st.just("width"), within=WITHIN, **CONTEXTS),
    st.builds(SameSize, first=SETS.map(Extent), dimension=st.just("height"), first_after=AFTER),
    st.builds(
        Symmetry,
        of=st.sampled_from([("H/F",), ("H/F", "H/G"), ("H",)]),
        pairs=st.sampled_from([(), (("P", "B"),), (("F", "G"),)]),
    ).filter(lambda c: c.pairs == () or (c.pairs[0][0] == "F") is (c.of == ("H",))),
    st.builds(Lock, of=SETS, keep=KEEPS, anchor=ANCHORS),
    st.builds(
        Frequency, of=st.just(RegionSet.parse("@Window")), within=st.just("H"), min=MEASURES, max=MEASURES
    ),
    st.builds(SameArrangement, of=st.just(("H/F", "H/G"))),
    st.builds(
        Sequence,
        within=st.just(("H/F",)),
        word=st.sampled_from(["⊢ P B P B P ⊣", "⊢ {P B} B"]).map(Word.parse),
    ),
)


@settings(max_examples=800, deadline=None)
@given(CONSTRAINTS, layouts())
def test_rules_and_checker_agree(constraint: Constraint, root: Region) -> None:
    facade = house(constraint)
    layout = laid_out(facade, root)
    broken = [v for v in layout.violations() if v.constraint == constraint]
    kept = kept_by_rules(constraint, facade, root)
    event(f"{constraint.kind} {'kept' if kept else 'broken'}")
    assert kept is (not broken), broken
    assert all(v.amount > 0 and v.message for v in broken)


@settings(max_examples=100, deadline=None)
@given(CONSTRAINTS.filter(lambda c: not isinstance(c, Sequence)), layouts(), st.floats(0.1, 9))
def test_a_soft_constraint_is_read_alike(constraint: Constraint, root: Region, weight: float) -> None:
    from layoutkit.constraints.checking import checked

    hard, soft = house(constraint), house(replace(constraint, weight=weight))
    broken = [v for v in laid_out(hard, root).violations() if v.constraint == constraint]
    missed = checked(laid_out(soft, root), soft).unkept
    assert [(v.path, v.message, v.amount) for v in missed] == [(v.path, v.message, v.amount) for v in broken]
    assert not any(v.constraint in soft.constraints for v in laid_out(soft, root).violations())
