"""Views of a cell of boxes as splats, cameras that see them, and pictures by the kernel alone."""

from __future__ import annotations

import functools
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar.orthoview._codec import CONNECTION_LIMITS
from tests.support import splat_oracle
from tests.support.orthoview_cases import CORNER, SIDE, boxes
from tests.support.orthoview_oracle import Triple
from tests.support.splat_oracle import Splat

MIDDLE = CORNER + SIDE / 2
THREE: list[Triple] = [(1, 0, 0), (0, 1, 0), (0, 1, 1)]
CHANNELS = ("range", "albedo", "normal")
WIDE = nf.Fov(-0.5, 0.5, -0.4, 0.4)


def views_of(directions: list[Triple], layout: tuple[int, int, int]) -> tuple[_core.OrthoViews, Any]:
    """Views of boxes in a cell, and the cell."""
    cell = (tuple(CORNER), SIDE)
    return _core.OrthoViews.of_cell(boxes()[0]._core, cell, directions, layout), cell


def splats_of(
    directions: list[Triple], depth_bits: int = 12, normal_bits: int = 24, size: int = 16
) -> list[_core.OrthoSplats]:
    """The same as splats."""
    views, cell = views_of(directions, (size, depth_bits, normal_bits))
    bits = views.connected(CONNECTION_LIMITS)
    return [_core.OrthoSplats(views, number, bits, cell) for number in range(len(directions))]


@functools.cache
def known_of(directions: tuple[Triple, ...], layout: tuple[int, int, int]) -> list[Splat]:
    """The same by the oracle, which takes some time."""
    views, _ = views_of(list(directions), layout)
    return [
        splat
        for number, direction in enumerate(directions)
        for splat in splat_oracle.splats_of(views, number, direction, CORNER, SIDE, layout[1])
    ]


def cell_of(
    directions: list[Triple], depth_bits: int = 12, normal_bits: int = 24, size: int = 16
) -> tuple[list[_core.OrthoSplats], list[Splat]]:
    """Views of boxes in a cell, and their splats."""
    splats = splats_of(directions, depth_bits, normal_bits, size)
    known = known_of(tuple(directions), (size, depth_bits, normal_bits))
    assert sum(view.count for view in splats) == len(known) > 50
    return splats, known


def draw_splats(
    splats: list[_core.OrthoSplats],
    camera: nf.Camera,
    channels: tuple[str, ...] = CHANNELS,
    grid: int = 1,
    before: dict[str, Any] | None = None,
    device: _core.GpuDevice | None = None,
    **limits: Any,
) -> dict[str, Any]:
    shot = Shot(cameras=(camera,), channels=channels, **limits)
    x, y, z = MIDDLE.tolist()
    return _core.splat_orthoviews(
        splats, camera._core, shot.settings, origin=(x, y, z), grid=grid, before=before, device=device
    )


def facing(direction: Triple, fov: nf.Fov | nf.Orthographic, size: tuple[int, int] = (40, 32)) -> nf.Camera:
    """A camera that sees the cell from about a direction."""
    toward = np.array(direction) / np.linalg.norm(direction)
    eye = MIDDLE + 2.4 * SIDE * toward + np.array([1.3, 2.1, -1.7])
    return nf.Camera.look_at(eye, MIDDLE, fov=fov, size=size, up=(0.1, 0.9, 0.3))


CAMERAS = {
    "perspective": facing((1, 1, 1), WIDE, (64, 48)),
    "close": nf.Camera.look_at(MIDDLE + np.array([9, 3, 8]), MIDDLE, fov=nf.Fov(-1, 1, -1, 1), size=(48, 48)),
    "inside": nf.Camera.look_at(
        MIDDLE + np.array([1, 3, 2]), MIDDLE - (9, 1, 8), fov=nf.Fov(-1, 1, -1, 1), size=(48, 48)
    ),
    "asymmetric": facing((1, 1, -1), nf.Fov(-0.2, 0.6, -0.5, 0.3), (70, 33)),
    "parallel": facing((1, 1, 1), nf.Orthographic(-14, 12, -11, 15), (52, 52)),
    "along an axis, plane in the cell": nf.Camera(
        tuple(MIDDLE + np.array([0.3, 0.2, 1.7])), fov=nf.Orthographic(-11, 11, -11, 11), size=(40, 40)
    ),
    "along an axis": nf.Camera(
        tuple(MIDDLE + np.array([0.3, 0.2, 30])), fov=nf.Orthographic(-11, 11, -11, 11), size=(41, 41)
    ),
}
LARGE = replace(CAMERAS["perspective"], size=(300, 200))
"""A camera whose picture has several screen tiles."""

CAMERAS |= {
    f"cube face {face}": nf.Camera(
        tuple(MIDDLE - 18 * np.eye(3)[face // 2] * (1 - 2 * (face % 2)) + (0.7, 0.4, -0.6)),
        fov=nf.CubeFace(face),
        size=(48, 48),
    )
    for face in range(6)
}

STRAIGHT = nf.Camera((4.0, 4.0, 16.0), fov=nf.Orthographic(-4, 4, -4, 4), size=(16, 16))


def wall(camera: nf.Camera, range_: NDArray[Any] | float) -> dict[str, Any]:
    """Images of red geometry at a range from each pixel."""
    width, height = camera.size
    near = np.broadcast_to(np.asarray(range_, np.float32), (height, width)).copy()
    red = np.broadcast_to(np.array([1, 0, 0], np.float32), (height, width, 3)).copy()
    return {
        "color": red,
        "coverage": np.isfinite(near).astype(np.float32),
        "range": near,
        "albedo": red * np.float32(0.5),
        "normal": np.broadcast_to(np.array([0, 0, 1], np.float32), (height, width, 3)).copy(),
        "object_id": np.full((height, width), 7, np.int32),
        "face_id": np.full((height, width), 11, np.int64),
    }


def flat(color: int, depth: int = 100, z: float = 0.0) -> _core.OrthoSplats:
    """A view whose pixels have one depth and one colour, of a cell at a height."""
    size, direction = 8, (0, 0, 1)
    views = _core.OrthoViews.from_arrays(
        [direction],
        (size, 12, 16),
        np.full((1, size, size, 3), color, np.uint8),
        np.full((1, size, size, 1), depth, np.uint16),
        np.full((1, size, size, 2), 127, np.uint16),
    )
    return _core.OrthoSplats(views, 0, views.connected(CONNECTION_LIMITS), ((0.0, 0.0, z), 8.0))


def limits_of(name: str) -> dict[str, Any]:
    low, high = CORNER + 0.2 * SIDE, CORNER + 0.8 * SIDE
    limits: dict[str, dict[str, Any]] = {
        "t_min": {"t_min": 45.0},
        "t_max": {"t_max": 50.0},
        "both": {"t_min": 44.0, "t_max": 49.0},
        "box": {"clip": nf.Clip(box=[low, high])},
        "planes": {"clip": nf.Clip(planes=[[1, 2, 3, -float(np.dot([1, 2, 3], MIDDLE))]])},
    }
    return limits[name]
