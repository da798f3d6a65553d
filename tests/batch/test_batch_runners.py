"""Processes and clusters: the same bytes as in one process, whatever dies."""

from __future__ import annotations

import json
import logging
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import batch_work
import pytest

from layoutkit import __version__
from layoutkit.batch import Finished, InProcess, Plan, Runner, Shared, Task, Watching, carry_out
from layoutkit.batch.cluster import LOCAL, Cluster
from layoutkit.batch.processes import Processes, _Worker
from layoutkit.batch.survey import differences, survey
from layoutkit.diagnostics import Faulty, Severity

Squares = Callable[..., Plan]
Same = Callable[[Path, Path], None]


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """Return the address of a cluster that runs: two workers on this machine."""
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address=None,
        scheduler_kwargs={"dashboard_address": "127.0.0.1:0"},
        silence_logs=logging.CRITICAL,
    ) as cluster:
        yield cluster.scheduler_address


@pytest.fixture(params=["processes", "joined"])
def runner(request: pytest.FixtureRequest) -> Runner:
    """Return each kind of runner, of two workers."""
    return Processes(2) if request.param == "processes" else Cluster(request.getfixturevalue("address"), 0)


def test_the_bytes_are_those_of_one_process(
    runner: Runner, squares: Squares, tmp_path: Path, same: Same
) -> None:
    (tmp_path / "trace").mkdir()
    plan = squares(30, trace=str(tmp_path / "trace"))
    carry_out(plan, tmp_path / "one", InProcess())
    for trace in (tmp_path / "trace").iterdir():
        trace.unlink()
    carry_out(plan, tmp_path / "two", runner)
    same(tmp_path / "one", tmp_path / "two")
    traces = [trace.name.split(".") for trace in (tmp_path / "trace").iterdir()]
    assert len(traces) == 30, "each is done once"
    assert len({process for _, process, _ in traces}) == 2, "by two"


def test_a_cluster_of_ones_own_gives_the_same_bytes(squares: Squares, tmp_path: Path, same: Same) -> None:
    carry_out(squares(8), tmp_path / "one", InProcess())
    carry_out(squares(8), tmp_path / "two", Cluster(LOCAL, 2))
    same(tmp_path / "one", tmp_path / "two")


def test_a_worker_that_is_killed_loses_and_repeats_nothing(
    runner: Runner, squares: Squares, tmp_path: Path, same: Same
) -> None:
    plan = squares(20, {3: batch_work.killed_once}, marker=str(tmp_path / "killed"))
    finished: list[str] = []
    report = carry_out(plan, tmp_path / "two", runner, Watching(finish=lambda f: finished.append(f.key)))
    assert (tmp_path / "killed").exists()
    assert (report.done, report.failed) == (20, 0)
    assert sorted(finished) == sorted(task.key for task in plan.tasks)
    carry_out(plan, tmp_path / "one", InProcess())
    same(tmp_path / "one", tmp_path / "two")


def test_a_task_that_workers_die_of_fails_alone(runner: Runner, squares: Squares, tmp_path: Path) -> None:
    report = carry_out(squares(12, {5: batch_work.deadly}), tmp_path, runner)
    assert (report.done, report.failed) == (11, 1)
    entry = json.loads(report.manifest.read_text())["entries"][5]
    assert (entry["status"], entry["diagnostics"][0]["code"]) == ("failed", "LK892")


def test_what_is_raised_in_a_worker_fails_its_task_alone(
    runner: Runner, squares: Squares, tmp_path: Path
) -> None:
    others = {1: batch_work.faulty, 3: batch_work.crashing, 4: batch_work.unspeakable}
    report = carry_out(squares(6, others), tmp_path, runner)
    assert (report.done, report.failed) == (3, 3)
    entries = json.loads(report.manifest.read_text())["entries"]
    codes = [[d["code"] for d in entry["diagnostics"]] for entry in entries]
    assert codes == [[], ["LK203"], [], ["LK901"], ["LK901"], []]


def test_inputs_that_cannot_be_had_fail_their_tasks_alone(runner: Runner, tmp_path: Path) -> None:
    class Missing:
        digest = ""

        def load(self) -> Shared:
            batch_work.faulty(Task("input", batch_work.faulty), Shared())
            raise AssertionError

    own = [Shared({"tail": bytes([number])}) for number in range(4)]
    sources = [own[0], Missing(), own[1], own[2], own[0], Missing(), own[3], own[0]]
    tasks = [Task(f"{n}", batch_work.square, {"number": n}, source) for n, source in enumerate(sources)]
    finished: dict[str, Finished] = {f.key: f for f in runner.run(tasks)}
    assert [finished[str(n)].status == "failed" for n in range(8)] == [n in (1, 5) for n in range(8)]
    assert finished["7"].files == (("7.txt", b"49\n\0"),)
    assert finished["6"].files == (("6.txt", b"36\n\3"),)


def test_no_more_tasks_are_taken_than_workers_need(runner: Runner) -> None:
    taken: list[int] = []

    def tasks() -> Iterator[Task]:
        for number in range(40):
            taken.append(number)
            yield Task(str(number), batch_work.large, {"size": 200_000})

    ahead = [len(taken) - done for done, _ in enumerate(runner.run(tasks()), 1)]
    assert len(taken) == 40
    assert max(ahead) <= 2 * 2, "at most two for each worker are under way"


def test_no_more_processes_are_started_than_there_are_tasks(
    squares: Squares, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[int] = []
    begin = _Worker.started

    def counted() -> _Worker:
        started.append(1)
        return begin()

    monkeypatch.setattr(_Worker, "started", counted)
    assert len(list(Processes(6).run(squares(2).tasks))) == 2
    assert len(started) == 2


def test_a_run_that_is_left_ends_its_workers(squares: Squares) -> None:
    import multiprocessing

    before = set(multiprocessing.active_children())
    running = Processes(2).run(squares(20).tasks)
    next(running)
    assert set(multiprocessing.active_children()) - before
    running.close()
    assert not set(multiprocessing.active_children()) - before


def test_processes_that_do_not_begin_are_told(squares: Squares, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("layoutkit.batch.processes._serve", batch_work.deadly)
    with pytest.raises(Faulty) as faulty:
        list(Processes(2).run(squares(4).tasks))
    assert faulty.value.diagnostics[0].code == "LK895"


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nowhere", "tcp://127.0.0.1:none"])
def test_a_cluster_that_is_not_there_is_told(address: str, squares: Squares) -> None:
    with pytest.raises(Faulty) as faulty:
        list(Cluster(address, 0).run(squares(1).tasks))
    assert faulty.value.diagnostics[0].code == "LK893"


def test_workers_that_differ_are_told() -> None:
    own = {**survey(), "plugin 'golden'": "golden 1.0", "plugin 'slow'": "slow 2"}
    assert own["layoutkit"] == __version__
    theirs = {**own, "numpy": "0.1", "plugin 'golden'": "golden 0.9"}
    del theirs["plugin 'slow'"]
    told = list(differences(own, {"tcp://a": theirs, "tcp://b": own}, without=["slow"]))
    assert Counter(d.severity for d in told) == {Severity.WARNING: 1, Severity.ERROR: 1}
    assert {d.code for d in told} == {"LK894"}
    assert "tcp://a has another plugin 'golden': golden 0.9, and golden 1.0 here" in told[1].message
    assert [d.severity for d in differences({"layoutkit": "1"}, {"bare": {}})] == [Severity.ERROR]
