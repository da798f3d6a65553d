"""Minimal conflicts among abstract units, whose conflicts are given."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from hypothesis import given
from hypothesis import strategies as st

from layoutkit_relayout.explanation.conflict import quickxplain
from layoutkit_relayout.explanation.units import Unit

UNITS = [Unit((), ()) for _ in range(24)]
NUMBERS = st.integers(0, len(UNITS) - 1)
CONFLICTS = st.lists(st.frozensets(NUMBERS, min_size=1, max_size=5), min_size=1, max_size=6)


def oracle(conflicts: Sequence[frozenset[int]]) -> Callable[[Sequence[Unit]], bool]:
    """Return a test that tells whether some of the units contain a conflict."""

    def infeasible(units: Sequence[Unit]) -> bool:
        held = {UNITS.index(unit) for unit in units}
        return any(conflict <= held for conflict in conflicts)

    return infeasible


@given(CONFLICTS)
def test_a_conflict_is_found_of_which_nothing_can_be_spared(conflicts: list[frozenset[int]]) -> None:
    infeasible = oracle(conflicts)
    found = quickxplain(infeasible, UNITS)
    assert infeasible(found)
    for unit in found:
        assert not infeasible([other for other in found if other is not unit])
    assert found == [unit for unit in UNITS if unit in found], "in the order given"


@given(CONFLICTS)
def test_later_units_take_part_only_where_it_cannot_be_shown_without_them(
    conflicts: list[frozenset[int]],
) -> None:
    """The last unit of the conflict found is as early as can be."""
    found = quickxplain(oracle(conflicts), UNITS)
    assert UNITS.index(found[-1]) == min(max(conflict) for conflict in conflicts)


@given(CONFLICTS, st.frozensets(st.frozensets(NUMBERS, max_size=24), max_size=40), st.integers(0, 2**32))
def test_what_is_found_is_infeasible_even_if_the_test_gives_up_at_times(
    conflicts: list[frozenset[int]], hard: frozenset[frozenset[int]], salt: int
) -> None:
    infeasible = oracle(conflicts)

    def doubtful(units: Sequence[Unit]) -> bool:
        numbers = frozenset(UNITS.index(unit) for unit in units)
        gives_up = numbers in hard or (sum(1 << n for n in numbers) ^ salt) % 3 == 0
        return infeasible(units) and not gives_up

    assert infeasible(quickxplain(doubtful, UNITS))


def test_few_questions_are_asked() -> None:
    """About 2 k log2(n / k) + 2 k of them for a conflict of k among n (Junker 2004)."""
    asked = 0

    def infeasible(units: Sequence[Unit]) -> bool:
        nonlocal asked
        asked += 1
        return {UNITS.index(unit) for unit in units} >= {3, 17}

    assert [UNITS.index(unit) for unit in quickxplain(infeasible, UNITS)] == [3, 17]
    assert asked <= 20
