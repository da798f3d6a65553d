"""Pictures of facades and layouts as SVG: terminals coloured by label, each telling its path."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
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
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(root.width * zoom)}"'
        f' height="{number(root.height * zoom)}" viewBox="0 0 {number(root.width)} {number(root.height)}">'
    )
    yield f"<title>{tooltip([document.name])}</title>"
    yield f'<g stroke-width="{number(max(root.width, root.height) * OUTLINE)}">'
    for placed in place(root):
        if placed.region.terminal:
            yield _rectangle(placed, root, document.units)
    yield "</g>"
    yield "</svg>"


def _rectangle(placed: PlacedRegion, root: Region, units: str) -> str:
    region, box = placed.region, placed.box
    colour = colour_of(region)
    labels = " ".join(region.labels)
    told = tooltip([placed.path, labels, f"{number(region.width)} × {number(region.height)} {units}"])
    return (
        f"<rect data-path={quoteattr(legal(placed.path))} data-labels={quoteattr(legal(labels))}"
        f' x="{number(box.x0)}" y="{number(root.height - box.y1)}"'
        f' width="{number(box.width)}" height="{number(box.height)}"'
        f' fill="{hexadecimal(colour)}" stroke="{hexadecimal(darker(colour))}">'
        f"<title>{told}</title></rect>"
    )


def number(value: float) -> str:
    """Return a number with no more digits than a drawing needs, and no noise of floats."""
    return f"{value:.6g}"


def hexadecimal(colour: tuple[int, int, int]) -> str:
    """Return a colour as drawings write it."""
    return "#{:02x}{:02x}{:02x}".format(*colour)


def tooltip(lines: Iterable[str]) -> str:
    """Return the text of a title, one line for each that says something."""
    return escape(legal("\n".join(filter(None, lines))))


def legal(text: str) -> str:
    """Replace the control characters that XML cannot hold."""
    return "".join(c if c in "\t\n\r" or c >= " " else "\N{REPLACEMENT CHARACTER}" for c in text)
