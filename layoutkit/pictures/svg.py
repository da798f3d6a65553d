"""Pictures of facades and layouts as SVG: terminals coloured by label, each telling its path."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from layoutkit.model import Facade, Layout, PlacedRegion, Region, place
from layoutkit.pictures.palette import colour_of, darker

#: The longest side on screen, in CSS pixels; the drawing itself is in document units.
SHOWN = 1000

#: Width of outlines, as a share of the longest side.
OUTLINE = 0.001


def render_svg(document: Facade | Layout) -> bytes:
    """Return an SVG drawing of a facade or layout, in document units, y flipped.

    Every terminal is a rectangle with its path, labels and size as tooltip; `data-path` and `data-labels`
    serve style sheets and scripts. The same document gives the same bytes.
    """
    return "\n".join([*_lines(document), ""]).encode()


def _lines(document: Facade | Layout) -> Iterator[str]:
    root = document.root
    zoom = SHOWN / max(root.width, root.height)
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_number(root.width * zoom)}"'
        f' height="{_number(root.height * zoom)}" viewBox="0 0 {_number(root.width)} {_number(root.height)}">'
    )
    yield f"<title>{_text(document.name)}</title>"
    yield f'<g stroke-width="{_number(max(root.width, root.height) * OUTLINE)}">'
    for placed in place(root):
        if placed.region.terminal:
            yield _rectangle(placed, root, document.units)
    yield "</g>"
    yield "</svg>"


def _rectangle(placed: PlacedRegion, root: Region, units: str) -> str:
    region, box = placed.region, placed.box
    colour = colour_of(region)
    labels = " ".join(region.labels)
    tooltip = [placed.path, f"{_number(region.width)} × {_number(region.height)} {units}"]
    tooltip[1:1] = [labels] if labels else []
    return (
        f"<rect data-path={quoteattr(_legal(placed.path))} data-labels={quoteattr(_legal(labels))}"
        f' x="{_number(box.x0)}" y="{_number(root.height - box.y1)}"'
        f' width="{_number(box.width)}" height="{_number(box.height)}"'
        f' fill="{_hex(colour)}" stroke="{_hex(darker(colour))}">'
        f"<title>{_text(chr(10).join(tooltip))}</title></rect>"
    )


def _number(value: float) -> str:
    """Return a number with no more digits than a drawing needs, and no noise of floats."""
    return f"{value:.6g}"


def _hex(colour: tuple[int, int, int]) -> str:
    return "#{:02x}{:02x}{:02x}".format(*colour)


def _text(text: str) -> str:
    return escape(_legal(text))


def _legal(text: str) -> str:
    """Replace the control characters that XML cannot hold."""
    return "".join(c if c in "\t\n\r" or c >= " " else "\N{REPLACEMENT CHARACTER}" for c in text)
