"""Explanations of random tiny models: conflicts are minimal, remedies help, best efforts are layouts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import pytest
from conflicting import alone, helps, keeps
from oracle import Doubtful, TooMany, arrangements
from tiny_models import tiny

from layoutkit.model import Facade
from layoutkit.model.conflict import Conflict, Explanation, Member
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.explanation.explaining import explain
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search

#: Combinations of words that brute force takes on, and the least sizes that leave so few.
MOST, COARSE = 200, 0.6
CHUNKS = 3

Case = tuple[str, Facade, tuple[float, float]]


def impossible(first: int, count: int) -> Iterator[Case]:
    """Yield tiny models of which it is proved that they have no layout, without their soft constraints."""
    seed, found = first, 0
    while found < count:
        facade, size = tiny(seed)
        facade = replace(facade, constraints=tuple(c for c in facade.constraints if not c.soft))
        if Search(Model(facade), size, BACKENDS).variation(0, 0, 5_000).status == "infeasible":
            found += 1
            yield f"tiny({seed})", facade, size
        seed += 1


def judge(case: Case, tally: Counter[str]) -> None:
    name, facade, size = case
    explanation = explain(facade, size)
    assert explanation.conflicts, name
    for conflict in explanation.conflicts:
        check_conflict(name, facade, size, conflict, tally)
    check_best_effort(name, facade, explanation)
    if len(explanation.conflicts) == 1 and explanation.complete:
        for remedy in explanation.conflicts[0].remedies:
            tally["remedies"] += 1
            assert helps(facade, size, remedy), f"{name}: {remedy.text}"


def check_conflict(
    name: str, facade: Facade, size: tuple[float, float], conflict: Conflict, tally: Counter[str]
) -> None:
    tally["conflicts"] += 1
    tally["minimal"] += conflict.minimal
    assert not possible(facade, size, conflict.members, tally), f"{name}: its conflict can hold"
    for member in conflict.members:
        others = [other for other in conflict.members if other is not member]
        if member.needed:
            assert has_layout(facade, size, others, tally), f"{name}: {member.subject} can be spared"


def possible(
    facade: Facade, size: tuple[float, float], members: Sequence[Member], tally: Counter[str]
) -> bool:
    """Tell whether brute force knows a layout that keeps members of a conflict, its sizes not too small."""
    try:
        found = bool(arrangements(alone(facade, members, COARSE), size, MOST))
    except (TooMany, Doubtful):
        return False
    tally["judged by brute force"] += 1
    return found


def has_layout(
    facade: Facade, size: tuple[float, float], members: Sequence[Member], tally: Counter[str]
) -> bool:
    """Tell whether members of a conflict can hold: by brute force, or by a search and the checker."""
    if possible(facade, size, members, tally):
        return True
    held = alone(facade, members)
    root = Search(Model(held), size, BACKENDS).variation(1, 0, 20_000).root
    return root is not None and keeps(root, held)


def check_best_effort(name: str, facade: Facade, explanation: Explanation) -> None:
    effort = explanation.best_effort
    assert effort is not None, name
    assert (effort.root.width, effort.root.height) == pytest.approx(explanation.size), name
    broken = {id(v.constraint) for v in effort.violations()}
    assert id(None) not in broken, f"{name}: the best effort is no layout at all"
    assert broken, f"{name}: the best effort breaks nothing"
    if explanation.complete:
        assert len(broken) <= len(explanation.conflicts), name


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_impossible_tiny_models(chunk: int) -> None:
    tally: Counter[str] = Counter()
    with single_threaded():
        for case in impossible(3_000 * chunk, 4):
            judge(case, tally)
    assert tally["minimal"] >= 0.5 * tally["conflicts"], tally
    assert tally["judged by brute force"] >= 1, tally
    assert tally["remedies"] >= 1, tally


@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(20))
def test_many_impossible_tiny_models(chunk: int) -> None:
    tally: Counter[str] = Counter()
    with single_threaded():
        for case in impossible(100_000 + 2_000 * chunk, 20):
            judge(case, tally)
    assert tally["minimal"] >= 0.8 * tally["conflicts"], tally
