"""SVG: shapes, paths, transforms and groups become polygons, y turned upwards."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Faulty
from layoutkit.scenes.features import Features
from tests.scenes_documents.format_reading import read

OPEN = '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="50">'


def drawn(tmp_path: Path, text: str, head: str = OPEN) -> Path:
    path = tmp_path / "drawing.svg"
    path.write_text(f"<?xml version='1.0'?>\n{head}{text}</svg>")
    return path


@pytest.mark.parametrize(
    ("text", "box"),
    [
        ('<rect x="10" y="5" width="20" height="10"/>', (10, 35, 30, 45)),
        ('<rect x="10" y="5" width="20" height="10" transform="translate(5,5)"/>', (15, 30, 35, 40)),
        ('<g transform="scale(2)"><rect width="20" height="10"/></g>', (0, 30, 40, 50)),
        ('<rect width="10" height="20" transform="rotate(-90) translate(-20,0)"/>', (0, 30, 20, 40)),
        ('<polygon points="0,0 10,0 10,10 0,10"/>', (0, 40, 10, 50)),
        ('<path d="M 1 1 h 8 v 8 h -8 z"/>', (1, 41, 9, 49)),
        ('<path d="m 1,1 l 8,0 0,8 -8,0"/>', (1, 41, 9, 49)),
        ('<path d="M1 1H9V9H1Z" fill="none"/>', (1, 41, 9, 49)),
        ('<circle cx="50" cy="25" r="10"/>', (40, 15, 60, 35)),
        ('<ellipse cx="50" cy="25" rx="20" ry="10"/>', (30, 15, 70, 35)),
        ('<path d="M 0 25 A 10 10 0 0 1 20 25 Z"/>', (0, 25, 20, 35)),
    ],
)
def test_shapes(text: str, box: tuple[float, ...], tmp_path: Path) -> None:
    found, codes = read(drawn(tmp_path, text))
    assert found.units == "px"
    assert found.bounds == pytest.approx(box, abs=0.05)
    assert codes == []


def test_the_view_box_is_what_is_shown(tmp_path: Path) -> None:
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" viewBox="10 20 100 50">'
    found, _ = read(drawn(tmp_path, '<rect x="10" y="20" width="50" height="10"/>', head))
    assert found.bounds == pytest.approx((0, 80, 100, 100))


@given(rx=st.floats(1, 400), ry=st.floats(1, 400))
def test_curves_are_round(rx: float, ry: float, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = drawn(tmp_path_factory.mktemp("svg"), f'<ellipse cx="0" cy="0" rx="{rx}" ry="{ry}"/>')
    (polygon,) = read(path)[0].polygons
    area = shapely.Polygon(polygon.points).area
    assert area == pytest.approx(math.pi * rx * ry, rel=0.05)
    if max(rx, ry) < 20 * min(rx, ry):
        assert len(Features.of([polygon]).corner_at) == 0, "its chords turn by less than corners do"


@pytest.mark.parametrize(
    ("text", "labels", "name"),
    [
        ('<rect width="9" height="9" class="Window Big"/>', ("Window", "Big"), "Window_1"),
        ('<rect width="9" height="9" class="a" data-labels="Door"/>', ("Door",), "Door_1"),
        ('<rect width="9" height="9" id="window-12"/>', ("window",), "window-12"),
        ('<g class="Window"><g><rect width="9" height="9" id="w"/></g></g>', ("Window",), "w"),
        ('<g class="Window"><rect width="9" height="9" class="Door"/></g>', ("Door",), "Door_1"),
        ('<defs><rect id="w" width="9" height="9"/></defs><use href="#w" class="Window"/>', ("Window",), "w"),
        ('<rect width="9" height="9"/>', (), "Polygon_1"),
    ],
)
def test_labels(text: str, labels: tuple[str, ...], name: str, tmp_path: Path) -> None:
    (polygon,) = read(drawn(tmp_path, text))[0].polygons
    assert (polygon.labels, polygon.name) == (labels, name)


def test_a_path_may_have_several_parts_and_holes(tmp_path: Path) -> None:
    ring = "M0 0h9v9h-9z m3 3h3v3h-3z m1 1h1v1h-1z"
    found, codes = read(drawn(tmp_path, f'<path d="{ring} M20 0h9v9h-9z" id="p"/>'))
    areas = [shapely.Polygon(p.points).area for p in found.polygons]
    assert areas == [81, 1, 81]
    assert codes == ["LK854"]


def test_what_is_no_polygon_is_left_out(tmp_path: Path) -> None:
    others = (
        '<line x2="5"/><polyline points="0,0 5,5 9,0" fill="none"/><text>Hi</text>'
        '<rect width="0" height="9"/><rect display="none" width="2" height="2"/>'
        '<path d="M 0 0 L 9 9 L 9 0 L 0 9 Z"/><path d="M nan"/><path/>'
    )
    found, codes = read(drawn(tmp_path, f'{others}<rect width="9" height="9"/>'))
    assert len(found.polygons) == 1
    assert set(codes) <= {"LK851", "LK852", "LK855"}
    assert "LK855" in codes


#: Groups of which each shows the one before it ten times.
BOMB = '<g id="g0"><rect width="1" height="1"/></g>' + "".join(
    f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 10 + "</g>" for k in range(1, 12)
)


@pytest.mark.parametrize(
    "text",
    [
        "<rect",
        "",
        '<g id="a"><use href="#a"/></g>',
        '<rect width="x" height="?"/>',
        BOMB,
    ],
)
def test_what_cannot_be_read(text: str, tmp_path: Path) -> None:
    with pytest.raises(Faulty, match=r"LK30[13]"):
        read(drawn(tmp_path, text))
