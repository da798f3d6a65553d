"""Runs in one process: what is kept, what is done again, and what is refused."""

from __future__ import annotations

import errno
import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import batch_work
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from layoutkit.batch import Finished, InProcess, Plan, Reread, Shared, Task, Watching, carry_out
from layoutkit.batch.cluster import Cluster
from layoutkit.batch.journal import JOURNAL_FILE, Journal
from layoutkit.diagnostics import Faulty

Squares = Callable[..., Plan]
Same = Callable[[Path, Path], None]


class Counting:
    """Does tasks in this process, and knows which; stops after some, as if it were killed."""

    def __init__(self, most: int = 1_000) -> None:
        self.keys: list[str] = []
        self.most = most

    def run(self, tasks: Iterable[Task]) -> Iterator[Finished]:
        for finished in InProcess().run(tasks):
            if len(self.keys) == self.most:
                raise KeyboardInterrupt
            self.keys.append(finished.key)
            yield finished


def code_of(faulty: pytest.ExceptionInfo[Faulty]) -> str:
    return faulty.value.diagnostics[0].code


def test_files_and_manifest_are_written_in_the_order_of_tasks(squares: Squares, tmp_path: Path) -> None:
    report = carry_out(squares(3), tmp_path, InProcess())
    assert (report.done, report.failed, report.kept) == (3, 0, 0)
    assert (tmp_path / "many" / "2.txt").read_bytes() == b"4\ntail"
    manifest = json.loads(report.manifest.read_text())
    assert manifest["command"] == "squares"
    assert [entry["key"] for entry in manifest["entries"]] == ["many/0", "many/1", "many/2"]
    assert manifest["entries"][2]["summary"] == {"number": 2}
    assert manifest["entries"][2]["files"][0]["bytes"] == 6


def test_two_tasks_of_one_key_are_refused() -> None:
    with pytest.raises(ValueError, match="same key"):
        Plan("squares", [Task("a", batch_work.square), Task("a", batch_work.square)])


