"""What formats have in common: polygons are gathered, and what is wrong with them is said and survived."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity
from layoutkit.model import Picture, Placement, Polygon, Scene
from layoutkit.model.facade import Units
from layoutkit.model.face import Point
from layoutkit.model.scene import OwnLabels
from layoutkit.scenes.naming import told_apart
from layoutkit.scenes.soundness import SAME, examined
from layoutkit_formats.remarks import conversion

Ring = Sequence[Point]


class Drawing:
    """Polygons as they are found in a file, and remarks on what is wrong with them.

    Parameters
    ----------
    path
        The file.
    """

    def __init__(self, path: Path) -> None:
        self.place = Place(str(path))
        self.polygons: list[Polygon] = []
        self.placements: list[Placement] = []
        self.remarks: list[Diagnostic] = []
        self._holes: list[int] = []
        self._others: Counter[str] = Counter()

    def add(
        self,
        rings: Sequence[Ring],
        labels: tuple[str, ...],
        name: str = "",
        angle: float | None = None,
        *,
        edges: OwnLabels = (),
        corners: OwnLabels = (),
        place: Place | None = None,
    ) -> None:
        """Add a polygon.

        Parameters
        ----------
        rings
            Its outline, then its holes, which are left out. A first point that is repeated is taken once.
        place
            Where in the file it stands, if that is known.
        """
        if not rings:
            return
        points = tuple((float(x), float(y)) for x, y in _opened(rings[0]))
        where = place or self.place
        self.polygons.append(Polygon(name, points, labels, edges, corners, angle, where))
        self._holes.append(len(rings) - 1)

    def leave_out(self, kind: str, count: int = 1) -> None:
        """Count what is no polygon, such as lines, and is left out."""
        self._others[kind] += count

    def remark(self, code: str, message: str, hint: str = "", severity: Severity = Severity.WARNING) -> None:
        """Say something of the whole file."""
        self.remarks.append(Diagnostic(code, message, self.place, hint, severity, "scene"))

    def scene(
        self, name: str, units: Units, picture: Picture | None = None
    ) -> tuple[Scene, tuple[Diagnostic, ...]]:
        """Return the scene of what is sound, and all remarks.

        Raises
        ------
        Faulty
            If nothing is left.
        """
        named = told_apart(self.polygons)
        result = examined(named)
        self._tell_holes(named)
        if result.notes:
            self._tell_repetition(len(result.notes))
        for kind, count in self._others.items():
            message = f"left out, as no polygon{'s' * (count > 1)}: {count} × {kind}"
            self.remark("LK855", message, "a scene is made of outlines that enclose something")
        remarks = tuple(_shortened([*self.remarks, *result.left_out]))
        if not result.polygons and not self.placements:
            raise Faulty([*remarks, conversion("LK303", "no usable polygon is in it", self.place)])
        return Scene(name, units, result.polygons, tuple(self.placements), picture), remarks

    def _tell_holes(self, named: Sequence[Polygon]) -> None:
        for polygon, count in zip(named, self._holes, strict=True):
            if count:
                message = f"{polygon.name} has {count} hole{'s' * (count != 1)}, and is taken for filled"
                hint = "a scene's polygons have no holes; what stands in one can be a polygon itself"
                place = polygon.place
                self.remarks.append(Diagnostic("LK854", message, place, hint, Severity.WARNING, "scene"))

    def _tell_repetition(self, count: int) -> None:
        some = "1 polygon repeats" if count == 1 else f"{count} polygons repeat"
        self.remark("LK853", f"{some} points in a row; they are taken once", severity=Severity.NOTE)


def _shortened(remarks: Sequence[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield remarks, of each code so many one by one, and how many more there are."""
    counts: Counter[str] = Counter()
    for remark in remarks:
        counts[remark.code] += 1
        if counts[remark.code] <= _TOLD:
            yield remark
    for code, count in counts.items():
        if count > _TOLD:
            last = next(remark for remark in reversed(remarks) if remark.code == code)
            more = count - _TOLD
            yield replace(
                last, message=f"and {more:,} more of this kind, such as: {last.message}", count=more
            )


#: As many remarks of one code are told one by one.
_TOLD = 5


def _opened(ring: Ring) -> Ring:
    """Return a ring whose first point is not repeated at the end, or only by a rounding error."""
    if len(ring) < 2:
        return ring
    (x0, y0), (x1, y1) = ring[0], ring[-1]
    same = math.isclose(x0, x1, rel_tol=SAME, abs_tol=SAME) and math.isclose(
        y0, y1, rel_tol=SAME, abs_tol=SAME
    )
    return ring[:-1] if same else ring


def unreadable(path: Path, message: str, line: int = 0, column: int = 0) -> Faulty:
    """Return the fault of a file that is not of its format's form."""
    return Faulty([conversion("LK301", message, Place(str(path), line, column))])


def loaded(path: Path) -> bytes:
    """Return a file's bytes, unpacked if it is compressed (gzip).

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    import gzip
    import zlib

    from layoutkit.documents import load

    data = load(path)
    if not data.startswith(b"\x1f\x8b"):
        return data
    try:
        return gzip.decompress(data)
    except (OSError, EOFError, zlib.error) as error:
        raise unreadable(path, f"the file cannot be unpacked: {error}") from None


def no_such_part(path: Path, part: str, known: Sequence[str]) -> Faulty:
    """Return the fault of a scene that is asked for, and not in the file."""
    from layoutkit.diagnostics import did_you_mean

    message = f"the file has no scene {part!r}"
    hint = did_you_mean(part, known) if len(known) <= _MANY else f"there are {known[0]} to {known[-1]}"
    return Faulty([Diagnostic("LK858", message, Place(str(path)), hint, topic="usage")])


#: Of more names, the first and the last are told.
_MANY = 30
