"""Conversion: annotations made by others (LK3)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK301",
        "annotation cannot be read",
        "The file is missing, may not be opened, or is not of the format's form.",
        "A misspelt name, or a file that was cut off.",
        "Correct the path, or mend the file at the place.",
    ),
    Code(
        "LK302",
        "picture missing or of another size",
        "Annotations give shares of a picture: its size is needed, and a mask's picture has the mask's size.",
        "No picture was named, and none of the same name stands beside the annotation.",
        "Name the picture that was annotated with --image.",
    ),
    Code(
        "LK303",
        "annotation shows nothing",
        "No usable box or labelled pixel is left, so there is nothing to convert.",
        "An empty file, or one whose boxes all have faults.",
        "Mend the faults listed with it.",
    ),
    Code(
        "LK304",
        "unknown class in an annotation",
        "A box or pixel is of a class that the format does not have; it is left out.",
        "A misspelt class, or a data set with other classes.",
        "Rename the class; the hint names the nearest one, or the ones known.",
        Severity.WARNING,
    ),
    Code(
        "LK305",
        "box without area",
        "A box has no area, or not two finite numbers along each axis; it is left out.",
        "A click instead of a drag while annotating.",
        "Nothing is needed; draw the box again if it was meant.",
        Severity.WARNING,
    ),
    Code(
        "LK306",
        "box beyond the picture",
        "A box reaches beyond the picture; only the part inside is kept.",
        "A picture that was cropped after it was annotated.",
        "Name the picture that was annotated.",
        Severity.WARNING,
    ),
    Code(
        "LK307",
        "box given twice",
        "Two boxes have the same class and the same edges; one is left out.",
        "An annotation saved twice.",
        "Nothing is needed.",
        Severity.WARNING,
    ),
    Code(
        "LK308",
        "several facades in one annotation",
        "The annotation marks several facades; those side by side become buildings of one document.",
        "A row of houses in one picture.",
        "Nothing is needed; annotate them apart to get a document for each.",
        Severity.NOTE,
    ),
    Code(
        "LK309",
        "no facade in the annotation",
        "The annotation does not say where the facade is; the box around all elements is taken for it.",
        "An annotation of elements only.",
        "Add a facade box if the wall reaches further than its elements.",
        Severity.WARNING,
    ),
)