def test_what_is_done_is_not_done_again(squares: Squares, tmp_path: Path, same: Same) -> None:
    first, second = Counting(4), Counting()
    with pytest.raises(KeyboardInterrupt):
        carry_out(squares(9), tmp_path / "some", first)
    assert not (tmp_path / "some" / "manifest.json").exists()
    report = carry_out(squares(9), tmp_path / "some", second)
    assert (len(first.keys), len(second.keys), report.kept) == (4, 5, 4)
    assert not set(first.keys) & set(second.keys)
    carry_out(squares(9), tmp_path / "whole", InProcess())
    same(tmp_path / "some", tmp_path / "whole")
    unable = Cluster("nowhere", 0)
    assert carry_out(squares(9), tmp_path / "some", unable).kept == 9, "nothing is started for nothing"


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=25)
@given(data=st.data())
def test_a_journal_torn_anywhere_loses_and_repeats_nothing(
    data: st.DataObject, squares: Squares, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.mktemp("torn")
    carry_out(squares(5), folder, InProcess())
    whole = (folder / "manifest.json").read_bytes()
    journal = folder / JOURNAL_FILE
    lines = journal.read_bytes()
    cut = data.draw(st.integers(0, len(lines)))
    journal.write_bytes(lines[:cut])
    counting = Counting()
    report = carry_out(squares(5), folder, counting)
    assert report.kept == max(0, lines[:cut].count(b"\n") - 1)  # the first line is no task's
    assert len(counting.keys) == 5 - report.kept
    assert (folder / "manifest.json").read_bytes() == whole
    assert carry_out(squares(5), folder, Counting()).kept == 5


def test_a_damaged_line_costs_its_task_alone(squares: Squares, tmp_path: Path) -> None:
    carry_out(squares(4), tmp_path, InProcess())
    journal = tmp_path / JOURNAL_FILE
    lines = journal.read_bytes().splitlines(keepends=True)
    lines[2] = b'{"key": "many/1", "files": 7}\n'
    journal.write_bytes(b"".join(lines))
    counting = Counting()
    carry_out(squares(4), tmp_path, counting)
    assert counting.keys == ["many/1"]


@pytest.mark.parametrize("damage", ["missing", "shorter", "changed"])
def test_a_file_that_is_no_longer_as_it_was_is_made_again(
    damage: str, squares: Squares, tmp_path: Path
) -> None:
    carry_out(squares(3), tmp_path, InProcess())
    file = tmp_path / "many" / "1.txt"
    before = file.read_bytes()
    file.write_bytes(before[:-1] if damage == "shorter" else before.upper())
    if damage == "missing":
        file.unlink()
    counting = Counting()
    carry_out(squares(3), tmp_path, counting)
    assert counting.keys == ["many/1"]
    assert file.read_bytes() == before


def test_what_was_half_written_is_swept_away(squares: Squares, tmp_path: Path, same: Same) -> None:
    with pytest.raises(KeyboardInterrupt):
        carry_out(squares(3), tmp_path / "some", Counting(1))
    (tmp_path / "some" / "many" / ".1.txt.4711-4712.part").write_bytes(b"1")
    carry_out(squares(3), tmp_path / "some", InProcess())
    carry_out(squares(3), tmp_path / "whole", InProcess())
    same(tmp_path / "some", tmp_path / "whole")


def test_failures_are_kept_and_tried_again(squares: Squares, tmp_path: Path) -> None:
    plan = squares(5, {1: batch_work.faulty, 3: batch_work.crashing})
    seen: list[Finished] = []
    report = carry_out(plan, tmp_path, InProcess(), Watching(finish=seen.append))
    assert (report.done, report.failed) == (3, 2)
    assert {f.key: f.diagnostics[0].code for f in seen if f.diagnostics} == {
        "many/1": "LK203",
        "many/3": "LK901",
    }
    entries = json.loads(report.manifest.read_text())["entries"]
    assert [entry["status"] for entry in entries] == ["done", "failed", "done", "failed", "done"]
    assert entries[1]["diagnostics"][0]["message"] == "many/1 cannot be"
    counting = Counting()
    before = report.manifest.read_bytes()
    carry_out(plan, tmp_path, counting)
    assert counting.keys == ["many/1", "many/3"]
    assert report.manifest.read_bytes() == before


@pytest.mark.parametrize(
    "other",
    [
        lambda plan: replace(plan, options={"seed": 2}),
        lambda plan: replace(plan, command="cubes"),
        lambda plan: replace(plan, tasks=plan.tasks[:-1]),
        lambda plan: replace(plan, tasks=[replace(t, source=Shared({"tail": b"x"})) for t in plan.tasks]),
        lambda plan: replace(plan, tasks=[replace(t, arguments={"number": 0}) for t in plan.tasks]),
    ],
    ids=["options", "command", "tasks", "inputs", "arguments"],
)
def test_another_run_is_not_mixed_in(
    other: Callable[[Plan], Plan], squares: Squares, tmp_path: Path, same: Same
) -> None:
    folder = tmp_path / "one"
    carry_out(squares(3), folder, InProcess())
    before = (folder / "manifest.json").read_bytes()
    with pytest.raises(Faulty) as faulty:
        carry_out(other(squares(3)), folder, InProcess())
    assert code_of(faulty) == "LK890"
    assert (folder / "manifest.json").read_bytes() == before
    (folder / "many" / "mine.txt").write_text("not of the run")
    (folder / "many" / "2.txt").write_text("edited")
    carry_out(other(squares(2)), folder, InProcess(), afresh=True)
    assert (folder / "many" / "mine.txt").exists(), "what is no result stays"
    assert (folder / "many" / "2.txt").read_text() == "edited", "as does what is none any more"
    for name in ("mine.txt", "2.txt"):
        (folder / "many" / name).unlink()
    carry_out(other(squares(2)), tmp_path / "two", InProcess())
    same(folder, tmp_path / "two")


def test_other_releases_of_libraries_make_another_run(
    squares: Squares, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    carry_out(squares(3), tmp_path, InProcess())
    monkeypatch.setattr("layoutkit.batch.plan.libraries", lambda: {"numpy": "0.1"})
    with pytest.raises(Faulty) as faulty:
        carry_out(squares(3), tmp_path, InProcess())
    assert code_of(faulty) == "LK890"


def test_a_run_that_failed_stands_in_nobodys_way(squares: Squares, tmp_path: Path, same: Same) -> None:
    carry_out(squares(1, {0: batch_work.faulty}), tmp_path / "one", InProcess())
    carry_out(squares(3), tmp_path / "one", InProcess())
    carry_out(squares(3), tmp_path / "two", InProcess())
    same(tmp_path / "one", tmp_path / "two")


def test_a_run_that_did_nothing_stands_in_nobodys_way(squares: Squares, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        carry_out(squares(3), tmp_path, Counting(0))
    assert carry_out(squares(2), tmp_path, InProcess()).done == 2


def test_two_runs_do_not_write_into_one_folder(squares: Squares, tmp_path: Path) -> None:
    journal = Journal.opened(tmp_path)
    with pytest.raises(Faulty) as faulty:
        carry_out(squares(1), tmp_path, InProcess())
    assert code_of(faulty) == "LK891"
    journal.close()
    assert carry_out(squares(1), tmp_path, InProcess()).done == 1


def test_a_folder_without_locks_is_told(
    squares: Squares, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(stream: Any) -> bool:
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr("layoutkit.batch.journal.locked", refused)
    with pytest.raises(Faulty, match="No locks available") as faulty:
        carry_out(squares(1), tmp_path, InProcess())
    assert code_of(faulty) == "LK008"


def test_a_folder_that_cannot_be_made_is_told(squares: Squares, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(Faulty) as faulty:
        carry_out(squares(1), tmp_path / "file" / "inner", InProcess())
    assert code_of(faulty) == "LK008"


def test_nothing_is_written_outside(squares: Squares, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="outside"):
        carry_out(squares(1, {0: batch_work.outside}), tmp_path / "out", InProcess())
    assert not (tmp_path / "outside.txt").exists()


def test_files_that_are_copied_belong_to_the_manifest(squares: Squares, tmp_path: Path) -> None:
    (tmp_path / "photo.png").write_bytes(b"photo")
    copies = {"many/facade.png": tmp_path / "photo.png", "many/none.png": tmp_path / "none.png"}
    report = carry_out(replace(squares(2), copies=copies), tmp_path / "out", InProcess())
    assert (tmp_path / "out" / "many" / "facade.png").read_bytes() == b"photo"
    assert [copy["name"] for copy in json.loads(report.manifest.read_text())["copies"]] == ["many/facade.png"]
    carry_out(
        Plan("other", [Task("x", batch_work.square, {"number": 1})]),
        tmp_path / "out",
        InProcess(),
        afresh=True,
    )
    assert not (tmp_path / "out" / "many").exists()


def test_inputs_are_read_again_and_must_be_the_same(tmp_path: Path) -> None:
    file = tmp_path / "tail.txt"
    file.write_bytes(b"before")
    source = Reread.of(lambda: Shared({"tail": file.read_bytes()}), "tail.txt")
    tasks = [Task(str(number), batch_work.square, {"number": number}, source) for number in range(2)]
    told: list[Any] = []
    carry_out(Plan("squares", tasks), tmp_path / "one", InProcess(), Watching(finish=told.append))
    assert (tmp_path / "one" / "1.txt").read_bytes() == b"1\nbefore"
    file.write_bytes(b"after")
    carry_out(Plan("squares", tasks), tmp_path / "two", InProcess(), Watching(finish=told.append))
    assert [f.status for f in told] == ["done", "done", "failed", "failed"]
    assert told[-1].diagnostics[0].code == "LK896"


def test_tasks_are_taken_one_by_one(tmp_path: Path) -> None:
    taken: list[int] = []

    def tasks() -> Iterator[Task]:
        for number in range(100):
            taken.append(number)
            yield Task(str(number), batch_work.square, {"number": number})

    for done, _ in enumerate(InProcess().run(tasks())):
        assert len(taken) == done + 1
