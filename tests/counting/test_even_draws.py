"""Uniform sampling: each arrangement that exists is as likely as any other, and none is left out."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from countable import row, search, stack
from scipy.stats import chisquare

from layoutkit.constraints import Alignment, Instances
from layoutkit.model import Facade, Layout, RegionSet
from layoutkit_relayout.sampling import sampling
from layoutkit_relayout.sampling.sampling import Told, Uniform

ONE_OR_TWO = {"a": (1.0, 1.0), "b": (2.0, 2.0)}
LOOSE = {"a": (1.0, 2.0)}
LINES = Alignment(first=RegionSet("R/F/a"), second=RegionSet("R/G/a"), lines=("left", "right"))
#: Of 49 combinations of words the 7 exist in which both floors have as many bays.
TIED = stack({"F": LOOSE, "G": LOOSE}, LINES)


def draw(sampler: Uniform, facade: Facade, count: int, seed: int = 3) -> Counter[object]:
    """Draw layouts, check each, and count their arrangements."""
    seen: Counter[object] = Counter()
    for index in range(count):
        found = sampler.variation(seed, index, 2000)
        assert found.root is not None
        assert Layout("drawn", "m", found.root, facade).violations() == ()
        seen[tuple(region.word for region in (found.root, *found.root.children))] += 1
    return seen


def even(seen: Counter[object], kinds: int) -> bool:
    """Tell whether so many kinds were seen, about equally often: by chance, 1 of 100 fair draws is not."""
    return len(seen) == kinds and chisquare([*seen.values()]).pvalue > 0.01


def test_ranks_are_drawn_evenly() -> None:
    sampler = Uniform(search(row(ONE_OR_TWO), 7.0))
    assert sampler.census is not None
    generator = np.random.default_rng(1)
    seen = Counter(sampler.words(sampler.census, generator)["R"] for _ in range(4200))
    assert even(Counter(seen), 21)


def test_layouts_are_drawn_evenly() -> None:
    facade = row(ONE_OR_TWO)
    assert even(draw(Uniform(search(facade, 6.0)), facade, 650), 13)


def test_coupled_floors_are_drawn_evenly() -> None:
    assert even(draw(Uniform(search(TIED, 12.0)), TIED, 350), 7)


def test_weighted_draws_are_not_even() -> None:
    """The test above would show a draw that is not: likely words stand out by far."""
    facade = row(ONE_OR_TWO)
    assert not even(draw(search(facade, 6.0), facade, 650), 13)  # type: ignore[arg-type]  # it draws alike


def test_what_may_exist_is_drawn_until_it_does(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "EFFORT", 9)
    sampler = Uniform(search(TIED, 12.0))
    assert sampler.census is not None
    assert sampler.census.ways.least < 7 < sampler.census.ways.most
    found = sampler.variation(0, 0, 2000)
    assert isinstance(found, Told)
    assert "until one does" in found.remark
    assert even(draw(sampler, TIED, 350), 7)


def test_a_draw_is_given_up_at_its_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "EFFORT", 9)
    found = [Uniform(search(TIED, 12.0)).variation(0, index, 1) for index in range(20)]
    lost = [own for own in found if own.root is None]
    assert lost
    assert all(own.status == "limit" and isinstance(own, Told) and "were drawn" in own.remark for own in lost)


def test_what_cannot_be_counted_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "EFFORT", 0.01)
    found = Uniform(search(TIED, 12.0)).variation(0, 0, 2000)
    assert isinstance(found, Told)
    assert (found.status, found.root) == ("limit", None)
    assert "counted" in found.remark


def test_instances_do_not_make_an_arrangement_likelier() -> None:
    facade = row({"a": (1.0, 2.0), "b": (1.0, 2.0)}, Instances(of=RegionSet("R/a")))
    # Words of 2, 3 or 4 bays, though those of many bays can name instances in many more ways.
    assert even(draw(Uniform(search(facade, 4.0)), facade, 560), 4 + 8 + 16)


def test_where_there_is_none_that_is_proved() -> None:
    found = Uniform(search(row(ONE_OR_TWO), 5.5)).variation(0, 0, 2000)
    assert (found.status, found.root) == ("infeasible", None)


def test_a_variation_is_the_same_whichever_others_are_made() -> None:
    one, other = Uniform(search(TIED, 12.0)), Uniform(search(TIED, 12.0))
    assert [one.variation(5, index, 2000).root for index in range(6)] == [
        other.variation(5, index, 2000).root for index in reversed(range(6))
    ][::-1]
