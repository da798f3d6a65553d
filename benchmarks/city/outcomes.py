"""What came of a replay, from what it has written."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

#: The code of a wall that no facade fills.
_BARE = "LK885"
#: What plots, and the buildings on them, are called.
_PLOTS = frozenset({"Plot", "plots"})
_BUILDINGS = frozenset({"House", "Core", "Wing"})


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a replay.

    Attributes
    ----------
    plots, built
        How many plots there are, and on how many of them something is built.
    failed
        How many tasks have failed.
    bare
        How many walls are without a facade.
    told
        How many diagnostics there are besides.
    counts
        Of solids, openings and triangles.
    """

    plots: int
    built: int
    failed: int
    bare: int
    told: int
    counts: Mapping[str, int]

    @classmethod
    def of(cls, folder: Path) -> Outcome:
        """Read it from a folder of results."""
        entries = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["entries"]
        told = [each for entry in entries for each in entry["diagnostics"]]
        bare = sum(each.get("count", 1) for each in told if each["code"] == _BARE)
        counts = {
            name: sum(entry["summary"].get(name, 0) for entry in entries)
            for name in ("solids", "openings", "triangles")
        }
        plots = [built for path in sorted(folder.rglob("*.glb")) for built in _plots(path)]
        return cls(
            len(plots),
            sum(plots),
            sum(entry["status"] != "done" for entry in entries),
            bare,
            sum(each.get("count", 1) for each in told) - bare,
            counts,
        )

    def __str__(self) -> str:
        counts = ", ".join(f"{number} {name}" for name, number in self.counts.items())
        return (
            f"{self.built} of {self.plots} plots built on; {counts}; {self.bare} walls without a facade, "
            f"{self.told} other remarks, {self.failed} tasks failed"
        )


def _plots(path: Path) -> list[bool]:
    """Return of each plot of a model whether a building stands on it: such are named after their plot."""
    nodes = [
        (node["name"], frozenset(node.get("extras", {}).get("labels", "").split()))
        for node in nodes_of(path.read_bytes())
    ]
    built = {name.partition(".")[0] for name, labels in nodes if labels & _BUILDINGS}
    return [name in built for name, labels in nodes if labels & _PLOTS]


def nodes_of(model: bytes) -> list[dict[str, Any]]:
    """Return the nodes of a binary glTF, whose first chunk is JSON."""
    (length,) = struct.unpack_from("<I", model, 12)
    nodes: list[dict[str, Any]] = json.loads(model[20 : 20 + length])["nodes"]
    return nodes
