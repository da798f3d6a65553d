"""Grids: what they name, and what they are named by (LK24)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code

CODES = (
    Code(
        "LK241",
        "grid of unknown regions",
        "A grid names a region or label that the facade lacks. Regions of the attribute `elements` go by "
        "unique paths, in which repeats are numbered; those of `of` by paths without numbers.",
        "A misspelt path, or a region that was renamed or is no longer there.",
        "Correct the name; `layoutkit inspect` prints the unique path of every region.",
    ),
    Code(
        "LK242",
        "element twice in a grid",
        "A grid names one region twice, and each element stands in it once.",
        "A path that was copied, and its number left as it was.",
        "Delete one of the two, or write the number of the region that is meant.",
    ),
    Code(
        "LK243",
        "element inside another",
        "One element of a grid is inside another: both would be in the same row and column.",
        "A label that a region and a part of it have in common.",
        "Take one of them out, or make a grid of the inner ones: it is found to be a subgrid by itself.",
    ),
    Code(
        "LK244",
        "grid without elements",
        "The regions that a grid names come to none.",
        "A difference of sets that leaves nothing.",
        "Name a region, or delete the grid.",
    ),
    Code(
        "LK245",
        "grids named alike",
        "Two grids of a facade have one name, by which edits could mean either.",
        "A grid that was copied.",
        "Give each a name of its own.",
    ),
    Code(
        "LK246",
        "edit of an unknown grid",
        "A session records an edit of a grid that its facade lacks.",
        "A grid that was renamed or deleted after the session was written.",
        "Correct the name, or give the facade that grid again.",
    ),
)
