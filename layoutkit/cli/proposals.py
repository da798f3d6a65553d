"""The folder of proposals that ``propose`` makes: self-contained, the same bytes anywhere."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.cli.editing import Subject, edited_bytes, edited_picture
from layoutkit.cli.results import FACADE_FILE, SHEET_FILE, left_over, write_facade
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, ProposedEdit, place
from layoutkit.model.told import told

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.hooks import Outcome
    from layoutkit.model import Grid
    from layoutkit.pictures import Exhibit, Photo

SESSION_FILE = "session.xml"

#: On the sheet, the longer side of the input has so many pixels, before the whole is fitted onto a page.
SHOWN = 640
#: How many pixels lines on it are wide then.
LINE = 3
#: What new elements are called in legends.
_NEW = {"add": "added", "move": "moved"}
_PROPOSAL = re.compile(r"proposal-\d{2,}(\.xml|\.png|-grids\.png)")


@dataclass(frozen=True)
class Written:
    """A proposal as it was written.

    Attributes
    ----------
    number
        Counted from 1, as ``apply --take`` has it.
    marked
        The picture with the grids marked.
    exhibit
        What the sheet shows of it.
    """

    number: int
    proposal: ProposedEdit
    facade: Path
    picture: Path
    marked: Path
    exhibit: Exhibit


@dataclass(frozen=True)
class ProposalFolder:
    """Where the proposals of one edit go.

    Attributes
    ----------
    subject
        The facade that editing began with.
    now
        It as it is now, and where its terminals are taken from.
    grids
        Names of the grids that are edited.
    action
        What is done.
    photo
        The photo of the facade that editing began with; None where there is none.
    scale
        Pixels a document unit, as a multiple of the photo's own.
    digits
        How many digits the numbers of proposals have.
    """

    session: Session
    folder: Path
    subject: Subject
    now: Outcome
    grids: tuple[str, ...]
    action: str
    photo: Photo | None
    scale: float
    digits: int

    def write_input(self) -> None:
        """Write what editing began with, its picture, and the session of what was done before."""
        from layoutkit.documents import session_bytes

        write_facade(self.session, self.folder, self.subject.source, self.subject.picture)
        edits = replace(self.subject.edits, facade_file=FACADE_FILE)
        self.session.write(self.folder / SESSION_FILE, session_bytes(edits))

    def write(self, number: int, outcome: Outcome) -> Written:
        """Write a proposal: its document, its picture, and that with its grids marked.

        Raises
        ------
        Faulty
            If a file cannot be written.
        """
        from layoutkit.pictures import png_bytes
        from layoutkit.pictures.gridded import grid_marks, legend_of, with_grids
        from layoutkit.pictures.legend import Entry, with_legend

        facade, proposal = outcome.document, outcome.proposal
        assert isinstance(facade, Facade)
        assert isinstance(proposal, ProposedEdit)
        name = f"proposal-{number:0{self.digits}d}"
        xml, plain, marked = (self.folder / f"{name}{end}" for end in (".xml", ".png", "-grids.png"))
        image = edited_picture(facade, self.photo, outcome.origins, self.scale)
        what, marks = told(proposal.edit), grid_marks(facade, self._edited(facade))
        boxes = [placed.box for placed in place(facade.root) if placed.path in set(proposal.new)]
        entries = [Entry(what), *legend_of(marks, _NEW[self.action] if boxes else "")]
        page = with_legend(with_grids(image, facade, marks, boxes), entries)
        self.session.write(plain, png_bytes(image))
        self.session.write(marked, png_bytes(page))
        self.session.write(xml, edited_bytes(facade, image, plain.name if self.photo else None))
        shown = with_grids(self._small(image), facade, marks, boxes, LINE)
        exhibit = _exhibit(shown, f"{number}: {what}", facade, f"distortion {proposal.distortion:.1%}")
        return Written(number, proposal, xml, plain, marked, exhibit)

    def write_sheet(self, written: Sequence[Written]) -> Path:
        """Write the sheet: the facade as it is now, and every proposal beside it, grids marked."""
        from layoutkit.pictures import contact_sheet, png_bytes
        from layoutkit.pictures.gridded import grid_marks, legend_of, with_grids
        from layoutkit.pictures.legend import with_legend
        from layoutkit.pictures.sheet import MARGIN

        facade = self.now.document
        assert isinstance(facade, Facade)
        marks = grid_marks(facade, self._edited(facade))
        shown = with_grids(self._small(self._input), facade, marks, line=LINE)
        sheet = contact_sheet(_exhibit(shown, facade.name, facade), [each.exhibit for each in written])
        new = _NEW.get(self.action, "") if any(each.proposal.new for each in written) else ""
        page = with_legend(sheet, legend_of(marks, new), MARGIN)
        self.session.write(self.folder / SHEET_FILE, png_bytes(page))
        return self.folder / SHEET_FILE

    def left_over(self, written: Sequence[Written]) -> tuple[Diagnostic, ...]:
        """Return a warning of proposals that an earlier run left in the folder, if there are any."""
        own = {path.name for each in written for path in (each.facade, each.picture, each.marked)}
        return left_over(self.folder, _PROPOSAL, own)

    @cached_property
    def _input(self) -> Image:
        """The picture of the facade as it is now."""
        facade = self.now.document
        assert isinstance(facade, Facade)
        return edited_picture(facade, self.photo, self.now.origins, self.scale)

    def _edited(self, facade: Facade) -> list[Grid]:
        """Return the grids that are edited, in the order in which they were named."""
        known = {grid.name: grid for grid in facade.grids}
        return [known[name] for name in self.grids if name in known]

    def _small(self, image: Image) -> Image:
        """Return a picture at the scale of the sheet: marks that are drawn on it then can be seen there."""
        from PIL.Image import Resampling

        factor = SHOWN / max(self._input.size)
        width, height = (max(1, round(side * factor)) for side in image.size)
        return image.resize((width, height), Resampling.LANCZOS)


def _exhibit(image: Image, name: str, facade: Facade, remark: str = "") -> Exhibit:
    from layoutkit.pictures import Exhibit

    # Of pixels, the caption has tenths.
    digits = 1 if facade.units == "px" else 6
    width, height = (round(size, digits) for size in (facade.root.width, facade.root.height))
    return Exhibit(image, name, width, height, facade.units, remark)
