"""`vary` and `infer`: folders that stand on their own, the same bytes anywhere, and how a search may end."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.documents import check, read
from layoutkit.hooks.host import Host
from layoutkit.model import Layout
from layoutkit.samples import list_pipelines, sample_path

#: Stages that lay the house out by scaling it, and end as the node limit tells them.
STAGES = """
    from dataclasses import dataclass, replace
    from layoutkit.constraints import Size
    from layoutkit.diagnostics import Diagnostic
    from layoutkit.hooks import Outcome, Stage, hookimpl
    from layoutkit.model import Layout, Measure, RegionSet

    FULL = Measure(1.0, True)

    @dataclass(frozen=True)
    class Options:
        count: int = 1
        width: Measure = FULL
        height: Measure = FULL
        seed: int = 0
        node_limit: int = 99

    def grown(region, x, y):
        children = tuple(grown(child, x, y) for child in region.children)
        return replace(region, width=region.width * x, height=region.height * y, children=children)

    def shifted(root):
        first, *rest = root.children
        return replace(root, children=(replace(first, width=first.width + 0.5), *rest))

    class Relayout(Stage):
        name, summary, options = "relayout", "Scales.", Options

        def run(self, facade, options):
            if options.node_limit == 7:
                raise KeyError("seven")
            if options.node_limit == 1:
                yield Outcome("infeasible", None, (Diagnostic("LK203", "cannot hold together"),))
                return
            x = options.width.of(facade.root.width) / facade.root.width
            y = options.height.of(facade.root.height) / facade.root.height
            for index in range(options.count):
                if options.node_limit == 2 and index == 1:
                    yield Outcome("limit", None, (Diagnostic("LK601", "gave up"),))
                    continue
                root = grown(facade.root, x, y)
                root = shifted(root) if options.node_limit == 3 else root
                name = f"{facade.name}-{index + 1}"
                layout = Layout(name, facade.units, root, facade, seed=options.seed, index=index)
                yield Outcome("found", layout, (), 0.25)

    @dataclass(frozen=True)
    class Freedom:
        freedom: str = "medium"

    class Infer(Stage):
        name, summary, options = "infer", "Finds a size.", Freedom

        def run(self, facade, options):
            size = Size(of=RegionSet("Facade/Bay"), min=FULL, comment=f"as {options.freedom} has it")
            yield Outcome("found", replace(facade, constraints=(*facade.constraints, size)))

    @hookimpl
    def layoutkit_stages():
        return [Relayout(), Infer()]
