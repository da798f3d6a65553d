"""The folder of results that ``vary`` makes: self-contained, the same bytes from the same seed anywhere."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.cli.relocation import with_picture_file
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity
from layoutkit.model import Facade, Layout, Picture

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.pictures import Exhibit, Photo

#: The copy of the facade's document that layouts in the folder refer to.
FACADE_FILE = "facade.xml"
SHEET_FILE = "sheet.png"

_VARIATION = re.compile(r"variation-\d{2,}\.(xml|png)")


@dataclass(frozen=True)
class Variation:
    """A layout as it was written.

    Attributes
    ----------
    exhibit
        What the contact sheet shows of it.
    """

    layout: Path
    picture: Path
    exhibit: Exhibit


@dataclass(frozen=True)
class ResultFolder:
    """Where the results of one run go.

    Attributes
    ----------
    facade
        What the facade's document has; of a building, its design.
    photo
        The facade's photo, decoded once; None where there is none: pictures then show labels by colour.
    scale
        Pixels a document unit, as a multiple of the photo's own.
    digits
        How many digits the numbers of variations have.
    """

    session: Session
    folder: Path
    facade: Facade
    photo: Photo | None
    scale: float
    digits: int

    def write_facade(self, source: bytes, picture: Path | None) -> None:
        """Copy the facade's document, and beside it its picture."""
        write_facade(self.session, self.folder, source, picture)

    def write_variation(self, number: int, layout: Layout) -> Variation:
        """Write a layout and its picture.

        Raises
        ------
        Faulty
            If the layout breaks a constraint (LK902), which is never written; or a file cannot be written.
        """
        from layoutkit.pictures import Exhibit, render_png

        refuse_broken(layout)
        name = variation_name(number, self.digits)
        image = render_png(layout, self.photo, scale=self.scale)
        for file, data in variation_files(name, layout, image):
            self.session.write(self.folder / file, data)
        root = layout.root
        exhibit = Exhibit(image, layout.name, root.width, root.height, layout.units)
        return Variation(self.folder / f"{name}.xml", self.folder / f"{name}.png", exhibit)

    def write_sheet(self, variations: Sequence[Variation]) -> Path:
        """Write the contact sheet: the input, and every variation beside it."""
        from layoutkit.pictures import Exhibit, contact_sheet, png_bytes, render_png

        root = self.facade.root
        image = self.photo.image if self.photo else render_png(self.facade, None, scale=self.scale)
        original = Exhibit(image, self.facade.name, root.width, root.height, self.facade.units)
        sheet = contact_sheet(original, [variation.exhibit for variation in variations])
        self.session.write(self.folder / SHEET_FILE, png_bytes(sheet))
        return self.folder / SHEET_FILE

    def left_over(self, variations: Sequence[Variation]) -> tuple[Diagnostic, ...]:
        """Return a warning of variations that an earlier run left in the folder, if there are any."""
        own = {path.name for v in variations for path in (v.layout, v.picture)}
        return left_over(self.folder, _VARIATION, own)


def variation_name(number: int, digits: int) -> str:
    """Return what the files of a variation are called."""
    return f"variation-{number:0{digits}d}"


def variation_files(name: str, layout: Layout, image: Image | None) -> tuple[tuple[str, bytes], ...]:
    """Return the files of a variation, by name: its picture, if it has one, and its document.

    They belong into a folder with the facade's document, under the name `FACADE_FILE`.
    """
    from layoutkit.documents import layout_bytes
    from layoutkit.pictures import png_bytes

    building = layout.facade.building if layout.facade else None
    mass = building.mass if building else None
    written = replace(layout, facade_file=FACADE_FILE, mass=mass)
    if image is None:
        return ((f"{name}.xml", layout_bytes(written)),)
    picture = Picture(f"{name}.png", (0.0, 0.0, float(image.width), float(image.height)))
    document = layout_bytes(replace(written, picture=picture))
    return ((picture.file, png_bytes(image)), (f"{name}.xml", document))


def refuse_broken(layout: Layout) -> None:
    """Raise `Faulty` if a layout breaks a constraint (LK902): such a layout is never written."""
    if broken := layout.violations():
        raise Faulty([_breaking(layout, [f"{v.path}: {v.message}" for v in broken])])


def write_facade(session: Session, folder: Path, source: bytes, picture: Path | None) -> None:
    """Write a copy of a facade's document into a folder of results, and beside it its picture."""
    from layoutkit.documents import load

    if picture is not None:
        name = f"facade{picture.suffix.lower()}"
        session.write(folder / name, load(picture))
        source = with_picture_file(source, name)
    session.write(folder / FACADE_FILE, source)


def left_over(folder: Path, pattern: re.Pattern[str], own: Collection[str]) -> tuple[Diagnostic, ...]:
    """Return a warning of files that an earlier run left in a folder, if there are any.

    Parameters
    ----------
    pattern
        What results are called.
    own
        Names of the results of this run.
    """
    names = {path.name for path in folder.iterdir() if pattern.fullmatch(path.name)}
    if not (old := sorted(names - set(own))):
        return ()
    shown = ", ".join(old[:4]) + " …" * (len(old) > 4)
    return (
        Diagnostic(
            "LK705",
            f"{len(old)} files of an earlier run are still here: {shown}",
            Place(str(folder)),
            "delete them, or name a new folder with -o",
            Severity.WARNING,
            "usage",
        ),
    )


def _breaking(layout: Layout, broken: Sequence[str]) -> Diagnostic:
    return Diagnostic(
        "LK902",
        f"the search returned the layout {layout.name!r}, which breaks its constraints; it is not written",
        hint="this is a fault of ours: please report it, with the facade's document",
        topic="internal",
        details=tuple(broken[:10]),
    )
