"""Binary glTF 2.0 as a container: arrays and files in one buffer, and a JSON document that tells of them.

Source: glTF 2.0 specification (ISO/IEC 12113:2022), sections 3.6 and 4.4.
"""

from __future__ import annotations

import json
import struct
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: What a part of the buffer holds: attributes of vertices, or numbers of vertices.
VERTICES, INDICES = 34962, 34963

#: How components of numbers are called, by numpy's names of them.
_COMPONENTS = {"<f4": 5126, "<u2": 5123, "<u4": 5125}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3"}


class Buffer:
    """The binary part, as it grows.

    Attributes
    ----------
    views, accessors
        What stands in it, as the document tells of it.
    """

    def __init__(self) -> None:
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []
        self._parts: list[bytes] = []
        self._length = 0

    def view(self, data: bytes, target: int | None = None) -> int:
        """Add bytes, and return the number of their view."""
        padding = b"\0" * (-len(data) % 4)
        view = {"buffer": 0, "byteOffset": self._length, "byteLength": len(data)}
        self.views.append(view if target is None else {**view, "target": target})
        self._parts += [data, padding]
        self._length += len(data) + len(padding)
        return len(self.views) - 1

    def vertices(self, values: NDArray[np.float32]) -> int:
        """Add one attribute of vertices, shape (vertices, components); return the number of its accessor."""
        bounds = {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        return self._accessor(values, VERTICES, values.shape[1], bounds)

    def indices(self, numbers: NDArray[np.unsignedinteger[Any]]) -> int:
        """Add numbers of vertices; return the number of their accessor."""
        return self._accessor(numbers, INDICES, 1, {})

    def packed(self, document: dict[str, Any]) -> bytes:
        """Return a document with this buffer as the bytes of a ``.glb``."""
        if self._length:
            tables = {"accessors": self.accessors, "bufferViews": self.views}
            document = {**document, **tables, "buffers": [{"byteLength": self._length}]}
        text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = [struct.pack("<I4s", len(text), b"JSON"), text]
        if self._length:
            chunks += [struct.pack("<I4s", self._length, b"BIN\0"), *self._parts]
        length = 12 + sum(map(len, chunks))
        return b"".join([struct.pack("<4sII", b"glTF", 2, length), *chunks])

    def _accessor(self, values: NDArray[Any], target: int, components: int, more: dict[str, Any]) -> int:
        self.accessors.append(
            {
                "bufferView": self.view(values.tobytes(), target),
                "componentType": _COMPONENTS[values.dtype.newbyteorder("<").str],
                "count": len(values),
                "type": _TYPES[components],
                **more,
            }
        )
        return len(self.accessors) - 1
