"""What `inspect` shows of scenes and placement models, as lines or as JSON."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict
from typing import Any

from layoutkit.cli.scene_conversion import counts
from layoutkit.model import Placement, PlacementModel, Polygon, Scene
from layoutkit.model.scene import OwnLabels


def scene_data(scene: Scene) -> dict[str, Any]:
    """Return a scene as JSON-ready data; of each polygon also what it is inside of."""
    picture = scene.picture
    parents = _parents(scene)
    return {
        "kind": "scene",
        "name": scene.name,
        "units": scene.units,
        "bounds": list(scene.bounds),
        "picture": None if picture is None else {"file": picture.file, "box": list(picture.box)},
        "polygons": [
            {**_polygon(polygon), "inside": scene.polygons[parent].name if parent >= 0 else None}
            for polygon, parent in zip(scene.polygons, parents, strict=True)
        ],
        "placements": [_placement(placement) for placement in scene.placements],
    }


def scene_lines(scene: Scene) -> Iterator[str]:
    """Yield a scene as lines: how many there are of each label, then polygons by what they are inside of."""
    x0, y0, x1, y1 = scene.bounds
    yield f"scene {scene.name}: {counts(scene)}, {x1 - x0:.6g} × {y1 - y0:.6g} {scene.units}"
    if scene.picture is not None:
        left, top, right, bottom = scene.picture.box
        yield f"picture {scene.picture.file}: {left:g} {top:g} {right:g} {bottom:g}"
    yield from _label_lines(label for polygon in scene.polygons for label in polygon.labels)
    inside: defaultdict[int, list[int]] = defaultdict(list)
    for number, parent in enumerate(_parents(scene)):
        inside[parent].append(number)
    pending = [(number, "", last) for number, last in _backwards(inside[-1])]
    while pending:
        number, indent, last = pending.pop()
        yield f"{indent}{'└── ' if last else '├── '}{_polygon_line(scene.polygons[number])}"
        deeper = indent + ("    " if last else "│   ")
        pending += ((child, deeper, end) for child, end in _backwards(inside[number]))
    for placement in scene.placements:
        yield _placement_line(placement)


def model_data(model: PlacementModel) -> dict[str, Any]:
    """Return a placement model as JSON-ready data."""
    return {
        "kind": "placement-model",
        "name": model.name,
        "units": model.units,
        "label": model.label,
        "settings": asdict(model.settings),
        "examples": [
            {
                "scene": example.scene.name,
                "polygons": len(example.scene.polygons),
                "placement": _placement(example.placement),
            }
            for example in model.examples
        ],
    }


def model_lines(model: PlacementModel) -> Iterator[str]:
    """Yield a placement model as lines: its settings, and its examples."""
    count = len(model.examples)
    some = f"{count} example{'s' * (count != 1)}"
    yield f"placement model {model.name}: {some} of {model.label}, {model.units}"
    for name, value in asdict(model.settings).items():
        yield f"{name.replace('_', '-')} {_shown(value)}"
    for example in model.examples:
        where = f" in {example.scene.name}" if example.scene.name else ""
        yield f"{_placement_line(example.placement)}{where}, {counts(example.scene)}"


def _parents(scene: Scene) -> Sequence[int]:
    from layoutkit.scenes.hierarchy import Hierarchy

    return [int(parent) for parent in Hierarchy(scene.polygons).parents]


def _backwards(numbers: Sequence[int]) -> Iterator[tuple[int, bool]]:
    """Yield siblings from the last one on, and whether each is the last."""
    for position in range(len(numbers) - 1, -1, -1):
        yield numbers[position], position == len(numbers) - 1


def _label_lines(labels: Iterable[str]) -> Iterator[str]:
    for label, count in Counter(labels).items():
        yield f"@{label} {count}"


def _polygon_line(polygon: Polygon) -> str:
    xs, ys = zip(*polygon.points, strict=True)
    size = f"{max(xs) - min(xs):.6g} × {max(ys) - min(ys):.6g}"
    labels = "".join(f" @{label}" for label in polygon.labels)
    points = f", {len(polygon.points)} points" if len(polygon.points) != 4 else ""
    return f"{polygon.name}{labels} {size}{points}"


def _placement_line(placement: Placement) -> str:
    size = f"{placement.width:.6g} × {placement.height:.6g}"
    turned = f" turned by {placement.angle:.6g}°" if placement.angle else ""
    mirrored = " mirrored" if placement.mirrored else ""
    score = f", score {placement.score:.4g}" if placement.score is not None else ""
    named = f" @{placement.label}" if placement.label else ""
    return f"placed{named} {size} at {placement.x:.6g} {placement.y:.6g}{turned}{mirrored}{score}"


def _polygon(polygon: Polygon) -> dict[str, Any]:
    return {
        "name": polygon.name,
        "labels": list(polygon.labels),
        "points": [list(point) for point in polygon.points],
        "angle": polygon.angle,
        "edges": _own(polygon.edges),
        "corners": _own(polygon.corners),
    }


def _own(labels: OwnLabels) -> list[dict[str, Any]]:
    return [{"at": index + 1, "labels": list(own)} for index, own in labels]


def _placement(placement: Placement) -> dict[str, Any]:
    keys = ("x", "y", "width", "height", "angle", "label", "score", "mirrored")
    return {key: getattr(placement, key) for key in keys}


def _shown(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return " ".join(map(str, value)) or "those of the paper"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
