"""Triangles of glTF primitives, by their modes: lists, strips and fans."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError

TRIANGLES, STRIP, FAN = 4, 5, 6
MODES = (TRIANGLES, STRIP, FAN)
"""Modes of primitives that are read."""

OTHERS = {0: "point primitive", 1: "line primitive", 2: "line primitive", 3: "line primitive"}
"""Kinds of the primitives without triangles, by their modes."""


def mode(primitive: dict[str, Any]) -> Any:
    """The kind of a primitive."""
    return primitive.get("mode", TRIANGLES)


def faces(kind: int, corners: NDArray[Any], *, is_indexed: bool) -> NDArray[Any]:
    """Triangles (F, 3) of a primitive's corners (N,); `is_indexed` says that these stand in the file."""
    if corners.dtype.kind == "f":
        raise UnusableError("expected whole numbers as indices, got fractions")
    if kind == TRIANGLES:
        if len(corners) % 3:
            raise UnusableError(f"expected three corners for each triangle, got {len(corners)}")
        return corners.reshape(-1, 3)
    if is_indexed and len(corners) and int(corners.max()) == np.iinfo(corners.dtype).max:
        # glTF 2.0, 3.7.2.1: not the greatest number of the type, which restarts strips in some programs.
        raise UnusableError(f"a strip or fan of its meshes has the index {corners.max()}, which glTF 2 does not allow")
    triangles = _of_strip(corners) if kind == STRIP else _of_fan(corners)
    first, second, third = triangles.T
    # Strips are joined by triangles without an area.
    kept: NDArray[Any] = triangles[(first != second) & (second != third) & (third != first)]
    return kept


def _of_strip(corners: NDArray[Any]) -> NDArray[Any]:
    """Each other triangle has its corners in the opposite order (glTF 2.0, 3.7.2.1)."""
    count = max(len(corners) - 2, 0)
    triangles = np.column_stack([corners[:count], corners[1 : count + 1], corners[2 : count + 2]])
    triangles[1::2] = triangles[1::2, ::-1]
    return triangles


def _of_fan(corners: NDArray[Any]) -> NDArray[Any]:
    """All triangles have the first corner (glTF 2.0, 3.7.2.1)."""
    count = max(len(corners) - 2, 0)
    hub = np.repeat(corners[:1], count)
    return np.column_stack([hub, corners[1 : count + 1], corners[2 : count + 2]])
