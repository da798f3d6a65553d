"""What the benchmarks make of their trials: figures, aims, tables; and that they run."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from benchmarks import scaling
from benchmarks.contenders import Attempt, Maker, Size, trial
from benchmarks.designs.front import front
from benchmarks.designs.storeys import storeys
from benchmarks.paper import terminals
from benchmarks.resizing import dragged
from benchmarks.variations import Measured, Trial, measure, table
from layoutkit.model import Facade, Layout, Region

ROOT = Path(__file__).parents[2]


def plain() -> Facade:
    parts = (Region("a", 1.0, 1.0), Region("b", 2.0, 1.0))
    return Facade("plain", "m", Region("F", 3.0, 1.0, "columns", parts))


@dataclass(frozen=True)
class Canned:
    """A contender that gives the input's regions back, as they are, to seeds of some kinds."""

    fails: tuple[int, ...] = ()
    name = "canned"

    def maker(self, facade: Facade, size: Size) -> Maker:
        return CannedMaker(facade, self.fails)


@dataclass(frozen=True)
class CannedMaker:
    facade: Facade
    fails: tuple[int, ...]

    def attempt(self, seed: int) -> Attempt:
        return Attempt("limit") if seed in self.fails else Attempt("found", self.facade.root)


def measured(*milliseconds: float, status: str = "found") -> Measured:
    first = Trial((1.0, 1.0), 0, "found", 99.0, 98.0, 0.0, 2)
    trials = (Trial((1.0, 1.0), n, status, time, time, 0.0, 2) for n, time in enumerate(milliseconds, 1))
    return Measured("any", (first,), tuple(trials))


def test_a_layout_that_the_checker_does_not_pass_is_wrong() -> None:
    facade = plain()
    broken = Region("F", 3.0, 1.0, "columns", facade.root.children[::-1])
    good = trial(facade, (3.0, 1.0), CannedMaker(facade, ()), 0)
    wrong = trial(facade, (3.0, 1.0), CannedMaker(Facade("x", "m", broken), ()), 0)
    assert (good.status, good.terminals) == ("found", 2)
    assert wrong.status == "wrong"


def test_seeds_take_turns_at_the_sizes_and_the_first_at_each_stand_apart() -> None:
    found = measure(plain(), Canned(fails=(2, 5)), 12, 4)
    assert [t.seed for t in found.firsts] == [0, 1, 2, 3]
    assert len({t.size for t in found.firsts}) == 4
    assert [t.size for t in found.trials[:4]] == [t.size for t in found.firsts]
    assert found.success == 10 / 12
    assert [t.seed for t in found.trials if t.status == "limit"] == [5]


def test_means_are_of_the_successes_and_where_there_is_none_the_rival_took_as_long_as_it_tried() -> None:
    assert measured(10.0, 30.0).mean == 20.0
    assert measured(10.0, 30.0).least == 20.0
    failed = measured(500.0, 700.0, status="limit")
    assert math.isnan(failed.mean)
    assert failed.least == 600.0


def test_the_table_shows_every_design_with_its_aims() -> None:
    row = {
        "name": "shop",
        "counts": (93, 4, 102, 19, 2),
        "paper": 27.0,
        "ours": {"mean": 2.0, "success": 1.0},
        "rivals": {"baseline": {"mean": 19.0, "success": 0.5}},
        "share_of_paper": 2 / 27,
        "times_faster": {"baseline": 9.5},
        "met": {"paper": True, "rivals": False, "success": True},
    }
    lines = table([row]).splitlines()
    assert len(lines) == 2
    assert "baseline ms" in lines[0]
    assert lines[1].split() == [
        *("shop", "93", "27", "2.0", "7%", "100.0%", "19", "50%", "10×"),
        *("met", "not", "met", "met"),
    ]


def test_variations_write_all_figures(tmp_path: Path) -> None:
    file = tmp_path / "figures.json"
    command = ["--only", "shop", "--seeds", "8", "--against", "baseline", "--rival-seeds", "4"]
    ran = subprocess.run(
        [sys.executable, "-m", "benchmarks.variations", *command, "--json", str(file)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    (row,) = json.loads(file.read_text(encoding="utf-8"))
    assert row["name"] == "shop"
    assert row["counts"] == [93, 4, 102, 19, 2]
    assert row["ours"]["trials"] == 8
    assert row["rivals"]["baseline"]["trials"] == 4
    assert "shop" in ran.stdout.splitlines()[-1]


def test_an_unknown_design_is_refused() -> None:
    command = [sys.executable, "-m", "benchmarks.variations", "--only", "castle"]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert ran.returncode == 2
    assert "no design is called 'castle'" in ran.stderr


@pytest.mark.parametrize("asked", [100, 1000, 20_000])
def test_fronts_have_about_the_terminals_asked_for_and_keep_their_constraints(asked: int) -> None:
    facade = front(asked)
    assert asked / 1.5 <= terminals(facade) <= asked * 1.5
    assert Layout(facade.name, "m", facade.root, facade).violations() == ()


def test_larger_fronts_have_more_distinct_regions() -> None:
    assert len(front(10_000).regions) > 2 * len(front(100).regions)


def test_the_slope_of_times_that_grow_with_the_square_is_two() -> None:
    rows = [{"terminals": n, "milliseconds": 3e-4 * n**2} for n in (100, 1000, 10_000)]
    assert scaling.slope(rows) == pytest.approx(2.0)
    assert math.isnan(scaling.slope(rows[:1]))


def test_a_small_front_is_measured() -> None:
    found = scaling.measured(100, 2)
    assert found["success"] == 1.0
    assert found["terminals"] > 30
    assert found["megabytes"] > 10


def test_a_facade_is_dragged_with_its_words_kept() -> None:
    found = dragged(storeys(), 12)
    assert (found.windows, found.steps, found.failed) == (96, 12, 0)
    assert 0 < found.median <= found.slowest
