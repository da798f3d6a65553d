"""Masses and buildings (LK8)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK801",
        "part of a mass without walls",
        "An outline needs sides that meet at their ends and nowhere else, and a part a height.",
        "Points in the wrong order, or one given twice; the first one repeated at the end.",
        "Draw a simple outline; a closed one closes by itself.",
    ),
    Code(
        "LK802",
        "face partly hidden",
        "A part of the face is inside other parts of the mass; it is laid out as a whole all the same.",
        "A tower that rises from inside a podium, and begins at the ground.",
        "Let it begin where the other part ends, or divide it there; nothing else is needed.",
        Severity.NOTE,
    ),
    Code(
        "LK803",
        "faces named alike",
        "Each face of a mass goes by a name of its own.",
        "Several parts without names.",
        "Name them: the faces of the part Tower are Tower_South and so on.",
    ),
    Code(
        "LK804",
        "scope without effect",
        "A constraint of a kind that speaks of one region at a time says the same within faces and across.",
        'scope="building" on a constraint that names one region.',
        "Delete the scope.",
        Severity.WARNING,
    ),
    Code(
        "LK805",
        "constraint not carried to faces",
        "Every face is a copy of the facade under its own name; the constraint still names the original.",
        "A plugin's kind that holds names of regions in an attribute of a type of its own.",
        "Let its author declare them with the types of `layoutkit.constraints.attributes`.",
    ),
    Code(
        "LK806",
        "faces not those of the mass",
        "A building's layout has one region for each face of its mass, in order, and of exactly its size.",
        "A mass edited in a finished layout.",
        "Make the layout again: `layoutkit vary FACADE --mass MASS`.",
    ),
    Code(
        "LK807",
        "facade split into faces",
        "A facade is one design; only layouts of buildings have faces.",
        "A region of a layout copied into a facade.",
        "Keep the region of one face; `layoutkit vary --mass` puts it on all faces of a mass.",
    ),
)
