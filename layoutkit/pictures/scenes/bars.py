"""What each relationship function adds to the scores of placements, as bars."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from layoutkit.model import Placement
from layoutkit.pictures.legend import INK, NARROWEST, WHITE, Entry, with_legend
from layoutkit.pictures.lettering import fitted, font, spelled
from layoutkit.pictures.scenes.ramp import kind_colour

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

    from layoutkit.pictures.palette import Colour

#: Pixels of a row, of its bar, of all bars, and of what stands before and behind them.
_ROW, _BAR, _WIDE, _NAME, _SCORE = 34, 24, 720, 190, 90
_TEXT = 17

Contributions = Mapping[str, float]


def render_contributions(placements: Sequence[Placement], contributions: Sequence[Contributions]) -> Image:
    """Return bars of what each function adds to the score of each placement, one row a placement.

    What speaks for a placement goes to the right of a line, what speaks against it to the left; all rows have
    one scale. Behind each bar stands the placement's score. Functions are in the order of what they add to
    all placements together, and so is the legend. Without placements it says that there are none.
    """
    from PIL import Image, ImageDraw

    if not placements:
        return with_legend(Image.new("RGB", (NARROWEST, 1), WHITE), [Entry("nothing was placed")])
    colours = {name: kind_colour(number) for number, name in enumerate(in_order(contributions))}
    zero, zoom = _axis(contributions)
    page = Image.new("RGB", (_NAME + _WIDE + _SCORE, _ROW * len(placements)), WHITE)
    draw = ImageDraw.Draw(page)
    for number, (placement, added) in enumerate(zip(placements, contributions, strict=True)):
        middle = number * _ROW + _ROW // 2
        name = fitted(draw, spelled(f"{number + 1} {placement.label}".rstrip()), font(_TEXT), _NAME - 16)
        draw.text((0, middle), name, INK, font(_TEXT), "lm")
        _bar(draw, added, colours, (_NAME + zero, middle), zoom)
        if placement.score is not None:
            draw.text((page.width, middle), f"{placement.score:.3g}", INK, font(_TEXT), "rm")
    draw.line((_NAME + zero, 0, _NAME + zero, page.height), INK, 1)
    keys = [Entry(name, partial(_key, colour=colour)) for name, colour in colours.items()]
    return with_legend(page, keys)


def in_order(contributions: Sequence[Contributions]) -> list[str]:
    """Return the names of functions, those that add most to all placements together first."""
    totals: dict[str, float] = {}
    for added in contributions:
        for name, value in added.items():
            totals[name] = totals.get(name, 0.0) + abs(value)
    return sorted(totals, key=lambda name: (-totals[name], name))


def _axis(contributions: Sequence[Contributions]) -> tuple[int, float]:
    """Return how far from the left the line is, and pixels a unit."""
    least = min((sum(min(v, 0.0) for v in added.values()) for added in contributions), default=0.0)
    most = max((sum(max(v, 0.0) for v in added.values()) for added in contributions), default=0.0)
    zoom = _WIDE / ((most - least) or 1.0)
    return round(-least * zoom), zoom


def _bar(
    draw: ImageDraw, added: Contributions, colours: Mapping[str, Colour], at: tuple[int, int], zoom: float
) -> None:
    reached = {1: 0.0, -1: 0.0}
    for name, colour in colours.items():
        value = added.get(name, 0.0)
        side = 1 if value > 0 else -1
        start, reached[side] = reached[side], reached[side] + value
        left, right = sorted(round(at[0] + edge * zoom) for edge in (start, reached[side]))
        if left < right:
            draw.rectangle((left, at[1] - _BAR // 2, right - 1, at[1] + _BAR // 2), colour)


def _key(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    x, y = at
    draw.rectangle((x - 11, y - 8, x + 11, y + 8), colour)
