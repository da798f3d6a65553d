"""The legend of a scene's drawing, laid out as in pictures."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape

from layoutkit.pictures.legend import INK, KEY, LINE, MARGIN, NARROWEST, TEXT
from layoutkit.pictures.palette import darker
from layoutkit.pictures.scenes.frame import Frame
from layoutkit.pictures.scenes.meanings import Meaning
from layoutkit.pictures.svg import hexadecimal, legal

#: How wide a letter is taken to be, as a share of its size: drawings are shown in whatever letters there are.
_LETTER = 0.6


@dataclass(frozen=True, slots=True)
class Legend:
    """Where a legend stands beside a drawing.

    Attributes
    ----------
    corner
        Of its first line, in pixels from the drawing's upper left corner.
    size
        Of the drawing with it, in pixels.
    """

    frame: Frame
    corner: tuple[int, int]
    size: tuple[int, int]
    texts: tuple[tuple[Meaning, tuple[str, ...]], ...]

    @classmethod
    def of(cls, found: Sequence[Meaning], frame: Frame) -> Legend:
        """Lay out a legend below a drawing, or beside one that is much higher than wide."""
        width, height = frame.columns, frame.rows
        if not found:
            return cls(frame, (0, height), (width, height), ())
        beside = width < min(height / 2, NARROWEST)
        room = NARROWEST if beside else max(NARROWEST, width - 2 * MARGIN)
        letters = int((room - KEY) / (_LETTER * TEXT))
        texts = tuple((one, tuple(textwrap.wrap(one.text, letters) or [""])) for one in found)
        corner = (width + MARGIN, MARGIN) if beside else (MARGIN, height + MARGIN)
        bottom = corner[1] + LINE * sum(len(lines) for _, lines in texts) + MARGIN
        return cls(frame, corner, (max(width, corner[0] + room + MARGIN), max(height, bottom)), texts)

    def lines(self) -> Iterator[str]:
        """Yield its elements: in pixels, whatever the drawing's unit is."""
        if not self.texts:
            return
        x0, _, _, y1 = self.frame.bounds
        shift, zoom = f"{x0:.10g} {-y1:.10g}", f"{1 / self.frame.zoom:.10g}"
        yield (
            f'<g class="legend" transform="translate({shift}) scale({zoom})" font-family="sans-serif"'
            f' font-size="{TEXT}" fill="{hexadecimal(INK)}">'
        )
        left, middle = self.corner[0], self.corner[1] + LINE // 2
        for meaning, lines in self.texts:
            yield _key(meaning, left + 14, middle)
            for line in lines:
                text = escape(legal(line))
                yield f'<text x="{left + KEY}" y="{middle}" dominant-baseline="central">{text}</text>'
                middle += LINE
        yield "</g>"


def _key(meaning: Meaning, x: int, y: int) -> str:
    """Return what stands in front of a line, around a point.

    All of it is open lines: whatever reads the drawing as a scene does not take the legend for shapes.
    """
    colour, edge = hexadecimal(meaning.colour), hexadecimal(darker(meaning.colour))
    match meaning.mark:
        case "area":
            return _line(f"M{x - 11},{y}h22", edge, 16) + _line(f"M{x - 10},{y}h20", colour, 14)
        case "edge":
            return _line(f"M{x - 11},{y}h22", colour, 4)
        case "corner":
            return _line(f"M{x},{y}h0.01", colour, 12, ' stroke-linecap="round"')
        case "placed":
            box = f"M{x - 12},{y - 8}H{x + 11}V{y + 8}H{x - 11}V{y - 7}"
            return _line(f"{box}M{x},{y}H{x + 10}L{x + 6},{y - 4}", colour, 2)


def _line(path: str, colour: str, width: int, cap: str = "") -> str:
    return f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{cap}/>'
