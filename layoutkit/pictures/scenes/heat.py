"""Heat maps over scenes: a panel for each map, all in the colours of one legend."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layoutkit.model import HeatMap, Placement, Polygon, Scene
from layoutkit.model.face import Point
from layoutkit.pictures.legend import INK, WHITE
from layoutkit.pictures.lettering import font, spelled
from layoutkit.pictures.scenes.frame import Frame
from layoutkit.pictures.scenes.marks import PLACED, arrow, number_placements, sample_point
from layoutkit.pictures.scenes.order import outermost_first
from layoutkit.pictures.scenes.painting import SMOOTH, line_of, painted
from layoutkit.pictures.scenes.ramp import STEPS, ramp

if TYPE_CHECKING:
    from PIL.Image import Image

#: Pixels of the longer side of a panel that stands alone, and of one among others.
ALONE, AMONG = 1200, 760
#: Width over height that panels are arranged for.
_ASPECT = 1.5
#: Where nothing was evaluated.
_NOTHING = (226, 226, 226)
_MARGIN, _GAP, _CAPTION, _TEXT, _LEGEND = 32, 28, 40, 20, 84

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Scale:
    """What the colours of the ramp stand for, from least to greatest."""

    least: float
    greatest: float

    @classmethod
    def of(cls, maps: Sequence[HeatMap]) -> Scale:
        """Return the scale of some maps: from 0, or from the least value if that is lower."""
        finite = [heat.values[np.isfinite(heat.values)] for heat in maps]
        values = np.concatenate([np.zeros(1), *finite])
        return cls(float(values.min()), float(values.max()))

    def colours(self, values: Array) -> NDArray[np.uint8]:
        """Return the colours of values, shape (..., 3); NaN has one of its own."""
        share = (np.nan_to_num(values) - self.least) / ((self.greatest - self.least) or 1.0)
        index = np.clip(np.rint(share * (STEPS - 1)), 0, STEPS - 1).astype(np.intp)
        painted = np.array(ramp(), np.uint8)[index]
        painted[~np.isfinite(values)] = _NOTHING
        return painted


def render_heat(scene: Scene, maps: Sequence[HeatMap]) -> Image:
    """Return a picture of heat maps, each over the outlines of the scene.

    Crosses mark where a map is greatest. Each placement of the scene is outlined, with a ring at the point
    that the map is of.

    Parameters
    ----------
    maps
        At least one; several stand side by side, in one scale of colours, and behind them the scene itself.
    """
    scale, several = Scale.of(maps), len(maps) > 1
    frame = Frame.around(scene, AMONG if several else ALONE)
    panels = [_panel(scene, heat, frame, scale) for heat in maps]
    captions = [_told(heat) for heat in maps]
    if several:
        panels.append(painted(scene, frame, None))
        captions.append(f"{len(scene.placements)} placed")
    number_placements(panels[-1], frame, scene.placements)
    return _sheet(panels, captions, scale)


def sampled(heat: HeatMap, frame: Frame) -> Array:
    """Return a map's value at the middle of each pixel, shape (rows, columns).

    Between four points it is interpolated; where one of them has none it is that of the nearest one, and
    beyond half a step from all of them there is none.
    """
    x0, y0, x1, y1 = frame.bounds
    x = (x0 + (np.arange(frame.columns) + 0.5) * (x1 - x0) / frame.columns - heat.x) / heat.step
    y = (y1 - (np.arange(frame.rows) + 0.5) * (y1 - y0) / frame.rows - heat.y) / heat.step
    padded = np.pad(heat.values, 1, constant_values=np.nan)
    rows, columns = padded.shape
    across, down = np.clip(x + 1, 0, columns - 1), np.clip(y + 1, 0, rows - 1)
    left = np.minimum(across.astype(np.intp), columns - 2)
    low = np.minimum(down.astype(np.intp), rows - 2)
    u, v = across - left, (down - low)[:, None]
    below, above = padded[low], padded[low + 1]
    smooth = (below[:, left] * (1 - u) + below[:, left + 1] * u) * (1 - v)
    smooth += (above[:, left] * (1 - u) + above[:, left + 1] * u) * v
    nearest = padded[np.rint(down).astype(np.intp)[:, None], np.rint(across).astype(np.intp)]
    known: Array = np.where(np.isfinite(smooth), smooth, nearest)
    return known


def maximum(heat: HeatMap) -> tuple[Point, float] | None:
    """Return where a map is greatest, the first of several, and its value there; None if it has no values."""
    if not np.isfinite(heat.values).any():
        return None
    row, column = np.unravel_index(np.nanargmax(heat.values), heat.values.shape)
    at = (heat.x + float(column) * heat.step, heat.y + float(row) * heat.step)
    return at, float(heat.values[row, column])


def _panel(scene: Scene, heat: HeatMap, frame: Frame, scale: Scale) -> Image:
    from PIL import Image

    field = Image.fromarray(scale.colours(sampled(heat, frame)))
    large = frame.times(SMOOTH)
    page = field.resize((large.columns, large.rows), Image.Resampling.NEAREST)
    line = line_of(large)
    _outlines(page, large, scene.polygons, line)
    for placement in scene.placements:
        _placement(page, large, placement, heat.name, line)
    if (top := maximum(heat)) is not None:
        _cross(page, large.pixel(top[0]), 5 * line, line)
    return page.reduce(SMOOTH)


def _outlines(page: Image, frame: Frame, polygons: Sequence[Polygon], line: int) -> None:
    """Draw outlines in white, between thin lines of ink: they show on any colour."""
    from PIL.ImageDraw import Draw

    draw = Draw(page, "RGBA")
    for polygon in outermost_first(polygons):
        ring = frame.pixels((*polygon.points, *polygon.points[:2]))
        draw.line(ring, (*INK, 110), 2 * line, joint="curve")
        draw.line(ring, (*WHITE, 200), line, joint="curve")


def _placement(page: Image, frame: Frame, placement: Placement, name: str, line: int) -> None:
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    ring = frame.pixels((*placement.points, *placement.points[:2]))
    x, y = frame.pixel(sample_point(placement, name))
    for colour, width in ((WHITE, 3 * line), (PLACED, line)):
        draw.line(ring, colour, width, joint="curve")
        draw.line(frame.pixels(arrow(placement)), colour, width, joint="curve")
    draw.circle((x, y), 4 * line, None, WHITE, 3 * line)
    draw.circle((x, y), 3 * line, None, PLACED, line)


def _cross(page: Image, at: Point, reach: int, line: int) -> None:
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    x, y = at
    for colour, width in ((WHITE, 3 * line), (INK, line)):
        draw.line((x - reach, y, x + reach, y), colour, width)
        draw.line((x, y - reach, x, y + reach), colour, width)


def _told(heat: HeatMap) -> str:
    top = maximum(heat)
    return f"{heat.name}: no values" if top is None else f"{heat.name}: up to {top[1]:.3g}"


def _sheet(panels: Sequence[Image], captions: Sequence[str], scale: Scale) -> Image:
    """Return panels of one size on a page, as near to the wanted shape as can be, the legend below."""
    from PIL import Image, ImageDraw

    width, height = panels[0].size
    columns = min(
        range(1, len(panels) + 1),
        key=lambda n: abs(math.log(n * width / (math.ceil(len(panels) / n) * height) / _ASPECT)),
    )
    rows = math.ceil(len(panels) / columns)
    across, down = width + _GAP, height + _CAPTION
    size = (columns * across - _GAP + 2 * _MARGIN, rows * down + _LEGEND + 2 * _MARGIN)
    page = Image.new("RGB", size, WHITE)
    draw = ImageDraw.Draw(page)
    for number, (panel, caption) in enumerate(zip(panels, captions, strict=True)):
        left, top = _MARGIN + number % columns * across, _MARGIN + number // columns * down
        page.paste(panel, (left, top))
        draw.text((left, top + height + _CAPTION // 2), spelled(caption), INK, font(_TEXT), "lm")
    _legend(page, rows * down + _MARGIN, scale)
    return page


def _legend(page: Image, top: int, scale: Scale) -> None:
    from PIL import Image, ImageDraw

    draw, length = ImageDraw.Draw(page), min(560, page.width - 2 * _MARGIN)
    bar = Image.new("RGB", (STEPS, 1))
    bar.putdata(ramp())
    page.paste(bar.resize((length, 24), Image.Resampling.NEAREST), (_MARGIN, top + 12))
    ends = ((_MARGIN, scale.least, "lm"), (_MARGIN + length, scale.greatest, "rm"))
    for x, value, anchor in ends:
        draw.text((x, top + 52), f"{value:.3g}", INK, font(_TEXT), anchor)
    told = "cross: the greatest value; ring: the point of each placement that is scored; grey: not evaluated"
    room = page.width - 2 * _MARGIN - length - _GAP
    if draw.textlength(told, font(_TEXT - 4)) <= room:
        draw.text((_MARGIN + length + _GAP, top + 24), told, INK, font(_TEXT - 4), "lm")
    else:
        draw.text((_MARGIN, top + 76), told, INK, font(_TEXT - 4), "lm")
