"""Draft the documents of our scenes and pipelines: ``python -m facades.draft [NAME …]``, from the root."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from facades.drafting import bedrooms, fronts, gardens, houses, interior, plots, towers
from layoutkit.documents import operations_bytes, scene_bytes
from layoutkit.model import Scene
from layoutkit.operations import Operations
from layoutkit.samples import list_pipelines, list_scenes

#: What drafts the examples of a sample, and the scene to place shapes in.
DRAFTS: Mapping[str, tuple[Callable[[], Scene], Callable[[], Scene]]] = {
    "flowers": (fronts.example, fronts.target),
    "bedside": (bedrooms.example, bedrooms.target),
    "plots": (plots.example, plots.target),
}

#: What drafts the operations of a pipeline, and the scenes that it comes with, in the registry's order.
PIPELINES: Mapping[str, tuple[Callable[[], Operations], Callable[[], tuple[Scene, ...]]]] = {
    "houses": (houses.operations, houses.scenes),
    "towers": (towers.operations, towers.scenes),
    "flat": (interior.operations, interior.scenes),
    "park": (gardens.operations, gardens.scenes),
}


def scene_files(name: str) -> Iterator[tuple[Path, bytes]]:
    """Yield the documents of a scene sample, each with what is to stand in it."""
    sample = next(sample for sample in list_scenes() if sample.name == name)
    for file, draft in zip((sample.examples, sample.target), DRAFTS[name], strict=True):
        yield file, scene_bytes(draft())


def pipeline_files(name: str) -> Iterator[tuple[Path, bytes]]:
    """Yield the documents of a pipeline, each with what is to stand in it; facades are written by hand."""
    sample = next(sample for sample in list_pipelines() if sample.name == name)
    operations, scenes = PIPELINES[name]
    for file, scene in zip(sample.scenes, scenes(), strict=True):
        yield file, scene_bytes(scene)
    yield sample.operations, operations_bytes(operations())


def main(names: tuple[str, ...]) -> None:
    """Write every document of the samples of some names, or of all."""
    for drafts, files in ((DRAFTS, scene_files), (PIPELINES, pipeline_files)):
        for name in drafts:
            if not names or name in names:
                for file, data in files(name):
                    file.parent.mkdir(exist_ok=True)
                    file.write_bytes(data)
                    print(file)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
