"""Thin lines where shapes end, so that they stand out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layoutkit.pictures.worlds.camera import Floats
from layoutkit.pictures.worlds.gathered import Gathered, Integers, doubled

#: What lines take of colours: about bodies, and where a body bends or steps back.
CONTOUR, CREASE = 0.55, 0.28
#: Neighbours whose normals have a smaller product than this are a crease.
BEND = 0.9
#: So far apart, in pixels, parallel sides are a step.
STEP = 2.0
#: About bodies that are less than so many pixels across lines are fainter: they would cover them.
SMALL = 60.0
#: The same for bends and steps between triangles, by the square root of the larger one's area.
FINE = 20.0


def lines(shown: Integers, triangles: Gathered, corners: Floats, zoom: float) -> NDArray[np.float32]:
    """Return what lines leave of the colour of each pixel, shape (rows, columns): 1 where there is none.

    Parameters
    ----------
    shown
        Shape (rows, columns): which triangle each pixel shows; -1 for the ground.
    corners
        Shape (triangles, 3, 2): of triangles in the picture, in pixels.
    zoom
        Pixels a unit of the world.
    """
    left = np.ones(shown.shape, dtype=np.float32)
    planes = (triangles.normals * triangles.corners[:, 0]).sum(axis=1) * zoom
    # The last one is for the ground, number -1: lines about bodies are as strong as these ask.
    strong = np.append(np.minimum(_across(corners, triangles.body) / SMALL, 1.0), 0.0)
    coarse = np.append(np.minimum(np.sqrt(np.abs(doubled(corners)) / 2) / FINE, 1.0), 0.0)
    for here, there in (
        ((slice(None), slice(None, -1)), (slice(None), slice(1, None))),
        ((slice(None, -1), slice(None)), (slice(1, None), slice(None))),
    ):
        rows, columns = np.nonzero(shown[here] != shown[there])
        one, other = shown[here][rows, columns], shown[there][rows, columns]
        creases = CREASE * np.maximum(coarse[one], coarse[other])
        taken = _taken(one, other, triangles, planes, creases) * np.maximum(strong[one], strong[other])
        for side in (here, there):
            part = left[side]
            part[rows, columns] = np.minimum(part[rows, columns], 1.0 - taken)
    return left


def _taken(one: Integers, other: Integers, triangles: Gathered, planes: Floats, creases: Floats) -> Floats:
    """Return what lines between pixels of two triangles take of their colours, given what creases do."""
    ground = (one < 0) | (other < 0)
    contour = ground | (triangles.body[one] != triangles.body[other])
    bend = (triangles.normals[one] * triangles.normals[other]).sum(axis=1) < BEND
    step = np.abs(planes[one] - planes[other]) > STEP
    return np.where(contour, CONTOUR, np.where(bend | step, creases, 0.0))


def _across(corners: Floats, body: Integers) -> Floats:
    """Return, of each triangle, how many pixels what is seen of its body is across."""
    count = int(body.max()) + 1 if len(body) else 0
    least, most = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(least, body, corners.min(axis=1))
    np.maximum.at(most, body, corners.max(axis=1))
    across: Floats = np.sqrt(((most - least) ** 2).sum(axis=1))[body]
    return across
