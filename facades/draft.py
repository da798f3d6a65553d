"""Draft the documents of our scenes anew: ``python -m facades.draft``, from the project's root."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from facades.drafting import bedrooms, fronts, plots
from layoutkit.documents import scene_bytes
from layoutkit.model import Scene
from layoutkit.samples import list_scenes

#: What drafts the examples of a sample, and the scene to place shapes in.
DRAFTS: Mapping[str, tuple[Callable[[], Scene], Callable[[], Scene]]] = {
    "flowers": (fronts.example, fronts.target),
    "bedside": (bedrooms.example, bedrooms.target),
    "plots": (plots.example, plots.target),
}


def main() -> None:
    """Write every scene's documents."""
    for sample in list_scenes():
        for file, draft in zip((sample.examples, sample.target), DRAFTS[sample.name], strict=True):
            file.parent.mkdir(exist_ok=True)
            file.write_bytes(scene_bytes(draft()))
            print(file)


if __name__ == "__main__":
    main()
