"""The scenes that operations are learned and tried on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Literal

from benchmarks.placement.facades import facades
from benchmarks.placement.operations import OPERATIONS, Domain, Operation, Stage, stages
from benchmarks.placement.rooms import rooms
from layoutkit.model.scene import Scene

#: Tolerances are chosen on one half of the scenes, and figures are reported of the other.
Half = Literal["tuning", "report", "all"]

#: Where each domain's scenes are, in the folder of real data.
FOLDERS: Mapping[Domain, str] = {"facades": "cmp", "rooms": "floorplans"}
READERS: Mapping[Domain, Callable[[Path], tuple[Scene, ...]]] = {"facades": facades, "rooms": rooms}


@cache
def scenes(domain: Domain, data: Path) -> tuple[Scene, ...]:
    """Return all scenes of a domain, in the order of their names."""
    return READERS[domain](data / FOLDERS[domain])


def half(found: tuple[Scene, ...], which: Half) -> tuple[Scene, ...]:
    """Return the scenes of even index for tuning, those of odd index to report, or all."""
    return found[{"tuning": slice(0, None, 2), "report": slice(1, None, 2), "all": slice(None)}[which]]


@cache
def stages_of(name: str, data: Path, which: Half) -> tuple[Stage, ...]:
    """Return the stages of an operation in one half of its domain's scenes."""
    operation = operation_of(name)
    return stages(operation, half(scenes(operation.domain, data), which))


def operation_of(name: str) -> Operation:
    """Return the operation of a name."""
    return next(each for each in OPERATIONS if each.name == name)
