"""What the colours in a picture of a scene mean, and its legend."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Literal

from layoutkit.model import Scene
from layoutkit.pictures.legend import Entry
from layoutkit.pictures.palette import PALETTE, colour_of_labels, darker
from layoutkit.pictures.scenes.marks import PLACED

if TYPE_CHECKING:
    from PIL.ImageDraw import ImageDraw

    from layoutkit.pictures.palette import Colour

Mark = Literal["area", "edge", "corner", "placed"]
#: What is said of polygons, edges and corners.
_TOLD = {"area": "{}", "edge": "{} (edges)", "corner": "{} (corners)"}


@dataclass(frozen=True, slots=True)
class Meaning:
    """What one kind of mark in one colour says.

    Attributes
    ----------
    text
        The labels that have the colour, or of what is placed.
    mark
        How it is drawn.
    """

    text: str
    mark: Mark
    colour: Colour


def meanings(scene: Scene) -> list[Meaning]:
    """Return what the colours of a scene mean, by label, and last what is placed.

    Labels of one colour have one line. A shape of several labels is in the colour of one of them, whose line
    it belongs to.
    """
    lines: dict[tuple[Mark, Colour], list[str]] = {}
    for mark, labels in sorted(set(_coloured(scene))):
        told = lines.setdefault((mark, colour_of_labels(labels)), [])
        if (label := decisive(labels)) not in told:
            told.append(label)
    found = [
        Meaning(_TOLD[mark].format(", ".join(names)), mark, colour) for (mark, colour), names in lines.items()
    ]
    return [*found, *_placed(scene)]


def decisive(labels: Sequence[str]) -> str:
    """Return which label a shape of some labels has its colour by."""
    if not labels:
        return "without a label"
    return next((label for label in labels if label.lower() in PALETTE), labels[0])


def entries(found: Sequence[Meaning]) -> list[Entry]:
    """Return the lines of a legend."""
    return [Entry(meaning.text, partial(_KEYS[meaning.mark], colour=meaning.colour)) for meaning in found]


def _coloured(scene: Scene) -> Iterator[tuple[Mark, tuple[str, ...]]]:
    for polygon in scene.polygons:
        yield "area", polygon.labels
        yield from (("edge", labels) for _, labels in polygon.edges)
        yield from (("corner", labels) for _, labels in polygon.corners)


def _placed(scene: Scene) -> Iterator[Meaning]:
    labels = sorted({placement.label for placement in scene.placements if placement.label})
    if scene.placements:
        yield Meaning(f"placed: {', '.join(labels)}" if labels else "placed", "placed", PLACED)


def _area(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    x, y = at
    draw.rectangle((x - 11, y - 8, x + 11, y + 8), colour, darker(colour), 1)


def _edge(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    x, y = at
    draw.rectangle((x - 11, y - 2, x + 11, y + 2), colour)


def _corner(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    draw.circle(at, 6, colour)


def _frame(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    """Draw a small placement, its half arrow to the right."""
    x, y = at
    draw.rectangle((x - 11, y - 8, x + 11, y + 8), outline=colour, width=2)
    draw.line((x, y, x + 10, y), colour, 2)
    draw.line((x + 10, y, x + 6, y - 4), colour, 2)


_KEYS = {"area": _area, "edge": _edge, "corner": _corner, "placed": _frame}