"""


@pytest.fixture
def stages(install: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    install("told_stages", STAGES)
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", "relayout")


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in sorted(folder.iterdir())}


@pytest.mark.usefixtures("stages")
def test_a_result_folder_stands_on_its_own(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "deep" / "out"
    run = layoutkit(
        "vary", house, "-n", 2, "--seed", 5, "--width", "120%", "--height", 5, "-o", out, "--json"
    )
    assert (run.code, run.err) == (0, "")
    assert run.data == {
        "status": "found",
        "seed": 5,
        "variations": [
            {
                "index": index,
                "status": "found",
                "layout": str(out / f"variation-0{index + 1}.xml"),
                "picture": str(out / f"variation-0{index + 1}.png"),
                "seconds": 0.25,
            }
            for index in range(2)
        ],
        "diagnostics": [],
    }
    assert sorted(contents(out)) == [
        "facade.png",
        "facade.xml",
        "sheet.png",
        "variation-01.png",
        "variation-01.xml",
        "variation-02.png",
        "variation-02.xml",
    ]
    moved = out.rename(tmp_path / "elsewhere")
    shutil.rmtree(house.parent)
    kinds = Host.load().constraints
    layout = read(moved / "variation-02.xml", kinds).model
    assert isinstance(layout, Layout)
    assert (layout.name, layout.seed, layout.index) == ("house-2", 5, 1)
    assert (layout.root.width, layout.root.height) == (pytest.approx(7.2), 5)
    assert layout.facade is not None
    assert layout.facade.picture is not None
    assert layout.facade.picture.file == "facade.png"
    assert layout.picture is not None
    with Image.open(moved / layout.picture.file) as picture:
        assert layout.picture.box == (0, 0, *picture.size)
        assert picture.size == (72, 50)
    assert [check(moved / f"variation-0{k}.xml", kinds) for k in (1, 2)] == [[], []]
    assert layoutkit("render", moved / "variation-01.xml", "-o", moved / "again.png").code == 0
    assert (moved / "again.png").read_bytes() == (moved / "variation-01.png").read_bytes()


@pytest.mark.usefixtures("stages")
def test_the_copy_of_the_facade_keeps_what_the_user_wrote(
    house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    layoutkit("vary", house, "-n", 1, "-o", tmp_path / "out")
    expected = house.read_text(encoding="utf-8").replace('file="photo.png"', 'file="facade.png"')
    assert (tmp_path / "out" / "facade.xml").read_text(encoding="utf-8") == expected
    assert (tmp_path / "out" / "facade.png").read_bytes() == house.with_name("photo.png").read_bytes()


@pytest.mark.usefixtures("stages")
@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig", "iso-8859-1"])
def test_the_copy_keeps_the_encoding(encoding: str, house: Path, tmp_path: Path, layoutkit: Any) -> None:
    declared = encoding.removesuffix("-sig")
    text = house.read_text(encoding="utf-8").replace("UTF-8", declared).replace("⊢", "|-").replace("⊣", "-|")
    text = text.replace("drawn by hand", "von Hand, für später").replace("photo.png", "fön.png")
    house.with_name("photo.png").rename(house.with_name("fön.png"))
    house.write_text(text, encoding=encoding)
    run = layoutkit("vary", house, "-n", 1, "-o", tmp_path / "out")
    assert (run.code, run.err) == (0, "")
    copied = (tmp_path / "out" / "facade.xml").read_text(encoding=encoding)
    assert copied == text.replace("fön.png", "facade.png")


@pytest.mark.usefixtures("stages")
def test_the_same_seed_gives_the_same_bytes_in_any_folder(
    house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    other = shutil.copytree(house.parent, tmp_path / "a" / "copy of it") / house.name
    for document, out in ((house, tmp_path / "one"), (other, tmp_path / "b" / "two")):
        assert layoutkit("vary", document, "-n", 3, "-o", out).code == 0
    assert contents(tmp_path / "one") == contents(tmp_path / "b" / "two")


@pytest.mark.usefixtures("stages")
def test_a_facade_without_constraints_gets_inferred_ones(
    bare_house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    run = layoutkit("vary", bare_house, "-n", 1, "-o", tmp_path / "out", "--json")
    assert run.code == 0
    assert [(d["code"], d["severity"]) for d in run.data["diagnostics"]] == [("LK602", "note")]
    assert "note LK602" in run.err
    copy = (tmp_path / "out" / "facade.xml").read_text(encoding="utf-8")
    assert '<size of="Facade/Bay" min="100%"/>' in copy
    assert "<!-- as medium has it -->" in copy
    assert "<!-- drawn by hand -->" in copy


@pytest.mark.usefixtures("stages")
@pytest.mark.parametrize(
    ("limit", "status", "code", "files"), [(1, "infeasible", 3, []), (2, "limit", 4, [1, 3])]
)
def test_how_a_search_may_end(
    limit: int, status: str, code: int, files: list[int], house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    out = tmp_path / "out"
    run = layoutkit("vary", house, "-n", 3, "-o", out, "--node-limit", limit, "--json")
    assert run.code == code
    assert run.data["status"] == status
    layouts = [str(out / f"variation-0{number}.xml") for number in files]
    listed = run.data["variations"]
    assert [v["layout"] for v in listed if v["layout"] is not None] == layouts
    assert [v["index"] for v in listed if v["status"] == "found"] == [number - 1 for number in files]
    assert all(
        (v["status"] == "found") == (v["layout"] is not None) == (v["picture"] is not None) for v in listed
    )
    assert {v["status"] for v in listed} == {"found", status} - (set() if files else {"found"})
    assert [str(path) for path in sorted(out.glob("variation-*.xml"))] == layouts
    assert (out / "sheet.png").exists() == bool(files)
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK203" if limit == 1 else "LK601"]
    assert layoutkit("vary", house, "-n", 3, "-o", out, "--node-limit", limit).code == code


@pytest.mark.usefixtures("stages")
def test_a_layout_that_breaks_its_constraints_is_never_written(
    house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    run = layoutkit("vary", house, "-n", 2, "-o", tmp_path / "out", "--node-limit", 3)
    assert run.code == 70
    assert "error LK902" in run.err
    assert list((tmp_path / "out").glob("variation*")) == []


@pytest.mark.usefixtures("stages")
def test_a_stage_that_raises_is_its_packages_fault(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("vary", house, "-o", tmp_path / "out", "--node-limit", 7, "--json")
    assert run.code == 5
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK407"]


@pytest.mark.usefixtures("stages")
def test_the_input_is_never_overwritten(house: Path, layoutkit: Any) -> None:
    facade = house.rename(house.with_name("facade.xml"))
    before = contents(facade.parent)
    run = layoutkit("vary", facade, "-o", facade.parent)
    assert run.code == 2
    assert "error LK704" in run.err
    assert "name another folder with -o" in run.err
    assert contents(facade.parent) == before


@pytest.mark.usefixtures("stages")
def test_files_of_an_earlier_run_are_pointed_out(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    assert layoutkit("vary", house, "-n", 3, "-o", tmp_path / "out").err == ""
    assert layoutkit("vary", house, "-n", 3, "-o", tmp_path / "out").err == ""
    run = layoutkit("vary", house, "-n", 2, "-o", tmp_path / "out")
    assert run.code == 0
    assert "warning LK705 usage: 2 files of an earlier run are still here: variation-03.png" in run.err


@pytest.mark.usefixtures("stages")
def test_a_layout_is_no_input(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    layoutkit("vary", house, "-n", 1, "-o", tmp_path / "out")
    for command in ("vary", "infer"):
        run = layoutkit(command, tmp_path / "out" / "variation-01.xml", "-o", tmp_path / "x")
        assert run.code == 2
        assert f"error LK702 usage: {command} takes a facade" in run.err


@pytest.mark.usefixtures("stages")
def test_a_photo_that_is_gone_is_an_error(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    house.with_name("photo.png").unlink()
    run = layoutkit("vary", house, "-o", tmp_path / "out")
    assert run.code == 1
    assert "error LK010" in run.err


@pytest.mark.usefixtures("stages")
def test_without_a_photo_labels_give_the_colours(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    lines = [line for line in house.read_text(encoding="utf-8").splitlines() if "<picture" not in line]
    house.write_text("\n".join(lines), encoding="utf-8")
    run = layoutkit("vary", house, "-n", 1, "-o", tmp_path / "out", "--scale", 0.5)
    assert (run.code, run.err) == (0, "")
    names = ["facade.xml", "sheet.png", "variation-01.png", "variation-01.xml"]
    assert sorted(contents(tmp_path / "out")) == names
    with Image.open(tmp_path / "out" / "variation-01.png") as picture:
        assert picture.size == (150, 100)


@pytest.mark.usefixtures("stages")
def test_infer_keeps_the_text_and_names_the_picture_from_its_new_folder(
    bare_house: Path, tmp_path: Path, layoutkit: Any
) -> None:
    output = tmp_path / "new" / "inferred.xml"
    run = layoutkit("infer", bare_house, "-o", output, "--freedom", "loose", "--json")
    assert run.code == 0
    assert run.data["constraints"] == ['size of="Facade/Bay" min="100%"']
    text = output.read_text(encoding="utf-8")
    assert "<!-- as loose has it -->" in text
    assert "<!-- drawn by hand -->" in text
    assert 'file="../house/photo.png"' in text
    assert layoutkit("render", output, "-o", tmp_path / "x.png").code == 0
    assert layoutkit("infer", bare_house, "-o", bare_house.with_name("i.xml")).out.endswith(
        "1 constraints added\n"
    )
    assert 'file="photo.png"' in bare_house.with_name("i.xml").read_text(encoding="utf-8")


def test_without_its_stage_vary_says_what_is_missing(
    house: Path, tmp_path: Path, layoutkit: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LAYOUTKIT_DISABLE_PLUGINS", "relayout")
    run = layoutkit("vary", house, "-o", tmp_path / "out")
    assert run.code == 2
    assert "error LK406 plugin: there is no stage 'relayout'" in run.err


@pytest.mark.parametrize("name", ["plain", "palace"])
def test_two_commands_make_variations_of_a_sample(
    name: str, tmp_path: Path, layoutkit: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert layoutkit("samples", name).code == 0
    run = layoutkit(
        "vary", os.path.join(name, "facade.xml"), "-n", 3, "--width", "120%", "-o", "out", "--json"
    )
    assert run.code == 0
    kinds = Host.load().constraints
    assert [check(Path(v["layout"]), kinds) for v in run.data["variations"]] == [[], [], []]
    assert layoutkit("vary", f"{name}/facade.xml", "-n", 3, "--width", "120%", "-o", "again").code == 0
    assert contents(tmp_path / "out") == contents(tmp_path / "again")


def test_samples_lists_and_copies_and_does_not_overwrite(tmp_path: Path, layoutkit: Any) -> None:
    names = [sample["name"] for sample in layoutkit("samples", "--json").data["samples"]]
    assert {"plain", "palace"} <= set(names)
    assert all(name in layoutkit("samples").out for name in names)
    pipelines = {sample.name for sample in list_pipelines()}  # tested by themselves
    for name in set(names) - pipelines:
        run = layoutkit("samples", name, "-o", tmp_path / name, "--json")
        document = Path(run.data["document"])
        assert (document.parent, run.data["diagnostics"]) == (tmp_path / name, [])
        assert layoutkit("validate", tmp_path / name).code == 0  # all documents that came
        assert layoutkit("render", document, "-o", tmp_path / "x.png").code == 0
    assert layoutkit("samples", "plain", "-o", tmp_path / "plain").code == 0
    document = tmp_path / "plain" / "facade.xml"
    document.write_text(document.read_text(encoding="utf-8") + "<!-- mine -->", encoding="utf-8")
    run = layoutkit("samples", "plain", "-o", tmp_path / "plain")
    assert run.code == 2
    assert "error LK704" in run.err
    assert document.read_text(encoding="utf-8").endswith("<!-- mine -->")
    assert layoutkit("samples", "plane").code == 2


def test_a_mass_goes_with_a_facade_and_not_in_its_place(tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("vary", sample_path("block").parent / "mass.xml", "-o", tmp_path / "out")
    assert run.code == 1
    assert "<mass> is no facade" in run.err
