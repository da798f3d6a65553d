"""Each command does what it says: results, files, JSON."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from PIL import Image

from layoutkit.model import place

TOY = """
    from layoutkit.diagnostics import Diagnostic, Severity
    from layoutkit.hooks import Format, hookimpl
    from layoutkit.model import Facade, Picture, Region

    class Toy(Format):
        name, summary, severity = "toy", "Reads toys.", Severity.WARNING

        def recognises(self, path, head): return head.startswith(b"toy")

        def read(self, path, picture):
            halves = tuple(Region(s, 5.0, 8.0, labels=("Wall",)) for s in "AB")
            root = Region("Facade", 10.0, 8.0, "columns", halves)
            shown = None if picture is None else Picture(str(picture), (0.0, 0.0, 10.0, 8.0))
            said = Diagnostic("LK302", "a crumb", severity=self.severity)
            return Facade(path.stem, "px", root, shown), [said]

    class Doubtful(Toy):
        name, summary = "doubtful", "Reads toys, or so it thinks."
        def recognises(self, path, head): return head.startswith(b"toy twice")

    class Strict(Toy):
        name, summary, severity = "strict-toy", "Minds crumbs.", Severity.ERROR
        def recognises(self, path, head): return False

    @hookimpl
    def layoutkit_formats():
        return [Toy(), Doubtful(), Strict()]
