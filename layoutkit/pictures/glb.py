"""Models of facades and buildings as binary glTF: every terminal at its depth, textured, faces in place."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from layoutkit.model import Box, Facade, Face, Layout, Mass, Part, PlacedRegion, Region, place
from layoutkit.model.outline import area
from layoutkit.model.region import place_children
from layoutkit.pictures.palette import PALETTE, Colour, colour_of
from layoutkit.pictures.photo import Photo, copies
from layoutkit.pictures.relief import Panel, Point, patches
from layoutkit.pictures.sources import sources

if TYPE_CHECKING:
    from PIL.Image import Image
    from trimesh import Scene
    from trimesh.visual.material import PBRMaterial

#: The material of what names none, where a photo shows what it looks like.
PLAIN = "facade"
ROOF = "roof"


@dataclass(frozen=True, slots=True)
class Skin:
    """What a panel looks like.

    Attributes
    ----------
    material
        The name of its material.
    colour
        What it is painted with; None where the photo shows it.
    window
        Left, bottom, right and top of its picture in the photo, as shares of that; y up.
    """

    material: str
    colour: Colour | None
    window: Box


@dataclass(frozen=True)
class Wall:
    """A face, and what is on it: panels, and the skin of each."""

    face: Face
    panels: tuple[Panel, ...]
    skins: tuple[Skin, ...]


@dataclass
class Surface:
    """What is of one material: corners, where in the photo each is, and triangles."""

    points: list[Point] = field(default_factory=list)
    shares: list[tuple[float, float]] = field(default_factory=list)
    triangles: list[tuple[int, int, int]] = field(default_factory=list)


def render_glb(document: Facade | Layout, photo: Photo | None = None) -> bytes:
    """Return a model of a facade or layout: a wall by itself, or a building with its faces in place.

    A unit of the document is one of the model, which glTF calls a metre; y is up. A wall by itself begins at
    the origin, goes along x and looks to where z grows; in a building, north is where z falls. Regions stand
    out by their depth. Materials have the names that regions give; with a photo each shows it, without one
    the colours of labels. Roofs are flat.

    Parameters
    ----------
    photo
        The photo of the facade that a layout varies; of a building, that of the design.

    Raises
    ------
    Faulty
        If a layout has a region that the photo's facade lacks (LK501).
    """
    import trimesh

    scene = trimesh.Scene()
    mass = _mass(document)
    parts = mass.parts if mass is not None else ()
    one_sided = bool(parts) and all(part.closed for part in parts)
    for wall in walls(document, photo):
        for (name, colour), surface in _surfaces(wall).items():
            look = {"baseColorFactor": linear(colour)} if colour else {"baseColorTexture": _image(photo)}
            _add(scene, f"{wall.face.name} {name}", surface, _material(name, look, one_sided))
    roof = _material(ROOF, {"baseColorFactor": linear(PALETTE["roof"])}, one_sided)
    for part in parts:
        if part.closed:
            _add(scene, f"{part.faces[0].name} {ROOF}", _caps(part), roof)
    written: bytes = scene.export(file_type="glb")
    return written


def walls(
    document: Facade | Layout, photo: Photo | None = None, pictured: Mapping[str, Box] | None = None
) -> Iterator[Wall]:
    """Yield the walls of a document: its faces with what is on them, or the one wall that it is.

    Parameters
    ----------
    pictured
        Which part of the photo's facade each terminal shows, by its path; None: as variations do.
    """
    root = document.root
    whole = PlacedRegion(root.symbol, root.symbol, root, Box(0.0, 0.0, root.width, root.height))
    mass = _mass(document)
    if mass is None:
        standing = [(Face(root.symbol, ((0.0, 0.0), (root.width, 0.0)), 0.0, root.height), whole)]
    else:
        standing = list(zip(mass.faces, place_children(whole), strict=True))
    if pictured is None:
        pictured = {p.path: s.box for p, s in sources(root, photo.facade)} if photo else {}
    finishes = _finishes(root)
    terminals: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
    for placed in place(root):
        if placed.region.terminal:
            steps = placed.path.split("/")
            terminals["/".join(steps[: 1 if mass is None else 2])].append(placed)
    for face, region in standing:
        panels, skins = [], []
        for number, placed in enumerate(terminals[region.path]):
            source = pictured.get(placed.path)
            depth, material = finishes[placed.path]
            panels.append(_panel(placed, region.box, depth, source, number))
            skins.append(_skin(placed.region, material, source, photo))
        yield Wall(face, tuple(panels), tuple(skins))


def _mass(document: Facade | Layout) -> Mass | None:
    if isinstance(document, Layout):
        return document.mass
    return document.building.mass if document.building is not None else None


def _finishes(root: Region) -> dict[str, tuple[float, str]]:
    """Return how far each region stands out of the wall, and its material: what is around it counts, too."""
    found: dict[str, tuple[float, str]] = {"": (0.0, "")}
    for placed in place(root):
        depth, material = found[placed.path.rpartition("/")[0]]
        found[placed.path] = depth + placed.region.depth, placed.region.material or material
    return found


def _panel(placed: PlacedRegion, wall: Box, depth: float, source: Box | None, number: int) -> Panel:
    box, (x, y, _, _) = placed.box, wall
    own = Box(box.x0 - x, box.y0 - y, box.x1 - x, box.y1 - y)
    return Panel(own, depth, copies(placed.region, source) if source else (1, 1), number)


def _skin(region: Region, material: str, source: Box | None, photo: Photo | None) -> Skin:
    if photo is not None and source is not None:
        return Skin(material or PLAIN, None, photo.window(source))
    label = region.labels[0] if region.labels else PLAIN
    return Skin(material or label, colour_of(region), Box(0.0, 0.0, 1.0, 1.0))


def _surfaces(wall: Wall) -> Mapping[tuple[str, Colour | None], Surface]:
    """Gather what is to be seen of a wall by material."""
    found: defaultdict[tuple[str, Colour | None], Surface] = defaultdict(Surface)
    face, ends = wall.face, _ends(wall)
    for patch in patches(wall.panels, face.width, face.height, face.marks[1:-1]):
        skin = wall.skins[patch.panel]
        surface, (x0, y0, x1, y1) = found[skin.material, skin.colour], skin.window
        first = len(surface.points)
        surface.points += [_in_space(face, ends, corner) for corner in patch.corners]
        surface.shares += [(x0 + u * (x1 - x0), y0 + v * (y1 - y0)) for u, v in patch.shares]
        surface.triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return found


def _ends(wall: Wall) -> tuple[float, float]:
    """Return how far the wall's ends move for each unit that something stands out, to meet the next wall's.

    No more than what stands there has room for: half of its width.
    """
    near = 1e-6 * wall.face.width
    limits = []
    for side, end in ((0, 0.0), (2, wall.face.width)):
        there = (p for p in wall.panels if p.out and abs(p.box[side] - end) <= near)
        limits.append(min((p.box.width / abs(p.out) / 2 for p in there), default=0.0))
    left, right = (
        max(-limit, min(limit, shift)) for limit, shift in zip(limits, wall.face.shifts, strict=True)
    )
    return left, right


def _in_space(face: Face, ends: tuple[float, float], corner: Point) -> Point:
    """Return a point of a wall as glTF counts: x to the east, y up, z to the south."""
    along, up, out = corner
    if along == 0.0:
        along -= ends[0] * out
    elif along == face.width:
        along += ends[1] * out
    x, y, z = face.at(along, up, out)
    return x, z, -y


def _caps(part: Part) -> Surface:
    """Return the flat roof of a part, and its underside."""
    import numpy as np
    from mapbox_earcut import triangulate_float64

    outline = part.outline
    count = len(outline)
    flat = triangulate_float64(np.array(outline), np.array([count], dtype=np.uint32)).reshape(-1, 3).tolist()
    over = [(a, b, c) if area((outline[a], outline[b], outline[c])) > 0 else (a, c, b) for a, b, c in flat]
    under = [(a + count, c + count, b + count) for a, b, c in over]
    points = [(x, z, -y) for z in (part.top, part.base) for x, y in outline]
    return Surface(points, [], over + under)


def _add(scene: Scene, name: str, surface: Surface, material: PBRMaterial) -> None:
    """Add a surface, its points counted from the first one: single floats are too coarse for far places."""
    import numpy as np
    from trimesh import Trimesh
    from trimesh.transformations import translation_matrix
    from trimesh.visual import TextureVisuals

    points = np.array(surface.points)
    shares = surface.shares or [(0.0, 0.0)] * len(points)
    visual = TextureVisuals(uv=shares, material=material)
    mesh = Trimesh(points - points[0], surface.triangles, visual=visual, process=False)
    scene.add_geometry(mesh, node_name=name, geom_name=name, transform=translation_matrix(points[0]))


def _material(name: str, look: Mapping[str, Any], one_sided: bool) -> PBRMaterial:
    from trimesh.visual.material import PBRMaterial

    return PBRMaterial(name=name, metallicFactor=0.0, roughnessFactor=0.9, doubleSided=not one_sided, **look)


def _image(photo: Photo | None) -> Image:
    assert photo is not None  # without one, every skin has a colour
    return photo.image


def linear(colour: Colour) -> list[float]:
    """Return a colour as glTF counts it: in proportion to light (IEC 61966-2-1), and opaque."""
    shares = (part / 255 for part in colour)
    return [*(((s + 0.055) / 1.055) ** 2.4 if s > 0.04045 else s / 12.92 for s in shares), 1.0]
