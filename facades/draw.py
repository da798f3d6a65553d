"""Draw the pictures of our designs anew: ``python -m facades.draw``, from the project's root."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from facades.painting.canvas import paint
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Facade
from layoutkit.pictures import png_bytes
from layoutkit.samples import list_pipelines, list_samples


def designs() -> Iterator[Path]:
    """Yield the documents of all facades: those of samples, and those that lie beside operations."""
    yield from (sample.path for sample in list_samples())
    for folder in dict.fromkeys(pipeline.operations.parent for pipeline in list_pipelines()):
        yield from (file for file in sorted(folder.glob("*.xml")) if b"<facade " in file.read_bytes())


def main() -> None:
    """Read every design and write the picture that its document names."""
    kinds = {kind.kind: kind for kind in BUILT_IN}
    for path in designs():
        facade = read(path, kinds).model
        if isinstance(facade, Facade) and facade.picture is not None:
            file = path.parent / facade.picture.file
            file.write_bytes(png_bytes(paint(facade), level=9))
            print(file)


if __name__ == "__main__":
    main()
