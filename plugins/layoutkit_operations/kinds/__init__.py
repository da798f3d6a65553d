"""The kinds of operations, one file each."""

from __future__ import annotations

from layoutkit.operations import Operation
from layoutkit_operations.kinds.array import Array
from layoutkit_operations.kinds.boolean import Boolean
from layoutkit_operations.kinds.delete import Delete
from layoutkit_operations.kinds.edit import Edit
from layoutkit_operations.kinds.extrude import Extrude
from layoutkit_operations.kinds.mesh import Mesh
from layoutkit_operations.kinds.place import Place
from layoutkit_operations.kinds.select import Select
from layoutkit_operations.kinds.shape import Shape
from layoutkit_operations.kinds.vary import Vary

#: In the order in which the reference has them.
BUILT_IN: tuple[type[Operation], ...] = (
    Select,
    Place,
    Array,
    Shape,
    Extrude,
    Mesh,
    Boolean,
    Vary,
    Edit,
    Delete,
)
