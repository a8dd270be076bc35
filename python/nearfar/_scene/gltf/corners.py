"""Splits glTF primitives into triangles, by mode: lists, strips and fans."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError

TRIANGLES, STRIP, FAN = 4, 5, 6
MODES = (TRIANGLES, STRIP, FAN)
"""Supported modes of primitives."""

UNSUPPORTED = {0: "point primitive", 1: "line primitive", 2: "line primitive", 3: "line primitive"}
"""Names of unsupported primitives, by mode."""


def mode(primitive: dict[str, Any]) -> Any:
    return primitive.get("mode", TRIANGLES)


def is_drawn(primitive: dict[str, Any]) -> bool:
    """Whether a primitive has triangles and positions."""
    return mode(primitive) in MODES and "POSITION" in primitive.get("attributes", {})


def drawn_primitives(mesh: dict[str, Any]) -> list[dict[str, Any]]:
    """Primitives of a mesh that are drawn."""
    return [primitive for primitive in mesh["primitives"] if is_drawn(primitive)]


def faces(kind: int, corners: NDArray[Any], *, is_indexed: bool) -> NDArray[Any]:
    """Triangles (F, 3) of a primitive's corners (N,); `is_indexed` means that the file has indices."""
    if corners.dtype.kind == "f":
        raise UnusableError("expected whole numbers as indices, got fractions")
    if kind == TRIANGLES:
        if len(corners) % 3:
            raise UnusableError(f"expected three corners for each triangle, got {len(corners)}")
        return corners.reshape(-1, 3)
    if is_indexed and len(corners) and int(corners.max()) == np.iinfo(corners.dtype).max:
        # glTF 2.0, 3.7.2.1 forbids the type's greatest value, which restarts strips in some programs.
        raise UnusableError(f"a strip or fan of its meshes has the index {corners.max()}, which glTF 2 does not allow")
    triangles = _split_strip(corners) if kind == STRIP else _split_fan(corners)
    first, second, third = triangles.T
    # Strips are joined by degenerate triangles.
    return np.asarray(triangles[(first != second) & (second != third) & (third != first)])


def _split_strip(corners: NDArray[Any]) -> NDArray[Any]:
    """Split a strip; every other triangle has its corners in reverse order (glTF 2.0, 3.7.2.1)."""
    count = max(len(corners) - 2, 0)
    triangles = np.column_stack([corners[:count], corners[1 : count + 1], corners[2 : count + 2]])
    triangles[1::2] = triangles[1::2, ::-1]
    return triangles


def _split_fan(corners: NDArray[Any]) -> NDArray[Any]:
    """Split a fan; all triangles share the first corner (glTF 2.0, 3.7.2.1)."""
    count = max(len(corners) - 2, 0)
    hub = np.repeat(corners[:1], count)
    return np.column_stack([hub, corners[1 : count + 1], corners[2 : count + 2]])
