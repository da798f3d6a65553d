"""What tests of operations are made of: outlines, sites, facades, and measures of bodies of their own."""

import math
from itertools import pairwise

import numpy as np
from hypothesis import strategies as st

from layoutkit.model import Polygon, Scene
from layoutkit.operations import Context, Design, Element, Site

FACADE = """<facade xmlns="urn:layoutkit:1" name="wall" units="m">
  <region symbol="Wall" width="6" height="3" split="rows" material="plaster">
    <region symbol="Top" height="0.2" labels="Cornice" depth="0.15"/>
    <region symbol="Floor" height="2.8" split="columns">
      <region symbol="Pier" width="0.6"/>
      <region symbol="Bay" width="1.2" split="rows">
        <region symbol="Over" height="0.4"/>
        <region symbol="Pane" height="1.5" labels="Window" depth="-0.12"/>
        <region symbol="Sill" height="0.1" depth="0.08"/>
        <region symbol="Under" height="0.8"/>
      </region>
      <region symbol="Pier" width="0.6"/>
      <region symbol="Bay" width="1.2" split="rows">
        <region symbol="Over" height="0.4"/>
        <region symbol="Pane" height="1.5" labels="Window" depth="-0.12"/>
        <region symbol="Sill" height="0.1" depth="0.08"/>
        <region symbol="Under" height="0.8"/>
      </region>
      <again symbol="Pier"/>
      <region symbol="Rest" width="1.8"/>
    </region>
  </region>
  <constraints>
    <size of="Wall/Top" min="0.15" max="0.3"/>
    <size of="Wall/Floor" min="2" max="4"/>
    <size of="Wall/Floor/Bay" min="1" max="1.6"/>
    <size of="Wall/Floor/Bay/Over" min="0.2" max="1"/>
    <size of="Wall/Floor/Bay/Pane" min="1" max="2"/>
    <size of="Wall/Floor/Bay/Under" min="0.5" max="1.2"/>
    <size of="Wall/Floor/Pier" min="0.3" max="2.5"/>
    <size of="Wall/Floor/Rest" min="0.3" max="2.5"/>
    <sequence within="Wall" word="⊢ Top Floor"/>
    <sequence within="Wall" word="Floor Floor"/>
    <sequence within="Wall" word="Floor ⊣"/>
    <sequence within="Wall/Floor" word="⊢ Pier Bay Pier"/>
    <sequence within="Wall/Floor" word="Pier Bay Pier"/>
    <sequence within="Wall/Floor" word="Pier Rest ⊣"/>
  </constraints>
</facade>
"""


def design(folder):
    """A facade whose parts stand out and back, of any width from 2.4 m and any height from 2.2 m."""
    from layoutkit.documents import read
    from layoutkit.hooks.host import Host

    path = folder / "wall.xml"
    path.write_text(FACADE)
    return Design("wall.xml", read(path, Host.load().constraints).model)


def context(stages=None, seed=0):
    return Context(stages, (seed,))


def scene(*outlines, labels=("Plot",)):
    """A scene of polygons A, B, C ..."""
    names = (chr(65 + number) for number in range(len(outlines)))
    polygons = (Polygon(n, tuple(map(tuple, o)), labels) for n, o in zip(names, outlines, strict=False))
    return Scene("built", "m", tuple(polygons))


def site(*outlines, labels=("Plot",)):
    return Site.of(scene(*outlines, labels=labels))


def box(x, y, width, height):
    return ((x, y), (x + width, y), (x + width, y + height), (x, y + height))


def on(own, surface, name, outline, labels=()):
    """The site with a flat element on a surface."""
    parent = own.surfaces[surface].element
    return own.with_elements(Element(name, tuple(labels), surface, outline, 0.0, parent=parent))


@st.composite
def convex_outlines(draw, least=3, most=8):
    """Outlines without inner corners, counter-clockwise, no side very short."""
    count = draw(st.integers(least, most))
    turn = draw(st.floats(0, 2 * math.pi))
    wide, deep = draw(st.floats(3, 20)), draw(st.floats(3, 20))
    nudges = draw(st.lists(st.floats(-0.25, 0.25), min_size=count, max_size=count))
    angles = [turn + 2 * math.pi * (n + nudge) / count for n, nudge in enumerate(nudges)]
    return tuple((wide * math.cos(a), deep * math.sin(a)) for a in angles)


@st.composite
def quadrilaterals(draw):
    """Rectangles pushed a little out of shape, anywhere, turned by any angle."""
    width, height = draw(st.floats(3, 20)), draw(st.floats(3, 20))
    x, y, angle = draw(st.floats(-1e4, 1e4)), draw(st.floats(-1e4, 1e4)), draw(st.floats(0, 2 * math.pi))
    pushed = [draw(st.floats(-0.2, 0.2)) for _ in range(8)]
    corners = [
        (u + width * pushed[2 * n], v + height * pushed[2 * n + 1])
        for n, (u, v) in enumerate(box(0, 0, width, height))
    ]
    cosine, sine = math.cos(angle), math.sin(angle)
    return tuple((x + u * cosine - v * sine, y + u * sine + v * cosine) for u, v in corners)


def area(outline):
    """The area of an outline, by triangles from its first point."""
    (x0, y0), *rest = outline
    pairs = pairwise(rest)
    return sum((a - x0) * (d - y0) - (c - x0) * (b - y0) for (a, b), (c, d) in pairs) / 2


def volume(points, triangles):
    """The volume of a mesh, as the sum of tetrahedra over its triangles, one by one."""
    first = points[0]
    return sum(
        float(np.linalg.det(np.stack([points[a] - first, points[b] - first, points[c] - first]))) / 6
        for a, b, c in triangles
    )


def open_edges(triangles):
    """Edges of triangles that no other triangle runs along the other way, each counted by itself."""
    count = {}
    for a, b, c in np.asarray(triangles).tolist():
        for one, other in ((a, b), (b, c), (c, a)):
            count[one, other] = count.get((one, other), 0) + 1
    return [(a, b) for (a, b), number in count.items() if count.get((b, a), 0) != number]
