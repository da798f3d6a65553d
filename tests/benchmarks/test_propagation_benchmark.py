"""The benchmark of propagation runs, and its plain evaluation gives our field."""

from __future__ import annotations

import re

from benchmarks import propagation


def test_it_runs_small() -> None:
    told = list(propagation.lines(2000, 1, True, [1, 3]))
    assert len(told) == 7
    assert all("placed" in line or "the field alone" in line for line in told)
    (compared,) = (line for line in told if "the field alone" in line)
    apart = re.search(r"differ by (\S+) of", compared)
    assert apart is not None
    assert float(apart.group(1)) < 1e-9
