"""Draw the pictures of our designs anew: ``python -m facades.draw``, from the project's root."""

from __future__ import annotations

from facades.painting.canvas import paint
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import read
from layoutkit.model import Facade
from layoutkit.pictures import png_bytes
from layoutkit.samples import list_samples


def main() -> None:
    """Read every design and write the picture that its document names."""
    kinds = {kind.kind: kind for kind in BUILT_IN}
    for sample in list_samples():
        facade = read(sample.path, kinds).model
        if isinstance(facade, Facade) and facade.picture is not None:
            file = sample.path.parent / facade.picture.file
            file.write_bytes(png_bytes(paint(facade), level=9))
            print(file)


if __name__ == "__main__":
    main()
