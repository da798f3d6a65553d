"""What operations hold that lies in files of its own: facades with pictures, sessions of edits, meshes."""

from __future__ import annotations

from dataclasses import dataclass, field

from layoutkit.model.facade import Facade
from layoutkit.model.session import Step


@dataclass(frozen=True)
class Design:
    """A facade, as an operation holds it.

    Attributes
    ----------
    file
        Its document, relative to that of the operations.
    facade
        What is in it; None where it was not read.
    picture
        The file that its picture is in; None where it names none.
    """

    file: str
    facade: Facade | None = field(default=None, repr=False)
    picture: bytes | None = field(default=None, repr=False)

    def __str__(self) -> str:
        return self.file

    @property
    def read(self) -> bool:
        """Whether the file was read."""
        return self.facade is not None


@dataclass(frozen=True)
class Steps:
    """The edits of a session, as an operation holds them.

    Attributes
    ----------
    file
        Its document, relative to that of the operations.
    steps
        What is in force of it; None where it was not read.
    """

    file: str
    steps: tuple[Step, ...] | None = field(default=None, repr=False)

    def __str__(self) -> str:
        return self.file

    @property
    def read(self) -> bool:
        """Whether the file was read."""
        return self.steps is not None


@dataclass(frozen=True)
class Asset:
    """A mesh that others modelled, as an operation holds it.

    Attributes
    ----------
    file
        Relative to the document of the operations; its suffix says how it is read.
    data
        What is in it; None where it was not read.
    """

    file: str
    data: bytes | None = field(default=None, repr=False)

    def __str__(self) -> str:
        return self.file

    @property
    def read(self) -> bool:
        """Whether the file was read."""
        return self.data is not None


#: What is named by a file in documents, and read with them.
Named = Design | Steps | Asset
