"""The benchmark of cities runs small; its city is one, and its simulation keeps to what is known exactly."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.city import hundred, runs
from benchmarks.city.measuring import digest, size, taken
from benchmarks.city.plots import city
from benchmarks.city.simulation import Costs, Machines, Work, simulated
from benchmarks.city.tasks import Done, Preparation, carried_out, idle, prepared, replays
from layoutkit.batch import InProcess
from layoutkit.cli.tiles import tiles_of
from layoutkit.operations.sites import sites_of

FREE = Costs(0.0, 0.0, 0.0)


def test_a_city_has_as_many_plots_as_asked_for_and_none_overlaps() -> None:
    scene = city(150, np.random.default_rng(3))
    outlines = [shapely.Polygon(polygon.points) for polygon in scene.polygons]
    plots = [polygon for polygon in scene.polygons if polygon.labels == ("Plot",)]
    assert len(plots) == 150
    assert all(outline.is_valid and outline.exterior.is_ccw for outline in outlines)
    assert shapely.union_all(outlines).area == pytest.approx(sum(o.area for o in outlines), abs=1e-3)
    assert {len(plot.edges) for plot in plots} == {1, 2}
    areas = [outline.area for outline in outlines[-150:]]
    assert max(areas) > 1.5 * min(areas)


def test_the_fronts_of_plots_are_at_streets() -> None:
    scene = city(60, np.random.default_rng(0))
    plots = [polygon for polygon in scene.polygons if polygon.labels == ("Plot",)]
    built = shapely.union_all([shapely.Polygon(plot.points) for plot in plots])
    for plot in plots:
        fronts = {number for number, _ in plot.edges}
        for number, (a, b) in enumerate(zip(plot.points, (*plot.points[1:], plot.points[0]), strict=True)):
            x, y = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
            along = (b[0] - a[0], b[1] - a[1])
            length = float(np.hypot(*along))
            outside = shapely.Point(x + along[1] / length, y - along[0] / length)
            if number in fronts:
                assert not built.contains(outside)


def test_the_same_seed_gives_the_same_city() -> None:
    assert city(20, np.random.default_rng(1)) == city(20, np.random.default_rng(1))
    assert city(20, np.random.default_rng(1)) != city(20, np.random.default_rng(2))


@pytest.mark.parametrize(("plots", "most"), [(30, 10), (31, 5), (64, 8), (9, 10)])
def test_tiles_are_as_many_as_the_simulation_takes_them_for(plots: int, most: int) -> None:
    scene = city(plots, np.random.default_rng(0))
    assert len(tiles_of(scene, sites_of(scene, ("Plot",)), most)) == hundred.tiles(plots, most)


def test_runs_are_measured_and_compared() -> None:
    told = list(runs.lines(2, 4, ["small", "large"], 2))
    assert [line.split(":")[0] for line in told[:2]] == ["small", "large"]
    assert all("0 tasks failed" in line for line in told[:2])
    assert "2 of 2 plots built on" in told[0]
    assert "4 of 4 plots built on" in told[1]
    assert "limit 120, met" in told[2]
    assert told[3].startswith("times as long for 2.0 times as many plots")


def test_memory_and_time_are_those_of_the_command(tmp_path: Path) -> None:
    program = "import time; held = bytearray(200_000_000); time.sleep(0.5)"
    used = taken(["python3", "-c", program], tmp_path / "log")
    assert used.code == 0
    assert used.seconds > 0.5
    assert used.memory > 180
    assert used.greatest > 180


def test_digests_tell_contents_and_names_and_leave_hidden_files_out(tmp_path: Path) -> None:
    first = None
    for name, data, same in (("a", b"1", True), (".b", b"2", True), ("c", b"3", False)):
        (tmp_path / name).write_bytes(data)
        first = first or digest(tmp_path)
        assert (digest(tmp_path) == first) is same
    assert size(tmp_path) == 2


def test_tasks_tell_how_long_they_took_and_what_they_gave() -> None:
    scene = city(4, np.random.default_rng(0))
    timed = carried_out(replays(scene, 2), InProcess())
    assert [done.plots for done in timed.done] == [2, 2]
    assert all(done.seconds > 0 and done.size > 1000 for done in timed.done)
    nothing = carried_out(idle(3, 100), InProcess())
    assert [done.size for done in nothing.done] == [100, 100, 100]
    made = prepared(scene, 2)
    assert made.plots == 4
    assert made.size > 500


@settings(max_examples=50)
@given(st.lists(st.floats(0.1, 5), min_size=1, max_size=30), st.integers(1, 3), st.integers(1, 3))
def test_list_scheduling_is_within_its_bounds(seconds: list[float], machines: int, cores: int) -> None:
    """Graham's: at most what all cores would need together, and once the longest task."""
    course = simulated([Work(each, 0) for each in seconds], Machines((1.0,) * machines, cores), FREE)
    together = sum(seconds) / (machines * cores)
    assert max(together, max(seconds)) - 1e-9 <= course.seconds <= together + max(seconds) + 1e-9
    assert course.repeated == 0


