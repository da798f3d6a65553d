"""What an example is: a small case of a fault, the same case mended, and what both are part of."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass, field

#: Where an example stands in its frame.
GAP = "…"


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """What examples stand in.

    Attributes
    ----------
    name
        What the reference calls it.
    text
        The file in which examples stand at `GAP`; nothing but that where they are whole files.
    file
        Its name.
    command
        What is run to see the fault; `GAP` alone where examples are commands.
    beside
        Files that stand beside it, by name.
    pictures
        Pictures that stand beside it, 100 × 100 pixels.
    """

    name: str
    text: str
    file: str
    command: str
    beside: Mapping[str, str] = field(default_factory=dict)
    pictures: tuple[str, ...] = ()

    def around(self, example: str) -> str:
        """Return the whole file that holds an example, indented as its place is."""
        line = next(line for line in self.text.splitlines() if GAP in line)
        indentation = line[: len(line) - len(line.lstrip())]
        return self.text.replace(line, textwrap.indent(example, indentation), 1)


@dataclass(frozen=True, slots=True)
class Example:
    """A case of a fault, and the same case mended.

    Attributes
    ----------
    frame
        What both stand in.
    wrong, mended
        Parts of a file, whole files or commands, as the frame says.
    """

    frame: Frame
    wrong: str
    mended: str

    def files(self, text: str) -> Mapping[str, str]:
        """Return the files of `wrong` or of `mended`, by name."""
        own = {self.frame.file: self.frame.around(text)} if self.frame.file else {}
        return {**self.frame.beside, **own}

    def command(self, text: str) -> str:
        """Return the command that shows the fault, or no longer does."""
        return self.frame.command.replace(GAP, text)
