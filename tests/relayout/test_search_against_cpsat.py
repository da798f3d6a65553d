"""The search and a constraint solver agree on larger facades, whose floors are coupled with one another."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import count
from pathlib import Path

import pytest
from coupled_models import coupled

from layoutkit.constraints import Constraint
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.diagnostics import Severity
from layoutkit.model import Facade, Layout, Region, RegionSet, Word, place
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Found, Search

pytest.importorskip("ortools", reason="the constraint solver is a tool of tests and benchmarks only")

from cpsat_oracle import Solved, solve

Size = tuple[float, float]
Words = dict[str, tuple[str, ...]]

#: Words that the search may try.
NODES = 1_500
#: Seconds for one program.
PATIENCE = 20.0
#: Of all models that are decided by the solver, so many may end the search at its limit.
AT_THE_LIMIT = 0.2
#: Models are judged in chunks, so that several workers can share them.
CHUNKS = 4


def words_of(root: Region) -> Words:
    return {p.symbol_path: p.region.word for p in place(root) if p.region.split}


def pinned(facade: Facade, words: Words) -> Facade:
    """Return the facade with one word for each region that has one."""
    kept: list[Constraint] = [c for c in facade.constraints if not isinstance(c, SequenceConstraint)]
    for path, word in words.items():
        own = Word(tuple(map(RegionSet, word)), at_start=True, at_end=True)
        kept.append(SequenceConstraint(within=(path,), word=own))
    return replace(facade, constraints=tuple(kept))


def judge(facade: Facade, size: Size) -> str:
    """Compare; return what both say, or why nothing is said.

    What the strict program finds is a layout, and where the lax one finds nothing, there is none. Between the
    two, the grid is too coarse to tell.
    """
    found = Search(Model(facade), size, BACKENDS).variation(0, 0, NODES)
    check_found(facade, size, found)
    strict = solve(facade, size, seconds=PATIENCE)
    check_strict(facade, size, strict)
    if strict.status == "found":
        assert found.status != "infeasible", facade.name
        return found.status
    lax = solve(facade, size, lax=True, seconds=PATIENCE)
    if lax.status == "infeasible":
        assert found.status != "found", facade.name
        return found.status
    return "between" if lax.status == "found" else "unknown"


def check_found(facade: Facade, size: Size, found: Found) -> None:
    """What the search finds is a layout, and its words are some to the solver as well."""
    if found.root is not None:
        assert Layout("coupled", "m", found.root, facade).violations() == (), facade.name
        words = words_of(found.root)
        assert solve(facade, size, lax=True, words=words, seconds=PATIENCE).status != "infeasible", (
            facade.name
        )


def check_strict(facade: Facade, size: Size, strict: Solved) -> None:
    """What the solver finds is a layout, and the search can lay out its words."""
    if strict.root is not None:
        assert Layout("coupled", "m", strict.root, facade).violations() == (), facade.name
        held = pinned(facade, words_of(strict.root))
        assert Search(Model(held), size, BACKENDS).variation(0, 0, NODES).status == "found", facade.name


def judge_some(models: int, first_seed: int, most: int, longest: float) -> Counter[str]:
    """Go on until the two agree on so many models."""
    told: Counter[str] = Counter()
    with single_threaded():
        for seed in count(first_seed):
            told[judge(*coupled(seed, most, longest))] += 1
            if told["found"] + told["infeasible"] == models:
                break
    assert told["limit"] <= max(1, AT_THE_LIMIT * models), told
    return told


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_twenty_coupled_models(chunk: int) -> None:
    judge_some(20 // CHUNKS, 1_000 * chunk, most=4, longest=9.0)


@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(20))
def test_two_hundred_coupled_models(chunk: int) -> None:
    told = judge_some(10, 100_000 + 1_000 * chunk, most=6, longest=16.0)
    assert told["found"] > 0, told


def test_the_coupled_models_have_something_of_everything() -> None:
    """Else the comparison above would say little."""
    kinds: Counter[str] = Counter()
    floors = set()
    for seed in range(100):
        facade, _ = coupled(seed)
        floors.add(len(set(facade.root.word)))
        kinds.update({constraint.kind for constraint in facade.constraints})
        for constraint in facade.constraints:
            assert not [d for d in constraint.faults(facade) if d.severity is Severity.ERROR], facade.name
    assert floors == {3, 4, 5, 6}
    wanted = {"size", "sequence", "frequency", "alignment", "same-size", "same-arrangement", "symmetry"}
    assert set(kinds) == wanted
    assert min(kinds.values()) >= 25, kinds


def test_the_solver_shares_nothing_with_the_search() -> None:
    source = Path(__file__).with_name("cpsat_oracle.py").read_text()
    assert "layoutkit.sizing" not in source
    assert "layoutkit_relayout" not in source
