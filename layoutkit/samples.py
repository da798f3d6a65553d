"""What comes with the program: facades with pictures, scenes and pipelines; designs of our own."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.shipped import shipped


@dataclass(frozen=True, slots=True)
class Sample:
    """A facade that comes with the program.

    Attributes
    ----------
    description
        What it shows, in one line.
    path
        Its facade document; the picture lies beside it.
    mass
        A mass document to put the facade on, where there is one.
    """

    name: str
    description: str
    path: Path
    mass: Path | None = None


@dataclass(frozen=True, slots=True)
class SceneSample:
    """Scenes that come with the program.

    Attributes
    ----------
    description
        What they show, in one line.
    examples
        A scene document with placements to learn from.
    target
        One to place shapes in.
    """

    name: str
    description: str
    examples: Path
    target: Path


@dataclass(frozen=True, slots=True)
class PipelineSample:
    """Operations that come with the program, and what they are made on.

    Attributes
    ----------
    description
        What comes of them, in one line.
    operations
        An operations document; the facades that it names lie beside it.
    scenes
        Scene documents to replay it on, the first one first.
    options
        Of `layoutkit replay`, by which pictures show most.
    """

    name: str
    description: str
    operations: Path
    scenes: tuple[Path, ...]
    options: str = ""


def list_samples() -> tuple[Sample, ...]:
    """Return the facades, the simplest first."""
    folder = shipped("facades")
    return tuple(
        Sample(s["name"], s["description"], folder / s["file"], folder / s["mass"] if "mass" in s else None)
        for s in _index(folder)["sample"]
    )


def list_scenes() -> tuple[SceneSample, ...]:
    """Return the scenes, the simplest first."""
    folder = shipped("facades")
    return tuple(
        SceneSample(s["name"], s["description"], folder / s["examples"], folder / s["target"])
        for s in _index(folder)["scene"]
    )


def list_pipelines() -> tuple[PipelineSample, ...]:
    """Return the pipelines, in the order of the registry."""
    folder = shipped("facades")
    return tuple(
        PipelineSample(
            s["name"],
            s["description"],
            folder / s["operations"],
            tuple(folder / file for file in s["scenes"]),
            s.get("options", ""),
        )
        for s in _index(folder)["pipeline"]
    )


def sample_path(name: str) -> Path:
    """Return the facade document of a sample, the examples of a scene, or the operations of a pipeline.

    Raises
    ------
    Faulty
        If there is none of that name (LK710).
    """
    match find_sample(name):
        case Sample() as facade:
            return facade.path
        case SceneSample() as scene:
            return scene.examples
        case PipelineSample() as pipeline:
            return pipeline.operations


def find_sample(name: str) -> Sample | SceneSample | PipelineSample:
    """Return a sample.

    Raises
    ------
    Faulty
        If there is none of that name (LK710).
    """
    every: tuple[Sample | SceneSample | PipelineSample, ...]
    every = (*list_samples(), *list_scenes(), *list_pipelines())
    samples = {sample.name: sample for sample in every}
    if name not in samples:
        message = f"no sample is called {name!r}"
        raise Faulty([Diagnostic("LK710", message, hint=did_you_mean(name, samples), topic="usage")])
    return samples[name]


def _index(folder: Path) -> dict[str, Any]:
    return tomllib.loads((folder / "index.toml").read_text(encoding="utf-8"))