"""


@pytest.fixture
def toy(install: Any, tmp_path: Path) -> Path:
    install("toys", TOY)
    file = tmp_path / "car.toy"
    file.write_text("toy")
    return file


def test_convert_names_the_picture_from_where_the_document_lies(
    toy: Path, tmp_path: Path, layoutkit: Any
) -> None:
    image = tmp_path / "photos" / "car.png"
    output = tmp_path / "new" / "folder" / "car.xml"
    run = layoutkit("convert", toy, "-o", output, "--image", image, "--json")
    assert run.code == 0
    assert run.data == {
        "document": str(output),
        "regions": 3,
        "terminals": 2,
        "diagnostics": json.loads(run.out)["diagnostics"],
    }
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK302"]
    assert "warning LK302" in run.err
    shown = layoutkit("inspect", output, "--json").data
    assert shown["picture"] == {"file": "../../photos/car.png", "box": [0, 0, 10, 8]}


def test_convert_says_what_it_made(toy: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("convert", toy, "-o", tmp_path / "car.xml")
    assert (run.code, run.out) == (0, f"{tmp_path / 'car.xml'}: 3 regions, 2 of them terminals\n")


def test_convert_with_errors_writes_what_it_has_and_exits_1(
    toy: Path, tmp_path: Path, layoutkit: Any
) -> None:
    run = layoutkit("convert", toy, "-o", tmp_path / "car.xml", "--format", "strict-toy")
    assert run.code == 1
    assert (tmp_path / "car.xml").exists()


def test_convert_does_not_guess_between_two_formats(toy: Path, tmp_path: Path, layoutkit: Any) -> None:
    toy.write_text("toy twice")
    run = layoutkit("convert", toy, "-o", tmp_path / "car.xml")
    assert run.code == 2
    assert "several formats recognise this file" in run.err
    assert "doubtful: Reads toys, or so it thinks." in run.err
    assert layoutkit("convert", toy, "-o", tmp_path / "car.xml", "--format", "toy").code == 0


def test_convert_of_what_no_format_recognises_lists_them(toy: Path, tmp_path: Path, layoutkit: Any) -> None:
    toy.write_text("no toy")
    run = layoutkit("convert", toy, "-o", tmp_path / "car.xml")
    assert run.code == 2
    assert "no format recognises this file" in run.err
    assert "toy: Reads toys." in run.err


def test_convert_with_an_unknown_format_suggests_one(toy: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("convert", toy, "-o", tmp_path / "car.xml", "--format", "doubtfull")
    assert run.code == 2
    assert "did you mean 'doubtful'?" in run.err


def test_inspect_as_json(house: Path, layoutkit: Any) -> None:
    run = layoutkit("inspect", house, "--json")
    assert (run.code, run.err) == (0, "")
    regions = run.data["regions"]
    assert {key: value for key, value in run.data.items() if key != "regions"} == {
        "kind": "facade",
        "name": "house",
        "units": "m",
        "width": 6.0,
        "height": 4.0,
        "picture": {"file": "photo.png", "box": [0.0, 0.0, 60.0, 40.0]},
        "grids": [],
    }
    assert [r["path"] for r in regions] == [
        "Facade",
        "Facade/Pier",
        "Facade/Bay",
        "Facade/Bay/Top",
        "Facade/Bay/Opening",
        "Facade/Bay/Bottom",
        "Facade/Pier.2",
        "Facade/Bay.2",
        "Facade/Bay.2/Top",
        "Facade/Bay.2/Opening",
        "Facade/Bay.2/Bottom",
        "Facade/Pier.3",
    ]
    assert regions[4] == {
        "path": "Facade/Bay/Opening",
        "symbol": "Opening",
        "labels": ["Window", "Glass"],
        "terminal": True,
        "box": [1.0, 1.0, 2.5, 3.0],
    }
    assert regions[7]["box"] == [3.5, 0.0, 5.0, 4.0]


def test_inspect_as_a_tree(house: Path, layoutkit: Any) -> None:
    lines = layoutkit("inspect", house).out.splitlines()
    assert lines[:6] == [
        "facade house: 6 × 4 m",
        "picture photo.png: 0 0 60 40",
        "Facade 6 × 4 columns",
        "├── Pier @Wall 1 × 4",
        "├── Bay 1.5 × 4 rows",
        "│   ├── Top @Wall 1.5 × 1",
    ]
    assert lines[-1] == "└── Pier @Wall 1 × 4"


def test_inspect_imports_nothing_heavy(house: Path) -> None:
    program = (
        f"import sys; from layoutkit.cli.app import main; main(['inspect', {str(house)!r}, '--json']);"
        "print([m for m in ('numpy', 'scipy', 'lxml', 'PIL', 'rich') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"


def test_validate_goes_on_to_the_last_file(house: Path, layoutkit: Any) -> None:
    broken = house.with_name("broken.xml")
    broken.write_text(
        house.read_text().replace('width="1.5"', 'width="1.6"').replace("Facade/Pier", "Facade/Peer")
    )
    run = layoutkit("validate", broken, house.with_name("absent.xml"), house)
    assert run.code == 1
    assert run.out.splitlines() == [
        f"{broken}: 2 errors",
        f"{house.with_name('absent.xml')}: 1 error",
        f"{house}: valid",
        "3 documents: 1 valid, 2 with errors (3 errors); `--fix` may mend some of it",
    ]
    assert run.err.count("error LK") == 3
    data = layoutkit("validate", broken, house, "--json").data
    assert data["documents"] == [
        {"document": str(broken), "valid": False},
        {"document": str(house), "valid": True},
    ]
    assert sorted(d["code"] for d in data["diagnostics"]) == ["LK201", "LK212"]


def test_validate_of_valid_files(house: Path, bare_house: Path, layoutkit: Any) -> None:
    run = layoutkit("validate", house, bare_house)
    assert (run.code, run.err) == (0, "")


def test_render_png_and_svg(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    png, svg = tmp_path / "new" / "house.PNG", tmp_path / "house.svg"
    assert layoutkit("render", house, "-o", png).out == f"{png}\n"
    with Image.open(png) as picture, Image.open(house.with_name("photo.png")) as photo:
        assert picture.tobytes() == photo.tobytes(), "a facade is drawn as its photo"
    layoutkit("render", house, "-o", png, "--scale", 2)
    with Image.open(png) as picture:
        assert picture.size == (120, 80)
    layoutkit("render", house, "-o", svg)
    assert ElementTree.fromstring(svg.read_bytes()).tag.endswith("svg")


def test_render_of_a_facade_whose_photo_is_gone_says_so(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    house.with_name("photo.png").unlink()
    run = layoutkit("render", house, "-o", tmp_path / "house.png")
    assert run.code == 1
    assert "error LK010" in run.err
    assert not (tmp_path / "house.png").exists()


def test_plugins_lists_what_each_adds(install: Any, layoutkit: Any) -> None:
    install("toys", TOY)
    data = layoutkit("plugins", "--json").data
    adds = {plugin["name"]: plugin for plugin in data["plugins"]}
    assert adds["toys"] == {
        "name": "toys",
        "package": "acme-plugin",
        "version": "1.2",
        "adds": {"formats": ["toy", "doubtful", "strict-toy"]},
    }
    assert "size" in adds["builtin"]["adds"]["constraints"]
    text = layoutkit("plugins").out
    assert "toys (acme-plugin 1.2)\n  formats: toy, doubtful, strict-toy\n" in text


def test_plugins_names_what_failed(install: Any, layoutkit: Any) -> None:
    install("broken", "1 / 0")
    run = layoutkit("plugins", "--json")
    assert run.code == 5
    names = ["builtin", "editing", "formats", "operations", "placement", "relayout"]
    assert [plugin["name"] for plugin in run.data["plugins"]] == names
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK401"]
    assert "ZeroDivisionError" in run.err
    strict = layoutkit("--strict", "plugins")
    assert (strict.code, strict.out) == (5, "")
    assert layoutkit("--without", "broken", "plugins").code == 0


CONSTRAINT = """
    from dataclasses import dataclass
    from layoutkit.constraints import Constraint
    from layoutkit.constraints.attributes import COUNT, attribute
    from layoutkit.constraints.namespace import Namespace
    from layoutkit.hooks import hookimpl

    @dataclass(frozen=True, kw_only=True)
    class Quiet(Constraint):
        kind = "quiet"
        namespace = Namespace("hush", "urn:hush:1")
        summary = "Demands nothing, in a loud voice."
        volume: int = attribute(COUNT, "How loud.", 3)
        def violations(self, view): return iter(())

    @hookimpl
    def layoutkit_constraints():
        return [Quiet]
