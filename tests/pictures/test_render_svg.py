"""Drawings: well-formed, complete, at their places."""

from __future__ import annotations

import pytest
from lxml import etree
from pictured import composite, facade, layout, leaf

from layoutkit.model import Facade, Layout, place
from layoutkit.pictures import render_svg

SVG = "{http://www.w3.org/2000/svg}"


def test_every_terminal_is_a_rectangle_at_its_place() -> None:
    source = facade()
    drawing = etree.fromstring(render_svg(source))
    terminals = {p.path: p for p in place(source.root) if p.region.terminal}
    rectangles = {r.get("data-path"): r for r in drawing.iter(f"{SVG}rect")}
    assert list(rectangles) == list(terminals)
    for path, rectangle in rectangles.items():
        box = terminals[path].box
        drawn = [float(rectangle.get(name)) for name in ("x", "y", "width", "height")]
        assert drawn == pytest.approx([box.x0, 14 - box.y1, box.width, box.height], rel=1e-5)
        assert rectangle.find(f"{SVG}title").text.startswith(path)
    assert drawing.get("viewBox") == "0 0 12 14"


def test_names_are_escaped() -> None:
    root = composite("Facade", "columns", leaf("A", 1, 1), leaf("B", 1, 1))
    drawing = etree.fromstring(render_svg(Facade('<&"\x01>', "m", root)))
    assert drawing.find(f"{SVG}title").text == '<&"\N{REPLACEMENT CHARACTER}>'


def test_the_same_document_gives_the_same_bytes() -> None:
    source = facade()
    assert render_svg(source) == render_svg(source)
    variation: Layout = layout(source.root, source)
    assert render_svg(variation).count(b"<rect") == render_svg(source).count(b"<rect")
