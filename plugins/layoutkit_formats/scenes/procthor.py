"""ProcTHOR houses: rooms with doors, windows and furniture, seen from above.

Unity, which these houses are for, has its y axis upwards and its z axis ahead, and turns clockwise when seen
from above. A scene's x is the house's x, its y is z, and its angles are the house's with the other sign. An
object's own y axis is the direction that it faces.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic
from layoutkit.hooks.specs import SceneFormat
from layoutkit.model import Placement, Scene
from layoutkit.model.face import Point
from layoutkit.model.outline import inside
from layoutkit_formats.scenes.drawing import Drawing, loaded, no_such_part, unreadable
from layoutkit_formats.scenes.labels import labels

#: How thick doors and windows are drawn, in metres, their wall in the middle.
THICKNESS = 0.1
#: Files beside the houses that hold the sizes of objects.
ASSETS = ("asset-database.json", "asset-database.json.gz")


class ProcThorFormat(SceneFormat):
    """Reads the rooms of houses, one house a line."""

    name = "procthor"
    summary = "ProcTHOR houses (JSON lines, also packed), each room a scene; sizes from asset-database.json."

    def recognises(self, path: Path, head: bytes) -> bool:
        """Tell whether the first line, unpacked, begins a house."""
        if head.startswith(b"\x1f\x8b"):
            import zlib

            try:
                head = zlib.decompressobj(wbits=31).decompress(head)
            except zlib.error:
                return False
        return head.lstrip().startswith(b"{") and b'"rooms"' in head and b'"floorPolygon"' in head

    def parts(self, path: Path) -> Sequence[str]:
        """Return the numbers of the houses, from 1; with the names of their rooms where there are several."""
        return tuple(_rooms(*_version(path)))

    def read(self, path: Path, part: str) -> tuple[Scene, Sequence[Diagnostic]]:
        """Return the scene of a room, in metres."""
        rooms = _rooms(*_version(path))
        if part not in rooms:
            raise no_such_part(path, part, list(rooms))
        line, room = rooms[part]
        house = json.loads(_lines(*_version(path))[line])
        drawing = Drawing(path)
        try:
            _draw(house, house["rooms"][room], drawing, _assets(path, drawing), len(house["rooms"]) > 1)
        except (KeyError, TypeError, ValueError, IndexError) as error:
            raise unreadable(path, f"house {line + 1} is not of the form of ProcTHOR: {error!r}") from None
        return drawing.scene(f"{path.name.partition('.')[0]}-{part}", "m")


def _version(path: Path) -> tuple[Path, int, int]:
    """Return a file with what tells it from later versions of itself."""
    try:
        status = path.stat()
    except OSError as error:
        raise unreadable(path, f"the file cannot be read: {error.strerror}") from None
    return path, status.st_mtime_ns, status.st_size


@lru_cache(maxsize=2)
def _lines(path: Path, changed: int, size: int) -> tuple[bytes, ...]:
    """Return the houses of a file, each as its text: a set of houses is read room by room."""
    return tuple(line for line in loaded(path).splitlines() if line.strip())


@lru_cache(maxsize=2)
def _rooms(path: Path, changed: int, size: int) -> dict[str, tuple[int, int]]:
    """Return the line and the number of each room, by its name."""
    found: dict[str, tuple[int, int]] = {}
    for line, text in enumerate(_lines(path, changed, size)):
        try:
            rooms = json.loads(text)["rooms"]
            names = [str(room["id"]) for room in rooms]
        except (ValueError, KeyError, TypeError, RecursionError):
            raise unreadable(path, "the line is no house of ProcTHOR", line + 1) from None
        for room, name in enumerate(names):
            found[f"{line + 1}/{name}" if len(names) > 1 else str(line + 1)] = (line, room)
    return found


def _assets(path: Path, drawing: Drawing) -> dict[str, tuple[str, float, float]]:
    """Return the type of each asset, and its extents along its own x and z."""
    folder = path.resolve().parent
    found = next((file for name in ASSETS if (file := folder / name).is_file()), None)
    if found is None:
        message = "the sizes of objects are not known; these are left out"
        drawing.remark("LK861", message, f"put {ASSETS[1]} beside the file")
        return {}
    return _database(*_version(found))


@lru_cache(maxsize=2)
def _database(path: Path, changed: int, size: int) -> dict[str, tuple[str, float, float]]:
    try:
        return {
            asset["assetId"]: (kind, float(asset["boundingBox"]["x"]), float(asset["boundingBox"]["z"]))
            for kind, assets in json.loads(loaded(path)).items()
            for asset in assets
        }
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise unreadable(path, f"the file is no database of assets: {error!r}") from None


def _draw(
    house: Any, room: Any, drawing: Drawing, assets: dict[str, tuple[str, float, float]], several: bool
) -> None:
    """Draw a room of a house, its doors and windows, and what stands in it."""
    floor = [(float(p["x"]), float(p["z"])) for p in room["floorPolygon"]]
    drawing.add([floor], labels([str(room["roomType"])]), "Room")
    walls = {wall["id"]: wall for wall in house.get("walls", ())}
    for kind, holes in (("Door", house.get("doors", ())), ("Window", house.get("windows", ()))):
        for hole in holes:
            own = [walls[hole[key]] for key in ("wall0", "wall1") if hole.get(key) in walls]
            wall = next((wall for wall in own if wall.get("roomId") == room["id"]), None)
            if wall is not None:
                opening = _opening(hole, wall, floor)
                drawing.add([opening.points], labels([kind]), angle=opening.angle)
    unknown = set()
    for thing in _things(house.get("objects", ())):
        x, y = float(thing["position"]["x"]), float(thing["position"]["z"])
        if several and not inside((x, y), floor):
            continue
        if thing["assetId"] not in assets:
            unknown.add(str(thing["assetId"]))
            continue
        kind, width, depth = assets[thing["assetId"]]
        turned = Placement(x, y, width, depth, -float(thing["rotation"]["y"]) % 360)
        drawing.add([turned.points], labels([kind]), angle=turned.angle)
    if unknown and assets:
        message = f"left out, as their size is not known: {', '.join(sorted(unknown))}"
        drawing.remark("LK861", message, "take the database that goes with the houses")


def _things(objects: Any) -> Iterator[Any]:
    """Yield objects, each before those that stand on it."""
    for thing in objects:
        yield thing
        yield from _things(thing.get("children", ()))


def _opening(hole: Any, wall: Any, floor: Sequence[Point]) -> Placement:
    """Return a door or window as a box along its wall, whose own y axis points into the room.

    Holes are measured along the wall from its first point.
    """
    (ax, ay), (bx, by) = ((float(p["x"]), float(p["z"])) for p in wall["polygon"][:2])
    length = math.dist((ax, ay), (bx, by))
    along = (bx - ax) / length, (by - ay) / length
    start, end = sorted(float(p["x"]) for p in hole["holePolygon"][:2])
    middle = (start + end) / 2
    x, y = ax + along[0] * middle, ay + along[1] * middle
    step = THICKNESS / 2
    leftwards = inside((x - along[1] * step, y + along[0] * step), floor)
    angle = math.degrees(math.atan2(along[1], along[0])) + (0 if leftwards else 180)
    return Placement(x, y, end - start, THICKNESS, angle % 360)
