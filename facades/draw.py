"""Draw the pictures of our designs anew: ``python -m facades.draw``, from the project's root."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from facades.painting.canvas import paint
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import is_facade, read
from layoutkit.model import Facade
from layoutkit.pictures import png_bytes
from layoutkit.samples import list_pipelines, list_samples

KINDS = {kind.kind: kind for kind in BUILT_IN}


def designs() -> Iterator[tuple[Path, Facade]]:
    """Yield all facades that name a picture, those of samples and of pipelines, with where it lies."""
    files = [sample.path for sample in list_samples()]
    for pipeline in list_pipelines():
        files += sorted(file for file in pipeline.operations.parent.glob("*.xml") if is_facade(file))
    for file in files:
        facade = read(file, KINDS).model
        if isinstance(facade, Facade) and facade.picture is not None:
            yield file.parent / facade.picture.file, facade


def main() -> None:
    """Draw the picture of every design."""
    for file, facade in designs():
        file.write_bytes(png_bytes(paint(facade), level=9))
        print(file)


if __name__ == "__main__":
    main()
