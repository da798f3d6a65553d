"""Our own faults (LK9)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code

CODES = (
    Code(
        "LK901",
        "layoutkit failed",
        "The program ran into an error that it does not foresee.",
        "A fault of ours.",
        "Report it, with the traceback that LAYOUTKIT_DEBUG=1 shows.",
    ),
    Code(
        "LK902",
        "layout breaks its constraints",
        "The search returned a layout that the check before writing does not pass; it is not written.",
        "A fault of ours, or of the plugin whose constraints the facade uses.",
        "Report it, with the facade's document and the seed.",
    ),
    Code(
        "LK903",
        "body that is not as it should be",
        "What a replay of operations has made does not pass the check afterwards: a mesh has gaps or no "
        "volume, or an opening is not on its surface.",
        "A fault of ours, or of the plugin whose operations are used.",
        "Report it, with the operations, the scene and the seed.",
    ),
)
