"""Operations: what they name, what makes no sense, and what comes to nothing (LK880 to LK889)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK880",
        "file that operations name is not there",
        "Facades, their pictures and sessions are looked for beside the document that names them, and are "
        "needed wherever the operations are made again.",
        "A misspelt name; a folder that was copied without its pictures.",
        "Correct the name, or put the file there.",
    ),
    Code(
        "LK881",
        "operations that do not go with the scene",
        "They cannot be made in it: sizes are counted in other units, or there is nothing to replay.",
        "A scene that was traced from a photo, in pixels.",
        "Write both in the same units.",
    ),
    Code(
        "LK882",
        "operation that makes no sense",
        "What its attributes say cannot be done, wherever it is made.",
        "A height of 0; a roof on what goes into its surface; shapes to place without a model of where.",
        "Do as the hint says.",
    ),
    Code(
        "LK883",
        "operation that does not fit an element",
        "An operation works on elements that it can do nothing with, and leaves them as they are, or does "
        "less.",
        "Something that is chosen along with what is meant; a roof on an outline that none can stand on.",
        "Choose by other labels, or do as the hint says.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK884",
        "solids that are not combined",
        "A solid is not united with another, or not taken away from it: there is no such solid, or nothing "
        "would be left of it.",
        "Something on the ground, which is no solid; a hole that is larger than what it is made in.",
        "Choose what stands on a solid, or what is smaller.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK885",
        "surface that stays bare",
        "No variation of the facade fits the surface, so that none is laid out on it.",
        "A side that is narrower or lower than the facade's constraints allow.",
        "Loosen the constraints, name another facade for such surfaces, or do not choose them.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK886",
        "facade that stays unedited",
        "The edits of a session cannot be made on a facade's variation, which stays as it is.",
        "Grids that some variations lack; edits that would not keep the size.",
        "Edit what all variations have.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK887",
        "file that operations name cannot be used",
        "It has errors, which are told at their own places, or it is a document of another kind.",
        "A facade that was changed afterwards; a layout in the place of its facade.",
        "Do as the hint says.",
    ),
    Code(
        "LK888",
        "selection that chooses nothing",
        "Nothing that a selection may choose of has one of its labels, on any site of the scene.",
        "A label with a slip.",
        "Choose among the labels that the hint names.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK889",
        "recording of what is not there",
        "A program that records operations names something that none of its scenes has at that step, or "
        "shows no examples.",
        "A name with a slip; an element that was made at a later step.",
        "Choose among the names that the hint lists.",
    ),
)
