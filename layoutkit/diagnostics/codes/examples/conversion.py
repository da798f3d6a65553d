"""Examples of annotations that `convert` finds fault with (LK3)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import ANNOTATION, COMMAND


def _box(name: str, x: tuple[float, float], y: tuple[float, float]) -> str:
    """Return an object of the CMP database, whose x counts down and whose y counts to the right."""
    points = f"<x>{y[0]:g}</x><x>{y[1]:g}</x><y>{x[0]:g}</y><y>{x[1]:g}</y>"
    return f"<object><points>{points}</points><labelname>{name}</labelname></object>"


_WHOLE = _box("facade", (0, 1), (0, 1))
_WINDOW = _box("window", (0.2, 0.4), (0.3, 0.6))
_BOTH = f"{_WHOLE}\n{_WINDOW}"

EXAMPLES = {
    "LK301": Example(ANNOTATION, f"{_WHOLE}\n<object><points><x>0.2</x>", _BOTH),
    "LK302": Example(
        COMMAND,
        "layoutkit convert boxes.xml -o converted.xml",
        "layoutkit convert boxes.xml --image photo.png -o converted.xml",
    ),
    "LK303": Example(ANNOTATION, "<!-- nothing was marked -->", _BOTH),
    "LK304": Example(ANNOTATION, f"{_WHOLE}\n{_WINDOW.replace('window', 'windows')}", _BOTH),
    "LK305": Example(ANNOTATION, f"{_WHOLE}\n{_box('window', (0.2, 0.2), (0.3, 0.3))}", _BOTH),
    "LK306": Example(ANNOTATION, f"{_WHOLE}\n{_box('window', (0.2, 1.4), (0.3, 0.6))}", _BOTH),
    "LK307": Example(ANNOTATION, f"{_BOTH}\n{_WINDOW}", _BOTH),
    "LK308": Example(
        ANNOTATION,
        f"{_box('facade', (0, 0.5), (0, 1))}\n{_box('facade', (0.5, 1), (0, 1))}\n{_WINDOW}",
        _BOTH,
    ),
    "LK309": Example(ANNOTATION, _WINDOW, _BOTH),
}
