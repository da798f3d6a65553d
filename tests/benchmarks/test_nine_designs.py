"""The nine designs are as large and as constrained as the paper's, valid, and leave a real choice."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

import pytest

from benchmarks.contenders import Attempt
from benchmarks.designs import DESIGNS
from benchmarks.paper import TABLE, counts, reported_counts
from benchmarks.paper_baseline import PaperBaseline
from benchmarks.stated import Stated
from layoutkit.model import Facade, Layout

pytestmark = pytest.mark.parametrize("name", list(DESIGNS))


def test_terminals_and_constraints_are_as_many_as_in_the_papers_table(
    name: str, designs: Mapping[str, Facade]
) -> None:
    assert counts(designs[name]) == reported_counts(TABLE[name])


def test_constraints_have_no_faults_and_none_stands_twice(name: str, designs: Mapping[str, Facade]) -> None:
    constraints = designs[name].constraints
    assert [fault for c in constraints for fault in c.faults(designs[name])] == []
    assert [str(c) for c, times in Counter(constraints).items() if times > 1] == []


def test_the_input_keeps_its_own_constraints(name: str, designs: Mapping[str, Facade]) -> None:
    design = designs[name]
    assert Layout(name, "m", design.root, design).violations() == ()


def test_words_leave_a_real_choice(name: str, designs: Mapping[str, Facade]) -> None:
    stated = Stated(designs[name])
    fitting = [fitting_words(stated, path) for path in stated.axis]
    assert max(fitting) >= 500
    assert sum(map(math.log10, fitting)) >= 10
    assert sum(count > 1 for count in fitting) >= 8


def test_alignments_exclude_layouts_that_all_else_admits(name: str, designs: Mapping[str, Facade]) -> None:
    design = designs[name]
    kept = tuple(c for c in design.constraints if c.kind != "alignment")
    size = (design.root.width, design.root.height)
    attempt: Attempt = PaperBaseline(60.0).maker(replace(design, constraints=kept), size).attempt(1)
    assert attempt.root is not None
    broken = Layout(name, "m", attempt.root, design).violations()
    assert {v.constraint.kind for v in broken if v.constraint is not None} == {"alignment"}


def fitting_words(stated: Stated, path: str) -> int:
    """Count the words that can fill a region at its input size, to the centimetre.

    Of the words whose least sizes fit, those whose greatest sizes fall short are left out.
    """
    region, axis = stated.facade.regions[path], stated.axis[path]
    length = round(100 * (region.width, region.height)[axis])
    return _no_longer(stated, path, 0, length) - _no_longer(stated, path, 1, length - 1)


def _no_longer(stated: Stated, path: str, end: int, length: int) -> int:
    grammar, axis = stated.grammars[path], stated.axis[path]
    ends = {s: stated.hull(f"{path}/{s}", axis)[end] for s in stated.children(path)}
    sizes = {s: max(1, round(100 * min(size, 1e6))) for s, size in ends.items()}
    ways: list[Counter[int]] = [Counter() for _ in range(length + 1)]
    ways[0][0] = 1
    found = 0
    for reached, states in enumerate(ways):
        for state, number in states.items():
            found += number * (state in grammar.accepting)
            for symbol, after in grammar.next[state].items():
                if reached + sizes[symbol] <= length:
                    ways[reached + sizes[symbol]][after] += number
    return found
