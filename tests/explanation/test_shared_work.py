"""What searches share, and what is seen without one: neither changes an answer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conflicting import row
from tiny_models import tiny

from layoutkit.constraints import Size
from layoutkit.model import Facade, Measure, RegionSet
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.kin import Kin
from layoutkit_relayout.explanation.sight import refuted
from layoutkit_relayout.explanation.units import flat
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Search

#: Tiny models, and sets of the constraints of each.
MODELS, SETS = 24, 6


def hard(seed: int) -> tuple[Facade, tuple[float, float]]:
    facade, size = tiny(seed)
    return replace(facade, constraints=tuple(c for c in facade.constraints if not c.soft)), size


@pytest.mark.parametrize("seed", range(MODELS))
def test_searches_with_work_in_common_find_the_same(seed: int) -> None:
    facade, size = hard(seed)
    judge, kin, random = Judge(facade, size), Kin(), np.random.default_rng(seed)
    with single_threaded():
        for _ in range(SETS):
            kept = [unit for unit in judge.units if random.random() < 0.7]
            constraints = (*judge.always.constraints, *flat(kept))
            alone = Search(Model(facade, constraints), size, BACKENDS)
            shared = kin.search(facade, constraints, size)
            assert shared.variation(0, 0, 60) == alone.variation(0, 0, 60)
            assert shared.candidates.exact == alone.candidates.exact


def test_what_is_plain_at_first_sight_is_so() -> None:
    seen = 0
    with single_threaded():
        for seed in range(150):
            facade, size = hard(seed)
            search = Search(Model(facade), size, BACKENDS)
            if refuted(search):
                seen += 1
                assert Search(Model(facade), size, BACKENDS).variation(0, 0, 400).status == "infeasible", seed
    assert seen >= 10


def test_what_holds_a_refuted_set_needs_no_search() -> None:
    sizes = [Size(of=RegionSet(f"R/{letter}"), min=Measure(2.0), max=Measure(3.0)) for letter in "abc"]
    judge = Judge(row("abc", dict.fromkeys("abc", 2.0), sizes), (3.5, 3.0))
    a, b, c = (unit for unit in judge.units if unit.constraints[0] in sizes)
    rest = [unit for unit in judge.units if unit not in (a, b, c)]
    assert judge.ask([a, b, *rest]).status == "infeasible"
    searched = judge.searched
    assert judge.ask([a, b, c, *rest]).status == "infeasible"
    assert judge.searched == searched