def test_a_client_or_a_scheduler_that_is_slow_is_the_limit() -> None:
    tasks, many = [Work(1.0, 1000.0)] * 200, Machines((1.0,) * 10, 10)
    client = simulated(tasks, many, Costs(0.0, 0.1, 0.0))
    assert client.limit == "client"
    assert client.seconds == pytest.approx(21.0)
    scheduler = simulated(tasks, many, Costs(0.1, 0.0, 0.0))
    assert scheduler.limit == "scheduler"
    assert scheduler.seconds == pytest.approx(21.0)
    line = simulated(tasks, Machines((1.0,) * 10, 10, line=10_000.0), FREE)
    assert line.limit == "client"
    assert line.seconds == pytest.approx(21.0)
    assert simulated(tasks, many, FREE).limit == "cores"


def test_a_lost_machine_costs_what_it_was_at_and_nothing_else() -> None:
    tasks, machines = [Work(1.0, 0.0)] * 400, Machines((1.0, 1.0, 1.0, 1.0), 2)
    whole = simulated(tasks, machines, FREE)
    lost = simulated(tasks, Machines((1.0, 1.0, 1.0, 1.0), 2, lost=1), FREE)
    assert whole.seconds == pytest.approx(50.0)
    assert 0 < lost.repeated <= 4
    assert lost.seconds == pytest.approx(25 + (200 + lost.repeated) / 6, abs=2.0)


def test_speeds_and_the_beginning_count() -> None:
    tasks = [Work(1.0, 0.0)] * 10
    assert simulated(tasks, Machines((0.5,), 1, (2.0, 3.0)), FREE).seconds == pytest.approx(3 + 4 + 20)


def test_what_was_measured_goes_into_the_simulation() -> None:
    work = {tile: [Done(0.1 * tile, tile, 1000 * tile, False)] for tile in hundred.TILES}
    small, large = (
        Preparation(plots, 200 * plots, (plots / 1e4, 1e-3, (plots / 1000) ** 2), 1.0)
        for plots in (1000, 4000)
    )
    found = hundred.Measured(work, 1.0, (small, large), Costs(1e-4, 1e-3, 0.0))
    assert found.preparation(8000) == pytest.approx(0.8 + 1e-3 + 64.0)
    tasks = found.tasks(4000, 10, np.random.default_rng(0))
    assert sum(task.seconds for task in tasks) == pytest.approx(400.0)
    assert sum(task.size for task in tasks) == pytest.approx(4_000_000)
    rows = list(hundred.table(found, ((4000, 1), (8000, 2))))
    assert len(rows) == 2 + 2 * len(hundred.LINES) * len(hundred.TILES)
    for one, other in combinations(rows[2:4], 2):
        assert float(one.split()[5]) > 0
        assert one.split()[:2] == other.split()[:2] == ["4000", "1"]
