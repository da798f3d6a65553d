"""The count is that of brute force, and every arrangement has one rank."""

from __future__ import annotations

from collections import Counter

import pytest
from oracle import Doubtful, TooMany, arrangements
from tiny_models import tiny

from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.counting.census import Census, tree
from layoutkit_relayout.counting.counted import counted
from layoutkit_relayout.search.wishes import granted

EFFORT = 20_000
#: Far more words than any tiny model has.
PLENTY = 100_000
#: Combinations of words and replicas that brute force takes on.
MOST = 120
#: Models are judged in chunks, so that several workers can share them.
CHUNKS = 6


def judge(seed: int) -> str:
    """Compare count and ranks with brute force; tell what came of it."""
    facade, size = tiny(seed)
    try:
        expected = arrangements(facade, size, MOST)
    except (Doubtful, TooMany):
        return "not judged"
    search = granted(facade, size, BACKENDS, PLENTY).search
    found = counted(search, EFFORT)
    assert found.least <= len(expected), f"tiny({seed})"
    assert found.most is None or len(expected) <= found.most, f"tiny({seed})"
    census = Census(search, EFFORT)
    named = [tree(census.words(rank), facade.root.symbol) for rank in range(census.ways.most)]
    assert set(named) >= expected, f"tiny({seed}): no arrangement may be left out"
    if census.ways.exact:
        assert set(named) == expected, f"tiny({seed})"
        assert len(named) == len(expected), f"tiny({seed}): an arrangement has two ranks"
    return found.kind if len(expected) != 1 else f"{found.kind}, one"


def judge_some(models: int, first_seed: int) -> None:
    """Judge so many models; nearly all counts are to be exact, and enough of them not trivial."""
    kinds: Counter[str] = Counter()
    seed = first_seed
    with single_threaded():
        while kinds.total() - kinds["not judged"] < models:
            kinds[judge(seed)] += 1
            seed += 1
    exact = kinds["exact"] + kinds["exact, one"]
    assert exact >= 0.98 * models, kinds
    assert kinds["exact"] >= 0.6 * models, kinds


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_three_hundred_tiny_models(chunk: int) -> None:
    judge_some(300 // CHUNKS, 50_000 + 1_000 * chunk)


@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(20))
def test_four_thousand_tiny_models(chunk: int) -> None:
    judge_some(200, 60_000 + 1_000 * chunk)


@pytest.mark.parametrize("seed", [64_062, 72_295, 74_048])
def test_regions_that_stand_across_others(seed: int) -> None:
    """Which regions there are matters across, though along their parent their sizes are as good as any."""
    assert judge(seed) != "not judged"


def test_too_little_effort_leaves_bounds() -> None:
    """Whatever the effort, what brute force finds lies between the ends."""
    kinds: Counter[str] = Counter()
    with single_threaded():
        for seed in range(40_000, 40_060):
            facade, size = tiny(seed)
            try:
                expected = arrangements(facade, size, MOST)
            except (Doubtful, TooMany):
                continue
            search = granted(facade, size, BACKENDS, PLENTY).search
            for effort in (1, 10, 100):
                found = counted(search, effort)
                assert found.least <= len(expected), f"tiny({seed}), {effort}"
                assert found.most is None or len(expected) <= found.most, f"tiny({seed}), {effort}"
                assert (found.kind == "exact") == (found.least == found.most)
                kinds[found.kind] += 1
    assert min(kinds["exact"], kinds["at least"] + kinds["at most"] + kinds["between"]) >= 5, kinds
