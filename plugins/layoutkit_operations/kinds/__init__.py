"""The kinds of operations, one file each."""

from __future__ import annotations

from layoutkit.operations import Operation
from layoutkit_operations.kinds.delete import Delete
from layoutkit_operations.kinds.select import Select

BUILT_IN: tuple[type[Operation], ...] = (Select, Delete)
