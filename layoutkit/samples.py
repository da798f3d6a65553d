"""The facades that come with the program: designs of our own, each with its picture."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.shipped import shipped


@dataclass(frozen=True, slots=True)
class Sample:
    """A design that comes with the program.

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


def list_samples() -> tuple[Sample, ...]:
    """Return the samples, the simplest first."""
    folder = shipped("facades")
    index = tomllib.loads((folder / "index.toml").read_text(encoding="utf-8"))
    return tuple(
        Sample(s["name"], s["description"], folder / s["file"], folder / s["mass"] if "mass" in s else None)
        for s in index["sample"]
    )


def sample_path(name: str) -> Path:
    """Return the facade document of a sample.

    Raises
    ------
    Faulty
        If there is none of that name (LK710).
    """
    return find_sample(name).path


def find_sample(name: str) -> Sample:
    """Return a sample.

    Raises
    ------
    Faulty
        If there is none of that name (LK710).
    """
    samples = {sample.name: sample for sample in list_samples()}
    if name not in samples:
        message = f"no sample is called {name!r}"
        raise Faulty([Diagnostic("LK710", message, hint=did_you_mean(name, samples), topic="usage")])
    return samples[name]
