"""Examples of plugins that fail (LK4)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.codes.examples.frames import COMMAND, CONVERTING_PLUGIN, PLUGIN

_FORMAT = """\
from layoutkit.hooks import Format, hookimpl

class Toy(Format):
    name = "{}"
    summary = "Reads toys."

    def recognises(self, path, head):
        return {}

    def read(self, path, picture):
        ...

@hookimpl
def layoutkit_formats():
    return [{}]"""
_SOUND = _FORMAT.format("toy", "False", "Toy()")

EXAMPLES = {
    "LK401": Example(PLUGIN, f"import a_package_that_is_not_there\n{_SOUND}", f"import json\n{_SOUND}"),
    "LK402": Example(PLUGIN, _SOUND.replace("layoutkit_formats", "layoutkit_format"), _SOUND),
    "LK403": Example(PLUGIN, _SOUND.replace("return [Toy()]", "return [Toy()[0]]"), _SOUND),
    "LK404": Example(PLUGIN, _FORMAT.format("toy", "False", "Toy"), _SOUND),
    "LK405": Example(PLUGIN, _FORMAT.format("cmp", "False", "Toy()"), _SOUND),
    "LK406": Example(
        COMMAND,
        "layoutkit convert boxes.xml --format cpm --image photo.png -o converted.xml",
        "layoutkit convert boxes.xml --format cmp --image photo.png -o converted.xml",
    ),
    "LK407": Example(CONVERTING_PLUGIN, _FORMAT.format("toy", "head[0] / 0", "Toy()"), _SOUND),
    "LK408": Example(COMMAND, "layoutkit --without relayot plugins", "layoutkit --without relayout plugins"),
    "LK409": Example(PLUGIN, f"LAYOUTKIT_API = 99\n{_SOUND}", f"LAYOUTKIT_API = 1\n{_SOUND}"),
}
