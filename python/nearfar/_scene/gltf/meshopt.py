"""Buffer views of glTF files that meshoptimizer has compressed."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.budget import Budget

MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
"""Extensions that compress buffer views; the second one adds a filter and a version of the codec to the first one."""


def stream(view: dict[str, Any]) -> dict[str, Any] | None:
    """An extension's description of a view: place of its compressed bytes, and their layout; None without one."""
    extensions = view.get("extensions", {})
    found: dict[str, Any] | None = next((extensions[name] for name in MESHOPT if name in extensions), None)
    return found


def is_placeholder(buffer: dict[str, Any], number: int, *, has_binary: bool) -> bool:
    """Whether a buffer has no bytes, but stands for those that a decoder makes."""
    is_fallback = any(buffer.get("extensions", {}).get(name, {}).get("fallback") for name in MESHOPT)
    return "uri" not in buffer and (is_fallback or number > 0 or not has_binary)


def decoded(
    number: int, view: dict[str, Any], described: dict[str, Any], data: memoryview, budget: Budget
) -> memoryview:
    """Decode a view.

    Parameters
    ----------
    number, view
        The view and its number, which errors name.
    described
        Its `stream`.
    data
        The compressed bytes.
    budget
        Counts the decoded bytes before there is memory for them.
    """
    count, stride = int(described["count"]), int(described["byteStride"])
    if count < 0 or stride < 0:
        raise UnusableError(f"its buffer view {number} has {count} rows of {stride} bytes")
    if view.get("byteStride", stride) != stride:
        raise UnusableError(f"its buffer view {number} has rows of {view['byteStride']} bytes, and {stride} compressed")
    budget.take(count * stride)
    try:
        words = _core.decode_meshopt(
            np.frombuffer(data, np.uint8), count, stride, described["mode"], described.get("filter", "NONE")
        )
    except (SceneError, ValueError) as error:
        raise UnusableError(f"its buffer view {number} cannot be decoded: {error}") from None
    return words.view(np.uint8)[: count * stride].data
