"""Baking of the static geometry beyond a radius to an environment map."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import DTypeLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._cubemap.envmap import EnvMap, to_half
from nearfar._scene.scene import Scene


def bake(
    scene: Scene,
    center: tuple[float, float, float],
    radius: float,
    *,
    size: int,
    samples: int,
    channels: Collection[str],
    half: bool,
    device: _core.GpuDevice | None,
) -> tuple[EnvMap, int]:
    """Bake the static part of a scene beyond a radius about the vertical axis through a centre.

    Returns the map, and the number of rays cast (0 on a device). If the scene has moving objects, the map always has
    range. `half` stores range as float16.
    """
    moves = scene._core.triangle_count > scene._core.standing_triangle_count
    settings: dict[str, Any] = {
        "center": center,
        "radius": radius,
        "size": size,
        "samples": samples,
        "range": "range" in channels or moves,
        "object_id": "object_id" in channels,
    }
    with progress.bar("baking") as report:
        if device is None:
            faces, rays = _core.bake(scene._core, settings, report=report)
        else:
            faces, rays = device.bake(scene._core, settings, report=report), 0
    shaped = {name: image.reshape(6, size, size, *image.shape[2:]) for name, image in faces.items()}
    if half and "range" in shaped:
        shaped["range"] = to_half(shaped["range"])
    names = scene.object_names if "object_id" in shaped else ()
    return EnvMap(center, **shaped, object_names=names), rays


def is_half(argument: str, dtype: DTypeLike) -> bool:
    """Return whether a type is float16; TypeError or ValueError for types other than float16 and float32."""
    try:
        kind = np.dtype(dtype)
    except (TypeError, ValueError, AttributeError, SyntaxError):
        raise TypeError(f"{argument}: expected float32 or float16, got {check.type_and_value(dtype)}") from None
    if kind not in (np.float16, np.float32):
        raise ValueError(f"{argument}: expected float32 or float16, got {kind}")
    return kind == np.float16
