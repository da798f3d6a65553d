"""What this package adds: the formats that `convert` reads."""

from __future__ import annotations

from collections.abc import Iterable

from layoutkit.hooks.specs import Format, hookimpl


@hookimpl
def layoutkit_formats() -> Iterable[Format]:
    """Return the readers of annotations."""
    from layoutkit_formats.cmp import CmpFormat
    from layoutkit_formats.masks import MaskFormat

    return [CmpFormat(), MaskFormat()]
