"""The search finds every arrangement that brute force finds, and no other; what it proves is so."""

from __future__ import annotations

from itertools import count
from pathlib import Path

import pytest
from oracle import Doubtful, TooMany, arrangements
from tiny_models import tiny

from layoutkit.model import Facade, Layout, place
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.model import Model
from layoutkit_relayout.search import Search

#: Far more words than any tiny model has.
PLENTY = 100_000
#: Combinations of words that brute force takes on.
MOST = 60
#: Models are judged in chunks, so that several workers can share them.
CHUNKS = 6


def words_of(layout: Layout) -> frozenset[tuple[str, tuple[str, ...]]]:
    return frozenset((p.symbol_path, p.region.word) for p in place(layout.root) if p.region.split)


def judge(seed: int) -> bool:
    """Compare the search with brute force; tell whether the model could be judged."""
    facade, size = tiny(seed)
    try:
        expected = arrangements(facade, size, MOST)
    except (Doubtful, TooMany):
        return False
    search = Search(Model(facade), size, BACKENDS)
    found = [frozenset(words.items()) for words in search.arrangements(PLENTY)]
    assert len(found) == len(set(found)), f"tiny({seed}): an arrangement is found twice"
    assert set(found) == expected, f"tiny({seed})"
    for index in range(2):
        variation = search.variation(seed, index, PLENTY)
        assert variation.status == ("found" if expected else "infeasible"), f"tiny({seed})"
        if variation.root is not None:
            layout = Layout("tiny", "m", variation.root, facade)
            assert layout.violations() == (), f"tiny({seed})"
            assert words_of(layout) in expected
    return True


def judge_some(models: int, first_seed: int) -> None:
    seeds = count(first_seed)
    with single_threaded():
        for _ in range(models):
            while not judge(next(seeds)):
                pass


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_three_hundred_tiny_models(chunk: int) -> None:
    judge_some(300 // CHUNKS, 1_000 * chunk)


@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(20))
def test_five_thousand_tiny_models(chunk: int) -> None:
    judge_some(5_000 // 20, 10_000 + 1_000 * chunk)


def test_the_tiny_models_have_something_of_everything() -> None:
    """Else the comparison above would say little."""
    kinds: dict[str, int] = {}
    shapes = set()
    for seed in range(500):
        facade, _ = tiny(seed)
        shapes.add(sum(region.split is not None for region in facade.regions.values()))
        for kind in {constraint.kind for constraint in facade.constraints}:
            kinds[kind] = kinds.get(kind, 0) + 1
        assert not faults(facade), f"tiny({seed})"
    assert shapes == {1, 2, 3, 4}
    assert set(kinds) == {"size", "sequence", "frequency", "alignment", "same-size", "same-arrangement"}
    assert min(kinds.values()) >= 50


def faults(facade: Facade) -> list[str]:
    return [
        str(d) for constraint in facade.constraints for d in constraint.faults(facade) if d.code != "LK207"
    ]


def test_brute_force_shares_nothing_with_the_search() -> None:
    source = Path(__file__).with_name("oracle.py").read_text()
    assert "layoutkit.sizing" not in source
    assert "layoutkit_relayout" not in source