"""


def test_a_plugins_constraint_is_read_and_in_the_schema(install: Any, house: Path, layoutkit: Any) -> None:
    element = '<h:quiet xmlns:h="urn:hush:1" volume="4"/>'
    house.write_text(house.read_text().replace("<constraints>", f"<constraints>\n{element}"))
    without = layoutkit("inspect", house)
    assert without.code == 1
    assert "no plugin that is loaded has constraints of the namespace 'urn:hush:1'" in without.err
    install("quiet_plugin", CONSTRAINT)
    assert layoutkit("inspect", house).code == 0
    assert "Demands nothing, in a loud voice." in layoutkit("schema", "--namespace", "hush").out
    assert 'ref="hush:quiet"' in layoutkit("schema").out
    house.write_text(house.read_text().replace(element, "<quiet/>"))
    plain = layoutkit("inspect", house)
    assert plain.code == 1
    assert 'hint: write <hush:quiet xmlns:hush="urn:hush:1" ...>' in plain.err


def test_schema_goes_to_stdout_or_a_file(tmp_path: Path, layoutkit: Any) -> None:
    printed = layoutkit("schema")
    assert printed.code == 0
    assert layoutkit("schema", "-o", tmp_path / "layoutkit.xsd").code == 0
    assert (tmp_path / "layoutkit.xsd").read_text(encoding="utf-8") == printed.out


def test_place_and_inspect_agree_on_every_sample(layoutkit: Any) -> None:
    from layoutkit.documents import read
    from layoutkit.hooks.host import Host

    for file in sorted(Path("facades").glob("*/facade.xml")):
        regions = layoutkit("inspect", file, "--json").data["regions"]
        placed = list(place(read(file, Host.load().constraints).model.root))
        assert [(r["path"], tuple(r["box"])) for r in regions] == [(p.path, tuple(p.box)) for p in placed]
        assert len({r["path"] for r in regions}) == len(regions)
