"""Editing: grids asked for, proposals, and edits that were recorded (LK65)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK651",
        "no such grid",
        "The facade has no grid of the name asked for.",
        "A misspelt name.",
        "Correct it; `layoutkit inspect` lists the grids of a facade.",
    ),
    Code(
        "LK652",
        "facade without grids",
        "Edits go by grids, and the facade has none.",
        "A facade fresh from `layoutkit convert`.",
        "Let `layoutkit grids` find some, or write them into the document.",
    ),
    Code(
        "LK653",
        "no proposal",
        "There is no way to make the edit that was asked for. What stands in the way of each one that was "
        "tried is told with it.",
        "A column to take away where there is only one; constraints that leave no room.",
        "Edit another grid, or loosen what the reasons name.",
    ),
    Code(
        "LK654",
        "edit that cannot be made again",
        "A session's edit does not fit the facade as it is when its turn comes.",
        "A facade or a session that was changed by hand after the edits were made.",
        "Correct the edit, or delete it with those that follow from it.",
    ),
    Code(
        "LK655",
        "proposal dropped",
        "One of the proposals leads to no facade that keeps what has to be kept; the others stand.",
        "Alignments, locks or other constraints that leave no room for it.",
        "Nothing is needed; to have it all the same, loosen what the message names.",
        Severity.NOTE,
    ),
    Code(
        "LK656",
        "proposals left out",
        "There are more proposals than were asked for.",
        "A grid with many different columns, each of which fits in many places.",
        "Nothing is needed; to see them all, raise the limit that the message names.",
        Severity.NOTE,
    ),
    Code(
        "LK657",
        "grids found",
        "The facade has no grids: those that its own regularity suggests were used.",
        "A facade fresh from `layoutkit convert`.",
        "Write them into the document with `layoutkit grids`, and edit them there.",
        Severity.NOTE,
    ),
    Code(
        "LK658",
        "no such region to edit",
        "The facade, as it is after the edits before, has no region of the path asked for.",
        "A misspelt path; one that an edit before has changed.",
        "Correct it; `layoutkit inspect` lists the regions of an edited facade.",
    ),
    Code(
        "LK659",
        "step made in part",
        "What was asked for cannot be reached: the facade went as near as it can, and the message says where "
        "that is.",
        "A side that is dragged past another one; a constraint or an alignment that stops it on its way.",
        "Nothing is needed; to get further, move or loosen what stops it.",
        Severity.NOTE,
    ),
)
