"""The relationship functions of both papers."""

from __future__ import annotations

from layoutkit.scenes.relationship import Relationship

#: All of them.
BUILT_IN: tuple[Relationship, ...] = ()
