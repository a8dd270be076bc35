"""Decodes buffer views of glTF files compressed by meshoptimizer."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.budget import Budget

MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
"""Extensions that compress buffer views; the second one adds a filter and a codec version to the first one."""


def stream(view: dict[str, Any]) -> dict[str, Any] | None:
    """The extension's entry of a view, with place and layout of the compressed bytes; None without the extension."""
    extensions = view.get("extensions", {})
    found: dict[str, Any] | None = next((extensions[name] for name in MESHOPT if name in extensions), None)
    return found


def is_placeholder(buffer: dict[str, Any], number: int, *, has_binary: bool) -> bool:
    """Whether a buffer is only a placeholder for decoded bytes."""
    is_fallback = any(buffer.get("extensions", {}).get(name, {}).get("fallback") for name in MESHOPT)
    return "uri" not in buffer and (is_fallback or number > 0 or not has_binary)


def decoded(
    number: int, view: dict[str, Any], described: dict[str, Any], data: memoryview, budget: Budget
) -> memoryview:
    """Decode a view's compressed bytes, whose layout its extension's entry `described` states.

    The view and its number are for error messages; `budget` counts the decoded bytes before they are allocated.
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
