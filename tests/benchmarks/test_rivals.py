"""The rivals solve the same problem: their layouts pass the checker, and what they prove is so."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.contenders import Contender, terminals_of, trial
from benchmarks.designs.parts import alike, columns, facade, frequency, in_line, leaf, rows, sequences, sizes
from benchmarks.paper_baseline import PaperBaseline
from benchmarks.stated import Stated, Unsupported, tree
from layoutkit.constraints import SameArrangement, Symmetry
from layoutkit.constraints.covering import Covering
from layoutkit.constraints.sequence import Sequence
from layoutkit.model import Facade, Layout, place

cpsat = pytest.importorskip("benchmarks.cpsat")
cpsat_words = pytest.importorskip("benchmarks.cpsat_words")

RIVALS = {"baseline": PaperBaseline(120.0), "cpsat": cpsat.CpSat(120.0)}
both = pytest.mark.parametrize("rival", RIVALS.values(), ids=RIVALS)


def front(*, mirrored: bool = False) -> Facade:
    """Return two storeys of windows and doors in line, with every kind of constraint that rivals know."""
    window = rows("W", 1.2, "h g", [leaf("h", 1.0), leaf("g", 2.0, "Glass")], "Window")
    door = leaf("D", 1.2, "Door")
    upper = columns("U", 3.0, "w W w W w W w", [leaf("w", 0.8), window])
    lower = columns("L", 3.0, "w W w D w W w", [leaf("w", 0.8), window, door])
    constraints = [
        *sequences("F/U", "⊢ w W", "w W w", "W w ⊣"),
        *sequences("F/L", "⊢ w {W D}", "w {W D} w", "{W D} w ⊣"),
        *frequency("D", "F/L", "1", "1"),
        *frequency("@Glass", "F", "50%", "200%"),
        *in_line("F/U/W", "F/L/W | F/L/D", "center"),
        *alike("width", "F/U/W", "F/L/W"),
        *alike("width", "F/U: w W", "F/L: w W"),
        *sizes("80%", "125%", "5%", "F/U/W", "F/L/W", "F/L/D"),
        *([Symmetry(of=("F/L",))] if mirrored else []),
    ]
    return facade("front", rows("F", 0.0, "U L", [upper, lower]), 6.8, 6.0, constraints)


@both
@pytest.mark.parametrize(("width", "mirrored"), [(6.8, False), (9.0, False), (9.0, True), (12.4, True)])
def test_layouts_keep_every_constraint(rival: Contender, width: float, mirrored: bool) -> None:
    design = front(mirrored=mirrored)
    for seed in range(3):
        found = trial(design, (width, 6.0), rival.maker(design, (width, 6.0)), seed)
        assert found.status == "found"
        assert found.terminals > 10


@both
def test_a_design_is_solved(rival: Contender, designs: Mapping[str, Facade]) -> None:
    design = designs["house"]
    size = (0.8 * design.root.width, 0.8 * design.root.height)
    assert trial(design, size, rival.maker(design, size), 1).status == "found"


@both
def test_a_facade_too_narrow_is_not_found(rival: Contender) -> None:
    design, size = front(), (1.5, 6.0)
    maker = type(rival)(1.0).maker(design, size)  # type: ignore[call-arg]
    assert trial(design, size, maker, 0).status == ("infeasible" if rival.name == "cpsat" else "limit")


def test_seeds_of_the_baseline_give_different_layouts_and_each_the_same() -> None:
    design = front()
    maker = PaperBaseline(30.0).maker(design, (9.0, 6.0))
    assert maker.attempt(1) == maker.attempt(1)
    assert len({maker.attempt(seed).root for seed in range(6)}) > 1


def test_a_size_between_millimetres_is_refused() -> None:
    design = front()
    with pytest.raises(cpsat_words.OffGrid, match=r"6\.8001 m is no"):
        cpsat_words.Program(Stated(design), (6.8001, 6.0))


def test_constraints_that_rivals_do_not_know_are_refused() -> None:
    design = front()
    unknown = SameArrangement(of=("F/U", "F/L"))
    with pytest.raises(Unsupported, match="same-arrangement"):
        Stated(replace(design, constraints=(*design.constraints, unknown)))


@given(st.lists(st.sampled_from("wWD"), max_size=9))
def test_grammars_accept_the_words_that_sequences_cover(word: list[str]) -> None:
    design = front()
    own = [c for c in design.constraints if isinstance(c, Sequence) and c.within == ("F/L",)]
    covering = Covering(tuple(c.piece(design.regions["F/L"]) for c in own))
    state = covering.start()
    for symbol in word:
        state = state and covering.step(state, symbol)  # type: ignore[assignment]
    accepted = bool(state) and covering.accepts(state)
    assert Stated(design).grammars["F/L"].accepts(word) == accepted


def test_hulls_hold_the_sizes_of_every_word() -> None:
    stated = Stated(front())
    assert stated.hull("F/U/W", 0) == pytest.approx((0.96, 1.5))
    assert stated.hull("F/U/W", 1) == pytest.approx((1.5, 6.0))
    assert stated.hull("F/U", 1) == pytest.approx((1.5, 6.0))
    low, high = stated.hull("F/L", 0)
    assert low == pytest.approx(0.8 + 0.96)
    assert high == float("inf")


def test_trees_tile_exactly_and_share_replicas() -> None:
    design = front()
    words = {path: design.regions[path].word for path in design.regions if design.regions[path].split}
    sizes_ = {"F/U": 3.0, "F/L": 3.0 + 1e-8, "F/U/w": 0.8, "F/U/W": 1.2 + 1e-8}
    sizes_ |= {"F/L/w": 0.8, "F/L/W": 1.2, "F/L/D": 1.2}
    sizes_ |= {f"F/{storey}/W/{part}": size for storey, (part, size) in product("UL", (("h", 1), ("g", 2)))}
    root = tree(design, words, sizes_, (6.8, 6.0))
    assert Layout("front", "m", root, design).violations() == ()
    upper = root.children[0]
    assert upper.children[1] is upper.children[3]
    assert terminals_of(root) == sum(placed.region.terminal for placed in place(root))
