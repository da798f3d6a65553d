"""`layoutkit replay`: models and pictures of every tile, the same bytes whoever makes them."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest
import trimesh
from built import FACADE, box, scene

from layoutkit.documents import operations_bytes, scene_bytes
from layoutkit.model import Polygon, Scene
from layoutkit.operations import Branch, Design, Node, Operations
from layoutkit_operations.kinds import Extrude, Select, Vary

JOURNAL = ".layoutkit-journal.jsonl"


@pytest.fixture
def files(tmp_path):
    """Operations for sites, a scene of nine, and a facade beside them."""
    (tmp_path / "wall.xml").write_text(FACADE)
    tall = Node(Extrude(height=6, random=0.3, cap="hip"))
    fronts = Node(Select(labels=("Front",)), (Node(Vary(facade=Design("wall.xml"))),))
    low = Node(Extrude(height=3.2, cap="gable"), (fronts,))
    root = Node(Select(labels=("Plot",)), (), (Branch((low,)), Branch((tall,), 2.0)))
    operations = Operations("rows", "m", (root,), ("Plot",))
    (tmp_path / "operations.xml").write_bytes(operations_bytes(operations))
    outlines = [box(14 * (n % 3), 20 * (n // 3), 10, 8) for n in range(9)]
    street = Polygon("Street", box(0, 10, 40, 6), ("Street",))
    plots = Scene("nine", "m", (*scene(*outlines).polygons, street))
    (tmp_path / "nine.xml").write_bytes(scene_bytes(plots))
    return tmp_path


def arguments(files, folder, *options):
    own = ("replay", files / "operations.xml", files / "nine.xml", "-o", files / folder, "--width", "300")
    return [*map(str, own), *options]


def contents(folder):
    found = sorted(path for path in folder.rglob("*") if path.is_file() and path.name != JOURNAL)
    return {path.name: path.read_bytes() for path in found}


def program(files, folder, *options):
    command = [sys.executable, "-m", "layoutkit", *arguments(files, folder, *options)]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def waited(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "nothing came of it"
        time.sleep(0.02)


def test_one_command_makes_a_model_and_pictures_from_two_sides(files, layoutkit):
    run = layoutkit(*arguments(files, "out"))
    assert run.code == 0
    assert "1 of 1 models done" in run.out
    assert set(contents(files / "out")) == {
        "manifest.json",
        "nine.glb",
        "nine-south-west.png",
        "nine-north-east.png",
    }
    model = trimesh.load(files / "out" / "nine.glb")
    assert {f"{letter}" for letter in "ABCDEFGHI"} <= set(model.graph.nodes)
    (entry,) = json.loads((files / "out" / "manifest.json").read_text())["entries"]
    assert entry["summary"]["solids"] == 9


@pytest.mark.parametrize("options", [("--workers", "2"), ("--scheduler", "local", "--workers", "2")])
def test_the_bytes_are_the_same_with_processes_and_dask(files, layoutkit, options):
    assert layoutkit(*arguments(files, "one", "--tile", "3", "--view", "75")).code == 0
    assert layoutkit(*arguments(files, "two", "--tile", "3", "--view", "75", *options)).code == 0
    one = contents(files / "one")
    assert len(one) == 9
    assert one == contents(files / "two")


def test_tiles_hold_near_sites_and_what_lies_around_them(files, layoutkit):
    run = layoutkit(*arguments(files, "out", "--tile", "3", "--no-views", "--json"))
    assert run.data["done"] == 4
    names = [set(trimesh.load(file).graph.nodes) for file in sorted((files / "out").glob("*.glb"))]
    built = [{name for name in own if len(name) == 1} for own in names]
    assert sorted(name for own in built for name in own) == list("ABCDEFGHI")
    assert all(0 < len(own) <= 3 for own in built)
    assert any("Street" in own for own in names)


def test_a_site_is_built_alike_in_any_tile(files, layoutkit):
    layoutkit(*arguments(files, "whole", "--no-views", "--seeds", "5"))
    layoutkit(*arguments(files, "tiles", "--no-views", "--seeds", "5", "--tile", "2"))

    def extents(folder):
        models = [trimesh.load(file) for file in sorted((files / folder).glob("*.glb"))]
        return {
            n: g.extents.round(5).tolist() for m in models for n, g in m.geometry.items() if n[0] in "ABC"
        }

    assert extents("whole") == extents("tiles")


def test_formats_sides_and_seeds_are_as_asked(files, layoutkit):
    asked = ("--format", "obj", "--format", "cityjson", "--view", "120", "--seeds", "1-2")
    assert layoutkit(*arguments(files, "out", *asked)).code == 0
    names = set(contents(files / "out"))
    assert {
        f"nine-s{seed}{end}" for seed in (1, 2) for end in (".obj", ".mtl", ".city.json", "-120.png")
    } <= names
    assert contents(files / "out")["nine-s1.obj"] != contents(files / "out")["nine-s2.obj"]


@pytest.mark.parametrize("options", [("--workers", "2"), ("--scheduler", "local", "--workers", "2")])
def test_a_worker_killed_in_the_middle_loses_and_repeats_nothing(files, layoutkit, options):
    own = ("--tile", "1", "--seeds", "0-1", "--view", "east")
    running = program(files, "killed", *own, *options)
    waited(lambda: (files / "killed" / JOURNAL).exists())
    waited(lambda: (files / "killed" / JOURNAL).read_text().count("\n") > 3)
    os.kill(int(_children(running.pid)[-1]), signal.SIGKILL)
    assert running.poll() is None, "it was killed in the middle"
    assert running.wait(120) == 0
    assert layoutkit(*arguments(files, "whole", *own)).code == 0
    assert contents(files / "killed") == contents(files / "whole")
    keys = [json.loads(line).get("key") for line in (files / "killed" / JOURNAL).read_text().splitlines()[1:]]
    assert len(keys) == len(set(keys)) == 18


def test_a_run_that_is_killed_goes_on_where_it_was(files, layoutkit):
    own = ("--tile", "1", "--seeds", "0-1", "--no-views")
    running = program(files, "killed", *own)
    waited(lambda: (files / "killed" / JOURNAL).exists())
    waited(lambda: (files / "killed" / JOURNAL).read_text().count("\n") > 3)
    running.kill()
    running.wait()
    before = (files / "killed" / JOURNAL).read_text().count("\n") - 1
    run = layoutkit(*arguments(files, "killed", *own, "--json"))
    assert run.data["kept"] >= before
    layoutkit(*arguments(files, "whole", *own))
    assert contents(files / "killed") == contents(files / "whole")


def test_remarks_that_are_alike_are_counted(files, layoutkit):
    low = (files / "operations.xml").read_text().replace('height="3.2"', 'height="2"')
    (files / "operations.xml").write_text(low)
    run = layoutkit(*arguments(files, "out", "--tile", "1", "--seeds", "0-2", "--no-views"))
    assert run.code == 0
    entries = json.loads((files / "out" / "manifest.json").read_text())["entries"]
    every = [d["message"] for entry in entries for d in entry["diagnostics"] if d["code"] == "LK885"]
    others = [message for message in every if message not in run.err]
    assert len(set(every)) - len(set(others)) == 2
    assert len(others) > 2
    assert run.err.count("warning LK885") == 3
    assert f"and {len(others)} more of this kind" in run.err


def test_a_selection_that_chooses_nothing_anywhere_is_told_once(files, layoutkit):
    text = (files / "operations.xml").read_text()
    end = "</operations>"
    (files / "operations.xml").write_text(text.replace(end, f'<select labels="Tree"/>{end}'))
    run = layoutkit(*arguments(files, "none", "--tile", "2", "--no-views"))
    assert run.err.count("LK888") == 1
    assert f"{files / 'operations.xml'}:" in run.err, "named as the user names it"
    tree = '<polygon name="Tree_1" points="1,1 2,1 2,2" labels="Tree"/></scene>'
    (files / "nine.xml").write_text((files / "nine.xml").read_text().replace("</scene>", tree))
    run = layoutkit(*arguments(files, "one", "--tile", "2", "--no-views"))
    assert "LK888" not in run.err


def test_names_of_files_may_be_no_text(files):
    own = files / os.fsdecode(b"o\xff.xml")
    own.write_text((files / "operations.xml").read_text().replace('height="3.2"', 'height="2"'))
    asked = ["replay", own, files / "nine.xml", "--no-views", "--seeds", "0-1", "-o", files / "out"]
    run = subprocess.run([sys.executable, "-m", "layoutkit", *asked], capture_output=True)
    assert (run.returncode, b"o\\udcff.xml:" in run.stderr) == (0, True)
    entries = json.loads((files / "out" / "manifest.json").read_text())["entries"]
    assert {d["place"]["file"] for entry in entries for d in entry["diagnostics"]} == {own.name}


def test_what_cannot_be_replayed_is_told(files, layoutkit, tmp_path):
    run = layoutkit("replay", files / "nine.xml", files / "nine.xml", "-o", files / "out")
    assert (run.code, "LK101" in run.err) == (1, True)
    run = layoutkit(*arguments(files, "out", "--view", "nowhere"))
    assert (run.code, "LK701" in run.err) == (2, True)
    assert "degrees" in run.err
    run = layoutkit(*arguments(files, "out", "--view", "south", "--no-views"))
    assert (run.code, "LK701" in run.err) == (2, True)
    picture = '<picture file="wall.png" left="0" top="0" right="9" bottom="9"/>'
    (files / "wall.xml").write_text(FACADE.replace("<region", f"{picture}<region", 1))
    (files / "wall.png").write_bytes(b"no picture")
    run = layoutkit(*arguments(files, "out", "--workers", "2"))
    assert (run.code, run.err.count("LK010"), "wall.png" in run.err) == (1, 1, True)
    (files / "wall.xml").write_text(FACADE)
    assert not (files / "out").exists()
    (tmp_path / "pixels.xml").write_text((files / "nine.xml").read_text().replace('units="m"', 'units="px"'))
    run = layoutkit("replay", files / "operations.xml", tmp_path / "pixels.xml", "-o", files / "px")
    assert (run.code, "LK881" in run.err) == (1, True)


def _children(pid):
    """Processes that a process has started, and those that these have."""
    found = []
    for process in os.listdir("/proc"):
        if process.isdigit():
            try:
                with open(f"/proc/{process}/stat") as stat:
                    parent = int(stat.read().rpartition(")")[2].split()[1])
                with open(f"/proc/{process}/cmdline") as line:
                    words = line.read()
            except OSError:
                continue
            if parent == pid and "resource_tracker" not in words and "forkserver" not in words:
                found.append(process)
            if parent == pid:
                found = [*_children(int(process)), *found]
    return found
